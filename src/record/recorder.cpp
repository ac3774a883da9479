// The class Recorder: order of updates of fields and recordings, and writing of the results file.
#include "hawser/record/recorder.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "hawser/base/mpi.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/record/energy_audit.hpp"
#include "hawser/record/output_times.hpp"
#include "hawser/record/result_parts.hpp"
#include "hawser/record/summary_rows.hpp"

namespace hawser::record {
namespace {

// Limit of the initial capacity, rows.
constexpr double kMostRoom = 1e6;

}  // namespace

Recorder::Recorder(Subject subject, std::vector<io::VolumeMesh> volumes, io::RunInfo run, RecorderFile use,
                   const io::Checkpoint* from)
    : subject_(std::move(subject)),
      touchdowns_(subject_.comm(), subject_.model, subject_.local()),
      fields_(subject_),
      recordings_(recordings(subject_, fields_)),
      rows_every_(subject_.model.output.history_every) {
  io::ResultContents contents = declared(std::move(volumes), std::move(run));
  if (use == RecorderFile::none) {
    planned_ = std::move(contents);
    return;
  }
  const LocalMesh& local = subject_.local();
  std::vector<int> owned(local.global.begin(), local.global.begin() + local.owned);
  const std::string& path = subject_.model.output.file;
  if (from) restore(*from);
  const bool append = use == RecorderFile::append;
  io::ReportedClashes reported;
  for (const auto& r : recordings_)
    if (append)
      r->add_reported(reported);
    else
      r->begin_file();
  file_ = std::make_unique<io::ResultsFile>(
      append ? io::ResultsFile::resume(subject_.comm(), path, std::move(contents), std::move(owned),
                                       from->time, from->sequence, reported)
             : io::ResultsFile::create(subject_.comm(), path, std::move(contents), std::move(owned)));
}

io::ResultContents Recorder::declared(std::vector<io::VolumeMesh> volumes, io::RunInfo run) {
  const model::Case& c = subject_.model;
  const Mesh& mesh = subject_.mesh();
  for (const auto& r : recordings_) r->add_fields(fields_.fields());
  Declarations all;
  io::ResultContents& contents = all.contents;
  contents.run = std::move(run);
  contents.single_precision = c.output.single_precision;
  contents.stages = c.stages;
  contents.fields = fields_.fields();
  contents.end_fields = fields_.end_fields();
  contents.volumes = std::move(volumes);
  contents.waves = result_waves(c);
  contents.xdmf = c.output.xdmf;
  contents.line_nodes = nodes_of_lines(mesh);
  if (rank_of(subject_.comm()) == 0) {
    contents.line_labels = result_line_labels(c, mesh);
    contents.ranks = subject_.local().owner.of_nodes();
    contents.ranks.resize(static_cast<size_t>(mesh.line_nodes()));
    for (const auto& b : c.bodies) contents.body_names.push_back(b.name);
  }
  contents.bodies = subject_.bodies.size();
  contents.body_nodes = mesh.body_nodes();
  // Unused capacity is free; rebuilding a file costs a copy.
  const io::ExpectedRows rows = expected_rows(c);
  contents.expected_outputs = static_cast<int>(std::min(rows.outputs + 2, kMostRoom));
  contents.expected_steps = static_cast<int>(std::min(1.1 * rows.steps + 100, kMostRoom));
  for (const auto& r : recordings_) r->declare(all);
  fields_.begin(all.every_step);
  return std::move(all.contents);
}

Snapshot Recorder::snapshot(const Kinematics& state, const StepInfo& info) const {
  return {subject_, touchdowns_, state, info, fields_.values(), fields_.ends(), fields_.end_forces()};
}

void Recorder::fill(const Snapshot& s, FieldsFilled which) {
  fields_.fill(s.at, which);
  for (const auto& r : recordings_) r->fill(s, fields_.values());
}

// Stages have no time: the last has 0, each one before it a second less.
void Recorder::stage(size_t place, const Kinematics& state) {
  const Snapshot s = snapshot(state);
  fill(s, FieldsFilled::all);
  for (const auto& r : recordings_) r->stage(s);
  const double last = static_cast<double>(subject_.model.stages.size()) - 1;
  write_output(static_cast<double>(place) - last, s, {});
}

void Recorder::start(const Kinematics& state) {
  if (subject_.model.statics.enabled) {
    const Snapshot s = snapshot(state);
    fill(s, FieldsFilled::every_step);
    for (const auto& r : recordings_) r->start(s);
  }
  step({}, state);
  output(state);
}

void Recorder::step(const StepInfo& info, const Kinematics& state) {
  const Snapshot s = snapshot(state, info);
  fill(s, FieldsFilled::every_step);
  stepped_ = true;
  for (const auto& r : recordings_) r->step(s);
  if (info.time < rows_from_ - time_tolerance(info.time)) return;
  if (rows_every_ > 0) rows_from_ = next_multiple(info.time, rows_every_);
  Rows rows;
  for (const auto& r : recordings_) r->rows(s, rows);
  file_->append_series(info.time, std::move(rows).gathered(subject_.comm()));
}

void Recorder::output(const Kinematics& state) {
  const Snapshot s = snapshot(state);
  if (!stepped_ || !fields_.complete(state)) fill(s, FieldsFilled::all);
  for (const auto& r : recordings_) r->output(s);
  write_output(state.time, s, take_clashes());
}

void Recorder::write_output(double time, const Snapshot& s, const io::ClashTables& clashes) {
  io::ContactRows points;
  for (const auto& r : recordings_) r->points(s, points);
  file_->write_output(time, s.values, s.poses(), clashes, s.ends, points);
}

io::ClashTables Recorder::take_clashes() {
  io::ClashTables all;
  for (const auto& r : recordings_) r->take_clashes(all);
  return all;
}

std::vector<std::string> Recorder::tables() const {
  std::vector<std::string> all;
  for (const auto& r : recordings_)
    if (std::string text = r->table(); !text.empty()) all.push_back(std::move(text));
  return all;
}

void Recorder::checkpoint(io::Checkpoint c) {
  for (const auto& r : recordings_) r->write(*file_);
  file_->write_checkpoint(std::move(c));
}

// Rows of the summary and warnings of all ranks, on rank 0 in the order of the lines. Collective.
std::vector<io::SummaryRow> Recorder::gather_summary() {
  std::vector<io::SummaryRow> rows;
  for (const auto& r : recordings_)
    for (io::SummaryRow& row : r->summary()) rows.push_back(std::move(row));
  std::vector<Warning> warnings;
  for (const auto& r : recordings_)
    for (Warning& w : r->warnings(rows)) warnings.push_back(std::move(w));
  gather_on_first(subject_.comm(), rows, warnings);
  std::vector<int> line;
  for (const io::SummaryRow& row : rows) line.push_back(subject_.model.line_index(row.line));
  std::vector<size_t> order(rows.size());
  std::vector<size_t> place(rows.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return line[a] < line[b]; });
  std::vector<io::SummaryRow> sorted;
  for (const size_t i : order) {
    place[i] = sorted.size();
    sorted.push_back(std::move(rows[i]));
  }
  for (Warning& w : warnings)
    if (w.row != Warning::kWholeRun) w.row = place[w.row];
  std::stable_sort(warnings.begin(), warnings.end(),
                   [](const Warning& a, const Warning& b) { return a.row < b.row; });
  std::vector<std::string> texts;
  for (Warning& w : warnings) texts.push_back(std::move(w.text));
  warnings_ = model::notes_by_place(subject_.model, std::move(texts));
  return sorted;
}

std::string Recorder::finish(std::vector<std::string> messages) {
  const std::vector<io::SummaryRow> rows = gather_summary();
  const bool moved = subject_.model.dynamics.enabled;
  if (const std::string n = energy().figures().note(); moved && !n.empty()) messages.push_back("note: " + n);
  if (const std::string w = energy().warning(); moved && !w.empty()) messages.push_back("warning: " + w);
  for (const std::string& w : warnings_) messages.push_back("warning: " + w);
  for (const auto& r : recordings_) r->write(*file_);
  file_->finish(rows, take_clashes(), messages);
  if (rank_of(subject_.comm()) != 0) return "";
  return summary_table(rows);
}

std::vector<std::string> Recorder::remarks() {
  std::vector<std::string> all;
  for (const auto& r : recordings_)
    for (std::string& text : r->remarks()) all.push_back(std::move(text));
  return all;
}

void Recorder::save(io::Checkpoint& to) {
  for (const auto& r : recordings_) r->save(to);
}

void Recorder::restore(const io::Checkpoint& from) {
  for (const auto& r : recordings_) r->restore(from);
  if (rows_every_ > 0) rows_from_ = next_multiple(from.time, rows_every_);
}

}  // namespace hawser::record
