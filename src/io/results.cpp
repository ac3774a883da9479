// The class ResultsFile: creation and continuation of a results file, growth of its capacity, and writing of
// series, outputs, clashes and checkpoints, each valid only when complete.
#include "hawser/io/results.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/base/share_of_time.hpp"
#include "hawser/io/old_results.hpp"
#include "hawser/io/results_build.hpp"
#include "hawser/io/results_progress.hpp"
#include "hawser/io/results_rows.hpp"
#include "hawser/io/xdmf.hpp"
#include "waiting_outputs.hpp"

namespace hawser::io {

namespace {

using Clock = std::chrono::steady_clock;

// Largest age of unflushed data, at risk in a power failure.
constexpr std::chrono::seconds kFlushEvery{10};
// Largest fractions of the run time for rewriting the XDMF text and for writing outputs.
constexpr double kXdmfShare = 0.02, kOutputShare = 0.05;
// Larger waiting outputs of a rank are written at once: up to this size they stay in the processor's cache,
// and the cost is that of the numbers, not of the calls.
constexpr size_t kMostWaiting = 250'000;  // numbers

}  // namespace

struct ResultsFile::Impl {
  SharedFile file;
  ResultContents contents;
  std::vector<int> owned;
  std::ptrdiff_t line_nodes;  // number of line nodes among them
  std::vector<RowRun> runs;
  std::vector<int> ends;                    // owned; number 2 l is end A of line l, 2 l + 1 its end B
  std::vector<RowRun> end_runs, line_runs;  // line_runs: of lines whose first node is owned
  ResultRoom room;
  ValidRows written;
  long long sequence = 0;  // of the newest checkpoint

  std::string xdmf_path;
  std::optional<XdmfWriter> xdmf;  // on rank 0
  Clock::time_point last_flush;
  ShareOfTime xdmf_time{kXdmfShare}, output_time{kOutputShare};
  bool xdmf_behind = false;

  WaitingOutputs waiting;

  std::vector<double> step_times;          // of the series rows that wait for the next output
  std::vector<std::vector<double>> steps;  // by series, of this rank
  std::vector<char> of_this_rank;
  std::vector<size_t> columns;  // by series, numbers per step

  Impl(MPI_Comm comm, const std::string& path, ResultContents contents, std::vector<int> owned);
  ~Impl() {
    if (xdmf_behind && root()) file.attempt([&] { xdmf->save(xdmf_path); });
  }
  bool root() const { return file.rank() == 0; }
  // True for volumes that are written at every output, for ParaView alone; fixed ones are written once.
  bool displayed(const VolumeMesh& v) const { return v.moves() && contents.xdmf; }

  // Rank 0 creates the file, all ranks open it.
  void build(const ResultRoom& required, const std::string& from, const ResultLast* last = nullptr) {
    file.close();
    bool input = false;
    if (root()) {
      file.attempt([&] {
        try {
          build_results(file.path(), contents, required, from, written, last);
        } catch (const InputError&) {
          input = true;
          throw;
        }
      });
    }
    MPI_Bcast(&input, 1, MPI_C_BOOL, 0, file.comm());
    try {
      file.agree();
    } catch (const std::runtime_error& e) {
      if (input) throw InputError(e.what());
      throw;
    }
    room = required;
    if (last && last->summary) return;
    std::vector<std::string> names{"written"};
    for (const auto& set : row_sets(contents)) names.push_back(set.name);
    if (contents.clashes) names.insert(names.end(), {kClashesEnded, kClashesOpen});
    if (room.slot_doubles)
      for (long long k = 0; k < kCheckpointSlots; ++k)
        for (const char* part : {"/header", "/index", "/values"}) names.push_back(checkpoint_slot(k) + part);
    file.open(names);
  }

  void ensure_room(long long outputs, long long step_rows, long long doubles = 0, long long text = 0,
                   const ClashRoom& clash_rows = {}, long long contact_rows = 0) {
    ResultRoom required = room;
    const auto grow = [](long long& have, long long need, long long spare) {
      if (need > have) have = std::max(2 * have, need + spare);
    };
    grow(required.outputs, outputs, 0);
    grow(required.steps, step_rows, 0);
    grow(required.slot_doubles, doubles, doubles / 2);
    grow(required.slot_text, text, text);
    grow(required.clashes.ended, clash_rows.ended, 0);
    grow(required.clashes.open, clash_rows.open, 0);
    grow(required.contacts, contact_rows, 0);
    if (required.outputs != room.outputs || required.steps != room.steps ||
        required.slot_doubles != room.slot_doubles || required.slot_text != room.slot_text ||
        required.clashes != room.clashes || required.contacts != room.contacts)
      build(required, file.path());
  }

  // Validates the rows: every rank's data are with the system before the counter is.
  void commit(const ResultCount& next) {
    file.agree();
    if (root()) file.write_alone("written", result_count_type(), &next);
    file.agree();
    written.count = next;
    int due = root() && Clock::now() - last_flush > kFlushEvery;
    MPI_Bcast(&due, 1, MPI_INT, 0, file.comm());
    if (!due) return;
    file.flush();
    file.agree();
    last_flush = Clock::now();
  }

  // Writes the series rows in memory up to that time [s], not yet validated. Returns their number.
  long long write_steps(double until = HUGE_VAL) {
    const double last = until + 1e-9 * std::max(std::abs(until), 1.0);
    const auto n = std::upper_bound(step_times.begin(), step_times.end(), last) - step_times.begin();
    std::vector<int> owners(of_this_rank.begin(), of_this_rank.end());
    all_reduce(file.comm(), MPI_SUM, owners);
    if (n > 0)
      for (const int k : owners)
        if (k != 1) throw std::logic_error("results: a series must come from exactly one rank");
    ensure_room(written.count.outputs, written.count.steps + n);
    if (n == 0) return 0;
    const long long row = written.count.steps;
    file.write_rows("series/time", H5T_NATIVE_DOUBLE, row, n, root(), step_times.data());
    const auto places = series_places(contents);
    for (size_t s = 0; s < places.size(); ++s)
      if (contents.series[s].by_line)
        file.write_runs(places[s], H5T_NATIVE_DOUBLE, row, line_runs, steps[s].data(), n);
      else
        file.write_rows(places[s], H5T_NATIVE_DOUBLE, row, n, of_this_rank[s], steps[s].data());
    return n;
  }

  void forget_steps(long long n) {
    step_times.erase(step_times.begin(), step_times.begin() + n);
    for (size_t s = 0; s < steps.size(); ++s)
      if (!steps[s].empty())
        steps[s].erase(steps[s].begin(), steps[s].begin() + n * static_cast<long long>(columns[s]));
  }

  // Numbers of rows of the clash tables, the same on all ranks.
  ClashRoom rows_of(size_t ended, size_t open) const {
    long long n[2] = {static_cast<long long>(ended), static_cast<long long>(open)};
    MPI_Bcast(n, 2, MPI_LONG_LONG, 0, file.comm());
    return {n[0], n[1]};
  }
  // Clashes of the outputs from `row` on; ongoing ones only of the last output.
  void write_clashes(long long row, const std::vector<ClashTables>& tables, const ClashRoom& rows) {
    const h5::Id type = clash_type();
    std::vector<ClashRow> all;
    std::vector<long long> counts;
    for (const ClashTables& t : tables) {
      all.insert(all.end(), t.ended.begin(), t.ended.end());
      counts.push_back(written.clashes + static_cast<long long>(all.size()));
      counts.push_back(static_cast<long long>(t.open.size()));
    }
    const long long n = static_cast<long long>(tables.size());
    std::vector<RowRun> ended, open;
    if (root() && rows.ended) ended.push_back({written.clashes, rows.ended});
    if (root() && rows.open) open.push_back({0, rows.open});
    if (rows.ended) file.write_runs(kClashesEnded, type, -1, ended, all.data());
    if (rows.open) file.write_runs(kClashesOpen, type, (row + n - 1) % 2, open, tables.back().open.data());
    file.write_rows(kClashCounts, H5T_NATIVE_LLONG, row, n, root(), counts.data());
  }

  void wait(std::span<const BodyPose> poses) {
    for (const auto& p : root() ? poses : std::span<const BodyPose>()) {
      waiting.position.insert(waiting.position.end(), {p.position.x(), p.position.y(), p.position.z()});
      waiting.rotation.insert(waiting.rotation.end(),
                              {p.rotation.w(), p.rotation.x(), p.rotation.y(), p.rotation.z()});
    }
    waiting.moved.resize(contents.volumes.size());
    for (size_t i = 0; i < contents.volumes.size(); ++i) {
      const VolumeMesh& mesh = contents.volumes[i];
      if (!displayed(mesh) || !root()) continue;
      const BodyPose& pose = poses[mesh.body];
      const Mat3 turn = pose.rotation.toRotationMatrix();
      for (const Vec3& v : mesh.displayed_vertices()) {
        const Eigen::Vector3f x = (pose.position + turn * v).cast<float>();
        waiting.moved[i].insert(waiting.moved[i].end(), {x.x(), x.y(), x.z()});
      }
    }
  }

  // Writes the waiting outputs and the series so far.
  void write_waiting() {
    while (!waiting.times.empty()) {
      // The two tables of ongoing clashes alternate with the parity of the output. An odd number of outputs
      // is written at a time, so the table of the last output in the file is valid after a kill.
      const size_t all = waiting.times.size();
      const WaitingOutputs w = waiting.take(contents.clashes && all % 2 == 0 ? all - 1 : all);
      write(w, w.fields, w.ends);
    }
  }
  // nodes, at_ends: values of all these outputs, as in WaitingOutputs.
  void write(const WaitingOutputs& w, std::span<const std::vector<double>> nodes,
             std::span<const std::vector<double>> at_ends) {
    const long long n = static_cast<long long>(w.times.size());
    const long long row = written.count.outputs;
    ClashRoom rows{0, 0};
    if (contents.clashes) {
      size_t ended = 0;
      for (const ClashTables& t : w.clashes) ended += t.ended.size();
      rows = rows_of(ended, w.clashes.back().open.size());
    }
    ContactPlaces points;
    if (contents.contact_points) points = contact_places(file.comm(), w.contacts, written.contacts);
    ensure_room(row + n, 0, 0, 0, {written.clashes + rows.ended, rows.open}, points.last);
    const long long rows_of_steps = write_steps(w.times.back());
    file.write_rows("outputs/time", H5T_NATIVE_DOUBLE, row, n, root(), w.times.data());
    for (size_t i = 0; i < nodes.size(); ++i)
      file.write_runs(field_place(contents.fields[i]), H5T_NATIVE_DOUBLE, row, runs, nodes[i].data(), n);
    for (size_t i = 0; i < at_ends.size(); ++i)
      file.write_runs("ends/" + contents.end_fields[i].name, H5T_NATIVE_DOUBLE, row, end_runs,
                      at_ends[i].data(), n);
    file.write_rows("bodies/position", H5T_NATIVE_DOUBLE, row, n, root(), w.position.data());
    file.write_rows("bodies/rotation", H5T_NATIVE_DOUBLE, row, n, root(), w.rotation.data());
    const auto places = volume_places(contents);
    for (size_t i = 0; i < places.size(); ++i)
      if (displayed(contents.volumes[i]))
        file.write_rows(places[i] + "/moved", H5T_NATIVE_FLOAT, row, n, root(), w.moved[i].data());
    if (contents.clashes) write_clashes(row, w.clashes, rows);
    if (contents.contact_points) write_contacts(file, row, w.contacts, points);
    commit({row + n, written.count.steps + rows_of_steps});
    written.clashes += rows.ended;
    written.contacts = points.last;
    forget_steps(rows_of_steps);
    if (root())
      for (const double t : w.times) xdmf->add(t);
    xdmf_behind = contents.xdmf;
  }

  void save_xdmf(bool always) {
    if (root() && contents.xdmf && (always || xdmf_time.due())) {
      xdmf_time.spend([&] { file.attempt([&] { xdmf->save(xdmf_path); }); });
      xdmf_behind = false;
    }
    file.agree();
  }
};

ResultsFile::Impl::Impl(MPI_Comm comm, const std::string& path, ResultContents result_contents,
                        std::vector<int> nodes)
    : file(comm, path),
      contents(std::move(result_contents)),
      owned(std::move(nodes)),
      line_nodes(std::lower_bound(owned.begin(), owned.end(), contents.nodes_total()) - owned.begin()),
      runs(runs_of({owned.begin(), owned.begin() + line_nodes})) {
  check_contents(contents, root());
  std::vector<int> lines;  // whose first node is owned
  int first = 0;           // node of the line
  for (size_t l = 0; l < contents.line_nodes.size(); ++l) {
    for (const int end : {0, 1}) {
      const int node = first + (end ? contents.line_nodes[l] - 1 : 0);
      if (!std::binary_search(owned.begin(), owned.end(), node)) continue;
      ends.push_back(2 * static_cast<int>(l) + end);
      if (end == 0) lines.push_back(static_cast<int>(l));
    }
    first += contents.line_nodes[l];
  }
  end_runs = runs_of(ends);
  line_runs = runs_of(lines);
  const size_t slash = path.rfind('/');
  const size_t name = slash == std::string::npos ? 0 : slash + 1;
  xdmf_path = xdmf_beside(path);
  if (root()) xdmf.emplace(contents, path.substr(name));
  steps.resize(contents.series.size());
  for (const auto& s : contents.series) {
    of_this_rank.push_back(s.by_line && root());
    columns.push_back(static_cast<size_t>(numbers_in_row(s)) * (s.by_line ? lines.size() : 1));
  }
}

ResultsFile::ResultsFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ResultsFile::ResultsFile(ResultsFile&&) noexcept = default;
ResultsFile& ResultsFile::operator=(ResultsFile&&) noexcept = default;
ResultsFile::~ResultsFile() = default;

ResultsFile ResultsFile::create(MPI_Comm comm, const std::string& path, ResultContents contents,
                                std::vector<int> owned) {
  auto impl = std::make_unique<Impl>(comm, path, std::move(contents), std::move(owned));
  auto& m = *impl;
  const ResultContents& c = m.contents;
  m.build({std::max(c.expected_outputs, 1), std::max(c.expected_steps, 1), 0, 0, {}, contact_room(c)}, "");
  m.save_xdmf(true);
  return ResultsFile(std::move(impl));
}

namespace {

// Capacity of a file that continues with the contents.
ResultRoom room_after(const EarlierRows& earlier, const ResultContents& c) {
  constexpr long long kFewestClashes = 64;
  const ValidRows& kept = earlier.kept;
  return {std::max<long long>(c.expected_outputs, kept.count.outputs + 1),
          std::max<long long>(c.expected_steps, kept.count.steps + 1),
          earlier.slot_doubles,
          earlier.slot_text,
          {std::max(kFewestClashes, 2 * kept.clashes), std::max(kFewestClashes, 2 * earlier.open_clashes)},
          std::max(contact_room(c), 2 * kept.contacts)};
}

}  // namespace

ResultsFile ResultsFile::resume(MPI_Comm comm, const std::string& path, ResultContents contents,
                                std::vector<int> owned, double time, long long sequence,
                                const ReportedClashes& reported) {
  EarlierResults earlier;
  on_root(comm, [&] {
    try {
      earlier = read_earlier(path, time, reported);
    } catch (const std::exception& e) {
      throw InputError(e.what());
    }
  });
  const EarlierRows& rows = earlier.rows;
  static_assert(is_plain_data<EarlierRows>);
  MPI_Bcast(&earlier.rows, sizeof earlier.rows, MPI_BYTE, 0, comm);
  const long long outputs = rows.kept.count.outputs;
  earlier.output_times.resize(outputs);
  MPI_Bcast(earlier.output_times.data(), static_cast<int>(outputs), MPI_DOUBLE, 0, comm);

  auto impl = std::make_unique<Impl>(comm, path, std::move(contents), std::move(owned));
  auto& m = *impl;
  m.written = rows.kept;
  m.sequence = sequence;
  if (m.root())
    for (const double t : earlier.output_times) m.xdmf->add(t);
  const ClashTables clashes{{}, reported.open};
  const ResultLast last{clashes};
  m.build(room_after(rows, m.contents), path, &last);
  m.save_xdmf(true);
  return ResultsFile(std::move(impl));
}

void ResultsFile::append_series(double time, const std::vector<std::vector<double>>& values) {
  auto& m = *impl_;
  if (values.size() != m.steps.size()) throw std::logic_error("results: one row a series");
  m.step_times.push_back(time);
  for (size_t s = 0; s < values.size(); ++s) {
    const bool by_line = m.contents.series[s].by_line;
    if (values[s].empty() && !by_line) continue;
    if (values[s].size() != m.columns[s]) throw std::logic_error("results: wrong columns in a series");
    if (!by_line) m.of_this_rank[s] = 1;
    m.steps[s].insert(m.steps[s].end(), values[s].begin(), values[s].end());
  }
}

void ResultsFile::write_output(double time, const std::vector<std::vector<double>>& fields,
                               std::span<const BodyPose> poses, const ClashTables& clashes,
                               const std::vector<std::vector<double>>& ends, const ContactRows& contacts) {
  auto& m = *impl_;
  const auto& c = m.contents;
  m.file.attempt([&] {
    if (fields.size() != c.fields.size() || std::ssize(poses) != c.bodies)
      throw std::logic_error("results: fields or poses missing from an output");
    for (size_t i = 0; i < fields.size(); ++i)
      if (fields[i].size() != m.owned.size() * static_cast<size_t>(c.fields[i].components))
        throw std::logic_error("results: field " + c.fields[i].name + " has the wrong size");
    if (ends.size() != c.end_fields.size()) throw std::logic_error("results: fields of ends are missing");
    for (size_t i = 0; i < ends.size(); ++i)
      if (ends[i].size() != m.ends.size() * static_cast<size_t>(c.end_fields[i].components))
        throw std::logic_error("results: field " + c.end_fields[i].name + " of ends has the wrong size");
  });
  m.file.agree();
  WaitingOutputs& w = m.waiting;
  size_t numbers = w.size();
  for (const auto& f : fields) numbers += f.size();
  numbers += kContactNumbers * contacts.size();
  const bool now = on_any_rank(m.file.comm(), (m.root() && m.output_time.due()) || numbers > kMostWaiting);
  const bool alone = now && w.times.empty();  // written directly, without a copy
  w.times.push_back(time);
  w.clashes.push_back(clashes);
  w.contacts.push_back(contacts);
  m.wait(poses);
  if (!alone) {
    w.fields.resize(fields.size());
    w.ends.resize(ends.size());
    // Body nodes come after the line nodes and have no rows.
    for (size_t i = 0; i < fields.size(); ++i) {
      const auto last = fields[i].begin() + m.line_nodes * c.fields[i].components;
      w.fields[i].insert(w.fields[i].end(), fields[i].begin(), last);
    }
    for (size_t i = 0; i < ends.size(); ++i)
      w.ends[i].insert(w.ends[i].end(), ends[i].begin(), ends[i].end());
  }
  if (!now) return;
  m.output_time.spend([&] {
    if (alone)
      m.write(std::exchange(w, {}), fields, ends);
    else
      m.write_waiting();
  });
  m.save_xdmf(false);
}

void ResultsFile::write_checkpoint(Checkpoint checkpoint) {
  auto& m = *impl_;
  m.write_waiting();  // a continued run keeps all earlier outputs
  const int nodes = m.contents.nodes_total() + m.contents.body_nodes;
  const CheckpointRoom need = checkpoint_room(m.file.comm(), checkpoint, nodes, m.owned);
  const auto text = static_cast<long long>(need.index.size());
  m.ensure_room(0, 0, need.size, text);
  // Uses the slot without the newest checkpoint; its header, written last, makes it the newest.
  const long long sequence = m.sequence + 1;
  const std::string slot = checkpoint_slot(sequence);
  std::vector<RowRun> index;
  if (m.root()) index.push_back({0, text});
  m.file.write_runs(slot + "/index", H5T_NATIVE_CHAR, -1, index, need.index.data());
  const auto sum = write_checkpoint_array(
      m.file.comm(), std::move(checkpoint), need, nodes, m.owned,
      [&](const std::vector<RowRun>& runs, const std::vector<double>& values) {
        m.file.write_runs(slot + "/values", H5T_NATIVE_DOUBLE, -1, runs, values.data());
      });
  m.file.agree();
  const CheckpointHeader header{.sequence = static_cast<std::uint64_t>(sequence),
                                .size = static_cast<std::uint64_t>(need.size),
                                .text = static_cast<std::uint64_t>(text),
                                .sum = checkpoint_sum(need.index, sequence, need.size) + sum};
  m.file.write_rows(slot + "/header", H5T_NATIVE_UINT64, 0, 4, m.root(), &header);
  m.file.agree();
  m.sequence = sequence;
}

void ResultsFile::write_statistics(size_t field, const std::vector<double>& values) {
  auto& m = *impl_;
  // Body nodes come after the line nodes and have no rows.
  m.file.write_runs(statistics_place(m.contents.statistics.at(field)), H5T_NATIVE_DOUBLE, -1, m.runs,
                    values.data());
  m.file.agree();
}

void ResultsFile::finish(const std::vector<SummaryRow>& summary, const ClashTables& clashes,
                         const std::vector<std::string>& messages) {
  auto& m = *impl_;
  m.write_waiting();
  const long long steps = m.write_steps();
  m.commit({m.written.count.outputs, m.written.count.steps + steps});
  m.forget_steps(steps);
  ClashRoom rows{0, 0};
  if (m.contents.clashes) rows = m.rows_of(clashes.ended.size(), clashes.open.size());
  const ResultLast end{clashes, &summary, &messages};
  m.build({std::max<long long>(m.written.count.outputs, 1),
           std::max<long long>(m.written.count.steps, 1),
           m.room.slot_doubles,
           m.room.slot_text,
           {m.written.clashes + rows.ended, rows.open},
           m.written.contacts},
          m.file.path(), &end);
  m.save_xdmf(true);
}

long long ResultsFile::outputs() const { return written() + std::ssize(impl_->waiting.times); }
long long ResultsFile::written() const { return impl_->written.count.outputs; }
const ResultContents& ResultsFile::contents() const { return impl_->contents; }
const std::string& ResultsFile::path() const { return impl_->file.path(); }
std::string ResultsFile::xdmf_path() const { return impl_->xdmf_path; }

}  // namespace hawser::io
