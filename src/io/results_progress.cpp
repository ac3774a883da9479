// State of a results file: counter, times of valid rows, and damage.
#include "hawser/io/results_progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/error.hpp"
#include "hawser/io/contact_rows.hpp"
#include "hawser/io/hdf5.hpp"

namespace hawser::io {

namespace {

InputError damaged(const std::string& path, const std::string& problem) {
  return InputError("{} is damaged and cannot be continued: {}; go on in another file with -o", path,
                    problem);
}

// Valid rows of a dataset of times.
std::vector<double> counted(const std::string& path, hid_t file, const std::string& name, long long rows) {
  std::vector<double> times = h5::read_array(file, name).values;
  if (rows < 0 || rows > static_cast<long long>(times.size()))
    throw damaged(path, fmt::format("it counts {} rows of {}, which has {}", rows, name, times.size()));
  times.resize(rows);
  return times;
}

}  // namespace

long long rows_until(const std::string& path, const std::string& name, const std::vector<double>& times,
                     double last) {
  size_t n = 0;
  while (n < times.size() && times[n] <= last && (n == 0 || times[n] >= times[n - 1])) ++n;
  for (size_t later = n; n > 0 && later < times.size(); ++later)
    if (times[later] > times[n - 1] && times[later] <= last)
      throw damaged(path, fmt::format("row {} of {} is {:g}, after {:g} and before {:g} s", n + 1, name,
                                      times[n], times[n - 1], times[later]));
  return static_cast<long long>(n);
}

ResultProgress read_progress(const std::string& path) {
  const h5::Id file = h5::open_read(path);
  if (!h5::exists(file, "written")) throw InputError(path + " is not a results file of hawser");
  const h5::Id type = result_count_type();
  const h5::Id count = h5::open_dataset(file, "written");
  ResultProgress p;
  h5::check(H5Dread(count, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &p.count), "counter");
  p.output_times = counted(path, file, "outputs/time", p.count.outputs);
  p.step_times = counted(path, file, "series/time", p.count.steps);
  // The first of `columns` counts the rows of a table at each output.
  const auto rows_at = [&](const char* of_outputs, size_t columns, const char* table, const char* rows_of) {
    std::vector<long long> out;
    if (!h5::exists(file, of_outputs)) return out;
    const h5::Array counts = h5::read_array(file, of_outputs);
    const hsize_t rows = h5::shape_of(h5::open_dataset(file, table))[0];
    for (size_t i = 0; i < p.output_times.size(); ++i) {
      const double n = counts.values[columns * i];
      if (n < 0 || n > static_cast<double>(rows))
        throw damaged(path, fmt::format("at output {} the count is {:g} {}, but there are {} rows", i + 1, n,
                                        rows_of, rows));
      out.push_back(static_cast<long long>(n));
    }
    return out;
  };
  p.clashes = rows_at(kClashCounts, 2, kClashesEnded, "clashes");
  p.contacts = rows_at(kContactCounts, 1, kContactPairs, "points of contact");
  if (!h5::exists(file, checkpoint_slot(kCheckpointSlots - 1))) return p;
  const auto length = [&](const char* part) {
    return static_cast<long long>(h5::shape_of(h5::open_dataset(file, checkpoint_slot(0) + part))[0]);
  };
  p.room.slot_doubles = length("/values");
  p.room.slot_text = length("/index");
  return p;
}

EarlierResults read_earlier(const std::string& path, double time, const ReportedClashes& reported) {
  // Tolerance for rounding: a step ends at the output time up to the last bits.
  const double last = time + 1e-9 * std::max(std::abs(time), 1.0);
  ResultProgress progress = read_progress(path);
  EarlierResults out;
  EarlierRows& rows = out.rows;
  const long long outputs = rows_until(path, "outputs/time", progress.output_times, last);
  rows.kept.count = {outputs, rows_until(path, "series/time", progress.step_times, last)};
  // A failed run has also written clashes that ended after its last output; older checkpoints do not contain
  // which clashes are in another file.
  if (outputs > 0 && !progress.clashes.empty())
    rows.kept.clashes = std::min(reported.ended, progress.clashes[outputs - 1]);
  if (outputs > 0 && !progress.contacts.empty()) rows.kept.contacts = progress.contacts[outputs - 1];
  rows.open_clashes = std::ssize(reported.open);
  rows.slot_doubles = progress.room.slot_doubles;
  rows.slot_text = progress.room.slot_text;
  progress.output_times.resize(outputs);
  out.output_times = std::move(progress.output_times);
  return out;
}

}  // namespace hawser::io
