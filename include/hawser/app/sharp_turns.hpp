// Where a line in contact with volumes is bent too sharply for its elements.
#pragma once

#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "hawser/mesh/local_mesh.hpp"
#include "hawser/state/kinematics.hpp"

namespace hawser::app {

// At a node where the line turns by alpha between two elements, what presses on one of them across it
// balances T (1 - cos alpha) of the tension along the other: by as much tension may be wrong without
// friction.
class SharpTurns {
 public:
  explicit SharpTurns(const LocalMesh& mesh);
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
  std::vector<int> before_, after_;  // local nodes, by owned node; -1: none
  std::vector<Worst> worst_;         // by line
};

}  // namespace hawser::app
