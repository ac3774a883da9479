// Runs of the whole program inside a test, and the contents of their results files.
#pragma once

#include <gtest/gtest.h>
#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hawser/io/clash_rows.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/run/driver.hpp"

namespace hawser::runs {

inline int rank_of(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}
inline int size_of(MPI_Comm comm) {
  int size = 1;
  MPI_Comm_size(comm, &size);
  return size;
}

// A folder for the files of `test`.
inline std::string folder(const std::string& test) {
  const std::string path = testing::TempDir() + test;
  if (rank_of(MPI_COMM_WORLD) == 0) std::filesystem::create_directories(path);
  MPI_Barrier(MPI_COMM_WORLD);
  return path;
}

using Edits = std::vector<std::pair<std::string, std::string>>;

// Writes `text` to `path` after replacements; each text to replace must be present. Collective.
inline void write_case(const std::string& path, std::string text, const Edits& edits = {}) {
  for (const auto& [from, to] : edits) {
    const size_t at = text.find(from);
    if (at == std::string::npos) throw std::logic_error("the case holds no '" + from + "'");
    text.replace(at, from.size(), to);
  }
  MPI_Barrier(MPI_COMM_WORLD);  // another rank may still be reading the old file
  if (rank_of(MPI_COMM_WORLD) == 0) std::ofstream(path) << text;
  MPI_Barrier(MPI_COMM_WORLD);
}

// The case cases/reel with edits.
inline std::string reel(const std::string& path, Edits edits = {}) {
  const std::string folder = HAWSER_SOURCE_DIR "/cases/reel/";
  std::ostringstream text;
  text << std::ifstream(folder + "reel.yaml").rdbuf();
  edits.push_back({"mesh: drum.stl", "mesh: " + folder + "drum.stl"});
  write_case(path, text.str(), edits);
  return path;
}

struct Run {
  std::string case_path, output;
  std::string restart = {};
  double stop_at = 0;
};

inline void run(MPI_Comm comm, const Run& r) {
  run::RunOptions o;
  o.case_path = r.case_path;
  o.output = r.output;
  o.restart = r.restart;
  o.stop_at = r.stop_at;
  o.quiet = true;
  // Other ranks may be waiting: errors of the case are thrown on all ranks, other errors on one.
  try {
    EXPECT_EQ(run::run(comm, o), 0);
  } catch (const std::logic_error& e) {
    std::cerr << "rank " << rank_of(MPI_COMM_WORLD) << ": " << e.what() << std::endl;
    MPI_Abort(MPI_COMM_WORLD, 1);
  } catch (const std::exception& e) {
    ADD_FAILURE() << e.what();
  }
}
inline void run_on_all(const Run& r) {
  run(MPI_COMM_WORLD, r);
  MPI_Barrier(MPI_COMM_WORLD);
}
// Runs on rank 0 alone; the others wait.
inline void run_on_one(const Run& r) {
  if (rank_of(MPI_COMM_WORLD) == 0) run(MPI_COMM_SELF, r);
  MPI_Barrier(MPI_COMM_WORLD);
}

// The compared contents of a results file: rows of outputs and of series.
struct Results {
  std::vector<double> output_times, step_times;
  std::map<std::string, std::vector<double>> fields;  // outputs, then nodes, then components
  std::map<std::string, std::vector<double>> series;  // steps, then columns; of series by line, lines first
  std::map<std::string, size_t> columns;              // of series
  std::vector<double> summary;                        // value, time, arc length, row after row
  std::vector<double> clash_counts;                   // outputs, then ended and open; empty: no clash report
  std::vector<double> ended, open;                    // clashes at the last output, row after row

  // Column `c` of series `name`.
  std::vector<double> column(const std::string& name, size_t c) const {
    std::vector<double> out;
    const auto& all = series.at(name);
    for (size_t i = c; i < all.size(); i += columns.at(name)) out.push_back(all[i]);
    return out;
  }
};
// Column of a history of a beam point: after position and velocity.
constexpr size_t kTension = 6;

inline herr_t list_names(hid_t, const char* name, const H5L_info_t*, void* to) {
  static_cast<std::vector<std::string>*>(to)->emplace_back(name);
  return 0;
}
inline std::vector<std::string> names_in(hid_t file, const std::string& group) {
  std::vector<std::string> names;
  H5Literate_by_name(file, group.c_str(), H5_INDEX_NAME, H5_ITER_INC, nullptr, list_names, &names,
                     H5P_DEFAULT);
  return names;
}

// Numbers of rows written: of outputs and of steps.
inline std::pair<size_t, size_t> written(hid_t file) {
  const auto set = io::h5::open_dataset(file, "written");
  const auto type = io::h5::own(H5Dget_type(set), H5Tclose, "type");
  long long n[2] = {};
  io::h5::check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, n), "written");
  return {static_cast<size_t>(n[0]), static_cast<size_t>(n[1])};
}

inline std::vector<double> numbers(const std::vector<io::ClashRow>& rows) {
  std::vector<double> out;
  for (const io::ClashRow& r : rows) {
    for (const int i : {r.line, r.other_line, r.volume, r.other_volume}) out.push_back(i);
    out.insert(out.end(), {r.start, r.end, r.from, r.to, r.other_from, r.other_to, r.peak_force, r.peak_time,
                           r.peak_from, r.peak_to, r.impulse, r.peak_energy, r.penetration});
  }
  return out;
}

inline Results read(const std::string& path) {
  using io::h5::read_array;
  const auto file = io::h5::open_read(path);
  Results r;
  const auto [outputs, steps] = written(file);
  const auto take = [](std::vector<double> values, size_t have, size_t rows) {
    values.resize(have ? values.size() / have * rows : 0);
    return values;
  };
  const auto times = read_array(file, "outputs/time");
  r.output_times = take(times.values, times.shape[0], outputs);
  for (const auto& name : names_in(file, "fields")) {
    const auto a = read_array(file, "fields/" + name);
    r.fields[name] = take(a.values, a.shape[0], outputs);
  }
  for (const auto& name : names_in(file, "series")) {
    const auto a = read_array(file, "series/" + name);
    if (name == "time") {
      r.step_times = take(a.values, a.shape[0], steps);
    } else {
      r.series[name] = take(a.values, a.shape[0], steps);
      r.columns[name] = a.shape[1];
    }
  }
  if (io::h5::exists(file, "line_series"))
    for (const auto& name : names_in(file, "line_series")) {
      const auto a = read_array(file, "line_series/" + name);
      r.series[name] = take(a.values, a.shape[0], steps);
      r.columns[name] = a.shape[1] * a.shape[2];
    }
  if (io::h5::exists(file, io::kClashCounts)) {
    const auto a = read_array(file, io::kClashCounts);
    r.clash_counts = take(a.values, a.shape[0], outputs);
    const io::ClashTables clashes = io::read_clashes(path);
    r.ended = numbers(clashes.ended);
    r.open = numbers(clashes.open);
  }
  if (io::h5::exists(file, "summary")) {
    const auto set = io::h5::open_dataset(file, "summary");
    const auto type = io::h5::own(H5Tcreate(H5T_COMPOUND, 24), H5Tclose, "type");
    size_t at = 0;
    for (const char* name : {"value", "time", "arc_length"})
      H5Tinsert(type, name, std::exchange(at, at + 8), H5T_NATIVE_DOUBLE);
    r.summary.resize(3 * io::h5::shape_of(set)[0]);
    io::h5::check(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, r.summary.data()), "summary");
  }
  return r;
}

// The names of the columns of a series: texts of fixed length.
inline std::vector<std::string> columns_of(const std::string& path, const std::string& series) {
  const auto file = io::h5::open_read(path);
  const bool by_line = !io::h5::exists(file, "series/" + series);
  const auto set = io::h5::open_dataset(file, (by_line ? "line_series/" : "series/") + series);
  const auto at = io::h5::own(H5Aopen(set, "columns", H5P_DEFAULT), H5Aclose, "columns");
  const auto type = io::h5::own(H5Aget_type(at), H5Tclose, "type");
  const auto space = io::h5::own(H5Aget_space(at), H5Sclose, "space");
  const size_t n = static_cast<size_t>(H5Sget_simple_extent_npoints(space));
  const size_t width = H5Tget_size(type);
  std::string all(n * width, '\0');
  io::h5::check(H5Aread(at, type, all.data()), "columns");
  std::vector<std::string> names;
  for (size_t i = 0; i < n; ++i) names.emplace_back(std::string(all.data() + i * width, width).c_str());
  return names;
}

// Column of a series by its name; in a series by line, the column of the first line.
inline std::vector<double> named(const std::string& path, const Results& r, const std::string& series,
                                 const std::string& column) {
  const auto names = columns_of(path, series);
  const auto at = std::find(names.begin(), names.end(), column);
  if (at == names.end()) throw std::logic_error("no column " + column);
  return r.column(series, static_cast<size_t>(at - names.begin()));
}

inline double largest(const std::vector<double>& a) {
  double most = 0;
  for (const double x : a) most = std::max(most, std::abs(x));
  return most;
}
// NaN counts as very different from any number.
inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return HUGE_VAL;
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i)
    if (!std::isnan(a[i]) || !std::isnan(b[i]))
      most = std::max(most, std::isnan(a[i] - b[i]) ? HUGE_VAL : std::abs(a[i] - b[i]));
  return most;
}

// The rows of `a` from the first time of `b` on.
inline std::vector<double> tail(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() < b.size()) return {};
  return {a.end() - static_cast<std::ptrdiff_t>(b.size()), a.end()};
}

// The clashes of a restarted run `rest`, in its own file or in the one it continues, are those of `whole`.
inline void expect_same_clashes(const Results& whole, const Results& rest, double tolerance) {
  const auto here = tail(whole.clash_counts, rest.clash_counts);
  ASSERT_EQ(here.size(), rest.clash_counts.size());
  ASSERT_FALSE(here.empty());
  // Clashes that ended before the restart are not in a new file.
  const double before = here[0] - rest.clash_counts[0];
  for (size_t i = 0; i < here.size(); ++i)
    EXPECT_EQ(here[i], rest.clash_counts[i] + (i % 2 ? 0 : before)) << "clashes of output " << i / 2;
  for (const auto& [all, some] :
       {std::pair{tail(whole.ended, rest.ended), rest.ended}, {whole.open, rest.open}}) {
    ASSERT_EQ(all.size(), some.size());
    for (size_t i = 0; i < all.size(); ++i)
      EXPECT_LE(std::abs(all[i] - some[i]), tolerance * std::max(std::abs(all[i]), 0.01))
          << "clash number " << i;
  }
}

}  // namespace hawser::runs
