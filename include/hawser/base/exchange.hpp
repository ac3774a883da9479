// Exchange of values with the ranks that need them, point to point.
#pragma once

#include <mpi.h>

#include <map>
#include <vector>

#include "hawser/base/mpi.hpp"

namespace hawser {

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
  const MessageType<T> type;
  std::vector<std::vector<T>> out, in;
  std::vector<MPI_Request> requests;
  for (const auto& [rank, of_rank] : indices) {
    std::vector<T>& sent = out.emplace_back();
    for (const int i : of_rank.send) sent.push_back(value(i));
    std::vector<T>& received = in.emplace_back(of_rank.receive.size());
    MPI_Irecv(received.data(), static_cast<int>(received.size()), type, rank, tag, comm,
              &requests.emplace_back());
    MPI_Isend(sent.data(), static_cast<int>(sent.size()), type, rank, tag, comm, &requests.emplace_back());
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  auto received = in.begin();
  for (const auto& [rank, of_rank] : indices) {
    for (size_t k = 0; k < of_rank.receive.size(); ++k) take(of_rank.receive[k], (*received)[k]);
    ++received;
  }
}

}  // namespace hawser
