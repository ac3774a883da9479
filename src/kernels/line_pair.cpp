// The class LinePairSide: where an element touches another, elastic slip from the start of the step, forces
// and couples at the Gauss points, their exact tangent, and the history kept.
#include "hawser/kernels/line_pair.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/kernels/line_pair_closing.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

// A panel is cut where the master's nearest point reaches an end, unless the slave crosses so steeply that
// the place would run away: then the integrand changes gently anyway.
constexpr double kSteep = 0.5;
constexpr double kRoot = 1e-15;

}  // namespace

double slave_share(double slave, double master) {
  const double ratio = std::max(slave, master) / std::min(slave, master);
  const double thin = std::min(ratio - 0.5, 1.0);
  return slave <= master ? thin : 1 - thin;
}

PairAxis::PairAxis(const AxisEnds& n, const AxisEnds& s) : now(n), start(s), ends(n) {
  if (n.beam) {
    to_space = {n.q1.toRotationMatrix(), n.q2.toRotationMatrix()};
    turn = {to_space[0] * s.q1.toRotationMatrix().transpose(),
            to_space[1] * s.q2.toRotationMatrix().transpose()};
  } else {
    const Vec3 was = (s.x2 - s.x1).normalized(), is = (n.x2 - n.x1).normalized();
    turn[0] = turn[1] = minimal_rotation(was, is).toRotationMatrix();
    to_space[0] = to_space[1] = Mat3::Identity();
  }
}

LinePairForces::LinePairForces(int slave_count, int master_count) : slave(slave_count), master(master_count) {
  F.fill(Vec3::Zero());
  for (auto& row : K) row.fill(Mat3::Zero());
  for (auto& row : C) row.fill(Mat3::Zero());
}

LinePairSide::LinePairSide(const PairAxis& slave, const PairAxis& master, ProjectOn part,
                           const Settings& settings, const std::vector<LinePairHistory>& history)
    : slave_(slave), master_(master), part_(part), set_(settings), history_(history) {
  if (part_ != ProjectOn::element) set_.share *= -0.5;
  wa_ = set_.slave_radius / set_.law.reach;
  wb_ = 1 - wa_;
}

// Where the nearest point passes the master's end `eta` between two places of the slave; none: it does not.
std::optional<double> LinePairSide::passes(double eta, double lo, double hi) const {
  const Vec3 V = master_.now.point(eta), t = master_.now.slope(eta);
  const auto beyond = [&](double xi) { return (slave_.now.point(xi) - V).dot(t); };
  const double a = beyond(lo), b = beyond(hi);
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

// Those places: the gap has a kink there, on one side of which it may fall slowly and on the other rise
// steeply, and to a scan that does not know of it a contact about there may seem to be none.
std::vector<double> LinePairSide::kinks(int levels) const {
  std::vector<double> out;
  if (part_ != ProjectOn::element) return out;
  const double size = std::ldexp(1.0, -levels);
  for (const double eta : {0.0, 1.0})
    for (double a = 0; a < 1; a += size)
      if (const auto xi = passes(eta, a, a + size)) out.push_back(*xi);
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<LinePairSide::Panel> LinePairSide::panels() const {
  // Along the slave, less the smoothing.
  const auto gap = [this](double xi, double) -> AxisGap {
    const AxisProjection f = projection(master_.now, part_, slave_.now.point(xi));
    return {f.distance - touch(), f.normal.dot(slave_.now.slope(xi))};
  };
  const int levels = contact_levels(slave_.ends.length, set_.slave_radius);
  std::vector<Panel> out;
  for (const ContactStretch& s :
       cut_stretches(contact_stretches(gap, {slave_.now.reach()}, levels, kinks(levels)), levels)) {
    const Panel p{s.from, s.to, s.from_moves ? End::gap : End::fixed, s.to_moves ? End::gap : End::fixed};
    if (part_ == ProjectOn::element)
      split(p, out);
    else
      out.push_back(p);
  }
  return out;
}

void LinePairSide::split(const Panel& panel, std::vector<Panel>& out) const {
  Panel cuts[2];
  int n = 0;
  for (const double eta : {0.0, 1.0}) {
    const auto xi = passes(eta, panel.from, panel.to);
    if (!xi) continue;
    const Vec3 x1 = slave_.now.slope(*xi), t = master_.now.slope(eta);
    if (std::abs(x1.dot(t)) < kSteep * x1.norm() * t.norm()) continue;
    if ((slave_.now.point(*xi) - master_.now.point(eta)).norm() >= touch()) continue;  // another bend
    cuts[n].from = *xi;
    cuts[n++].at_from = eta == 0 ? End::first_joint : End::second_joint;
  }
  if (n == 2 && cuts[1].from < cuts[0].from) std::swap(cuts[0], cuts[1]);
  Panel rest = panel;
  for (int i = 0; i < n; ++i) {
    out.push_back({rest.from, cuts[i].from, rest.at_from, cuts[i].at_from});
    rest.from = cuts[i].from, rest.at_from = cuts[i].at_from;
  }
  out.push_back(rest);
}

struct LinePairSide::Point {
  double xi = 0;
  AxisProjection foot;
  AxisShape::Weights H, G;  // slave's at xi, master's at eta
  Vec3 slope, along;        // x', y', m
  Vec3 velocity;            // m/s, of x relative to y
  Mat3 Ta, Tb;              // turns of the sections
  Vec3 was;                 // m, x - y of the same material at the start
};

// What a material point of the slave brings from the start of the step. Derivatives along the slave, along
// the master, and by the generalised positions at these places.
struct LinePairSide::Start {
  double slip[2] = {0, 0}, slip_slope[2] = {0, 0};
  double closing = 0, closing_xi = 0, closing_eta = 0;
  std::array<Vec3, LinePairForces::kPositions> closing_by;
};

// Of material that did not touch.
void LinePairSide::close(const Point& p, bool derivatives, Start& s) const {
  using C = LinePairClosing;
  const double eta = p.foot.eta;
  const Vec3 slope0 = slave_.start.slope(p.xi), along0 = master_.start.slope(eta);
  const C c = line_pair_closing({p.foot.away, p.was, p.slope, slope0, p.along, along0}, derivatives);
  s.closing = c.value;
  if (!derivatives) return;
  const auto by = [&c](int row) -> Vec3 { return c.by.segment<3>(row); };
  s.closing_xi = by(C::kAway).dot(p.slope) + by(C::kAwayBefore).dot(slope0) +
                 by(C::kSlope).dot(slave_.now.bend(p.xi)) + by(C::kSlopeBefore).dot(slave_.start.bend(p.xi));
  s.closing_eta = -by(C::kAway).dot(p.along) - by(C::kAwayBefore).dot(along0) +
                  by(C::kAlong).dot(master_.now.bend(eta)) + by(C::kAlongBefore).dot(master_.start.bend(eta));
  const AxisShape::Weights dH = slave_.now.derivatives(p.xi), dG = master_.now.derivatives(eta);
  const size_t na = static_cast<size_t>(slave_.now.count()), nb = static_cast<size_t>(master_.now.count());
  for (size_t j = 0; j < na; ++j) s.closing_by[j] = p.H[j] * by(C::kAway) + dH[j] * by(C::kSlope);
  for (size_t k = 0; k < nb; ++k) s.closing_by[na + k] = -p.G[k] * by(C::kAway) + dG[k] * by(C::kAlong);
}

// Slip is interpolated between the Gauss points of one stretch. Material that did not touch has none.
LinePairSide::Start LinePairSide::start(const Point& p, bool derivatives) const {
  Start s;
  const double xi = p.xi;
  const bool touched = std::any_of(history_.begin(), history_.end(),
                                   [xi](const LinePairHistory& h) { return h.from <= xi && xi <= h.to; });
  s.closing_by.fill(Vec3::Zero());
  if (!touched) {
    close(p, derivatives, s);
    return s;
  }
  const auto after =
      std::find_if(history_.begin(), history_.end(), [xi](const LinePairHistory& h) { return h.xi > xi; });
  const LinePairHistory* b = after != history_.end() ? &*after : nullptr;
  const LinePairHistory* a = after != history_.begin() ? &*(after - 1) : nullptr;
  if (!a && !b) return s;
  if (a && b && a->from != b->from && a->to != b->from) (xi <= a->to ? b : a) = nullptr;
  // Outside the outermost point: down to nothing where contact ends, for beyond there is none.
  const double x0 = a ? a->xi : b->from, x1 = b ? b->xi : a->to;
  for (int c = 0; c < 2; ++c) {
    const double v0 = a          ? a->slip[c]
                      : b->opens ? 0
                                 : b->slip[c],
                 v1 = b           ? b->slip[c]
                      : a->closes ? 0
                                  : a->slip[c];
    s.slip_slope[c] = x1 > x0 ? (v1 - v0) / (x1 - x0) : 0;
    s.slip[c] = v0 + s.slip_slope[c] * (xi - x0);
  }
  return s;
}

LinePairSide::Point LinePairSide::point(double xi) const {
  Point p;
  p.xi = xi;
  p.foot = projection(master_.now, part_, slave_.now.point(xi));
  p.H = slave_.now.functions(xi), p.G = master_.now.functions(p.foot.eta);
  p.slope = slave_.now.slope(xi), p.along = master_.now.slope(p.foot.eta);
  p.velocity = set_.moves ? Vec3(slave_.now.velocity(xi) - master_.now.velocity(p.foot.eta)) : Vec3::Zero();
  if (set_.law.friction.active()) {
    p.Ta = slave_.turn_at(xi), p.Tb = master_.turn_at(p.foot.eta);
    p.was = slave_.start.point(xi) - master_.start.point(p.foot.eta);
  }
  return p;
}

LinePairPoint LinePairSide::local(const Point& p, const Start& s) const {
  LinePairPoint l;
  l.away = p.foot.away;
  l.along = p.along;
  l.rate = p.foot.normal.dot(p.velocity);
  if (set_.law.friction.active()) {
    l.moved = l.away - wa_ * (p.Ta * p.was) - wb_ * (p.Tb * p.was);
    l.closing = s.closing;
    l.slip[0] = s.slip[0], l.slip[1] = s.slip[1];
  }
  return l;
}

void LinePairSide::keep(const std::vector<Panel>& panels, std::vector<LinePairHistory>& out) const {
  for (const Panel& s : panels)
    for (size_t q = 0; q < ContactRule::kPoints; ++q) {
      const double xi = s.from + (s.to - s.from) * ContactRule::place()[q];
      const Point p = point(xi);
      const LinePairForce c =
          line_pair_force(set_.law, local(p, set_.law.friction.active() ? start(p, false) : Start{}), false);
      if (!(c.normal.elastic > 0)) continue;
      LinePairHistory h;
      h.xi = xi, h.from = s.from, h.to = s.to;
      h.opens = s.at_from == End::gap, h.closes = s.at_to == End::gap;
      h.weight = set_.share * slave_.ends.length * (s.to - s.from) * ContactRule::weight()[q];
      h.eta = p.foot.eta;
      h.slip[0] = c.slip[0], h.slip[1] = c.slip[1];
      h.force = c.force, h.friction = c.friction, h.normal = p.foot.normal;
      h.normal_force = c.normal.force, h.damping_force = c.normal.force - c.normal.elastic;
      h.potential = c.normal.potential, h.gap = c.gap;
      out.push_back(h);
    }
}

double LinePairSide::potential(const std::vector<Panel>& panels) const {
  double sum = 0;
  for (const Panel& s : panels)
    for (size_t q = 0; q < ContactRule::kPoints; ++q) {
      const double xi = s.from + (s.to - s.from) * ContactRule::place()[q];
      const double d = projection(master_.now, part_, slave_.now.point(xi)).distance;
      sum += set_.share * slave_.ends.length * (s.to - s.from) * ContactRule::weight()[q] *
             normal_force(set_.law.normal, d - set_.law.reach, 0).potential;
    }
  return sum;
}

// The tangent is exact. With the slave's place xi given, everything depends on D = x - y and T = y' at a
// given eta, on the sections' turns and on eta, which follows from D . y' = 0:
//   d eta = ((dx - dy) . y' + D . dy') / (y' . y' - D . y'').
// Moving ends of panels take the Gauss points along: the derivative along xi does the rest.
void LinePairSide::add(const std::vector<Panel>& panels, bool derivatives, LinePairForces& g) const {
  using Six = Eigen::Matrix<double, 6, 3>;
  using Column = Eigen::Matrix<double, 6, 1>;
  using F = LinePairForce;
  const bool rubs = set_.law.friction.active();
  const int na = g.slave, nb = g.master, n = na + nb;
  g.rotates = g.rotates || rubs;
  const double L = set_.share * slave_.ends.length;
  // Index of generalised position j of the master: na + j; of the rotations: kPositions + 0..3.
  constexpr int kTurns = LinePairForces::kPositions;
  const bool turns[4] = {rubs && slave_.beam(), rubs && slave_.beam(), rubs && master_.beam(),
                         rubs && master_.beam()};

  for (const Panel& s : panels) {
    const double span = s.to - s.from;
    // Ends that move: ds/dZ.
    struct Moving {
      bool on = false;
      std::array<Vec3, kTurns> by;
      std::array<Vec3, LinePairForces::kMost> force;
    } moving[2];
    for (size_t i = 0; i < 2 && derivatives && !set_.convex; ++i) {
      const End end = i ? s.at_to : s.at_from;
      if (end == End::fixed) continue;
      Moving& m = moving[i];
      const double xi = i ? s.to : s.from;
      const Vec3 x = slave_.now.point(xi), x1 = slave_.now.slope(xi);
      const AxisShape::Weights H = slave_.now.functions(xi);
      m.force.fill(Vec3::Zero());
      if (end == End::gap) {
        const AxisProjection f = projection(master_.now, part_, x);
        const double slope = f.normal.dot(x1);
        if (std::abs(slope) < 1e-9 * slave_.now.reach()) continue;
        const AxisShape::Weights G = master_.now.functions(f.eta);
        for (int j = 0; j < na; ++j)
          m.by[static_cast<size_t>(j)] = -H[static_cast<size_t>(j)] / slope * f.normal;
        for (int k = 0; k < nb; ++k)
          m.by[static_cast<size_t>(na + k)] = G[static_cast<size_t>(k)] / slope * f.normal;
      } else {
        const double eta = end == End::first_joint ? 0 : 1;
        const Vec3 V = master_.now.point(eta), t = master_.now.slope(eta);
        const double slope = x1.dot(t);
        const AxisShape::Weights G = master_.now.functions(eta), dG = master_.now.derivatives(eta);
        for (int j = 0; j < na; ++j) m.by[static_cast<size_t>(j)] = -H[static_cast<size_t>(j)] / slope * t;
        for (int k = 0; k < nb; ++k) {
          const size_t c = static_cast<size_t>(k);
          m.by[static_cast<size_t>(na + k)] = (G[c] * t - dG[c] * (x - V)) / slope;
        }
      }
      m.on = true;
    }

    for (size_t q = 0; q < ContactRule::kPoints; ++q) {
      const double place = ContactRule::place()[q], weight = ContactRule::weight()[q];
      const double xi = s.from + span * place, w = L * span * weight;
      const Point p = point(xi);
      const Start from = rubs ? start(p, derivatives && !set_.convex) : Start{};
      const F c = line_pair_force(set_.law, local(p, from), derivatives);
      if (!(c.normal.force > 0)) continue;
      const double eta = p.foot.eta;
      const double Na[2] = {1 - xi, xi}, Nb[2] = {1 - eta, eta};
      // Rows: weight h of the vector (force or couple) that a row of F gets.
      std::array<double, LinePairForces::kMost> h{};
      for (int j = 0; j < na; ++j) h[static_cast<size_t>(j)] = p.H[static_cast<size_t>(j)];
      for (int k = 0; k < nb; ++k) h[static_cast<size_t>(na + k)] = -p.G[static_cast<size_t>(k)];
      for (size_t i = 0; i < 2; ++i) {
        if (turns[i]) h[kTurns + i] = wa_ * Na[i];
        if (turns[2 + i]) h[kTurns + 2 + i] = wb_ * Nb[i];
      }
      const auto used = [&](int r) { return r < n || (r >= kTurns && turns[r - kTurns]); };
      const auto vector = [&](int r) -> const Vec3& { return r < kTurns ? c.force : c.couple; };
      // The residual is internal minus external: -force.
      for (int r = 0; r < LinePairForces::kMost; ++r)
        if (used(r)) g.F[static_cast<size_t>(r)] -= w * h[static_cast<size_t>(r)] * vector(r);
      if (!derivatives) continue;

      const Vec3& nrm = p.foot.normal;
      const Vec3& y1 = p.along;
      const AxisShape::Weights dH = slave_.now.derivatives(xi), dG = master_.now.derivatives(eta);
      const Vec3 y2 = master_.now.bend(eta);
      const double curve = y1.squaredNorm() - p.foot.away.dot(y2);
      const bool slides_on = p.foot.inside && curve > 0;
      const auto by = [&](int column) { return c.by.block<6, 3>(0, column); };
      const Six by_moved = by(F::kMoved);
      if (set_.convex) {
        const Six flat = by_moved;
        for (int r = 0; r < n; ++r)
          for (int m = 0; m < n; ++m) {
            const double hh = w * h[static_cast<size_t>(r)] * h[static_cast<size_t>(m)];
            g.K[static_cast<size_t>(r)][static_cast<size_t>(m)] -=
                hh * (c.normal.by_gap * nrm * nrm.transpose() + flat.topRows<3>());
          }
        continue;
      }
      const Column by_rate = c.by.col(F::kRate);
      const Mat3 P = (Mat3::Identity() - nrm * nrm.transpose()) / p.foot.distance;
      const Six QD = by(F::kAway) + by_moved + by_rate * (P * p.velocity).transpose();

      Column q_eta = -QD * y1 + by(F::kAlong) * y2;
      Column q_xi = QD * p.slope;
      if (set_.moves) {
        q_eta -= by_rate * nrm.dot(master_.now.velocity_slope(eta));
        q_xi += by_rate * nrm.dot(slave_.now.velocity_slope(xi));
      }
      if (rubs) {
        const Mat3 T = wa_ * p.Ta + wb_ * p.Tb;
        q_eta +=
            by_moved * (T * master_.start.slope(eta) - wb_ * ((master_.turn[1] - master_.turn[0]) * p.was));
        q_xi += by_moved * (-T * slave_.start.slope(xi) - wa_ * ((slave_.turn[1] - slave_.turn[0]) * p.was));
        q_eta += c.by.col(F::kClosing) * from.closing_eta;
        q_xi += c.by.col(F::kClosing) * from.closing_xi + c.by.col(F::kSlip) * from.slip_slope[0] +
                c.by.col(F::kSlip + 1) * from.slip_slope[1];
      }
      // d eta / dZ and / d xi.
      std::array<Vec3, kTurns> e;
      double e_xi = 0;
      if (slides_on) {
        for (int j = 0; j < na; ++j) e[static_cast<size_t>(j)] = p.H[static_cast<size_t>(j)] / curve * y1;
        for (int k = 0; k < nb; ++k) {
          const size_t b = static_cast<size_t>(k);
          e[static_cast<size_t>(na + k)] = (dG[b] * p.foot.away - p.G[b] * y1) / curve;
        }
        e_xi = p.slope.dot(y1) / curve;
      } else {
        e.fill(Vec3::Zero());
      }
      q_xi += q_eta * e_xi;

      // Derivatives of (force, couple) by each column.
      std::array<Six, LinePairForces::kMost> J;
      for (int m = 0; m < n; ++m) {
        const size_t b = static_cast<size_t>(m);
        J[b] = (m < na ? p.H[b] : -p.G[b - static_cast<size_t>(na)]) * QD;
        if (m >= na && rubs) J[b] += dG[b - static_cast<size_t>(na)] * by(F::kAlong);
        if (rubs) J[b] += c.by.col(F::kClosing) * from.closing_by[b].transpose();
        if (slides_on) J[b] += q_eta * e[b].transpose();
      }
      for (size_t i = 0; i < 2; ++i) {
        // - w N d(turn was), with d(turn) v = dphi x (turn v)
        if (turns[i]) J[kTurns + i] = wa_ * Na[i] * by_moved * hat(slave_.turn[i] * p.was);
        if (turns[2 + i]) J[kTurns + 2 + i] = wb_ * Nb[i] * by_moved * hat(master_.turn[i] * p.was);
      }
      if (rubs)
        for (int line = 0; line < 2; ++line) {
          const PairAxis& axis = line ? master_ : slave_;
          if (axis.beam()) continue;
          // Sections of a cable turn by the smallest rotation from f to t, its axis then and now:
          // v - (f + t)(t . v + f . v)/(1 + f . t) + 2 t (f . v).
          const Vec3 chord = axis.now.slope(0), t = chord.normalized(), f = axis.start.slope(0).normalized(),
                     sum = f + t;
          const double opening = 1 + f.dot(t), a = sum.dot(p.was);
          const Mat3 by_t = -(a / opening) * Mat3::Identity() - sum * p.was.transpose() / opening +
                            sum * f.transpose() * (a / (opening * opening)) +
                            2 * f.dot(p.was) * Mat3::Identity();
          const Six turned =
              (line ? wb_ : wa_) * by_moved * by_t * ((Mat3::Identity() - t * t.transpose()) / chord.norm());
          const size_t first = line ? static_cast<size_t>(na) : 0;
          J[first] += turned, J[first + 1] -= turned;
        }

      for (int r = 0; r < LinePairForces::kMost; ++r) {
        if (!used(r)) continue;
        const size_t b = static_cast<size_t>(r);
        const int part = r < kTurns ? 0 : 3;
        // How the row's weight moves with eta and xi.
        double h_eta = 0, h_xi = 0;
        if (r < na)
          h_xi = dH[b];
        else if (r < n)
          h_eta = -dG[b - static_cast<size_t>(na)];
        else if (r < kTurns + 2)
          h_xi = r == kTurns ? -wa_ : wa_;
        else
          h_eta = r == kTurns + 2 ? -wb_ : wb_;
        const Vec3 v = vector(r);
        for (int m = 0; m < LinePairForces::kMost; ++m) {
          if (!used(m)) continue;
          const size_t d = static_cast<size_t>(m);
          g.K[b][d] -= w * h[b] * J[d].middleRows<3>(part);
          if (m >= n) continue;
          if (slides_on && h_eta != 0) g.K[b][d] -= w * h_eta * v * e[d].transpose();
          if (set_.moves)
            g.C[b][d] -= w * h[b] * (m < na ? p.H[d] : -p.G[d - static_cast<size_t>(na)]) *
                         by_rate.segment<3>(part) * nrm.transpose();
        }
        const Vec3 along = (h_xi + h_eta * e_xi) * v + h[b] * q_xi.segment<3>(part);
        for (size_t i = 0; i < 2; ++i) {
          if (!moving[i].on) continue;
          const double stretch = i ? weight : -weight, shift = span * weight * (i ? place : 1 - place);
          moving[i].force[b] -= L * (stretch * h[b] * v + shift * along);
        }
      }
    }
    for (const Moving& m : moving) {
      if (!m.on) continue;
      for (int r = 0; r < LinePairForces::kMost; ++r) {
        if (r >= n && !(r >= kTurns && turns[r - kTurns])) continue;
        for (int k = 0; k < n; ++k)
          g.K[static_cast<size_t>(r)][static_cast<size_t>(k)] +=
              m.force[static_cast<size_t>(r)] * m.by[static_cast<size_t>(k)].transpose();
      }
    }
  }
}

}  // namespace hawser
