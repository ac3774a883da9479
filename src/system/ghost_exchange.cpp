// The class GhostExchange: nodes that each rank sends to each other rank, and messages with numbers, vectors,
// quaternions or matrices to the ghosts.
#include "hawser/system/ghost_exchange.hpp"

#include <algorithm>
#include <iterator>

#include "hawser/base/gather.hpp"

namespace hawser {
namespace {
constexpr int kPlan = 71, kValues = 72;  // message tags
}

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

void GhostExchange::spread(std::span<double> values, int width) const {
  const size_t w = width;
  std::vector<std::vector<double>> out(neighbours_.size()), in(neighbours_.size());
  std::vector<MPI_Request> requests(2 * neighbours_.size());
  for (size_t i = 0; i < neighbours_.size(); ++i) {
    const Neighbour& n = neighbours_[i];
    out[i].reserve(w * n.send.size());
    in[i].resize(w * n.receive.size());
    for (int node : n.send) {
      const auto from = values.begin() + static_cast<std::ptrdiff_t>(w * static_cast<size_t>(node));
      std::copy_n(from, w, std::back_inserter(out[i]));
    }
    MPI_Irecv(in[i].data(), static_cast<int>(in[i].size()), MPI_DOUBLE, n.rank, kValues, comm_,
              &requests[2 * i]);
    MPI_Isend(out[i].data(), static_cast<int>(out[i].size()), MPI_DOUBLE, n.rank, kValues, comm_,
              &requests[2 * i + 1]);
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (size_t i = 0; i < neighbours_.size(); ++i)
    for (size_t k = 0; k < neighbours_[i].receive.size(); ++k)
      std::copy_n(
          in[i].begin() + static_cast<std::ptrdiff_t>(w * k), w,
          values.begin() + static_cast<std::ptrdiff_t>(w * static_cast<size_t>(neighbours_[i].receive[k])));
}

void GhostExchange::spread(std::vector<Vec3>& values) const {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  values.resize(nodes_, Vec3::Zero());
  if (!values.empty()) spread(std::span(values.front().data(), 3 * nodes_), 3);
}

void GhostExchange::spread(std::vector<Mat3>& values) const {
  static_assert(sizeof(Mat3) == 9 * sizeof(double));
  values.resize(nodes_, Mat3::Zero());
  if (!values.empty()) spread(std::span(values.front().data(), 9 * nodes_), 9);
}

void GhostExchange::spread(std::vector<Quat>& values) const {
  static_assert(sizeof(Quat) == 4 * sizeof(double));
  values.resize(nodes_, Quat::Identity());
  if (!values.empty()) spread(std::span(values.front().coeffs().data(), 4 * nodes_), 4);
}

}  // namespace hawser
