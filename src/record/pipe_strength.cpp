// The class PipeStrength: line types at each node, loads and pressures there, and the larger value of both
// sides.
#include "hawser/record/pipe_strength.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hawser/advice/limits.hpp"
#include "hawser/base/mpi.hpp"

namespace hawser::record {
namespace {

constexpr const char *kTension = "effective_tension", *kMoment2 = "bending_moment_2",
                     *kMoment3 = "bending_moment_3", *kCurvature = "curvature";

Field of_code(const char* name, const char* label, const char* code) {
  return {.name = name,
          .unit = "1",
          .label = label,
          .history = Field::History::after_end_columns,
          .statistics = true,
          .at_stations = true,
          .extreme = label,
          .report = Field::Report::graph,
          .order = 4,
          .exceeded = fmt::format("loaded above the limit of {}", code)};
}

// Keys in a checkpoint.
const std::string kRest = "pipe codes: functional loads", kPulled = "pipe codes: design tension";

}  // namespace

PipeStrength::PipeStrength(const Subject& subject)
    : case_(subject.model), mesh_(subject.mesh()), comm_(subject.comm()) {
  if (!case_.supports.empty()) rollers_.emplace(subject);
  for (const model::LineType& t : case_.line_types) {
    const bool judged = t.steel && t.kind == model::LineKind::beam;
    of_type_.push_back(judged ? static_cast<int>(codes_.size()) : -1);
    if (!judged) continue;
    codes_.emplace_back(*t.steel);
    by_place_ |= t.conditions.supports != t.conditions.span || t.conditions.seabed != t.conditions.span;
  }
  const LocalMesh& local = subject.local();
  for (size_t n = 0; n < static_cast<size_t>(local.owned) && !codes_.empty(); ++n) {
    const Node& node = mesh_.node(local.global[n]);
    auto& sides = sides_.emplace_back();
    if (node.body >= 0) continue;
    const LineSpan& line = mesh_.lines[node.line];
    for (const size_t side : {0u, 1u}) {
      const int i = local.global[n] - line.first_node - 1 + static_cast<int>(side);
      if (i < 0 || i >= line.elements) continue;
      const int type = mesh_.element(line.first_element + i).type;
      if (of_type_[type] >= 0) sides[side] = {type, node.arc, node.line};
    }
  }
}

void PipeStrength::add_fields(std::vector<Field>& fields) {
  const auto find = [&](const char* name) { return find_field(fields, name); };
  tension_ = find(kTension);
  moment_2_ = find(kMoment2);
  moment_3_ = find(kMoment3);
  curvature_ = find(kCurvature);
  if (codes_.empty() || std::min({tension_, moment_2_, moment_3_, curvature_}) < 0) return;
  const auto add = [&](const char* name, const char* label, const char* code) {
    fields.push_back(of_code(name, label, code));
    return static_cast<int>(fields.size()) - 1;
  };
  if (case_.statics.enabled)
    buckling_ = add("dnv_local_buckling", "local buckling, DNV-ST-F101", "DNV-ST-F101");
  bending_ = add("api_bending_pressure", "bending and pressure, API RP 1111", "API RP 1111");
  pull_ = add("api_tension_pressure", "tension and pressure, API RP 1111", "API RP 1111");
}

void PipeStrength::declare(Declarations& to) {
  if (!codes_.empty()) to.every_step.insert({kTension, kMoment2, kMoment3, kCurvature});
}

PipeLoads PipeStrength::loads(const Values& values, size_t node) const {
  const auto value_of = [&](int field) { return values[field][node]; };
  return {value_of(moment_2_), value_of(moment_3_), value_of(tension_)};
}

void PipeStrength::start(const Snapshot& s) {
  static_loads_.clear();
  for (size_t n = 0; n < sides_.size() && bending_ >= 0; ++n) static_loads_.push_back(loads(s.values, n));
}

double PipeStrength::condition(const Side& side, const PipePlaces& places) const {
  const PipeConditions& conditions = case_.line_types[side.type].conditions;
  const auto within = [&](const std::vector<std::array<double, 2>>& stretches) {
    if (stretches.empty()) return false;
    const auto& [from, to] = stretches[side.line];
    return from <= side.arc && side.arc <= to;
  };
  return within(places.supports) ? conditions.supports
         : within(places.seabed) ? conditions.seabed
                                 : conditions.span;
}

// Places where the condition of a pipe depends on its support.
PipePlaces PipeStrength::places(const Snapshot& s) const {
  PipePlaces out;
  if (!by_place_) return out;
  if (rollers_) out.supports = rollers_->carrying(s);
  if (!case_.environment.seabed.present) return out;
  out.seabed.assign(mesh_.lines.size(), {HUGE_VAL, -HUGE_VAL});
  for (const Touchdown& t : s.touchdowns()) {
    std::array<double, 2>& lies = out.seabed[t.line];
    if (!t.from_a && t.laid > 0) lies = {-HUGE_VAL, HUGE_VAL};  // lies completely
    if (!t.from_a) continue;
    const double from = t.from_a->arc;
    const double to = t.from_b->arc;
    const double behind = mesh_.lines[t.line].length - to;
    // A line that lies up to one of its ends has a single touchdown point.
    if (to > from)
      lies = {from, to};
    else if (std::abs(t.laid - behind) < std::abs(t.laid - from))
      lies = {from, HUGE_VAL};
    else
      lies = {-HUGE_VAL, to};
  }
  return out;
}

void PipeStrength::fill(const Snapshot& s, Values& values) {
  if (bending_ < 0) return;
  const PipePlaces known = places(s);
  const model::Water& water = case_.environment.water;
  for (size_t n = 0; n < sides_.size(); ++n) {
    const double depth = water.present ? water.surface - values[0][3 * n + 2] : 0;
    const double outside = water.density * case_.environment.gravity * std::max(depth, 0.0);
    const PipeLoads now = loads(values, n);
    double worst[3] = {std::nan(""), std::nan(""), std::nan("")};
    for (const Side& side : sides_[n]) {
      if (side.type < 0) continue;
      const model::LineType& type = case_.line_types[side.type];
      const PipeCodes& codes = codes_[of_type_[side.type]];
      const double inside =
          type.contents_pressure + type.contents_density * case_.environment.gravity * depth;
      const double strain = 0.5 * codes.outer() * values[curvature_][n];
      if (!static_loads_.empty()) {
        const double factor = condition(side, known);
        worst[0] = std::fmax(worst[0], codes.local_buckling(static_loads_[n], now, factor, outside, inside));
        pulled_ = std::max(pulled_, codes.pulled(static_loads_[n], now, factor));
      }
      worst[1] = std::fmax(worst[1], codes.bending_and_pressure(strain, outside, inside));
      worst[2] = std::fmax(worst[2], codes.tension_and_pressure(now.tension, outside, inside));
    }
    for (const auto& [field, value] :
         {std::pair{buckling_, worst[0]}, {bending_, worst[1]}, {pull_, worst[2]}})
      if (field >= 0) values[field][n] = value;
  }
}

std::vector<Warning> PipeStrength::warnings(const std::vector<io::SummaryRow>&) {
  double largest = pulled_;
  all_reduce(comm_, MPI_MAX, largest);
  if (!(largest > kMaxPulled) || rank_of(comm_) != 0) return {};
  return {{advice::beyond_pipe_formulas(largest)}};
}

void PipeStrength::save(io::Checkpoint& to) {
  if (codes_.empty()) return;
  to.scalars[kPulled] = pulled_;
  io::CheckpointField& f = to.nodes[kRest];
  f.components = 3;
  for (size_t n = 0; n < sides_.size(); ++n) {
    const PipeLoads l = static_loads_.empty() ? PipeLoads{} : static_loads_[n];
    f.values.insert(f.values.end(), {l.moment_2, l.moment_3, l.tension});
  }
}

void PipeStrength::restore(const io::Checkpoint& from) {
  const auto at = from.nodes.find(kRest);
  if (at == from.nodes.end() || buckling_ < 0) return;
  static_loads_.clear();
  for (size_t n = 0; n < sides_.size(); ++n) {
    const double* v = at->second.values.data() + 3 * n;
    static_loads_.push_back({v[0], v[1], v[2]});
  }
  pulled_ = from.scalars.at(kPulled);
}

}  // namespace hawser::record
