#include "hawser/io/results.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "hawser/base/error.hpp"
#include "hawser/io/results_build.hpp"
#include "hawser/io/xdmf.hpp"

namespace hawser::io {

namespace {

using Clock = std::chrono::steady_clock;

// What the disk has not yet been told to keep through a power cut is at most this old.
constexpr double kSyncEvery = 10;  // s
// Writing the XDMF text anew takes at most this share of the time.
constexpr double kXdmfShare = 0.02;

double seconds_since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

struct Run {
  hsize_t first = 0, count = 0;
};

std::vector<Run> runs_of(const std::vector<int>& owned) {
  std::vector<Run> runs;
  for (const int node : owned) {
    const auto n = static_cast<hsize_t>(node);
    if (runs.empty() || runs.back().first + runs.back().count != n) runs.push_back({n, 0});
    ++runs.back().count;
  }
  return runs;
}

}  // namespace

struct ResultsFile::Impl {
  MPI_Comm comm = MPI_COMM_NULL;
  int rank = 0;
  std::string path, xdmf_path;
  ResultContents contents;
  std::vector<int> owned;
  std::vector<Run> runs;
  std::vector<RowSet> sets;
  ResultRoom room;
  ResultCount count;
  long long sequence = 0;  // of the newest checkpoint
  std::vector<double> times;
  std::optional<XdmfWriter> xdmf;
  Clock::time_point last_xdmf, last_sync;
  double xdmf_cost = 0;  // s
  bool xdmf_behind = false;

  h5::Id file, collective, count_type;
  std::map<std::string, h5::Id> open;  // datasets; closed before the file
  std::string trouble;                 // first error on this rank since the ranks last agreed

  std::vector<double> step_times;
  std::vector<std::vector<double>> steps;  // by series, this rank's
  std::vector<char> mine;
  std::vector<size_t> columns;   // by series
  std::vector<DrawnMesh> drawn;  // by volume

  static std::unique_ptr<Impl> prepare(MPI_Comm comm, const std::string& path, ResultContents contents,
                                       std::vector<int> owned);
  ~Impl() {
    if (xdmf_behind && rank == 0) attempt([&] { xdmf->save(xdmf_path); });
    close();
  }
  void close() {
    open.clear();
    file.reset();
  }

  // Runs f on this rank; an error is kept for agree(), so that all ranks make the same collective calls.
  template <class F>
  void attempt(F&& f) {
    try {
      f();
    } catch (const std::exception& e) {
      if (trouble.empty()) trouble = e.what();
    }
  }

  // All ranks have done their part, or all throw the first one's error.
  void agree() {
    int size = 0;
    MPI_Comm_size(comm, &size);
    int who = trouble.empty() ? size : rank;
    MPI_Allreduce(MPI_IN_PLACE, &who, 1, MPI_INT, MPI_MIN, comm);
    if (who == size) return;
    auto length = static_cast<int>(trouble.size());
    MPI_Bcast(&length, 1, MPI_INT, who, comm);
    trouble.resize(static_cast<size_t>(length));
    MPI_Bcast(trouble.data(), length, MPI_CHAR, who, comm);
    throw std::runtime_error(std::exchange(trouble, ""));
  }

  // Rank 0 makes the file anew, everybody opens it.
  void build(const ResultRoom& wanted, const std::string& from, const std::vector<SummaryRow>* summary) {
    close();
    bool input = false;
    if (rank == 0) {
      attempt([&] {
        try {
          build_results(path, contents, wanted, from, count, summary);
        } catch (const InputError&) {
          input = true;
          throw;
        }
      });
    }
    MPI_Bcast(&input, 1, MPI_C_BOOL, 0, comm);
    try {
      agree();
    } catch (const std::runtime_error& e) {
      if (input) throw InputError(e.what());
      throw;
    }
    room = wanted;
    if (summary) return;
    attempt([&] { open_all(); });
    agree();
  }

  void open_all() {
    h5::quiet();
    const h5::Id access = h5::own(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "HDF5 property list");
    h5::check(H5Pset_libver_bounds(access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18), "HDF5 property list");
    h5::check(H5Pset_fapl_mpio(access, comm, MPI_INFO_NULL), "HDF5 with MPI");
    file = h5::own(H5Fopen(path.c_str(), H5F_ACC_RDWR, access), H5Fclose, "cannot open " + path);
    collective = h5::own(H5Pcreate(H5P_DATASET_XFER), H5Pclose, "HDF5 property list");
    h5::check(H5Pset_dxpl_mpio(collective, H5FD_MPIO_COLLECTIVE), "HDF5 with MPI");
    count_type = result_count_type();
    const auto keep = [&](const std::string& name) { open[name] = h5::open_dataset(file, name); };
    keep("written");
    for (const auto& s : sets) keep(s.name);
    if (room.slot_doubles)
      for (const std::string slot : {"checkpoint/0/", "checkpoint/1/"})
        keep(slot + "header"), keep(slot + "index"), keep(slot + "values");
  }

  void ensure_room(long long outputs, long long steps_wanted, long long doubles = 0, long long text = 0) {
    ResultRoom wanted = room;
    const auto grow = [](long long& have, long long need, long long spare) {
      if (need > have) have = std::max(2 * have, need + spare);
    };
    grow(wanted.outputs, outputs, 0);
    grow(wanted.steps, steps_wanted, 0);
    grow(wanted.slot_doubles, doubles, doubles / 2);
    grow(wanted.slot_text, text, text);
    if (wanted.outputs != room.outputs || wanted.steps != room.steps ||
        wanted.slot_doubles != room.slot_doubles || wanted.slot_text != room.slot_text)
      build(wanted, path, nullptr);
  }

  // Collective write of a selection of the file: the runs along one dimension, at a row or without rows.
  template <class R>
  void write_runs(const std::string& name, hid_t type, long long row, const std::vector<R>& where,
                  const void* data) {
    const hid_t set = open.at(name);
    const h5::Shape shape = h5::shape_of(set);
    const size_t axis = row >= 0 ? 1 : 0;
    h5::Shape start(shape.size(), 0), block(shape);
    hsize_t total = 0, inner = 1;
    for (size_t i = axis + 1; i < shape.size(); ++i) inner *= shape[i];
    if (row >= 0) start[0] = static_cast<hsize_t>(row), block[0] = 1;
    const h5::Id space = h5::own(H5Dget_space(set), H5Sclose, name);
    h5::check(H5Sselect_none(space), name);
    for (const auto& run : where) {
      start[axis] = static_cast<hsize_t>(run.first), block[axis] = static_cast<hsize_t>(run.count);
      const H5S_seloper_t how = total == 0 ? H5S_SELECT_SET : H5S_SELECT_OR;
      h5::check(H5Sselect_hyperslab(space, how, start.data(), nullptr, block.data(), nullptr), name);
      total += block[axis] * inner;
    }
    transfer(set, type, space, total, data, name);
  }

  // Collective write of `rows` whole rows; only the rank with `here` has them.
  void write_rows(const std::string& name, hid_t type, long long first, long long rows, bool here,
                  const void* data) {
    const hid_t set = open.at(name);
    h5::Shape count_of = h5::shape_of(set), start(count_of.size(), 0);
    start[0] = static_cast<hsize_t>(first), count_of[0] = static_cast<hsize_t>(rows);
    hsize_t total = 1;
    for (const hsize_t n : count_of) total *= n;
    const h5::Id space = h5::own(H5Dget_space(set), H5Sclose, name);
    if (here && total)
      h5::check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count_of.data(), nullptr),
                name);
    else
      h5::check(H5Sselect_none(space), name), total = 0;
    transfer(set, type, space, total, data, name);
  }

  void transfer(hid_t set, hid_t type, hid_t space, hsize_t n, const void* data, const std::string& name) {
    const hsize_t length = std::max<hsize_t>(n, 1);
    const h5::Id memory = h5::own(H5Screate_simple(1, &length, nullptr), H5Sclose, name);
    if (n == 0) h5::check(H5Sselect_none(memory), name);
    const double nothing = 0;
    h5::check(H5Dwrite(set, type, memory, space, collective, n ? data : &nothing), "cannot write " + path);
  }

  // The rows become results: every rank's bytes are with the system before the counter is.
  void commit(const ResultCount& next) {
    agree();
    if (rank == 0)
      attempt([&] {
        h5::check(H5Dwrite(open.at("written"), count_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, &next),
                  "cannot write " + path);
      });
    agree();
    count = next;
    int due = rank == 0 && seconds_since(last_sync) > kSyncEvery;
    MPI_Bcast(&due, 1, MPI_INT, 0, comm);
    if (!due) return;
    attempt([&] { h5::check(H5Fflush(file, H5F_SCOPE_LOCAL), "cannot write " + path); });
    agree();
    last_sync = Clock::now();
  }

  // Rows of the series in memory to the file, not yet counted. Returns how many.
  long long write_steps() {
    const auto n = static_cast<long long>(step_times.size());
    std::vector<int> owners(mine.begin(), mine.end());
    MPI_Allreduce(MPI_IN_PLACE, owners.data(), static_cast<int>(owners.size()), MPI_INT, MPI_SUM, comm);
    if (n > 0)
      for (const int k : owners)
        if (k != 1) throw std::logic_error("results: a series must come from exactly one rank");
    ensure_room(count.outputs, count.steps + n);
    if (n == 0) return 0;
    attempt(
        [&] { write_rows("series/time", H5T_NATIVE_DOUBLE, count.steps, n, rank == 0, step_times.data()); });
    const auto places = series_places(contents);
    for (size_t s = 0; s < places.size(); ++s)
      attempt([&] { write_rows(places[s], H5T_NATIVE_DOUBLE, count.steps, n, mine[s], steps[s].data()); });
    return n;
  }

  void forget_steps() {
    step_times.clear();
    for (auto& s : steps) s.clear();
  }

  void write_bodies(long long row, std::span<const BodyPose> poses) {
    std::vector<double> position, rotation;
    for (const auto& p : poses) {
      position.insert(position.end(), {p.position.x(), p.position.y(), p.position.z()});
      rotation.insert(rotation.end(), {p.rotation.w(), p.rotation.x(), p.rotation.y(), p.rotation.z()});
    }
    attempt([&] { write_rows("bodies/position", H5T_NATIVE_DOUBLE, row, 1, rank == 0, position.data()); });
    attempt([&] { write_rows("bodies/rotation", H5T_NATIVE_DOUBLE, row, 1, rank == 0, rotation.data()); });
    const auto places = volume_places(contents);
    for (size_t i = 0; i < places.size(); ++i) {
      if (!drawn[i].moves) continue;
      std::vector<float> moved;
      if (rank == 0) {
        const BodyPose& pose = poses[static_cast<size_t>(contents.volumes[i].body)];
        const Mat3 turn = pose.rotation.toRotationMatrix();
        for (const auto& v : drawn[i].vertices) {
          const Eigen::Vector3f x = (pose.position + turn * v).cast<float>();
          moved.insert(moved.end(), {x.x(), x.y(), x.z()});
        }
      }
      attempt([&] { write_rows(places[i] + "/moved", H5T_NATIVE_FLOAT, row, 1, rank == 0, moved.data()); });
    }
  }

  void save_xdmf(bool always) {
    if (rank == 0 && contents.xdmf && (always || seconds_since(last_xdmf) * kXdmfShare > xdmf_cost)) {
      const auto start = Clock::now();
      attempt([&] { xdmf->save(xdmf_path); });
      xdmf_behind = false;
      xdmf_cost = seconds_since(start);
      last_xdmf = Clock::now();
    }
    agree();
  }
};

namespace {

void check_contents(const ResultContents& c) {
  if (c.fields.empty() || c.fields[0].name != "position" || c.fields[0].components != 3)
    throw std::logic_error("results: the first field must be position");
  int next = 0;
  for (const auto& line : c.lines) {
    if (line.first_node != next || line.arc.size() != static_cast<size_t>(line.nodes))
      throw std::logic_error("results: the nodes of line " + line.name + " are not in file order");
    next += line.nodes;
  }
  for (const auto& v : c.volumes)
    if (v.body >= static_cast<int>(c.bodies.size()))
      throw std::logic_error("results: volume " + v.name + " moves with a body that is not there");
}

}  // namespace

std::unique_ptr<ResultsFile::Impl> ResultsFile::Impl::prepare(MPI_Comm comm, const std::string& path,
                                                              ResultContents contents,
                                                              std::vector<int> owned) {
  check_contents(contents);
  auto impl = std::make_unique<Impl>();
  auto& m = *impl;
  m.comm = comm, m.path = path, m.contents = std::move(contents), m.owned = std::move(owned);
  MPI_Comm_rank(comm, &m.rank);
  m.runs = runs_of(m.owned);
  m.sets = row_sets(m.contents);
  const size_t slash = path.rfind('/'), name = slash == std::string::npos ? 0 : slash + 1;
  const size_t dot = path.rfind('.');
  m.xdmf_path = path.substr(0, dot == std::string::npos || dot < name ? path.size() : dot) + ".xdmf";
  m.xdmf.emplace(m.contents, path.substr(name));
  m.steps.resize(m.contents.series.size());
  m.mine.resize(m.contents.series.size());
  for (const auto& s : m.contents.series) {
    size_t n = 0;
    for (const auto& col : s.columns) n += static_cast<size_t>(col.components);
    m.columns.push_back(n);
  }
  for (const auto& v : m.contents.volumes) m.drawn.push_back(drawn_mesh(v, m.contents.moving_vertices));
  return impl;
}

ResultsFile::ResultsFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ResultsFile::ResultsFile(ResultsFile&&) noexcept = default;
ResultsFile& ResultsFile::operator=(ResultsFile&&) noexcept = default;
ResultsFile::~ResultsFile() = default;

ResultsFile ResultsFile::create(MPI_Comm comm, const std::string& path, ResultContents contents,
                                std::vector<int> owned) {
  auto impl = Impl::prepare(comm, path, std::move(contents), std::move(owned));
  auto& m = *impl;
  try {
    m.build({std::max(m.contents.expected_outputs, 1), std::max(m.contents.expected_steps, 1), 0, 0}, "",
            nullptr);
    m.save_xdmf(true);
  } catch (const std::runtime_error& e) {
    throw InputError(e.what());
  }
  return ResultsFile(std::move(impl));
}

ResultsFile ResultsFile::resume(MPI_Comm comm, const std::string& path, ResultContents contents,
                                std::vector<int> owned, double time) {
  ResultProgress progress;
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  std::string error;
  if (rank == 0) {
    try {
      progress = read_progress(path);
    } catch (const std::exception& e) {
      error = e.what();
    }
  }
  int failed = !error.empty();
  MPI_Bcast(&failed, 1, MPI_INT, 0, comm);
  if (failed) throw InputError(rank == 0 ? error : "cannot read " + path);
  // Times are compared with room for rounding: a step ends on the output time to the last few bits.
  const double last = time + 1e-9 * std::max(std::abs(time), 1.0);
  const auto until = [&](const std::vector<double>& t) {
    return static_cast<long long>(std::upper_bound(t.begin(), t.end(), last) - t.begin());
  };
  long long n[5] = {until(progress.output_times), until(progress.step_times), 0, 0, 0};
  if (rank == 0) {
    const h5::Id file = h5::open_read(path);
    if (h5::exists(file, "checkpoint/1")) {
      n[2] = static_cast<long long>(h5::shape_of(h5::open_dataset(file, "checkpoint/0/values"))[0]);
      n[3] = static_cast<long long>(h5::shape_of(h5::open_dataset(file, "checkpoint/0/index"))[0]);
      for (const char* slot : {"checkpoint/0/header", "checkpoint/1/header"})
        n[4] = std::max(n[4], static_cast<long long>(h5::read_array(file, slot).values[0]));
    }
  }
  MPI_Bcast(n, 5, MPI_LONG_LONG, 0, comm);
  progress.output_times.resize(static_cast<size_t>(n[0]));
  MPI_Bcast(progress.output_times.data(), static_cast<int>(n[0]), MPI_DOUBLE, 0, comm);

  auto impl = Impl::prepare(comm, path, std::move(contents), std::move(owned));
  impl->count = {n[0], n[1]};
  impl->times = progress.output_times;
  if (rank == 0)
    for (const double t : impl->times) impl->xdmf->add(t);
  impl->sequence = n[4];
  impl->build({std::max<long long>(impl->contents.expected_outputs, n[0] + 1),
               std::max<long long>(impl->contents.expected_steps, n[1] + 1), n[2], n[3]},
              path, nullptr);
  impl->save_xdmf(true);
  return ResultsFile(std::move(impl));
}

void ResultsFile::append_series(double time, const std::vector<std::vector<double>>& values) {
  auto& m = *impl_;
  if (values.size() != m.steps.size()) throw std::logic_error("results: one row a series");
  m.step_times.push_back(time);
  for (size_t s = 0; s < values.size(); ++s) {
    if (values[s].empty()) continue;
    if (values[s].size() != m.columns[s]) throw std::logic_error("results: wrong columns in a series");
    m.mine[s] = 1;
    m.steps[s].insert(m.steps[s].end(), values[s].begin(), values[s].end());
  }
}

void ResultsFile::write_output(double time, const std::vector<std::vector<double>>& fields,
                               std::span<const BodyPose> poses) {
  auto& m = *impl_;
  const auto& c = m.contents;
  m.attempt([&] {
    if (fields.size() != c.fields.size() || poses.size() != c.bodies.size())
      throw std::logic_error("results: fields or poses missing from an output");
    for (size_t i = 0; i < fields.size(); ++i)
      if (fields[i].size() != m.owned.size() * static_cast<size_t>(c.fields[i].components))
        throw std::logic_error("results: field " + c.fields[i].name + " has the wrong size");
  });
  m.agree();
  m.ensure_room(m.count.outputs + 1, 0);
  const long long steps = m.write_steps(), row = m.count.outputs;
  m.attempt([&] { m.write_rows("outputs/time", H5T_NATIVE_DOUBLE, row, 1, m.rank == 0, &time); });
  for (size_t i = 0; i < fields.size(); ++i)
    m.attempt([&] {
      m.write_runs("fields/" + safe_name(c.fields[i].name), H5T_NATIVE_DOUBLE, row, m.runs, fields[i].data());
    });
  m.write_bodies(row, poses);
  m.commit({row + 1, m.count.steps + steps});
  m.forget_steps();
  m.times.push_back(time);
  if (m.rank == 0) m.xdmf->add(time);
  m.xdmf_behind = m.contents.xdmf;
  m.save_xdmf(false);
}

void ResultsFile::write_checkpoint(const Checkpoint& checkpoint) {
  auto& m = *impl_;
  const PackedCheckpoint p = pack_checkpoint(m.comm, checkpoint, m.contents.nodes_total(), m.owned);
  const auto text = static_cast<long long>(p.index.size());
  m.ensure_room(0, 0, p.size, text);
  // The slot that does not hold the newest one; its header, written last, makes it the newest.
  const long long sequence = m.sequence + 1;
  const std::string slot = sequence % 2 ? "checkpoint/1/" : "checkpoint/0/";
  std::vector<Run> index;
  if (m.rank == 0) index.push_back({0, p.index.size()});
  m.attempt([&] { m.write_runs(slot + "index", H5T_NATIVE_CHAR, -1, index, p.index.data()); });
  m.attempt([&] { m.write_runs(slot + "values", H5T_NATIVE_DOUBLE, -1, p.runs, p.values.data()); });
  m.agree();
  const std::uint64_t header[4] = {static_cast<std::uint64_t>(sequence), static_cast<std::uint64_t>(p.size),
                                   static_cast<std::uint64_t>(text),
                                   checkpoint_sum(p.index, sequence, p.size) + p.checksum};
  m.attempt([&] { m.write_rows(slot + "header", H5T_NATIVE_UINT64, 0, 4, m.rank == 0, header); });
  m.agree();
  m.sequence = sequence;
}

void ResultsFile::finish(const std::vector<SummaryRow>& summary) {
  auto& m = *impl_;
  const long long steps = m.write_steps();
  m.commit({m.count.outputs, m.count.steps + steps});
  m.forget_steps();
  m.build({std::max<long long>(m.count.outputs, 1), std::max<long long>(m.count.steps, 1),
           m.room.slot_doubles, m.room.slot_text},
          m.path, &summary);
  m.save_xdmf(true);
}

long long ResultsFile::outputs() const { return impl_->count.outputs; }
const std::vector<double>& ResultsFile::times() const { return impl_->times; }
const ResultContents& ResultsFile::contents() const { return impl_->contents; }
const std::string& ResultsFile::path() const { return impl_->path; }
std::string ResultsFile::xdmf_path() const { return impl_->xdmf_path; }

}  // namespace hawser::io
