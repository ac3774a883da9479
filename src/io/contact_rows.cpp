// Rows of contact points of several outputs and ranks in the tables of a results file.
#include "hawser/io/contact_rows.hpp"

#include <algorithm>

#include "hawser/base/mpi.hpp"
#include "hawser/io/results.hpp"

namespace hawser::io {

ContactPlaces contact_places(MPI_Comm comm, const std::vector<ContactRows>& outputs, long long before) {
  std::vector<long long> local;
  for (const ContactRows& rows : outputs) local.push_back(std::ssize(rows));
  std::vector<long long> of_lower_ranks(local.size());
  MPI_Exscan(local.data(), of_lower_ranks.data(), static_cast<int>(local.size()), MPI_LONG_LONG, MPI_SUM,
             comm);
  // MPI_Exscan leaves the values of rank 0 undefined.
  if (rank_of(comm) == 0) std::fill(of_lower_ranks.begin(), of_lower_ranks.end(), 0);
  ContactPlaces out;
  out.counts = local;
  all_reduce(comm, MPI_SUM, out.counts);
  out.last = before;
  for (size_t k = 0; k < local.size(); ++k) {
    const long long first = out.last + of_lower_ranks[k];
    out.last += out.counts[k];
    out.counts[k] = out.last;
    if (local[k] == 0) continue;
    if (out.runs.empty() || out.runs.back().first + out.runs.back().count != first)
      out.runs.push_back({first, 0});
    out.runs.back().count += local[k];
  }
  out.any = out.last > before;
  return out;
}

void write_contacts(SharedFile& file, long long output, const std::vector<ContactRows>& outputs,
                    const ContactPlaces& at) {
  std::vector<int> pairs;
  std::vector<double> positions;
  std::vector<float> forces;
  for (const ContactRows& rows : outputs)
    for (const ContactRow& r : rows) {
      pairs.insert(pairs.end(), {r.line, r.other_line, r.volume, r.other_volume});
      positions.insert(positions.end(), r.position.begin(), r.position.end());
      for (const double x : r.force) forces.push_back(static_cast<float>(x));
    }
  if (at.any) {
    file.write_runs(kContactPairs, H5T_NATIVE_INT, -1, at.runs, pairs.data());
    file.write_runs(kContactPositions, H5T_NATIVE_DOUBLE, -1, at.runs, positions.data());
    file.write_runs(kContactForces, H5T_NATIVE_FLOAT, -1, at.runs, forces.data());
  }
  const bool contributes = file.rank() == 0;
  file.write_rows(kContactCounts, H5T_NATIVE_LLONG, output, std::ssize(at.counts), contributes,
                  at.counts.data());
}

long long contact_room(const ResultContents& c) {
  if (!c.contact_points) return 0;
  return std::max(64LL, static_cast<long long>(c.expected_outputs) * c.nodes_total());
}

}  // namespace hawser::io
