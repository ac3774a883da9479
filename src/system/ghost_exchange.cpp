// The class GhostExchange: nodes that each rank sends to each other rank.
#include "hawser/system/ghost_exchange.hpp"

#include <algorithm>

namespace hawser {

GhostExchange::GhostExchange(MPI_Comm comm, const LocalMesh& mesh)
    : comm_(comm), nodes_(static_cast<size_t>(mesh.nodes())) {
  const int size = ranks_of(comm);
  if (size == 1) return;
  const size_t ranks = size;
  std::vector<std::vector<int>> wanted(ranks), local(ranks);
  for (int n = mesh.owned; n < mesh.nodes(); ++n) {
    const int g = mesh.global[n];
    const size_t r = mesh.owner[g];
    wanted[r].push_back(g);
    local[r].push_back(n);
  }
  // Each rank first sends each other one the number of nodes it needs; the nodes follow if there are any.
  std::vector<int> ask(ranks), asked(ranks);
  std::transform(wanted.begin(), wanted.end(), ask.begin(),
                 [](const auto& w) { return static_cast<int>(w.size()); });
  MPI_Alltoall(ask.data(), 1, MPI_INT, asked.data(), 1, MPI_INT, comm);
  for (size_t r = 0; r < ranks; ++r) {
    if (ask[r] == 0 && asked[r] == 0) continue;
    Neighbour& n = neighbours_.emplace_back();
    n.rank = static_cast<int>(r);
    n.receive = std::move(local[r]);
    n.send.resize(asked[r]);
  }
  std::vector<MPI_Request> requests;
  for (Neighbour& n : neighbours_) {
    const auto& w = wanted[n.rank];
    MPI_Irecv(n.send.data(), static_cast<int>(n.send.size()), MPI_INT, n.rank, kPlan, comm,
              &requests.emplace_back());
    MPI_Isend(w.data(), static_cast<int>(w.size()), MPI_INT, n.rank, kPlan, comm, &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (Neighbour& n : neighbours_)
    for (int& node : n.send) node = mesh.find(node);
}

}  // namespace hawser
