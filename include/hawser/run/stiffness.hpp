// `hawser stiffness`: stiffness and restoring force of the lines on a body, at rest and at offsets.
#pragma once

#include <mpi.h>

#include <array>
#include <string>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser::run {

using Offset = std::array<double, 6>;  // m, axes of space; rad, rotation vector

struct StiffnessOptions {
  std::string case_path;
  std::string output;                // CSV file; empty: <case>-stiffness.csv beside the case file
  std::vector<std::string> changes;  // of the case, KEY=VALUE each
  std::string body;                  // empty: the only one that lines are tied to
  Vec3 at = Vec3::Zero();            // m, the point of the body that all is about, its frame
  std::vector<Offset> offsets;       // from rest, beside that
  double direction = 0, to = 0;      // rad; m: offsets in steps from rest, where `to` is above 0
  int steps = 10;
  bool quiet = false;
};

// Prints the stiffness at rest and a table of the offsets, and writes both. Exit code. Throws InputError and
// SolveError. Collective.
int stiffness(MPI_Comm comm, const StiffnessOptions& options);

}  // namespace hawser::run
