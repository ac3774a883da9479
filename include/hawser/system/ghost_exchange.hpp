// Sends values of owned nodes, point to point, to the ranks that have these nodes as ghosts.
#pragma once

#include <mpi.h>

#include <vector>

#include "hawser/base/exchange.hpp"
#include "hawser/mesh/local_mesh.hpp"

namespace hawser {

class GhostExchange {
 public:
  GhostExchange() = default;
  // Determines which rank needs which nodes. The mesh's ghosts must not change afterwards. Collective.
  GhostExchange(MPI_Comm comm, const LocalMesh& mesh);

  // Resizes `values` to the number of local nodes, and copies those of the owned nodes to the ghosts on other
  // ranks. T: plain data. Collective.
  template <class T>
  void update_ghosts(std::vector<T>& values) const {
    values.resize(nodes_);
    exchange<T>(
        comm_, kValues, nodes_by_rank_, [&](int node) { return values[node]; },
        [&](int node, const T& value) { values[node] = value; });
  }

 private:
  static constexpr int kPlan = 71, kValues = 72;  // message tags
  MPI_Comm comm_ = MPI_COMM_NULL;
  size_t nodes_ = 0;
  IndicesByRank nodes_by_rank_;  // local nodes
};

}  // namespace hawser
