// Where a line in contact with volumes is bent too sharply for its elements.
#pragma once

#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"
#include "hawser/terms/line_neighbours.hpp"

namespace hawser::app {

// A straight element that lies across an edge is pressed perpendicular to itself. At its node, where the line
// turns by alpha, the tensions T of the two elements are then in equilibrium although they differ by up to
// T (1 - cos alpha); without friction they should be equal.
class SharpTurns {
 public:
  explicit SharpTurns(const LocalMesh& mesh) : mesh_(mesh), line_(mesh), worst_(mesh.mesh->lines.size()) {}
  // By owned node: effective tension and normal force of volumes, N.
  void look(const Kinematics& at, std::span<const double> tension, std::span<const double> normal_force);
  // That the worst turn of a line may cost more than a tenth of its largest tension [N], in words; empty: it
  // is not. Collective, with the same line on all ranks.
  std::string warning(MPI_Comm comm, int line, const std::string& name, double largest_tension) const;

 private:
  struct Worst {
    double error = 0, turn = 0, arc = 0, time = 0;  // N, rad, m, s
  };
  const LocalMesh& mesh_;
  LineNeighbours line_;
  std::vector<Worst> worst_;  // by line
};

}  // namespace hawser::app
