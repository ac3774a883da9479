// The class SupportSettlement: contacts as supports of a continuous beam, and the effects of their
// penetration.
#include "hawser/record/support_settlement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "hawser/base/mpi.hpp"
#include "hawser/kernels/continuous_beam.hpp"
#include "hawser/model/check.hpp"
#include "hawser/record/contact_points.hpp"

namespace hawser::record {
namespace {

constexpr double kWarned = 0.02;       // of a reaction, or of the largest moment
constexpr double kRemaining = 0.005;   // effect after the remedy
constexpr double kShort = 0.2;         // length of a support over that of the spans beside it
constexpr double kSignificant = 0.5;   // of the line's largest reaction, below which one counts as this part
constexpr double kRollerDepth = 0.01;  // of the radius, where the stiffness of a roller is defined

// Smallest gap between points across a round surface, where the gap is a parabola.
double smallest_gap(std::span<const LineVolumeContact::Load> points) {
  const auto less = [](const auto& a, const auto& b) { return a.gap < b.gap; };
  const auto at = std::min_element(points.begin(), points.end(), less);
  if (at == points.begin() || at + 1 == points.end()) return at->gap;
  const double a = (at - 1)->xi - at->xi;
  const double b = (at + 1)->xi - at->xi;
  if (!(a < 0 && b > 0)) return at->gap;  // points of several facet groups
  const double slope_a = ((at - 1)->gap - at->gap) / a;
  const double slope_b = ((at + 1)->gap - at->gap) / b;
  const double curvature = (slope_b - slope_a) / (b - a);  // half the second derivative
  const double slope = slope_a - curvature * a;
  return curvature > 0 ? at->gap - slope * slope / (4 * curvature) : at->gap;
}

}  // namespace

bool SupportSettlement::possible(const Subject& s) {
  const auto is_beam = [](const model::LineType& t) { return t.smallest_bending_stiffness() > 0; };
  return s.model.statics.enabled && s.term<LineVolumeContact>() &&
         std::any_of(s.model.line_types.begin(), s.model.line_types.end(), is_beam);
}

SupportSettlement::SupportSettlement(const Subject& subject)
    : subject_(subject), volumes_(case_indices_of_volumes(subject)) {}

void SupportSettlement::declare(Declarations& to) {
  moment_ = find_field(to.contents.fields, "bending_moment");
  if (moment_ >= 0) to.every_step.insert("bending_moment");
}

// By virtual work the supports move the beam by the mean of their settlements, weighted by their forces;
// forces that nearly cancel, as of a clamp, are no support.
Vec3 SupportSettlement::Support::displacement() const {
  if (!(pressed > 0)) return Vec3::Zero();
  return -work / std::max(force.norm(), 0.5 * pressed) * force.normalized();
}

// Of an automatic stiffness all penetration counts; a given one is that of the support, and only the
// difference (d + g)²/4d of its smooth onset d at the gap g = -depth counts, by which the axis is above that
// of the linear law.
double SupportSettlement::settlement(const Support& s) const {
  if (subject_.model.volumes[s.volume].basis == model::StiffnessBasis::automatic) return s.depth;
  const double d = s.smoothing;
  if (!(d > 0) || s.depth >= d) return 0;
  return -(d - s.depth) * (d - s.depth) / (4 * d);
}

SupportSettlement::Support SupportSettlement::support(const Kinematics& state,
                                                      std::span<const LineVolumeContact::Load> loads) const {
  const LocalMesh& mesh = subject_.local();
  const LocalElement& e = mesh.elements[loads.front().element];
  const model::LineType& type = subject_.model.line_types[mesh.element(e).type];
  const Vec3 along = (state.x[e.second] - state.x[e.first]).normalized();
  Support s{.line = mesh.element(e).line,
            .volume = volumes_[loads.front().volume],
            .from = arc_at(mesh, e, loads.front().from),
            .to = arc_at(mesh, e, loads.back().to),
            .radius = 0.5 * type.contact_diameter,
            .EI = type.smallest_bending_stiffness()};
  for (const LineVolumeContact::Load& l : loads) s.force += l.force - along.dot(l.force) * along;
  s.depth = -smallest_gap(loads);
  s.smoothing = loads.front().smoothing;
  s.pressed = s.force.norm();
  s.work = s.pressed * settlement(s);
  return s;
}

std::vector<SupportSettlement::Support> SupportSettlement::supports_of_rank(const Kinematics& state) const {
  const LocalMesh& mesh = subject_.local();
  const std::vector<LineVolumeContact::Load> loads = subject_.term<LineVolumeContact>()->loads(state);
  std::vector<Support> out;
  for (auto first = loads.begin(); first != loads.end();) {
    const auto last = std::find_if(first + 1, loads.end(), [&](const LineVolumeContact::Load& l) {
      return l.element != first->element || l.volume != first->volume || l.from > (&l - 1)->to;
    });
    const LocalElement& e = mesh.elements[first->element];
    if (e.counted && mesh.element(e).beam) out.push_back(support(state, {first, last}));
    first = last;
  }
  return out;
}

std::vector<SupportSettlement::Support> SupportSettlement::chain(std::span<const Support> of_line) const {
  const int l = of_line.front().line;
  const model::Line& line = subject_.model.lines[l];
  const double length = subject_.mesh().lines[l].length;
  std::vector<Support> out;
  for (const Support& s : of_line) {
    if (out.empty() || s.from > out.back().to + s.radius) {
      out.push_back(s);
      continue;
    }
    Support& joined = out.back();
    if (s.pressed > joined.pressed) {
      joined.volume = s.volume;
      joined.smoothing = s.smoothing;
    }
    joined.to = std::max(joined.to, s.to);
    joined.force += s.force;
    joined.pressed += s.pressed;
    joined.work += s.work;
    joined.depth = std::max(joined.depth, s.depth);
  }
  const Support first = out.front();
  const Support last = out.back();
  if (model::is_held(line.end_a) && !line.end_a.feed && first.from > first.radius)
    out.insert(out.begin(), {.line = l, .EI = first.EI});
  if (model::is_held(line.end_b) && !line.end_b.feed && last.to < length - last.radius)
    out.push_back({.line = l, .from = length, .to = length, .EI = last.EI});
  return out;
}

void SupportSettlement::find_worst(std::span<const Support> chain, double largest_moment) {
  std::vector<BeamSpan> spans;
  std::vector<Vec3> displacements;
  double most = 0;  // N
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
  for (size_t i = 0; i < chain.size(); ++i) {
    displacements.push_back(chain[i].displacement());
    most = std::max(most, chain[i].force.norm());
    low = i > 0 ? Vec3(low.cwiseMin(displacements.back())) : displacements.back();
    high = i > 0 ? Vec3(high.cwiseMax(displacements.back())) : displacements.back();
    if (i > 0) spans.push_back({chain[i].from - chain[i - 1].to, chain[i - 1].EI});
  }
  const std::vector<SettlementEffect> effects = settlement_effects(spans, displacements);
  for (size_t i = 0; i < chain.size(); ++i) {
    const Support& s = chain[i];
    const double before = i > 0 ? spans[i - 1].length : HUGE_VAL;
    const double after = i < spans.size() ? spans[i].length : HUGE_VAL;
    if (s.volume < 0 || s.to - s.from > kShort * std::min(before, after)) continue;
    const double reaction = s.force.norm();
    const double of_reaction = effects[i].force.norm() / std::max(reaction, kSignificant * most);
    const double of_moment = largest_moment > 0 ? effects[i].moment.norm() / largest_moment : 0;
    const double worst = std::max(of_reaction, of_moment);
    if (!(worst > std::max(kWarned, worst_))) continue;
    worst_ = worst;
    const model::Volume& v = subject_.model.volumes[s.volume];
    const bool automatic = v.basis == model::StiffnessBasis::automatic;
    advice::SettledSupport at{.line = subject_.mesh().line_names[s.line],
                              .volume = v.name,
                              .arc = 0.5 * (s.from + s.to),
                              .penetration = s.depth,
                              .of_reaction = effects[i].force.norm() / reaction,
                              .of_moment = of_moment,
                              .by_smoothing = !automatic || s.depth < 0,
                              .roller = v.roller};
    at.remedy = (at.by_smoothing ? s.smoothing : (high - low).norm()) * kRemaining / worst;
    // The force of a roller is proportional to the penetration to the power 3/2.
    if (at.roller && !at.by_smoothing)
      at.remedy = reaction / at.remedy * std::sqrt(kRollerDepth * s.radius / at.remedy);
    text_ = advice::settles(at);
  }
}

void SupportSettlement::start(const Snapshot& s) {
  const LocalMesh& mesh = subject_.local();
  std::vector<Support> all = gather_all(subject_.comm(), supports_of_rank(s.at));
  if (all.empty()) return;
  std::map<int, size_t> place;  // by line with supports, in `moments`
  for (const Support& of_line : all) place.try_emplace(of_line.line, place.size());
  std::vector<double> moments(place.size(), 0);  // N m, largest of the line
  for (size_t n = 0; moment_ >= 0 && n < static_cast<size_t>(mesh.owned); ++n) {
    const auto at = place.find(mesh.node(static_cast<int>(n)).line);
    if (at != place.end())
      moments[at->second] = std::fmax(moments[at->second], std::abs(s.values[moment_][n]));
  }
  all_reduce(subject_.comm(), MPI_MAX, moments);
  if (rank_of(subject_.comm()) != 0) return;
  std::sort(all.begin(), all.end(), [](const Support& a, const Support& b) {
    return std::tie(a.line, a.from, a.to, a.volume) < std::tie(b.line, b.from, b.to, b.volume);
  });
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(first, all.end(), [&](const Support& o) { return o.line != first->line; });
    find_worst(chain({first, last}), moments[place[first->line]]);
    first = last;
  }
}

std::vector<std::string> SupportSettlement::remarks() {
  if (text_.empty() || !subject_.model.dynamics.enabled) return {};
  return {std::exchange(text_, {})};
}

std::vector<Warning> SupportSettlement::warnings(const std::vector<io::SummaryRow>&) {
  if (text_.empty()) return {};
  return {{text_}};
}

}  // namespace hawser::record
