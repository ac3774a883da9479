// The class Recorder: what is evaluated at every accepted step and at every output (fields, section forces at
// ends of lines, histories, energies, extremes) and put into the results file.
#include "hawser/record/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "hawser/base/gather.hpp"
#include "hawser/math/declination.hpp"
#include "hawser/record/audit_checkpoint.hpp"
#include "hawser/record/output_times.hpp"
#include "hawser/record/result_parts.hpp"
#include "hawser/terms/body_contact.hpp"
#include "hawser/terms/feeders.hpp"
#include "hawser/terms/links.hpp"

namespace hawser::record {
namespace {

// Of one side of a node, where they may differ (correct_ends).
FieldSource tension_of_side(const char* name, const std::string& tension) {
  return {{.name = name,
           .unit = "N",
           .history = Field::History::yes,
           .statistics = true,
           .extreme = "effective tension",
           .smallest = true,
           .order = 1},
          [](const Kinematics&, std::span<double>) {},
          tension};
}

// Of ends: the last is that of beams only.
const io::ResultField kEnds[] = {{"force", "N", 3}, {"direction", "", 3}, {"moment", "N m", 3}};

// Rows made at once.
constexpr double kMostRoom = 1e6;

// Beside those of the terms in a checkpoint.
const std::string kClashRecords = "clash report";

std::vector<double> touchdown_row(const Touchdown& t) {
  std::vector<double> row;
  for (const auto& p : {t.from_a, t.from_b}) {
    row.push_back(p ? p->arc : std::nan(""));
    for (int k = 0; k < 3; ++k) row.push_back(p ? p->position[k] : std::nan(""));
  }
  row.push_back(t.laid);
  return row;
}

}  // namespace

Recorder::Recorder(Subject subject, std::vector<io::VolumeMesh> volumes, const io::RunInfo& run,
                   const io::Checkpoint* from, bool append, bool write)
    : subject_(std::move(subject)),
      comm_(subject_.comm()),
      feeders_(subject_.term<Feeders>()),
      registry_(subject_.system.fields()),
      end_forces_(subject_.system, feeders_),
      peaks_(subject_.model, subject_.system),
      element_errors_(comm_, subject_.model, subject_.local(), feeders_),
      water_errors_(subject_.model, subject_.system),
      folds_(subject_.model, subject_.local(), feeders_),
      snaps_(subject_.model, subject_.local()),
      utilisation_(subject_.model, subject_.local()),
      pipes_(subject_.model, subject_.local()),
      touchdowns_(comm_, subject_.model, subject_.local()),
      clearances_(comm_, subject_.model, subject_.local(), subject_.surfaces),
      rows_every_(subject_.model.output.history_every) {
  const model::Case& c = subject_.model;
  const LocalMesh& local = subject_.local();
  fields_ = {{"position", "m", 3}, {"velocity", "m/s", 3}};
  const auto& all = registry_.sources();
  const std::string tension = "effective_tension", before = tension + "_before", after = tension + "_after";
  if (std::any_of(all.begin(), all.end(), [&](const Field& f) { return f.name == tension; }))
    for (const std::string& side : {before, after}) registry_.add(tension_of_side(side.c_str(), tension));
  fields_.insert(fields_.end(), all.begin(), all.end());
  peaks_.find(fields_);
  utilisation_.add_fields(fields_);
  pipes_.add_fields(fields_);
  for (const auto& f : fields_) values_.emplace_back(static_cast<size_t>(local.owned * f.components));
  const auto find = [&](const std::string& name) { return find_field(fields_, name); };
  pressed_ = find("contact_normal_force");
  for (const char* name : {"contact_normal_force", "line_contact_normal_force", "seabed_force"})
    if (const int f = find(name); f >= 0) touches_.push_back(f);
  tension_ = find(tension), before_ = find(before), after_ = find(after);
  declination_ = find("declination");
  wall_ = find("wall_tension"), shear_ = find("shear_force"), torsion_ = find("torsion_moment");
  moment_ = find("bending_moment"), moment_2_ = find("bending_moment_2"),
  moment_3_ = find("bending_moment_3");
  for (const FieldSource& f : registry_.sources()) onto_.push_back(f.onto.empty() ? -1 : find(f.onto));
  for (size_t f = 0; f < fields_.size(); ++f)
    if (fields_[f].carries) carriers_.push_back(static_cast<int>(f));
  ends_.resize(moment_ >= 0 ? 3 : 2);
  const bool points = std::any_of(c.output.histories.begin(), c.output.histories.end(),
                                  [](const auto& h) { return !h.line.empty(); });
  for (const FieldSource& s : registry_.sources())
    every_step_.push_back(s.name == tension || s.carries || pipes_.wants(s.name) ||
                          (points && s.history != Field::History::no) || !s.extreme.empty() ||
                          (c.output.statistics && s.statistics));
  const int corrected[] = {tension_, declination_, wall_, shear_, torsion_, moment_, moment_2_, moment_3_};
  rest_apart_ = std::all_of(std::begin(corrected), std::end(corrected),
                            [this](int f) { return f < 0 || every_step_[f - 2]; });

  io::ResultContents contents;
  contents.run = run;
  contents.single_precision = subject_.model.output.single_precision;
  contents.stages = c.stages;
  contents.fields = fields_;
  contents.end_fields.assign(kEnds, kEnds + ends_.size());
  if (c.output.statistics) {
    statistics_ =
        std::make_unique<NodeStatistics>(fields_, static_cast<size_t>(local.owned), c.output.statistics_from);
    stations_ = std::make_unique<Stations>(comm_, local, feeders_, fields_);
    at_stations_ = std::make_unique<NodeStatistics>(stations_->fields(), static_cast<size_t>(local.owned),
                                                    c.output.statistics_from);
    contents.statistics = statistics_->fields();
    contents.statistics.insert(contents.statistics.end(), stations_->fields().begin(),
                               stations_->fields().end());
  }
  contents.volumes = std::move(volumes);
  contents.waves = result_waves(c);
  contents.xdmf = c.output.xdmf;
  const Mesh& mesh = subject_.mesh();
  contents.lines = result_lines(c, mesh);
  for (const auto& b : c.bodies) contents.bodies.push_back(b.name);
  if (ClashReport::wanted(subject_)) clashes_ = std::make_unique<ClashReport>(comm_, subject_);
  contents.clashes = clashes_ != nullptr;
  contents.free_bodies = static_cast<int>(mesh.nodes.size()) - mesh.line_nodes();
  histories_ = std::make_unique<Histories>(comm_, subject_, end_forces_, fields_,
                                           std::span(kEnds).first(ends_.size()));
  contents.series = histories_->series();
  for (io::ResultSeries& s : clearances_.series()) contents.series.push_back(std::move(s));
  if (!c.supports.empty()) {
    supports_ = std::make_unique<SupportLog>(comm_, subject_);
    for (io::ResultSeries& s : supports_->series()) contents.series.push_back(std::move(s));
  }
  if (shows_touchdowns())
    for (const model::Line& line : c.lines)
      contents.series.push_back({line.name + " touchdown",
                                 {{"end_a_arc_length", "m", 1},
                                  {"end_a_position", "m", 3},
                                  {"end_b_arc_length", "m", 1},
                                  {"end_b_position", "m", 3},
                                  {"laid_length", "m", 1}}});
  for (const model::Link& l : c.links)
    contents.series.push_back(
        {l.name + " link",
         {{"tension", "N", 1}, {"length", "m", 1}, {"speed", "m/s", 1}, {"force", "N", 3}}});
  if (const Feeders* feeders = feeders_)
    for (const Feeder& f : feeders->list())
      contents.series.push_back(
          {fmt::format("{} {} feed", c.lines[f.line].name, f.at_b ? "end_b" : "end_a"),
           {{"paid_out", "m", 1}, {"feed_speed", "m/s", 1}, {"tension", "N", 1}, {"mouth_length", "m", 1}}});
  io::ResultSeries energy{"energy", {}};
  for (const char* name :
       {"kinetic", "strain", "potential", "friction", "damping", "brought_in", "error", "unresolved"})
    energy.columns.push_back({name, "J", 1});
  contents.series.push_back(std::move(energy));
  contents.series.push_back(
      {"solver", {{"step", "s", 1}, {"newton_iterations", "1", 1}, {"rejected", "1", 1}}});
  // Room for more steps than there are costs nothing; a file that must be made anew costs what is in it.
  const io::ExpectedRows rows = expected_rows(c);
  contents.expected_outputs = static_cast<int>(std::min(rows.outputs + 2, kMostRoom));
  contents.expected_steps = static_cast<int>(std::min(1.1 * rows.steps + 100, kMostRoom));
  std::vector<int> owned(local.global.begin(), local.global.begin() + local.owned);
  extremes_ = std::make_unique<LineExtremes>(comm_, c, local, feeders_, fields_);
  if (!write) {
    planned_ = std::move(contents);
    return;
  }
  if (from) restore(*from);
  if (clashes_ && !append) clashes_->begin_file();
  file_ = std::make_unique<io::ResultsFile>(
      append ? io::ResultsFile::resume(comm_, c.output.file, std::move(contents), std::move(owned),
                                       from->time, clashes_ ? clashes_->told() : io::ClashesTold{})
             : io::ResultsFile::create(comm_, c.output.file, std::move(contents), std::move(owned)));
}

// Fields that neither histories nor extremes nor statistics show are for outputs alone.
void Recorder::fill(const Kinematics& at, bool all) {
  const size_t owned = subject_.local().owned;
  for (size_t n = 0; n < owned; ++n)
    for (size_t k = 0; k < 3; ++k) {
      values_[0][3 * n + k] = at.x[n][static_cast<Eigen::Index>(k)];
      values_[1][3 * n + k] = at.v[n][static_cast<Eigen::Index>(k)];
    }
  for (size_t f = 0; f < registry_.sources().size(); ++f)
    if (all || every_step_[f]) fill_field(f, at);
  correct_ends(at);
  utilisation_.fill(values_);
  pipes_.fill(values_, pipe_places(at));
}

// Where the condition of a pipe depends on what carries it.
PipePlaces Recorder::pipe_places(const Kinematics& at) {
  PipePlaces out;
  if (!pipes_.wants_places()) return out;
  const model::Case& c = subject_.model;
  if (supports_) out.supports = supports_->carrying(at, body_poses(subject_.bodies, subject_.system, at));
  if (!c.environment.seabed.present) return out;
  const std::vector<Touchdown> all = touchdowns_.find(at);
  for (size_t l = 0; l < all.size(); ++l) {
    const Touchdown& t = all[l];
    std::array<double, 2>& lies = out.seabed.emplace_back(std::array{HUGE_VAL, -HUGE_VAL});
    if (!t.from_a && t.laid > 0) lies = {-HUGE_VAL, HUGE_VAL};  // from end to end
    if (!t.from_a) continue;
    const double from = t.from_a->arc, to = t.from_b->arc, behind = subject_.mesh().lines[l].length - to;
    // A line that lies up to one of its ends has one touchdown point.
    if (to > from)
      lies = {from, to};
    else if (std::abs(t.laid - behind) < std::abs(t.laid - from))
      lies = {from, HUGE_VAL};
    else
      lies = {-HUGE_VAL, to};
  }
  return out;
}

void Recorder::fill_field(size_t f, const Kinematics& at) {
  if (onto_[f] >= 0) values_[f + 2] = values_[onto_[f]];
  registry_.sources()[f].fill(at, values_[f + 2]);
}

// An element's tension is that of its middle, its moments leave out the load along it. At the ends of a line,
// and where tension may jump, the values are those of the forces there (docs/theory/end-forces.md). The
// wall's tension goes with the effective one: the pressures are those of the node already.
void Recorder::correct_ends(const Kinematics& at) {
  const LocalMesh& local = subject_.local();
  std::vector<Vec3> carried(static_cast<size_t>(local.nodes()), Vec3::Zero());
  for (const int f : carriers_)
    for (size_t n = 0; n < static_cast<size_t>(local.owned); ++n)
      carried[n] += Eigen::Map<const Vec3>(values_[f].data() + 3 * n).cwiseAbs();
  if (!carriers_.empty()) subject_.system.spread(carried);
  // A run in time that begins without statics has no step yet, but what acts is that of motion: waves.
  Kinematics now = at;
  if (!subject_.model.statics.enabled && subject_.model.dynamics.enabled && now.step == 0)
    now.step = subject_.dynamics().control().proposal();
  end_forces_.evaluate(now, carried);

  for (auto& e : ends_) e.clear();
  for (const EndForces::Place& p : end_forces_.places()) {
    const size_t n = p.node;
    const auto larger = [&p](auto&& of) {
      const double a = of(p.sides[0]), b = of(p.sides[1]);
      return std::abs(a) > std::abs(b) ? a : b;
    };
    const auto put = [&](int field, double value) {
      return field < 0 ? 0 : std::exchange(values_[field][n], value);
    };
    put(before_, p.sides[0].tension()), put(after_, p.sides[1].tension());
    const Vec3 &first = p.sides[0].direction, &second = p.sides[1].direction;
    put(declination_, degrees(declination(p.end >= 0 ? p.at_end().direction : Vec3(first + second))));
    const double tension = larger([](const SectionForce& s) { return s.tension(); });
    const double middle = put(tension_, tension);
    if (wall_ >= 0) values_[wall_][n] += tension - middle;
    if (p.sides[0].beam || p.sides[1].beam) {
      const auto moment = [&](int axis) {
        return larger([&](const SectionForce& s) { return s.moment.dot(at.q[n] * Vec3::Unit(axis)); });
      };
      put(shear_, larger([](const SectionForce& s) { return s.shear(); }));
      put(torsion_, moment(0)), put(moment_2_, moment(1)), put(moment_3_, moment(2));
      put(moment_,
          larger([&](const SectionForce& s) { return s.moment.cross(at.q[n] * Vec3::UnitX()).norm(); }));
    }
    if (p.end < 0) continue;
    const SectionForce& s = p.at_end();
    const Vec3 rows[] = {p.sign() * s.force, s.direction, p.sign() * s.moment};
    for (size_t f = 0; f < ends_.size(); ++f) ends_[f].insert(ends_[f].end(), rows[f].begin(), rows[f].end());
  }
  peaks_.fill(now, values_);
}

// Stages have no time: that of the last is 0, and a second less for each before it.
void Recorder::stage(size_t place, const Kinematics& at) {
  fill(at, true);
  water_errors_.look(at);
  const double last = static_cast<double>(subject_.model.stages.size()) - 1;
  file_->write_output(static_cast<double>(place) - last, values_,
                      body_poses(subject_.bodies, subject_.system, at), {}, ends_);
}

void Recorder::start(const Kinematics& at, const Kinematics& shown) {
  start_ = sum_of(comm_, subject_.system.energy(at));
  if (subject_.model.statics.enabled) fill(shown, false), pipes_.rest(values_);
  step({}, at, 0, shown);
  output(shown);
}

bool Recorder::shows_touchdowns() const {
  return subject_.model.output.touchdowns && subject_.model.environment.seabed.present;
}

void Recorder::step(const StepInfo& info, const Kinematics& at, double support_work) {
  step(info, at, support_work, at);
}

void Recorder::step(const StepInfo& info, const Kinematics& at, double support_work,
                    const Kinematics& shown) {
  fill(shown, false);
  stepped_ = true;
  Energy share = subject_.system.energy(at);
  share.work += support_work;
  if (audit_.update(start_, sum_of(comm_, share), info.time, info.h, passed_through(info.h)) && info.h > 0)
    find_worst(at);
  extremes_->add(info.time, values_, utilisation_);
  const auto &on_a = values_[before_], &on_b = values_[after_];
  folds_.look(shown, on_a, on_b);
  snaps_.look(info.time, info.h, on_a, on_b);
  water_errors_.step(shown);
  if (statistics_) statistics_->add(info.time, values_);
  if (at_stations_) at_stations_->add(info.time, stations_->at(values_));
  if (clashes_) clashes_->step(info.time);
  if (supports_) support_rows_ = supports_->rows(shown, body_poses(subject_.bodies, subject_.system, shown));
  if (info.time < rows_from_ - time_tolerance(info.time)) return;
  if (rows_every_ > 0) rows_from_ = next_multiple(info.time, rows_every_);
  append_rows(info, shown);
}

void Recorder::append_rows(const StepInfo& info, const Kinematics& at) {
  const Energy& e = audit_.now;

  std::vector<std::vector<double>> rows = histories_->rows(at, values_, ends_);
  if (!subject_.model.output.clearances.empty())
    for (std::vector<double>& row : clearances_.rows(at, body_poses(subject_.bodies, subject_.system, at)))
      rows.push_back(std::move(row));
  if (supports_)
    for (std::vector<double>& row : support_rows_) rows.push_back(std::move(row));
  const int rank = rank_of(comm_);
  if (shows_touchdowns())
    for (const Touchdown& t : touchdowns_.find(at))
      rows.push_back(rank == 0 ? touchdown_row(t) : std::vector<double>{});
  const auto* links = subject_.term<Links>();
  for (size_t i = 0; i < subject_.model.links.size(); ++i) {
    const Links::Now l = links->now(i, at);
    std::vector<double>& row = rows.emplace_back();
    if (!l.known) continue;
    row = {l.force.along.tension, l.force.length, l.force.speed};
    for (const double on_a : l.force.pull) row.push_back(on_a);
  }
  if (const Feeders* feeders = feeders_)
    for (size_t k = 0; k < feeders->list().size(); ++k) {
      const Feeder& f = feeders->list()[k];
      std::vector<double> row{feeders->outside(f) - f.outside_at_start, f.speed, end_forces_.at_feeders()[k],
                              f.length};
      rows.push_back(rank == 0 ? std::move(row) : std::vector<double>{});
    }
  if (rank == 0) {
    rows.push_back({e.kinetic, e.strain, e.potential, e.friction, e.damping, audit_.brought_in, audit_.error,
                    e.unresolved});
    rows.push_back({info.h, static_cast<double>(info.iterations), static_cast<double>(info.rejected)});
  } else {
    rows.push_back({}), rows.push_back({});
  }
  file_->append_series(info.time, rows);
}

// J, work in a step that one feeder does on its line and another takes out of its own, or of the same.
double Recorder::passed_through(double h) const {
  double gross = 0, net = 0;
  if (const Feeders* feeders = feeders_)
    for (size_t k = 0; k < feeders->list().size(); ++k) {
      const double work = end_forces_.at_feeders()[k] * feeders->list()[k].speed * h;
      gross += std::abs(work), net += work;
    }
  return gross - std::abs(net);
}

// Where the step that made most energy so far changed the motion most, and what acted there.
void Recorder::find_worst(const Kinematics& at) {
  fill(at, true);
  const NodeValue most = subject_.dynamics().roughest();
  int with = 0;
  const int n = subject_.local().find(most.node);
  if (subject_.local().owns(n))
    for (size_t f = 2; f < fields_.size() && with == 0; ++f) {
      const int components = fields_[f].components;
      double size = 0;
      for (int c = 0; c < components; ++c) size += std::abs(values_[f][n * components + c]);
      if (size == 0) continue;
      if (fields_[f].name == "contact_normal_force")
        with = static_cast<int>(Audit::Step::ContactWith::volume);
      if (fields_[f].name == "line_contact_normal_force")
        with = static_cast<int>(Audit::Step::ContactWith::line);
      if (fields_[f].name == "seabed_force") with = static_cast<int>(Audit::Step::ContactWith::seabed);
    }
  all_reduce(comm_, MPI_MAX, with);
  audit_.located(most.node, static_cast<Audit::Step::ContactWith>(with));
}

void Recorder::output(const Kinematics& at) {
  if (stepped_ && rest_apart_) {
    for (size_t f = 0; f < every_step_.size(); ++f)
      if (!every_step_[f]) fill_field(f, at);
  } else {
    fill(at, true);
  }
  look_at_elements(at);
  file_->write_output(at.time, values_, body_poses(subject_.bodies, subject_.system, at),
                      clashes_ ? clashes_->take() : io::ClashTables{}, ends_);
}

void Recorder::checkpoint(io::Checkpoint c) {
  write_statistics();
  file_->write_checkpoint(std::move(c));
}

void Recorder::write_statistics() {
  size_t place = 0;
  for (const NodeStatistics* s : {statistics_.get(), at_stations_.get()})
    for (size_t f = 0; s && f < s->fields().size(); ++f) file_->write_statistics(place++, s->table(f));
}

std::string Recorder::finish(std::vector<std::string> messages) {
  const auto rows = extremes_->table();
  gather_warnings(rows);
  const bool moved = subject_.model.dynamics.enabled;
  if (const std::string n = audit_.note(); moved && !n.empty()) messages.push_back("note: " + n);
  if (const std::string w = audit_warning(); moved && !w.empty()) messages.push_back("warning: " + w);
  for (const std::string& w : warnings_) messages.push_back("warning: " + w);
  write_statistics();
  file_->finish(rows, clashes_ ? clashes_->take() : io::ClashTables{}, messages);
  std::string text = fmt::format("{:<24} {:<16} {:>14} {:<6} {:>10} {:>12}\n", "quantity", "line", "value",
                                 "unit", "time [s]", "arc [m]");
  for (const auto& r : rows)
    text += fmt::format("{:<24} {:<16} {:>14.6g} {:<6} {:>10.3f} {:>12.3f}\n", r.quantity, r.line, r.value,
                        r.unit, r.time, r.arc_length);
  return text;
}

void Recorder::save(io::Checkpoint& to) {
  if (clashes_) to.history[kClashRecords] = {ClashReport::history(), clashes_->save()};
  if (statistics_) statistics_->save(to), at_stations_->save(to);
  save_audit(start_, audit_, to);
  pipes_.save(to);
  extremes_->save(to);
}

void Recorder::restore(const io::Checkpoint& from) {
  if (clashes_) {
    const auto at = from.history.find(kClashRecords);
    clashes_->restore(at == from.history.end() ? std::vector<HistoryRecord>{} : at->second.records);
  }
  if (statistics_) statistics_->restore(from), at_stations_->restore(from);
  restore_audit(from, start_, audit_);
  pipes_.restore(from);
  extremes_->restore(from);
  if (rows_every_ > 0) rows_from_ = next_multiple(from.time, rows_every_);
}

}  // namespace hawser::record
