// The class GhostExchange: nodes that each rank sends to each other rank.
#include "hawser/system/ghost_exchange.hpp"

#include <petscsys.h>

#include "hawser/base/handle.hpp"

namespace hawser {

GhostExchange::GhostExchange(MPI_Comm comm, const LocalMesh& mesh)
    : comm_(comm), nodes_(static_cast<size_t>(mesh.nodes())) {
  if (ranks_of(comm) == 1) return;
  std::map<int, std::vector<int>> wanted;  // nodes of the mesh by owner
  for (int n = mesh.owned; n < mesh.nodes(); ++n) {
    const int node = mesh.global[n], owner = mesh.owner[node];
    wanted[owner].push_back(node);
    nodes_by_rank_[owner].receive.push_back(n);
  }
  // Owners learn how many of their nodes other ranks want; the nodes follow.
  std::vector<PetscMPIInt> owners;
  std::vector<int> counts;
  for (const auto& [owner, nodes] : wanted) {
    owners.push_back(owner);
    counts.push_back(static_cast<int>(nodes.size()));
  }
  PetscMPIInt ranks = 0;
  PetscMPIInt* rank = nullptr;
  int* count = nullptr;
  check(PetscCommBuildTwoSided(comm, 1, MPI_INT, static_cast<PetscMPIInt>(owners.size()), owners.data(),
                               counts.data(), &ranks, &rank, &count));
  for (int i = 0; i < ranks; ++i) nodes_by_rank_[rank[i]].send.resize(count[i]);
  check(PetscFree(rank));
  check(PetscFree(count));
  std::vector<MPI_Request> requests;
  for (auto& [other, nodes] : nodes_by_rank_) {
    const std::vector<int>& own = wanted[other];
    MPI_Irecv(nodes.send.data(), static_cast<int>(nodes.send.size()), MPI_INT, other, kPlan, comm,
              &requests.emplace_back());
    MPI_Isend(own.data(), static_cast<int>(own.size()), MPI_INT, other, kPlan, comm,
              &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (auto& [other, nodes] : nodes_by_rank_)
    for (int& node : nodes.send) node = mesh.find(node);
}

}  // namespace hawser
