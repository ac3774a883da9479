// The class LinePairPass: contact intervals of two elements, state of their points at the start of the step,
// and contact points of an accepted step. Forces and tangent are in line_pair_forces.cpp.
#include <algorithm>
#include <cmath>

#include "line_pair_point.hpp"

namespace hawser {
namespace {

// A panel is cut where the master's nearest point reaches an end, unless the slave crosses so steeply that
// the cut would move fast; the integrand is then smooth anyway.
constexpr double kSteep = 0.5;
constexpr double kRoot = 1e-15;

// Between straight axes panels are not finer than 2^-kStraightPanels of the element.
constexpr int kStraightPanels = 3;

// Weight of a pass against an end of the master, where another element joins it. Along a chain of elements b
// with the joints V the potential is phi(rho) = sum_b phi(rho_b) - sum_V phi(rho_V): the closest point at a
// joint belongs to both elements there and would count twice. Each of the two has half of the joint's term
// (docs/theory/line-line.md#a-chain-of-elements).
constexpr double kJointWeight = -0.5;

}  // namespace

double slave_fraction(double slave, double master) {
  const double ratio = std::max(slave, master) / std::min(slave, master);
  const double thin = std::min(ratio - 0.5, 1.0);
  return slave <= master ? thin : 1 - thin;
}

PairAxis::PairAxis(const AxisEnds& n, const AxisEnds& s) : now(n), start(s), ends(n) {
  if (n.beam) {
    for (size_t i = 0; i < 2; ++i) turn[i] = now.axes(i) * start.axes(i).transpose();
  } else {
    directions = {(s.x2 - s.x1).normalized(), (n.x2 - n.x1).normalized()};
    turn[0] = turn[1] = section_turn(directions[0], directions[1]);
  }
}

AttachedForces no_forces(const PairAxis& one, const PairAxis& other, bool has_friction, bool derivatives) {
  return AttachedForces(one.now.count() + other.now.count(), has_friction, derivatives);
}

Stencil stencil_of(const PairAxis& one, const PairAxis& other) {
  Stencil s;
  one.now.attach(s, 0);
  other.now.attach(s, 2);
  return s;
}

LinePairPass::LinePairPass(const PairAxis& slave, const PairAxis& master, ProjectOn target,
                           const Settings& settings, const std::vector<LinePairContactPoint>& previous)
    : slave_(slave), master_(master), target_(target), set_(settings), previous_(previous) {
  if (target_ != ProjectOn::element) set_.fraction *= kJointWeight;
  slave_lever_ = set_.slave_radius / set_.law.radii;
  master_lever_ = 1 - slave_lever_;
  at_slave_ = set_.swapped ? static_cast<size_t>(master.now.count()) : 0;
  at_master_ = set_.swapped ? 0 : static_cast<size_t>(slave.now.count());
  turn_slave_ = AttachedForces::kPositions + (set_.swapped ? 2 : 0);
  turn_master_ = AttachedForces::kPositions + (set_.swapped ? 0 : 2);
}

// Position between lo and hi on the slave where the nearest point passes the master's end `eta`, if any.
std::optional<double> LinePairPass::crossing_of(double eta, double lo, double hi) const {
  const Vec3 V = master_.now.point(eta);
  const Vec3 t = master_.now.slope(eta);
  const auto beyond = [&](double xi) { return (slave_.now.point(xi) - V).dot(t); };
  const double a = beyond(lo);
  const double b = beyond(hi);
  if (!((a < 0 && b > 0) || (a > 0 && b < 0))) return std::nullopt;
  double xi = lo - a * (hi - lo) / (b - a);
  for (int i = 0; i < 60; ++i) {
    const double v = beyond(xi);
    ((v < 0) == (a < 0) ? lo : hi) = xi;
    double next = xi - v / slave_.now.slope(xi).dot(t);
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    const double step = std::abs(next - xi);
    xi = next;
    if (step <= kRoot || hi - lo <= kRoot) break;
  }
  return xi;
}

// These positions, where the gap has a kink: it may decrease slowly on one side and increase steeply on the
// other, so that a scan without them may miss contact nearby.
std::vector<double> LinePairPass::kinks(int levels) const {
  std::vector<double> out;
  if (target_ != ProjectOn::element) return out;
  const double size = std::ldexp(1.0, -levels);
  for (const double eta : {0.0, 1.0})
    for (double a = 0; a < 1; a += size)
      if (const auto xi = crossing_of(eta, a, a + size)) out.push_back(*xi);
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<LinePairPass::Panel> LinePairPass::panels() const {
  // Gap along the slave minus the smoothing.
  const auto gap = [this](double xi, double) -> AxisGap {
    const AxisProjection f = projection(master_.now, target_, slave_.now.point(xi));
    return {f.distance - contact_distance(), f.normal.dot(slave_.now.slope(xi))};
  };
  // Between straight axes the gap is convex: it has one interval and is smooth along it.
  const bool straight = !slave_.beam() && !master_.beam();
  const double length = slave_.ends.length;
  const double radius = set_.slave_radius;
  const int levels = straight ? 1 : contact_levels(length, radius);
  const int fine = panel_levels(length, radius);
  std::vector<Panel> out;
  for (const ContactInterval& s :
       split_intervals(contact_intervals(gap, {slave_.now.slope_bound()}, levels, kinks(levels)),
                       straight ? std::min(fine, kStraightPanels) : fine)) {
    Panel p{s.from, s.to, s.from_moves ? End::gap : End::fixed, s.to_moves ? End::gap : End::fixed};
    if (p.from < set_.range[0]) {
      p.from = set_.range[0];
      p.at_from = End::fixed;
    }
    if (p.to > set_.range[1]) {
      p.to = set_.range[1];
      p.at_to = End::fixed;
    }
    if (!(p.from < p.to)) continue;
    if (target_ == ProjectOn::element)
      split(p, out);
    else
      out.push_back(p);
  }
  return out;
}

void LinePairPass::split(const Panel& panel, std::vector<Panel>& out) const {
  Panel cuts[2];
  int n = 0;
  for (const double eta : {0.0, 1.0}) {
    const auto xi = crossing_of(eta, panel.from, panel.to);
    if (!xi) continue;
    const Vec3 x1 = slave_.now.slope(*xi);
    const Vec3 t = master_.now.slope(eta);
    if (std::abs(x1.dot(t)) < kSteep * x1.norm() * t.norm()) continue;
    if ((slave_.now.point(*xi) - master_.now.point(eta)).norm() >= contact_distance())
      continue;  // contact is at another bend
    cuts[n].from = *xi;
    cuts[n++].at_from = eta == 0 ? End::first_joint : End::second_joint;
  }
  if (n == 2 && cuts[1].from < cuts[0].from) std::swap(cuts[0], cuts[1]);
  Panel remaining = panel;
  for (int i = 0; i < n; ++i) {
    out.push_back({remaining.from, cuts[i].from, remaining.at_from, cuts[i].at_from});
    remaining.from = cuts[i].from;
    remaining.at_from = cuts[i].at_from;
  }
  out.push_back(remaining);
}

// Slip is interpolated between the Gauss points of an interval. New material has none.
LinePairPass::Start LinePairPass::start(double xi) const {
  Start s;
  // Points are sorted by position: if a panel contains xi, one of the points next to xi is in it.
  const auto after = std::partition_point(previous_.begin(), previous_.end(),
                                          [xi](const LinePairContactPoint& h) { return h.xi <= xi; });
  const LinePairContactPoint* b = after != previous_.end() ? &*after : nullptr;
  const LinePairContactPoint* a = after != previous_.begin() ? &*(after - 1) : nullptr;
  const auto has = [xi](const LinePairContactPoint* h) { return h && h->from <= xi && xi <= h->to; };
  s.is_new = !has(a) && !has(b);
  if (s.is_new) return s;
  if (a && b && a->from != b->from && a->to != b->from) (xi <= a->to ? b : a) = nullptr;
  // Beyond the outermost point slip decreases to zero where contact ends.
  const double x0 = a ? a->xi : b->from;
  const double x1 = b ? b->xi : a->to;
  for (int c = 0; c < 2; ++c) {
    const double v0 = a ? a->slip[c] : b->opens ? 0 : b->slip[c];
    const double v1 = b ? b->slip[c] : a->closes ? 0 : a->slip[c];
    s.slip_slope[c] = x1 > x0 ? (v1 - v0) / (x1 - x0) : 0;
    s.slip[c] = v0 + s.slip_slope[c] * (xi - x0);
  }
  return s;
}

LinePairPass::Point LinePairPass::point(double xi) const {
  Point p;
  p.xi = xi;
  p.foot = projection(master_.now, target_, slave_.now.point(xi));
  p.H = slave_.now.functions(xi);
  p.G = master_.now.functions(p.foot.eta);
  p.slope = slave_.now.slope(xi);
  p.along = master_.now.slope(p.foot.eta);
  p.velocity = set_.moves ? Vec3(slave_.now.velocity(xi) - master_.now.velocity(p.foot.eta)) : Vec3::Zero();
  if (set_.law.friction.active()) {
    p.Ta = slave_.turn_at(xi);
    p.Tb = master_.turn_at(p.foot.eta);
    p.before = slave_.start.point(xi) - master_.start.point(p.foot.eta);
  }
  return p;
}

LinePairPoint LinePairPass::local(const Point& p, const Start& s) const {
  LinePairPoint l;
  l.away = p.foot.away;
  l.along = p.along;
  l.rate = p.foot.normal.dot(p.velocity);
  if (set_.law.friction.active()) {
    l.moved = l.away - slave_lever_ * (p.Ta * p.before) - master_lever_ * (p.Tb * p.before);
    l.slip[0] = s.slip[0];
    l.slip[1] = s.slip[1];
    l.is_new = s.is_new;
    l.away_before = p.before;
    l.slope = p.slope;
    l.slope_before = slave_.start.slope(p.xi);
    l.along_before = master_.start.slope(p.foot.eta);
  }
  return l;
}

LinePairContactPoint LinePairPass::stored_point(const Panel& panel, const Point& p, const LinePairForce& c,
                                                double weight) const {
  LinePairContactPoint h;
  h.xi = p.xi;
  h.from = panel.from;
  h.to = panel.to;
  h.opens = panel.at_from == End::gap;
  h.closes = panel.at_to == End::gap;
  h.weight = weight;
  h.eta = p.foot.eta;
  h.slip[0] = c.slip[0];
  h.slip[1] = c.slip[1];
  h.force = c.force;
  h.friction = c.friction;
  h.normal = p.foot.normal;
  h.normal_force = c.along_normal.force;
  h.damping_force = c.along_normal.force - c.along_normal.elastic;
  h.potential = c.along_normal.potential;
  h.gap = c.gap;
  return h;
}

double LinePairPass::potential(const std::vector<Panel>& panels) const {
  double sum = 0;
  for (const Panel& s : panels)
    for (size_t q = 0; q < kContactPoints; ++q) {
      const PanelPoint at = panel_point(q);
      const double xi = s.from + (s.to - s.from) * at.place;
      const double d = projection(master_.now, target_, slave_.now.point(xi)).distance;
      sum += set_.fraction * slave_.ends.length * (s.to - s.from) * at.weight *
             normal_force(set_.law.normal, d - set_.law.radii, 0).potential;
    }
  return sum;
}

}  // namespace hawser
