// The class LineExtremes: quantities of the table, comparison at every step, and the table.
#include "hawser/record/line_extremes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hawser/advice/limits.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/terms/feeders.hpp"

namespace hawser::record {
namespace {

// Relative amount by which a value must exceed an earlier one: a line at rest has its extreme at the start
// despite later rounding.
constexpr double kBeyond = 1e-9;
// Strain below which the tension is round-off.
constexpr double kNoStrain = 1e-9;
const char* const kRecords = "extremes of lines";  // key in a checkpoint

// Fields of the printed table, in their requested order.
std::vector<size_t> shown(const std::vector<io::ResultField>& fields) {
  std::vector<size_t> out;
  for (size_t f = 0; f < fields.size(); ++f)
    if (!fields[f].extreme.empty()) out.push_back(f);
  std::stable_sort(out.begin(), out.end(),
                   [&](size_t a, size_t b) { return fields[a].order < fields[b].order; });
  return out;
}

}  // namespace

bool is_largest_tension(const model::Case& c, const io::SummaryRow& row) {
  if (row.quantity != "max effective tension") return false;
  double EA = 0;
  for (const auto& s : c.line(row.line).sections) EA = std::max(EA, c.line_type(s.type).EA);
  return row.value > kNoStrain * EA;
}

LineExtremes::LineExtremes(const Subject& subject, const Utilisation& utilisation)
    : comm_(subject.comm()),
      case_(subject.model),
      local_(subject.local()),
      feeders_(subject.term<Feeders>()),
      utilisation_(utilisation),
      has_beams_(case_.lines.size(), false) {
  for (const EvenPart& p : local_.mesh->parts())
    if (p.shape->beam) has_beams_[p.line] = true;
}

void LineExtremes::declare(Declarations& to) {
  fields_ = to.contents.fields;
  for (const size_t f : shown(fields_)) {
    to.every_step.insert(fields_[f].name);
    for (const bool largest : {true, false}) {
      if (!largest && !fields_[f].smallest) continue;
      const std::string name = (largest ? "max " : "min ") + fields_[f].extreme;
      auto q = std::find_if(quantities_.begin(), quantities_.end(),
                            [&](const Quantity& other) { return other.name == name; });
      if (q == quantities_.end())
        q = quantities_.insert(q, {name, fields_[f].unit, {}, largest, PerLine<Extreme>(local_)});
      q->fields.push_back(f);
    }
  }
}

void LineExtremes::step(const Snapshot& s) {
  const double time = s.step.time;
  const auto inside = feeders_ ? feeders_->inside() : std::vector<std::array<int, 2>>{};
  const auto is_inside = [&](const Node& node, size_t n) {
    const size_t line = node.line;
    const LineSpan& span = local_.mesh->lines[line];
    const int i = local_.global[n] - span.first_node;
    return i < inside[line][0] || i >= span.nodes - inside[line][1];
  };
  for (Quantity& q : quantities_)
    for (const size_t f : q.fields)
      for (size_t n = 0; n < static_cast<size_t>(local_.owned); ++n) {
        const Node& node = local_.node(n);
        if (node.body >= 0) break;  // bodies come after the lines
        if (fields_[f].of_beams && !has_beams_[node.line]) continue;
        if (!utilisation_.known(static_cast<int>(f), n) || (feeders_ && is_inside(node, n))) continue;
        const double v = s.values[f][n];
        if (std::isnan(v)) continue;  // no pipe
        Extreme& x = q.lines[node.line];
        const double slack = x.set && time > x.time ? kBeyond * std::abs(x.value) : 0;
        if (!x.set || (q.largest ? v > x.value + slack : v < x.value - slack)) x = {v, time, node.arc, true};
      }
}

std::vector<Warning> LineExtremes::warnings(const std::vector<io::SummaryRow>& summary) {
  std::vector<Warning> out;
  for (size_t i = 0; i < summary.size(); ++i) {
    const io::SummaryRow& row = summary[i];
    const advice::Extreme at{row.line, row.value, row.time, row.arc_length};
    const auto add = [&](std::string text) {
      if (!text.empty()) out.push_back({std::move(text), i});
    };
    const auto limited = std::find_if(fields_.begin(), fields_.end(), [&](const Field& f) {
      return !f.exceeded.empty() && row.quantity == "max " + f.extreme;
    });
    if (limited != fields_.end())
      add(advice::utilisation_warning(case_, at, limited->exceeded, label_of(*limited)));
    if (row.quantity == "min effective tension") add(advice::compression_warning(case_, at));
    if (row.quantity == "max curvature") add(advice::curvature_warning(case_, at));
  }
  return out;
}

std::vector<io::SummaryRow> LineExtremes::summary() {
  for (Quantity& q : quantities_)
    q.lines.take_largest(comm_, [&q](const Extreme& x) {
      return !x.set ? -HUGE_VAL : q.largest ? x.value : -x.value;
    });
  std::vector<io::SummaryRow> rows;
  if (quantities_.empty()) return rows;
  for (const int l : quantities_.front().lines.lines()) {
    if (!owns_line(local_, l)) continue;
    for (const Quantity& q : quantities_)
      if (const Extreme& x = q.lines[l]; x.set)
        rows.push_back({q.name, case_.lines[l].name, x.value, q.unit, x.time, x.arc});
  }
  return rows;
}

// Every rank stores its data of a line at the first node of the line that it owns, so that each rank writes
// and reads only its own.
std::vector<CheckpointRecord> LineExtremes::checkpoint_records(NodeRange nodes) const {
  std::vector<CheckpointRecord> out;
  int before = -1;  // line of the previous node
  for (int n = 0; n < local_.owned && local_.node(n).body < 0; ++n) {
    const int line = local_.node(n).line;
    if (std::exchange(before, line) == line || !nodes.has(local_.global[n])) continue;
    for (size_t q = 0; q < quantities_.size(); ++q)
      if (const Extreme& x = quantities_[q].lines[line]; x.set)
        out.push_back({local_.global[n], 0, {x.value, x.time, x.arc}, static_cast<int>(q)});
  }
  return out;
}

void LineExtremes::save(io::Checkpoint& to) {
  io::TermCheckpoint& kept = to.records[kRecords];
  for (const Quantity& q : quantities_)
    kept.kinds.push_back({q.name, {{"value", 1, q.unit}, {"time", 1, "s"}, {"arc length", 1, "m"}}});
  kept.make = [this](NodeRange nodes) { return checkpoint_records(nodes); };
}

// Data stored by several ranks may now belong to one rank.
void LineExtremes::restore(const io::Checkpoint& from) {
  const auto at = from.records.find(kRecords);
  if (at == from.records.end()) return;
  for (const CheckpointRecord& r : at->second.records) {
    if (static_cast<size_t>(r.kind) >= at->second.kinds.size() || r.values.size() != 3) continue;
    const std::string& name = at->second.kinds[r.kind].name;
    const auto q = std::find_if(quantities_.begin(), quantities_.end(),
                                [&](const Quantity& other) { return other.name == name; });
    if (q == quantities_.end()) continue;
    Extreme& x = q->lines[local_.mesh->node(r.node).line];
    if (!x.set || (q->largest ? r.values[0] > x.value : r.values[0] < x.value))
      x = {r.values[0], r.values[1], r.values[2], true};
  }
}

}  // namespace hawser::record
