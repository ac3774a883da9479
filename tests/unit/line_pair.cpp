// Contact of two elements: tangents against differences in all situations, potential, balance of forces and
// moments.
#include "hawser/kernels/line_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "hawser/math/so3.hpp"
#include "support/axis_elements.hpp"

namespace hawser::line_pair_test {
namespace {

using namespace test::axis_elements;

// Increments of a node: position 0..2, rotation 3..5 (material).
AxisEnds moved(const AxisEnds& e, const double* u, const double* du = nullptr) {
  AxisEnds m = e;
  m.x1 += Eigen::Map<const Vec3>(u);
  m.x2 += Eigen::Map<const Vec3>(u + (e.beam ? 6 : 3));
  if (e.beam) {
    m.q1 = m.q1 * exp_so3(Eigen::Map<const Vec3>(u + 3));
    m.q2 = m.q2 * exp_so3(Eigen::Map<const Vec3>(u + 9));
  }
  if (du) {
    m.v1 += Eigen::Map<const Vec3>(du);
    m.v2 += Eigen::Map<const Vec3>(du + (e.beam ? 6 : 3));
    if (e.beam) {
      m.w1 += Eigen::Map<const Vec3>(du + 3);
      m.w2 += Eigen::Map<const Vec3>(du + 9);
    }
  }
  return m;
}

constexpr double kRadius = 0.05, kStiffness = 1e5;

struct Situation {
  const char* name;
  Vec3 a1, a2, b1, b2;       // the trial
  double before = 0;         // m, additional distance at the start of the step, along z
  Vec3 slip = Vec3::Zero();  // m, of a in the step
  bool round = false;        // cable a has rotated by almost half a turn
};

std::vector<Situation> situations() {
  const double z = 0.094;
  return {
      {"crossing", {-0.5, 0.02, z}, {0.5, -0.01, z}, {0.1, -0.4, 0}, {0.13, 0.6, 0}, 0, {3e-4, 4e-4, 0}},
      {"crossing, slides",
       {-0.5, 0.02, z},
       {0.5, -0.01, z},
       {0.1, -0.4, 0},
       {0.13, 0.6, 0},
       0,
       {0.02, 0.01, 0}},
      {"crossing, sweeps",
       {-0.5, 0.02, z},
       {0.5, -0.01, z},
       {0.1, -0.4, 0},
       {0.13, 0.6, 0},
       0,
       {0.02, 0.3, 0}},
      {"crossing, sweeps from beyond",
       {-0.5, 0.02, z},
       {0.5, -0.01, z},
       {0.1, -0.4, 0},
       {0.13, 0.6, 0},
       0,
       {0.02, 0.6, 0}},
      {"crossing, ramp",
       {-0.5, 0.02, 0.1 + 2e-4},
       {0.5, -0.01, 0.1 + 2e-4},
       {0.1, -0.4, 0},
       {0.13, 0.6, 0},
       0,
       {3e-4, 1e-4, 0}},
      {"crossing, first touch",
       {-0.5, 0.02, z},
       {0.5, -0.01, z},
       {0.1, -0.4, 0},
       {0.13, 0.6, 0},
       0.02,
       {3e-3, 4e-3, 0}},
      {"crossing, half round",
       {-0.5, 0.02, z},
       {0.5, -0.01, z},
       {0.1, -0.4, 0},
       {0.13, 0.6, 0},
       0,
       {0, 0, 0},
       true},
      {"oblique at an end",
       {-0.5, 0.02, z},
       {0.5, 0.3, z},
       {0.0, 0.15, 0},
       {1.0, 0.3, 0},
       0,
       {3e-4, 1e-4, 0}},
      {"parallel", {-0.5, 0.004, z}, {0.5, -0.003, z}, {-0.3, 0.002, 0}, {0.7, 0.001, 0}, 0, {3e-4, 1e-4, 0}},
      {"parallel, slides",
       {-0.5, 0.004, z},
       {0.5, -0.003, z},
       {-0.3, 0.002, 0},
       {0.7, 0.001, 0},
       0,
       {0.02, 0.01, 0}},
      {"end on the side",
       {0.1, 0.05, z},
       {0.3, 0.04, 0.6},
       {-0.4, 0.02, 0},
       {0.6, 0.03, 0},
       0,
       {3e-4, 1e-4, 0}},
      {"end against end",
       {0.0, 0.02, 0.06},
       {-0.8, 0.1, 0.3},
       {0.06, -0.01, 0},
       {0.9, 0.1, 0.1},
       0,
       {3e-4, 1e-4, 0}},
  };
}

// Keeps the contact points of this side.
void keep(const LinePairPass& pass, std::vector<LinePairContactPoint>& points) {
  AttachedForces unused(AttachedForces::kPositions, true);
  pass.add(pass.panels(), false, unused, &points);
}

struct Rig {
  AxisEnds a0, b0, a, b;  // start and trial
  LinePairPass::Settings settings;
  std::array<std::vector<LinePairContactPoint>, 6> history;

  Rig(const Situation& s, bool beam_a, bool beam_b, double friction) {
    settings.law.radii = 2 * kRadius;
    settings.law.normal = {kStiffness, 1e-3, 50};
    settings.law.friction.axial = settings.law.friction.lateral = friction;
    settings.law.friction.axial_length = settings.law.friction.lateral_length = 5e-3;
    settings.slave_radius = kRadius;
    a = element(beam_a, s.a1, s.a2, 1, 0.02);
    b = element(beam_b, s.b1, s.b2, 2, 0.02);
    double u[12] = {};
    Eigen::Map<Vec3>(u, 3) = Eigen::Map<Vec3>(u + (beam_a ? 6 : 3), 3) = -s.slip + Vec3(0, 0, s.before);
    if (beam_a) {
      Eigen::Map<Vec3>(u + 3, 3) = 0.02 * noise3(1, 7);
      Eigen::Map<Vec3>(u + 9, 3) = 0.01 * noise3(1, 8);
    }
    a0 = moved(a, u);
    // Not exactly half a turn, because without slip the direction is undefined.
    if (s.round && !beam_a) {
      std::swap(a0.x1, a0.x2);
      a0.x1.y() += 0.01;
    }
    b0 = b;
    if (beam_b) {
      b0.q1 = b0.q1 * exp_so3(0.01 * noise3(2, 7));
      b0.q2 = b0.q2 * exp_so3(0.01 * noise3(2, 8));
    }
    if (s.before == 0) {  // a previous step creates history
      double w[12] = {};
      Eigen::Map<Vec3>(w, 3) = Eigen::Map<Vec3>(w + (beam_a ? 6 : 3), 3) = Vec3(2e-4, -3e-4, 0);
      const AxisEnds older = moved(a0, w);
      std::array<std::vector<LinePairContactPoint>, 6> none;
      each(a0, b0, older, b0, none, [&](size_t k, const LinePairPass& pass) { keep(pass, history[k]); });
    }
  }

  // Calls `what` for both sides, for elements and joints.
  void each(const AxisEnds& a1, const AxisEnds& b1, const AxisEnds& sa, const AxisEnds& sb,
            const std::array<std::vector<LinePairContactPoint>, 6>& past,
            const std::function<void(size_t, const LinePairPass&)>& what) const {
    const PairAxis A(a1, sa);
    const PairAxis B(b1, sb);
    for (size_t k = 0; k < 6; ++k)
      what(k, LinePairPass(k < 3 ? A : B, k < 3 ? B : A, static_cast<ProjectOn>(k % 3), settings, past[k]));
  }

  int unknowns() const { return (a.beam ? 12 : 6) + (b.beam ? 12 : 6); }

  // f, K, C of one of the six passes, or of their sum (-1), reordered from slave and master of the pass to a,
  // b.
  void forces(const std::vector<double>& u, const std::vector<double>& du, int pass, std::vector<double>& f,
              std::vector<double>* K, std::vector<double>* C) const {
    const int n = unknowns();
    const int na = a.beam ? 12 : 6;
    f.assign(static_cast<size_t>(n), 0);
    if (K) {
      K->assign(static_cast<size_t>(n * n), 0);
      C->assign(static_cast<size_t>(n * n), 0);
    }
    const AxisEnds at = moved(a, u.data(), du.data());
    const AxisEnds bt = moved(b, u.data() + na, du.data() + na);
    const PairAxis A(at, a0);
    const PairAxis B(bt, b0);
    each(at, bt, a0, b0, history, [&](size_t k, const LinePairPass& s) {
      if (pass >= 0 && static_cast<size_t>(pass) != k) return;
      const bool swapped = k >= 3;
      const PairAxis& slave = swapped ? B : A;
      const PairAxis& master = swapped ? A : B;
      AttachedForces g = no_forces(slave, master, settings.law.friction.active());
      s.add(s.panels(), K, g);
      BlockVector ff = BlockVector::Zero(n);
      BlockMatrix kk = BlockMatrix::Zero(n, n);
      BlockMatrix cc = kk;
      stencil_of(slave, master).to_blocks(g, true, ff, &kk, &cc);
      const int ns = swapped ? n - na : na;
      const auto index = [&](int i) { return !swapped ? i : i < ns ? i + na : i - ns; };
      for (int i = 0; i < n; ++i) {
        f[static_cast<size_t>(index(i))] += ff[i];
        for (int j = 0; K && j < n; ++j) {
          (*K)[static_cast<size_t>(index(i) * n + index(j))] += kk(i, j);
          (*C)[static_cast<size_t>(index(i) * n + index(j))] += cc(i, j);
        }
      }
    });
  }
  double potential(const std::vector<double>& u) const {
    double sum = 0;
    each(moved(a, u.data()), moved(b, u.data() + (a.beam ? 12 : 6)), a0, b0, history,
         [&](size_t, const LinePairPass& s) { sum += s.potential(s.panels()); });
    return sum;
  }
};

void for_all(const std::function<void(const std::string&, const Rig&, double friction)>& what) {
  for (const Situation& s : situations())
    for (const double friction : {0.0, 0.3})
      for (const auto& [beam_a, beam_b] : {std::pair{true, true}, {true, false}, {false, false}})
        what(std::string(s.name) + (friction > 0 ? ", rough, " : ", smooth, ") +
                 (beam_a ? "beam on " : "cable on ") + (beam_b ? "beam" : "cable"),
             Rig(s, beam_a, beam_b, friction), friction);
}

// Tangents with the whole slave, and with a part of it near a shared place.
TEST(LinePair, Tangents) {
  double worst = 0;
  for_all([&](const std::string& name, const Rig& whole, double) {
    for (const double from : {0.0, 0.52}) {
      Rig rig = whole;
      rig.settings.range = {from, 1};
      const int n = rig.unknowns();
      const size_t size = static_cast<size_t>(n);
      const std::vector<double> zero(size, 0);
      for (int pass = 0; pass < 6; ++pass) {
        std::vector<double> f, K, C, none;
        rig.forces(zero, zero, pass, f, &K, &C);
        double largest = 0;
        for (const double k : K) largest = std::max(largest, std::abs(k));
        if (from == 0 && pass % 3 == 0 && name.find("end ") != 0) {
          EXPECT_GT(largest, 1) << name;
        }
        double largest_c = 0;
        for (const double k : C) largest_c = std::max(largest_c, std::abs(k));
        for (int d = 0; d < 3; ++d) {
          std::vector<double> dir(size);
          for (int i = 0; i < n; ++i) dir[static_cast<size_t>(i)] = noise(i, 100 + d);
          const double e = 2e-6;
          const auto at = [&](double t, bool rate) {
            std::vector<double> u(size);
            std::vector<double> out;
            for (size_t i = 0; i < size; ++i) u[i] = t * dir[i];
            rate ? rig.forces(zero, u, pass, out, nullptr, nullptr)
                 : rig.forces(u, zero, pass, out, nullptr, nullptr);
            return out;
          };
          for (const bool rate : {false, true}) {
            const auto p = at(e, rate);
            const auto m = at(-e, rate);
            const auto pp = at(2 * e, rate);
            const auto mm = at(-2 * e, rate);
            double off = 0, norm = 0;
            for (int i = 0; i < n; ++i) {
              const size_t r = static_cast<size_t>(i);
              double exact = 0;
              for (int j = 0; j < n; ++j)
                exact += (rate ? C : K)[static_cast<size_t>(i * n + j)] * dir[static_cast<size_t>(j)];
              const double difference = (8 * (p[r] - m[r]) - (pp[r] - mm[r])) / (12 * e);
              off = std::max(off, std::abs(difference - exact));
              norm = std::max(norm, std::abs(exact));
            }
            if (norm == 0 && off == 0) continue;
            const double error = off / std::max(norm, 1e-3 * (rate ? largest_c : largest));
            worst = std::max(worst, error);
            EXPECT_LT(error, 1e-6) << name << ", pass " << pass << (rate ? ", C" : ", K") << ", from "
                                   << from;
          }
        }
      }
    }
  });
  printf("  largest error of a tangent %.1e\n", worst);
}

// A cable that folds back rotates by half a turn: forces and their derivatives are finite.
TEST(LinePair, HalfATurn) {
  Rig rig({"half round", {-0.5, 0, 0.094}, {0.5, 0, 0.094}, {0.1, -0.4, 0}, {0.1, 0.6, 0}}, false, false,
          0.3);
  std::swap(rig.a0.x1, rig.a0.x2);
  const std::vector<double> zero(static_cast<size_t>(rig.unknowns()), 0);
  std::vector<double> f, K, C;
  rig.forces(zero, zero, -1, f, &K, &C);
  EXPECT_TRUE(std::all_of(K.begin(), K.end(), [](double k) { return std::isfinite(k); }));
  double largest = 0;
  for (const double k : K) largest = std::max(largest, std::abs(k));
  EXPECT_GT(largest, 1);
  EXPECT_LT(largest, 1e3 * kStiffness);
}

// Contact points of a cable that is swept along another one in steps of `way`, 0.3 m in total.
std::array<std::vector<LinePairContactPoint>, 6> swept(double way, double mu) {
  Rig rig({"swept", {-0.5, 0, 0.094}, {0.5, 0, 0.094}, {0.1, -0.4, 0}, {0.1, 0.6, 0}}, false, false, mu);
  auto at = [&](double y) {
    AxisEnds a = rig.a;
    a.x1.y() += y;
    a.x2.y() += y;
    return a;
  };
  std::array<std::vector<LinePairContactPoint>, 6> past;
  const int steps = static_cast<int>(std::lround(0.3 / way));
  for (int i = 1; i <= steps; ++i) {
    std::array<std::vector<LinePairContactPoint>, 6> next;
    rig.each(at((i - steps) * way), rig.b, at((i - 1 - steps) * way), rig.b, past,
             [&](size_t k, const LinePairPass& pass) { keep(pass, next[k]); });
    past = std::move(next);
  }
  return past;
}

// Material that is new in a crossing gets the slip of the sweep: friction is mu N for any step length.
TEST(LinePair, NewMaterialHasTheSlipOfTheSweep) {
  const double mu = 0.3, mobilised = 5e-3;
  const auto once = swept(0.3, mu);
  for (const LinePairContactPoint& h : once[3])
    EXPECT_NEAR(std::hypot(h.slip[0], h.slip[1]), mobilised, 1e-9);
  for (const double way : {0.3, 0.1, 0.03, 0.01, 3e-3, 1e-3}) {
    const auto left = swept(way, mu);
    double friction = 0, normal = 0;
    for (const auto& pass : left)
      for (const LinePairContactPoint& h : pass) {
        friction += h.weight * h.friction.norm();
        normal += h.weight * h.normal_force;
      }
    EXPECT_NEAR(friction / normal, mu, 0.005 * mu) << way;
  }
}

// Without friction and damping the forces are the gradient of the potential.
TEST(LinePair, ForceIsTheGradientOfThePotential) {
  for_all([&](const std::string& name, const Rig& rough, double friction) {
    if (friction > 0) return;
    Rig rig = rough;
    rig.settings.law.normal.damping = 0;
    const size_t size = static_cast<size_t>(rig.unknowns());
    const std::vector<double> zero(size, 0);
    std::vector<double> f;
    rig.forces(zero, zero, -1, f, nullptr, nullptr);
    const double e = 1e-5;
    double norm = 0, off = 0;
    for (size_t i = 0; i < size; ++i) {
      std::vector<double> u = zero;
      u[i] = e;
      const double p = rig.potential(u);
      u[i] = -e;
      const double m = rig.potential(u);
      norm = std::max(norm, std::abs(f[i]));
      off = std::max(off, std::abs((p - m) / (2 * e) - f[i]));
    }
    // The quadratures of potential and force are truncated differently, so they agree to the error of the
    // rule.
    EXPECT_LE(off, 5e-3 * norm) << name;
  });
}

// For two beams, total force and total moment are zero, also with friction.
TEST(LinePair, ForcesAndMomentsBalance) {
  for (const Situation& s : situations()) {
    const Rig rig(s, true, true, 0.3);
    const std::vector<double> zero(24, 0);
    std::vector<double> f;
    rig.forces(zero, zero, -1, f, nullptr, nullptr);
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    double size = 0;
    const AxisEnds* lines[2] = {&rig.a, &rig.b};
    for (int line = 0; line < 2; ++line)
      for (int node = 0; node < 2; ++node) {
        const double* p = f.data() + 12 * line + 6 * node;
        const Eigen::Map<const Vec3> v(p);
        const Eigen::Map<const Vec3> t(p + 3);
        force += v;
        size += v.norm();
        moment += (node ? lines[line]->x2 : lines[line]->x1).cross(v) +
                  (node ? lines[line]->q2 : lines[line]->q1) * t;
      }
    EXPECT_LE(force.norm(), 1e-13 * size) << s.name;
    EXPECT_LE(moment.norm(), 1e-12 * size) << s.name;
  }
}

// A rigid motion of a pair does not change its friction: the elastic slip rotates with the pair.
TEST(LinePair, RigidMotionLeavesTheSlipAlone) {
  for (const Situation& s : situations())
    for (const bool beam : {true, false}) {
      Rig rig(s, beam, beam, 0.3);
      rig.settings.law.normal.damping = 0;
      // A cable has no sections, so its frame has the smallest rotation of its chord; this is the full
      // rotation only if the axis of rotation is normal to the chord.
      if (!beam && std::string(s.name).starts_with("end ")) continue;
      if (rig.history[0].empty() && rig.history[3].empty()) continue;
      const Quat turn = exp_so3(beam ? Vec3(0.4, -0.7, 1.1) : Vec3(0, 0, 0.9));
      const auto turned = [&](AxisEnds e) {
        e.x1 = turn * e.x1 + Vec3(1, 2, 3);
        e.x2 = turn * e.x2 + Vec3(1, 2, 3);
        e.q1 = turn * e.q1;
        e.q2 = turn * e.q2;
        return e;
      };
      std::array<std::vector<LinePairContactPoint>, 6> next;
      rig.each(turned(rig.a0), turned(rig.b0), rig.a0, rig.b0, rig.history,
               [&](size_t k, const LinePairPass& pass) { keep(pass, next[k]); });
      for (size_t k = 0; k < 6; ++k) {
        ASSERT_EQ(next[k].size(), rig.history[k].size()) << s.name;
        for (size_t i = 0; i < next[k].size(); ++i) {
          const LinePairContactPoint& before = rig.history[k][i];
          const LinePairContactPoint& after = next[k][i];
          EXPECT_NEAR(before.slip[0], after.slip[0], 1e-10) << s.name << ", pass " << k;
          EXPECT_NEAR(before.slip[1], after.slip[1], 1e-10) << s.name << ", pass " << k;
          EXPECT_LE((turn * before.friction - after.friction).norm() / after.normal_force,
                    1e-6 + std::abs(before.normal_force / after.normal_force - 1))
              << s.name;
        }
      }
    }
}

}  // namespace
}  // namespace hawser::line_pair_test
