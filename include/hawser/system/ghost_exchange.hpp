// Sends values of owned nodes, point to point, to the ranks that have these nodes as ghosts.
#pragma once

#include <mpi.h>

#include <vector>

#include "hawser/base/mpi.hpp"
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
    const MessageType<T> type;
    std::vector<std::vector<T>> out(neighbours_.size()), in(neighbours_.size());
    std::vector<MPI_Request> requests(2 * neighbours_.size());
    for (size_t i = 0; i < neighbours_.size(); ++i) {
      const Neighbour& n = neighbours_[i];
      for (const int node : n.send) out[i].push_back(values[node]);
      in[i].resize(n.receive.size());
      MPI_Irecv(in[i].data(), static_cast<int>(in[i].size()), type, n.rank, kValues, comm_, &requests[2 * i]);
      MPI_Isend(out[i].data(), static_cast<int>(out[i].size()), type, n.rank, kValues, comm_,
                &requests[2 * i + 1]);
    }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
    for (size_t i = 0; i < neighbours_.size(); ++i)
      for (size_t k = 0; k < in[i].size(); ++k) values[neighbours_[i].receive[k]] = in[i][k];
  }

 private:
  static constexpr int kPlan = 71, kValues = 72;  // message tags
  struct Neighbour {
    int rank = 0;
    std::vector<int> send, receive;  // local nodes
  };
  MPI_Comm comm_ = MPI_COMM_NULL;
  size_t nodes_ = 0;
  std::vector<Neighbour> neighbours_;
};

}  // namespace hawser
