// Sends values of owned nodes, point to point, to the ranks that have these nodes as ghosts.
#pragma once

#include <mpi.h>

#include <span>
#include <vector>

#include "hawser/math/types.hpp"
#include "hawser/mesh/local_mesh.hpp"

namespace hawser {

class GhostExchange {
 public:
  GhostExchange() = default;
  // Determines which rank needs which nodes. The mesh's ghosts must not change afterwards. Collective.
  GhostExchange(MPI_Comm comm, const LocalMesh& mesh);

  // Copies values[node * width + c] of the owned nodes to the ghosts on other ranks. Collective.
  void spread(std::span<double> values, int width) const;
  // The same, after resizing to the number of local nodes.
  void spread(std::vector<Vec3>& values) const;
  void spread(std::vector<Quat>& values) const;
  void spread(std::vector<Mat3>& values) const;

 private:
  struct Neighbour {
    int rank = 0;
    std::vector<int> send, receive;  // local nodes
  };
  MPI_Comm comm_ = MPI_COMM_NULL;
  size_t nodes_ = 0;
  std::vector<Neighbour> neighbours_;
};

}  // namespace hawser
