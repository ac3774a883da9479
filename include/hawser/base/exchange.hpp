// Exchange with some of the other ranks, point to point.
#pragma once

#include <mpi.h>
#include <petscsys.h>

#include <cstddef>
#include <map>
#include <vector>

#include "hawser/base/handle.hpp"
#include "hawser/base/mpi.hpp"

namespace hawser {

template <class T>
using ListsByRank = std::map<int, std::vector<T>>;

// Sends each rank its list, and receives lists of the sizes that `receive` has. T: plain data.
template <class T>
void exchange_lists(MPI_Comm comm, int tag, const ListsByRank<T>& send, ListsByRank<T>& receive) {
  const MessageType<T> type;
  std::vector<MPI_Request> requests;
  for (auto& [rank, list] : receive)
    MPI_Irecv(list.data(), static_cast<int>(list.size()), type, rank, tag, comm, &requests.emplace_back());
  for (const auto& [rank, list] : send)
    MPI_Isend(list.data(), static_cast<int>(list.size()), type, rank, tag, comm, &requests.emplace_back());
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
}

// Sends each rank its list. Returns the lists that this rank receives; it need not know from which ranks.
// T: plain data. Collective.
template <class T>
ListsByRank<T> send_lists(MPI_Comm comm, int tag, const ListsByRank<T>& send) {
  std::vector<PetscMPIInt> to;
  std::vector<int> sizes;
  for (const auto& [rank, list] : send) {
    to.push_back(rank);
    sizes.push_back(static_cast<int>(list.size()));
  }
  PetscMPIInt count = 0;
  PetscMPIInt* from = nullptr;
  int* received = nullptr;
  check(PetscCommBuildTwoSided(comm, 1, MPI_INT, static_cast<PetscMPIInt>(to.size()), to.data(), sizes.data(),
                               &count, &from, &received));
  ListsByRank<T> out;
  for (int i = 0; i < count; ++i) out[from[i]].resize(static_cast<std::size_t>(received[i]));
  check(PetscFree(from));
  check(PetscFree(received));
  exchange_lists(comm, tag, send, out);
  return out;
}

// Indices of the values that a rank sends to another one, and of those it receives from it. The other rank
// lists the same values in the same order.
struct SharedIndices {
  std::vector<int> send, receive;
};
using IndicesByRank = std::map<int, SharedIndices>;

// Sends value(i) for each index i to send, and calls take(k, value) for each index k to receive. T: plain
// data. Collective over the ranks in `indices`, which agree on the tag.
template <class T, class Value, class Take>
void exchange(MPI_Comm comm, int tag, const IndicesByRank& indices, Value&& value, Take&& take) {
  ListsByRank<T> out, in;
  for (const auto& [rank, of_rank] : indices) {
    std::vector<T>& sent = out[rank];  // also if it is empty: the other rank expects a message
    for (const int i : of_rank.send) sent.push_back(value(i));
    in[rank].resize(of_rank.receive.size());
  }
  exchange_lists(comm, tag, out, in);
  for (const auto& [rank, of_rank] : indices)
    for (std::size_t k = 0; k < of_rank.receive.size(); ++k) take(of_rank.receive[k], in[rank][k]);
}

}  // namespace hawser
