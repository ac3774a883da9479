// The class ClashReport: gathering of the contacts of three contact terms on rank 0, its checkpoint records,
// and the final table.
#include "hawser/record/clash_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hawser/advice/clashes.hpp"
#include "hawser/base/exchange.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/model/check.hpp"
#include "hawser/record/contact_points.hpp"
#include "hawser/terms/body_contact.hpp"
#include "hawser/terms/line_pairs.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser::record {
namespace {

constexpr size_t kMostSteps = 256;  // stored by each rank
constexpr double kMergeDiameters = 4;
constexpr int kLogTag = 78;
// Key in the records of a checkpoint, beside those of the terms.
const std::string kRecords = "clash report";

ClashSettings settings_of(const model::Case& c, const Mesh& mesh) {
  const model::ClashOutput& o = c.output.clashes;
  ClashSettings s;
  s.merge_gap = o.merge_gap;
  std::vector<double> of_types;
  for (const model::LineType& t : c.line_types)
    of_types.push_back(o.merge_length > 0 ? o.merge_length : kMergeDiameters * t.contact_diameter);
  s.merge_length = largest_of_types(mesh, of_types);
  return s;
}

}  // namespace

bool ClashReport::enabled(const Subject& s) { return s.model.output.clashes.enabled && can_touch(s); }

ClashReport::ClashReport(const Subject& subject)
    : comm_(subject.comm()),
      subject_(subject),
      line_pairs_(subject.term<LinePairs>()),
      body_contact_(subject.term<BodyContact>()),
      rank_(rank_of(comm_)),
      settings_(settings_of(subject.model, subject.mesh())),
      volumes_(case_indices_of_volumes(subject)),
      log_(settings_) {}

void ClashReport::step(const Snapshot& s) {
  ActiveContacts touches = s.volume_contacts();
  for (ActiveContact& t : touches) t.volume = volumes_[t.volume];
  if (line_pairs_) line_pairs_->active_contacts(touches);
  if (body_contact_) body_contact_->active_contacts(touches);
  touches = merge_contacts(std::move(touches), settings_.merge_length);
  steps_.push_back({s.step.time, static_cast<int>(touches.size())});
  contacts_.insert(contacts_.end(), touches.begin(), touches.end());
  if (steps_.size() >= kMostSteps) collect();
}

void ClashReport::collect() {
  const size_t steps = steps_.size();
  std::vector<Step> all_steps;  // of all ranks, rank by rank
  GatherPlan(comm_, static_cast<int>(steps)).gather_on_first(steps_.data(), all_steps);
  ActiveContacts all_contacts;
  const GatherPlan plan(comm_, static_cast<int>(contacts_.size()));
  plan.gather_on_first(contacts_.data(), all_contacts);
  steps_.clear();
  contacts_.clear();
  if (rank_ > 0) return;
  std::vector<int> next(plan.starts().begin(), plan.starts().end() - 1);  // contact of each rank
  for (size_t k = 0; k < steps; ++k) {
    ActiveContacts touches;
    for (size_t rank = 0; rank < next.size(); ++rank) {
      const auto first = all_contacts.begin() + next[rank];
      const int contacts = all_steps[rank * steps + k].contacts;
      touches.insert(touches.end(), first, first + contacts);
      next[rank] += contacts;
    }
    log_.step(all_steps[k].time, merge_contacts(std::move(touches), settings_.merge_length));
  }
}

void ClashReport::take_clashes(io::ClashTables& to) {
  collect();
  to = log_.take();
}

// A record needs a node of the rank that writes it; rank 0 may own none, so the owner of node 0 receives the
// log.
void ClashReport::save(io::Checkpoint& to) {
  collect();
  io::TermCheckpoint& kept = to.records[kRecords];
  kept.kinds = ClashLog::checkpoint_kinds();
  for (CheckpointRecord& r : log_.save()) {
    ListsByRank<double> values;
    if (rank_ == 0) values[subject_.local().owner[0]] = std::move(r.values);
    values = send_lists(comm_, kLogTag, values);
    if (!subject_.local().owns_node(0)) continue;
    r.values = std::move(values[0]);
    kept.records.push_back(std::move(r));
  }
}

bool ClashReport::can_restore(const io::Checkpoint& from) {
  const auto at = from.records.find(kRecords);
  return at == from.records.end() || at->second.kinds == ClashLog::checkpoint_kinds();
}

void ClashReport::restore(const io::Checkpoint& from) {
  const auto at = from.records.find(kRecords);
  if (at == from.records.end()) return;
  std::vector<CheckpointRecord> log;  // on rank 0
  for (int kind = 0; kind < static_cast<int>(at->second.kinds.size()); ++kind) {
    ListsByRank<double> values;
    if (const CheckpointRecord* r = find_record(at->second.records, 0, 0, kind)) values[0] = r->values;
    for (auto& [rank, received] : send_lists(comm_, kLogTag, values))
      log.push_back({0, 0, std::move(received), kind});
  }
  if (rank_ == 0) log_.restore(log);
}

std::string ClashReport::table() const {
  const model::Case& c = subject_.model;
  const auto rows = log_.largest(static_cast<size_t>(c.output.clashes.rows));
  if (log_.count() == 0) return "";
  const auto open = log_.open();
  std::string text = advice::clashes(log_.count(), open.size(), rows.size());
  if (rows.empty()) return text;
  const auto name = [&](const io::ClashRow& r) {
    const auto line = [&](int l) { return c.lines[l].name; };
    const auto volume = [&](int v) { return c.volumes[v].name; };
    if (r.line < 0) return volume(r.volume) + " / " + volume(r.other_volume);
    if (r.other_line < 0) return line(r.line) + " / " + volume(r.volume);
    return line(r.line) + " / " + (r.other_line == r.line ? "itself" : line(r.other_line));
  };
  const auto arcs = [](bool valid, double from, double to) {
    return valid ? fmt::format("{:.2f}-{:.2f}", from, to) : "";
  };
  text += fmt::format("{:<28} {:>9} {:>9} {:>16} {:>16} {:>11} {:>13} {:>11} {:>15}\n", "pair", "start [s]",
                      "end [s]", "arc [m]", "other arc [m]", "peak [N]", "impulse [N s]", "energy [J]",
                      "penetration [m]");
  for (const io::ClashRow& r : rows) {
    const bool ongoing = std::any_of(open.begin(), open.end(), [&](const io::ClashRow& o) {
      return o.line == r.line && o.other_line == r.other_line && o.volume == r.volume &&
             o.other_volume == r.other_volume && o.start == r.start && o.from == r.from;
    });
    text += fmt::format("{:<28} {:>9.3f} {:>9} {:>16} {:>16} {:>11.4g} {:>13.4g} {:>11.3g} {:>15.3g}\n",
                        name(r), r.start, ongoing ? "ongoing" : fmt::format("{:.3f}", r.end),
                        arcs(r.line >= 0, r.from, r.to), arcs(r.other_line >= 0, r.other_from, r.other_to),
                        r.peak_force, r.impulse, r.peak_energy, r.penetration);
  }
  return text;
}

}  // namespace hawser::record
