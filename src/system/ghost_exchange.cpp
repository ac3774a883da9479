// The class GhostExchange: nodes that each rank sends to each other rank.
#include "hawser/system/ghost_exchange.hpp"

namespace hawser {

GhostExchange::GhostExchange(MPI_Comm comm, const LocalMesh& mesh)
    : comm_(comm), nodes_(static_cast<size_t>(mesh.nodes())) {
  if (ranks_of(comm) == 1) return;
  ListsByRank<int> required;  // nodes of the mesh by owner
  for (int n = mesh.owned; n < mesh.nodes(); ++n) {
    const int node = mesh.global[n];
    const int owner = mesh.owner[node];
    required[owner].push_back(node);
    nodes_by_rank_[owner].receive.push_back(n);
  }
  for (const auto& [rank, nodes] : send_lists(comm, kPlan, required))
    for (const int node : nodes) nodes_by_rank_[rank].send.push_back(mesh.find(node));
}

}  // namespace hawser
