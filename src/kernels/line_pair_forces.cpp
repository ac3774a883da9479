// The class LinePairPass: forces and couples summed over the Gauss points, with their exact tangent. A pass
// integrates along one line and finds the nearest points on the other. terms/line_pairs.hpp lists the passes.
// The law at a pair of points is in line_pair_law.cpp, the types of points in line_pair_point.hpp.
#include <cmath>
#include <limits>

#include "hawser/math/so3.hpp"
#include "line_pair_point.hpp"

namespace hawser {
namespace {

constexpr size_t kTurns = AttachedForces::kPositions, kMaxRows = AttachedForces::kMaxRows;
// By the columns of AttachedForces::K.
constexpr int kColumns = 3 * kMaxRows;
using Gradient = Eigen::Matrix<double, 1, kColumns>;
using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using VectorGradient = Eigen::Matrix<double, 3, kColumns, Eigen::RowMajor>;

// d(section_turn v) by the chord of a cable.
Mat3 section_turn_by_chord(const PairAxis& cable, const Vec3& v) {
  const auto& [f, t] = cable.directions;
  const Vec3 sum = f + t;
  const double opening = std::max(1 + f.dot(t), kHalfRound);
  const double a = sum.dot(v);
  const double by_opening = opening > kHalfRound ? a / (opening * opening) : 0;
  const Mat3 by_t =
      (2 * f.dot(v) - a / opening) * Mat3::Identity() - sum * (v / opening - by_opening * f).transpose();
  const double length = std::max(cable.now.slope_bound(), std::numeric_limits<double>::min());
  return (by_t - by_t * t * t.transpose()) / length;
}

// Columns of a position or a rotation.
template <class Matrix>
auto columns(Matrix& m, size_t position) {
  return m.template middleCols<3>(3 * static_cast<Eigen::Index>(position));
}

}  // namespace

// Rows of AttachedForces::F in use, and the factor of each on the force or couple at a point.
struct LinePairPass::Rows {
  std::array<size_t, kMaxRows> used;
  size_t count = 0;
  std::array<double, kMaxRows> factor{}, by_xi{},
      by_eta{};  // factors, and derivatives along slave and master

  void add(size_t row, double s, double along_slave, double along_master) {
    used[count++] = row;
    factor[row] = s;
    by_xi[row] = along_slave;
    by_eta[row] = along_master;
  }
  bool turn() const { return used[count - 1] >= kTurns; }
  auto begin() const { return used.begin(); }
  auto end() const { return used.begin() + static_cast<std::ptrdiff_t>(count); }
};

LinePairPass::Rows LinePairPass::rows(const Point& p) const {
  Rows r;
  const double xi = p.xi;
  const double eta = p.foot.eta;
  const AxisShape::Weights dH = slave_.now.derivatives(xi);
  const AxisShape::Weights dG = master_.now.derivatives(eta);
  const size_t na = slave_.now.count();
  const size_t nb = master_.now.count();
  for (size_t j = 0; j < na; ++j) r.add(at_slave_ + j, p.H[j], dH[j], 0);
  for (size_t k = 0; k < nb; ++k) r.add(at_master_ + k, -p.G[k], 0, -dG[k]);
  if (!set_.law.friction.active()) return r;
  if (slave_.beam()) {
    r.add(turn_slave_, slave_lever_ * (1 - xi), -slave_lever_, 0);
    r.add(turn_slave_ + 1, slave_lever_ * xi, slave_lever_, 0);
  }
  if (master_.beam()) {
    r.add(turn_master_, master_lever_ * (1 - eta), 0, -master_lever_);
    r.add(turn_master_ + 1, master_lever_ * eta, 0, master_lever_);
  }
  return r;
}

// Derivatives of force and couple at a point. `positions`: number of positions of both elements.
struct LinePairPass::Slopes {
  // By the columns of K; by the position on the slave; by the rate of the gap.
  struct Of {
    VectorGradient by_positions = VectorGradient::Zero();
    Vec3 by_xi, by_rate;
  };
  Of force, couple;
  Gradient eta_by = Gradient::Zero();  // of the nearest point along the master, if it moves
  double eta_by_xi = 0;

  void find_eta(const Point& p, const Vec3& bend, const Rows& rows, size_t positions);
  void find_couple(const Point& p, const Vec3& force_at_point, const Rows& rows, size_t positions);
};

// The nearest point y has D . y' = 0, therefore
//   d eta = ((dx - dy) . y' + D . dy') / c,   d eta/d xi = x' . y' / c,   c = y' . y' - D . y'',
// except at an end of the master, where eta is constant. bend: y''.
void LinePairPass::Slopes::find_eta(const Point& p, const Vec3& bend, const Rows& rows, size_t positions) {
  const double curve = p.along.squaredNorm() - p.foot.away.dot(bend);
  if (p.foot.inside && curve > 0) {
    const Vec3 by_difference = p.along / curve;
    const Vec3 by_tangent = p.foot.away / curve;
    for (size_t m = 0; m < positions; ++m)
      columns(eta_by, m) = (rows.factor[m] * by_difference - rows.by_eta[m] * by_tangent).transpose();
    eta_by_xi = p.slope.dot(by_difference);
  } else {
    eta_by.setZero();
    eta_by_xi = 0;
  }
}

// couple = force x D:
//   d couple = d force x D + force x (dx - dy - y' d eta),
//   d couple/d xi = d force/d xi x D + force x (x' - y' d eta/d xi).
void LinePairPass::Slopes::find_couple(const Point& p, const Vec3& force_at_point, const Rows& rows,
                                       size_t positions) {
  const Mat3 by_force = -hat(p.foot.away);
  const RowMajor3 arm = hat(force_at_point);
  couple.by_rate = by_force * force.by_rate;
  couple.by_xi = by_force * force.by_xi + arm * (p.slope - eta_by_xi * p.along);
  const Vec3 by_foot = arm * p.along;
  const VectorGradient& by = force.by_positions;
  for (int i = 0; i < 3; ++i)
    couple.by_positions.row(i) = by_force(i, 0) * by.row(0) + by_force(i, 1) * by.row(1) +
                                 by_force(i, 2) * by.row(2) - by_foot[i] * eta_by;
  for (size_t m = 0; m < positions; ++m) columns(couple.by_positions, m) += rows.factor[m] * arm;
}

// Derivatives of friction along slave and master at constant D and tangents: M = D - R D_0 (theory: Friction)
// with R = w_a R_a + w_b R_b has
//   dM/d xi = -R x_0' - w_a dR_a/d xi D_0,   dM/d eta = R y_0' - w_b dR_b/d eta D_0;
// the previous slip depends on xi, and the friction of new material on the state at the start of the step.
void LinePairPass::add_friction_slopes(const Point& p, const Start& from, const LinePairForce& c, Vec3& by_xi,
                                       Vec3& by_eta) const {
  using F = LinePairForce;
  const auto derivative_by = [&](int first_column) { return c.by.block<3, 3>(0, first_column); };
  const double xi = p.xi;
  const double eta = p.foot.eta;
  const Mat3 by_moved = derivative_by(F::kMoved);
  const Mat3 weighted_turn = slave_lever_ * p.Ta + master_lever_ * p.Tb;
  const Vec3 x1_before = slave_.start.slope(xi);
  const Vec3 y1_before = master_.start.slope(eta);
  by_eta += by_moved *
            (weighted_turn * y1_before - master_lever_ * ((master_.turn[1] - master_.turn[0]) * p.before));
  by_xi +=
      by_moved * (-weighted_turn * x1_before - slave_lever_ * ((slave_.turn[1] - slave_.turn[0]) * p.before));
  by_xi += c.by.col(F::kSlip) * from.slip_slope[0] + c.by.col(F::kSlip + 1) * from.slip_slope[1];
  if (from.is_new) {
    by_eta +=
        derivative_by(F::kAlongBefore) * master_.start.bend(eta) - derivative_by(F::kAwayBefore) * y1_before;
    by_xi += derivative_by(F::kAwayBefore) * x1_before + derivative_by(F::kSlope) * slave_.now.bend(xi) +
             derivative_by(F::kSlopeBefore) * slave_.start.bend(xi);
  }
}

// Derivatives of the force by the rotations of the sections, dM = -w dR D_0. At a node with the share N of a
// beam's section, dR D_0 = N dphi x (R D_0); sections of a cable rotate with its chord.
void LinePairPass::add_section_turns(const Point& p, const Mat3& by_moved, const Rows& rows,
                                     Slopes& s) const {
  VectorGradient& by = s.force.by_positions;
  for (const bool of_master : {false, true}) {
    const PairAxis& axis = of_master ? master_ : slave_;
    const size_t turn = of_master ? turn_master_ : turn_slave_;
    const size_t position = of_master ? at_master_ : at_slave_;
    if (axis.beam()) {
      for (size_t i = 0; i < 2; ++i)
        columns(by, turn + i) = rows.factor[turn + i] * by_moved * hat(axis.turn[i] * p.before);
    } else {
      const Mat3 turned =
          (of_master ? master_lever_ : slave_lever_) * by_moved * section_turn_by_chord(axis, p.before);
      columns(by, position) += turned;
      columns(by, position + 1) -= turned;
    }
  }
}

// At a fixed position xi on the slave, the force depends on D = x - y and T = y' at a given eta, on the
// rotations of the sections and on eta:
//   d force = F_D (dx - dy) + F_T dy' + F_x' dx' + F_R dR + F_eta d eta,
//   d force/d xi = F_xi + F_eta d eta/d xi.
// F_D includes the parts of D in M and in the rate of the gap, n . (v_x - v_y), with dn = (I - n n') dD/|D|.
// flatten: otherwise products of small matrices are function calls.
[[gnu::flatten]] void LinePairPass::find_slopes(const Point& p, const Start& from, const LinePairForce& c,
                                                const Rows& rows, Slopes& s) const {
  using F = LinePairForce;
  const bool has_friction = set_.law.friction.active();
  const size_t positions = slave_.now.count() + master_.now.count();
  const Vec3& normal = p.foot.normal;
  const Vec3 y2 = master_.now.bend(p.foot.eta);
  const auto derivative_by = [&](int first_column) { return c.by.block<3, 3>(0, first_column); };
  const Mat3 by_moved = derivative_by(F::kMoved);
  s.force.by_rate = c.by.col(F::kRate);
  const Mat3 normal_by_away = (Mat3::Identity() - normal * normal.transpose()) / p.foot.distance;
  const RowMajor3 by_away =
      derivative_by(F::kAway) + by_moved + s.force.by_rate * (normal_by_away * p.velocity).transpose();

  Vec3 by_eta = -by_away * p.along + derivative_by(F::kAlong) * y2;
  Vec3& by_xi = s.force.by_xi;
  by_xi = by_away * p.slope;
  if (set_.moves) {
    by_eta -= s.force.by_rate * normal.dot(master_.now.velocity_slope(p.foot.eta));
    by_xi += s.force.by_rate * normal.dot(slave_.now.velocity_slope(p.xi));
  }
  if (has_friction) add_friction_slopes(p, from, c, by_xi, by_eta);
  s.find_eta(p, y2, rows, positions);
  by_xi += by_eta * s.eta_by_xi;

  VectorGradient& by = s.force.by_positions;
  for (int i = 0; i < 3; ++i) by.row(i) = by_eta[i] * s.eta_by;
  const RowMajor3 by_along = derivative_by(F::kAlong);
  const RowMajor3 by_slope = derivative_by(F::kSlope);
  for (size_t m = 0; m < positions; ++m) {
    columns(by, m) += rows.factor[m] * by_away;
    if (has_friction) columns(by, m) -= rows.by_eta[m] * by_along;
    if (from.is_new) columns(by, m) += rows.by_xi[m] * by_slope;
  }
  if (!has_friction) return;
  add_section_turns(p, by_moved, rows, s);
  if (rows.turn()) s.find_couple(p, c.force, rows, positions);
}

// Moving end of a panel, and the change of the panel's forces as its Gauss points move along. With x at xi on
// the slave, y, V on the master and n the normal from y to x, the end moves by
//   dxi = -n . (dx - dy) / (n . x')                   where the gap is constant (End::gap);
//   dxi = -[(dx - dV) . t + (x - V) . dt] / (x' . t)  where (x - V) . t = 0, at a joint V of the master; t is
//                                                     its tangent there.
struct LinePairPass::MovingEnd {
  bool moves = false;
  Gradient by_positions;             // derivative of its xi by the positions
  std::array<Vec3, kMaxRows> force;  // derivative of the rows of F by its xi
};

LinePairPass::MovingEnd LinePairPass::moving_end(double xi, End end) const {
  MovingEnd m;
  if (end == End::fixed) return m;
  const size_t na = slave_.now.count();
  const size_t nb = master_.now.count();
  const Vec3 x = slave_.now.point(xi);
  const Vec3 x1 = slave_.now.slope(xi);
  const AxisShape::Weights H = slave_.now.functions(xi);
  m.by_positions.setZero();
  if (end == End::gap) {
    const AxisProjection f = projection(master_.now, target_, x);
    const double slope = f.normal.dot(x1);
    if (std::abs(slope) < 1e-9 * slave_.now.slope_bound()) return m;
    const AxisShape::Weights G = master_.now.functions(f.eta);
    for (size_t j = 0; j < na; ++j)
      columns(m.by_positions, at_slave_ + j) = -H[j] / slope * f.normal.transpose();
    for (size_t k = 0; k < nb; ++k)
      columns(m.by_positions, at_master_ + k) = G[k] / slope * f.normal.transpose();
  } else {
    const double eta = end == End::first_joint ? 0 : 1;
    const Vec3 V = master_.now.point(eta);
    const Vec3 t = master_.now.slope(eta);
    const double slope = x1.dot(t);
    const AxisShape::Weights G = master_.now.functions(eta);
    const AxisShape::Weights dG = master_.now.derivatives(eta);
    for (size_t j = 0; j < na; ++j) columns(m.by_positions, at_slave_ + j) = -H[j] / slope * t.transpose();
    for (size_t k = 0; k < nb; ++k)
      columns(m.by_positions, at_master_ + k) = (G[k] * t - dG[k] * (x - V)).transpose() / slope;
  }
  m.force.fill(Vec3::Zero());
  m.moves = true;
  return m;
}

// Tangent without negative stiffness: nearest points and normals are taken as constant.
void LinePairPass::add_convex(const Point& p, const LinePairForce& c, const Rows& rows, double weight,
                              AttachedForces& g) const {
  const Vec3& normal = p.foot.normal;
  const Mat3 by_moved = c.by.block<3, 3>(0, LinePairForce::kMoved);
  const size_t n = g.positions;
  for (size_t r = 0; r < n; ++r)
    for (size_t m = 0; m < n; ++m)
      block_of(g.K, r, m) -= weight * rows.factor[r] * rows.factor[m] *
                             (c.along_normal.by_gap * normal * normal.transpose() + by_moved);
}

// The tangent includes moving ends.
void LinePairPass::add(const std::vector<Panel>& panels, bool derivatives, AttachedForces& g,
                       std::vector<LinePairContactPoint>* points) const {
  const bool has_friction = set_.law.friction.active();
  const bool exact = derivatives && !set_.convex;
  const double L = set_.fraction * slave_.ends.length;
  std::optional<Slopes> slopes;
  if (exact) slopes.emplace();
  if (points) points->reserve(kContactPoints * panels.size());
  for (const Panel& panel : panels) {
    const double span = panel.to - panel.from;
    std::array<MovingEnd, 2> ends;
    if (exact) ends = {moving_end(panel.from, panel.at_from), moving_end(panel.to, panel.at_to)};
    for (size_t q = 0; q < kContactPoints; ++q) {
      const PanelPoint at = panel_point(q);
      const double w = L * span * at.weight;
      const Point p = point(panel.from + span * at.place);
      const Start from = has_friction ? start(p.xi) : Start{};
      const LinePairForce c = line_pair_force(set_.law, local(p, from), derivatives);
      if (points && c.along_normal.elastic > 0) points->push_back(stored_point(panel, p, c, w));
      if (!(c.along_normal.force > 0)) continue;
      const Rows rows = this->rows(p);
      const auto vector = [&c](size_t r) -> const Vec3& { return r < kTurns ? c.force : c.couple; };
      // The residual is internal minus external: -force.
      for (const size_t r : rows) g.F[r] -= w * rows.factor[r] * vector(r);
      if (derivatives && !exact) add_convex(p, c, rows, w, g);
      if (!exact) continue;

      Slopes& s = *slopes;
      find_slopes(p, from, c, rows, s);
      Gradient rate = Gradient::Zero();  // derivative of the gap rate by the velocities of the positions
      for (size_t m = 0; m < g.positions; ++m) columns(rate, m) = rows.factor[m] * p.foot.normal.transpose();
      for (const size_t r : rows) {
        const Vec3& v = vector(r);
        const Slopes::Of& of = r < kTurns ? s.force : s.couple;
        for (int i = 0; i < 3; ++i) {
          const Eigen::Index row = 3 * static_cast<Eigen::Index>(r) + i;
          g.K.row(row) -= w * rows.factor[r] * of.by_positions.row(i);
          if (rows.by_eta[r] != 0) g.K.row(row) -= w * rows.by_eta[r] * v[i] * s.eta_by;
          if (set_.moves)
            g.C.row(row) -= w * rows.factor[r] * of.by_rate[i] * rate.head<3 * AttachedForces::kPositions>();
        }
        // The Gauss points move with the ends of the panel, which adds the derivative along xi.
        const Vec3 along = (rows.by_xi[r] + rows.by_eta[r] * s.eta_by_xi) * v + rows.factor[r] * of.by_xi;
        for (const bool last : {false, true}) {
          if (!ends[last].moves) continue;
          const double by_length = at.length_by_end(last);
          const double by_xi = span * at.weight * at.xi_by_end(last);
          ends[last].force[r] -= L * (by_length * rows.factor[r] * v + by_xi * along);
        }
      }
    }
    for (const MovingEnd& end : ends)
      for (size_t r = 0; r < kMaxRows && end.moves; ++r)
        for (int i = 0; i < 3; ++i)
          g.K.row(3 * static_cast<Eigen::Index>(r) + i) += end.force[r][i] * end.by_positions;
  }
}

}  // namespace hawser
