// Rows that several ranks share, summed on rank 0; contacts of a snapshot.
#include "hawser/record/recording.hpp"

#include <algorithm>

#include "hawser/base/mpi.hpp"
#include "hawser/terms/line_volume_contact.hpp"

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

const ActiveContacts& Snapshot::volume_contacts() const {
  if (!volume_contacts_) {
    volume_contacts_.emplace();
    if (const auto* contact = subject_.term<LineVolumeContact>()) contact->active_contacts(*volume_contacts_);
  }
  return *volume_contacts_;
}

}  // namespace hawser::record
