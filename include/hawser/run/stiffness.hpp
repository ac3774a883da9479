// `hawser stiffness`: stiffness and restoring force of the lines on a body at rest and at offsets.
#pragma once

#include <mpi.h>

#include <array>
#include <string>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser::run {

using Offset = std::array<double, 6>;  // m, space axes; rad, rotation vector

struct StiffnessOptions {
  std::string case_path;
  std::string output;                // CSV file; empty: <case>-stiffness.csv beside the case file
  std::vector<std::string> changes;  // changes of the case, KEY=VALUE each
  std::string body;                  // empty: the only body with attached lines
  Vec3 at = Vec3::Zero();            // m, reference point in the body's frame
  std::vector<Offset> offsets;       // offsets from rest, in addition to it
  double direction = 0, to = 0;      // rad; m: equidistant offsets from rest if `to` is above 0
  int steps = 10;
  bool quiet = false;
};

// Prints the stiffness at rest and a table of the offsets, and writes both. Returns the exit code. Throws
// InputError and SolveError. Collective.
int stiffness(MPI_Comm comm, const StiffnessOptions& options);

}  // namespace hawser::run
