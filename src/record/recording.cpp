// The class Rows: rows that several ranks share, summed on rank 0.
#include "hawser/record/recording.hpp"

#include <algorithm>

#include "hawser/base/gather.hpp"

namespace hawser::record {

std::vector<std::vector<double>> Rows::gathered(MPI_Comm comm) && {
  std::vector<double> all;
  for (const size_t p : parts_) all.insert(all.end(), rows_[p].begin(), rows_[p].end());
  if (all.empty()) return std::move(rows_);
  const bool first = rank_of(comm) == 0;
  MPI_Reduce(first ? MPI_IN_PLACE : all.data(), all.data(), static_cast<int>(all.size()), MPI_DOUBLE, MPI_SUM,
             0, comm);
  auto sum = all.begin();
  for (const size_t p : parts_) {
    std::vector<double>& row = rows_[p];
    if (first) std::copy_n(sum, row.size(), row.begin());
    sum += static_cast<std::ptrdiff_t>(row.size());
    if (!first) row.clear();
  }
  return std::move(rows_);
}

}  // namespace hawser::record
