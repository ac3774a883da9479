// The formulas of the generalized-alpha scheme: trial velocities and accelerations from an increment,
// predictor, mean forces of cables, weights of the tangent, local error.
#include "hawser/solve/generalized_alpha.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {

double alpha_stored(const AlphaCoefficients& c) { return (0.5 - c.af) * (0.5 - c.af); }

bool has_directors(const LocalMesh& mesh) { return mesh.mesh->any_rotates(); }

void alpha_start(const LocalMesh& mesh, AlphaState& state) {
  State& s = state.s;
  const bool turns = has_directors(mesh);
  state.ax = s.a;
  state.aw = turns ? s.alpha : std::vector<Vec3>();
  s.directors.resize(turns ? s.x.size() : 0);
  for (size_t n = 0; n < s.directors.size(); ++n)
    s.directors[n] = director_acceleration(s.q[n], s.w[n], s.alpha[n]);
  state.ad = s.directors;
}

void alpha_trial(const LocalMesh& mesh, const TiedNodes& tied, const AlphaCoefficients& c, double h,
                 const AlphaState& from, const std::vector<double>& u, AlphaState& trial) {
  State& s = trial.s;
  s.time = from.s.time + h;
  retract(mesh, from.s, u.data(), s);
  const double b = 1 / (h * h * c.beta);
  const double k1 = h * (1 - c.gamma);
  const double k2 = h * c.gamma;
  const double half = h * h * (0.5 - c.beta);
  const double m1 = (1 - c.am) / (1 - c.af);
  const double m0 = c.am / (1 - c.af);
  const double d0 = c.af / (1 - c.af);
  s.mean = alpha_mean(c);
  auto advance = [&](const double* p, const Vec3& v0, const Vec3& a0, const Vec3& true0, Vec3& v, Vec3& a,
                     Vec3& true1) {
    const Eigen::Map<const Vec3> du(p);
    a = b * (du - h * v0 - half * a0);
    v = v0 + k1 * a0 + k2 * a;
    true1 = m1 * a + m0 * a0 - d0 * true0;
  };
  for (size_t n = 0; n < s.x.size(); ++n) {
    const double* p = u.data() + 3 * mesh.block[n];
    advance(p, from.s.v[n], from.ax[n], from.s.a[n], s.v[n], trial.ax[n], s.a[n]);
    if (mesh.rotates(static_cast<int>(n)))
      advance(p + 3, from.s.w[n], from.aw[n], from.s.alpha[n], s.w[n], trial.aw[n], s.alpha[n]);
  }
  // Prescribed components take the velocities and accelerations of their motion law instead of the scheme's,
  // which would ring at rho = 1.
  tied.rates(s.time, s);
  s.director_weight = m1 / k2;
  for (size_t n = 0; n < s.x.size(); ++n) {
    if (!mesh.rotates(static_cast<int>(n))) continue;
    const Mat3 rate0 = from.s.q[n].toRotationMatrix() * hat(from.s.w[n]);
    const Mat3 rate1 = s.q[n].toRotationMatrix() * hat(s.w[n]);
    trial.ad[n] = (rate1 - rate0 - k1 * from.ad[n]) / k2;
    s.directors[n] = m1 * trial.ad[n] + m0 * from.ad[n] - d0 * from.s.directors[n];
  }
  tied.move_with_frames(s);
  for (const TiedNode& p : tied.nodes()) {
    const size_t n = p.node;
    if (p.frame >= 0 && p.position_mask == 7) {
      const size_t f = p.frame;
      trial.ax[n] = trial.ax[f];
      if (mesh.rotates(p.frame)) trial.ax[n] += trial.ad[f] * p.at;
      if (p.rotation_mask != 7 || !mesh.rotates(p.node)) continue;
      trial.aw[n] = p.rotation.conjugate() * trial.aw[f];
      trial.ad[n] = trial.ad[f] * p.rotation.toRotationMatrix();
      continue;
    }
    if (p.rotation_mask == 7 && mesh.rotates(p.node))
      trial.ad[n] = s.directors[n] = director_acceleration(s.q[n], s.w[n], s.alpha[n]);
    for (int i = 0; i < 3; ++i) {
      if (p.position_mask >> i & 1) trial.ax[n][i] = s.a[n][i];
      if (mesh.rotates(p.node) && p.rotation_mask >> i & 1) trial.aw[n][i] = s.alpha[n][i];
    }
  }
}

void alpha_predict(const LocalMesh& mesh, const TiedNodes& tied, double h, const AlphaState& from,
                   std::vector<double>& u) {
  u.resize(3 * static_cast<size_t>(mesh.blocks()));
  for (size_t n = 0; n < from.s.x.size(); ++n) {
    double* p = u.data() + 3 * mesh.block[n];
    Eigen::Map<Vec3>(p, 3) = h * from.s.v[n] + (0.5 * h * h) * from.ax[n];
    if (mesh.rotates(static_cast<int>(n)))
      Eigen::Map<Vec3>(p + 3, 3) = h * from.s.w[n] + (0.5 * h * h) * from.aw[n];
  }
  tied.increments(from.s, from.s.time + h, u.data());
}

StepMean alpha_mean(const AlphaCoefficients& c) {
  // In each step the scheme multiplies the strain of an element that is far too stiff for the step by `root`.
  // It is the spectral radius; the filter cannot make it less than 1/3.
  const double rho = c.af / (1 - c.af);
  const double root = std::max(rho, 1.0 / 3);
  return {MeanWeights(c).weight(), 0.5 * root * (1 - root) / ((1 + root) * (1 + root))};
}

void alpha_mean_history(const AlphaCoefficients& c, const MeanForces& from, std::vector<double>& history) {
  const MeanWeights w(c);
  history.resize(from.q.size());
  for (size_t i = 0; i < history.size(); ++i) history[i] = w.history(from.q[i], from.f[i]);
}

void alpha_mean_advance(const AlphaCoefficients& c, const std::vector<double>& S, MeanForces& forces) {
  const MeanWeights w(c);
  for (size_t i = 0; i < forces.q.size(); ++i) w.advance(S[i], forces.q[i], forces.f[i]);
}

Weights alpha_weights(const AlphaCoefficients& c, double h) {
  Weights w;
  w.C = c.gamma / (h * c.beta);
  w.M = (1 - c.am) / (h * h * c.beta * (1 - c.af));
  return w;
}

NodeValue alpha_turn(const LocalMesh& mesh, const std::vector<double>& u) {
  NodeValue largest;
  for (size_t n = 0; n < static_cast<size_t>(mesh.owned); ++n) {
    if (!mesh.rotates(static_cast<int>(n))) continue;
    const double angle = Eigen::Map<const Vec3>(u.data() + 3 * mesh.block[n] + 3).norm();
    if (angle > largest.value) largest = {angle, mesh.global[n]};
  }
  return largest;
}

double alpha_error(const LocalMesh& mesh, const AlphaCoefficients& c, double h, const AlphaState& from,
                   const AlphaState& to, const std::vector<double>& error_weight) {
  double worst = 0;
  for (size_t n = 0; n < static_cast<size_t>(mesh.owned); ++n) {
    const auto line = static_cast<size_t>(mesh.node(n).line);
    const double weight = line < error_weight.size() ? error_weight[line] : 1;
    worst = std::max(worst, weight * weight * (to.ax[n] - from.ax[n]).squaredNorm());
  }
  return std::abs(1.0 / 6 - c.beta) * h * h * std::sqrt(worst);
}

}  // namespace hawser
