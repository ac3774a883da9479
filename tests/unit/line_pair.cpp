// Contact of two elements: exact tangents in every situation, potential, balance of forces and moments, and
// joints that do not show.
#include "hawser/kernels/line_pair.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

double noise(int i, int purpose) {
  const double x = std::sin(12.9898 * (i + 1) + 78.233 * purpose) * 43758.5453;
  return 2 * (x - std::floor(x)) - 1;
}
Vec3 noise3(int i, int purpose) {
  return {noise(3 * i, purpose), noise(3 * i + 1, purpose), noise(3 * i + 2, purpose)};
}

// An element from a to b; its nodes' axes lean off the chord by up to `bend`.
AxisEnds element(bool beam, const Vec3& a, const Vec3& b, int seed, double bend = 0.05) {
  AxisEnds e;
  e.beam = beam;
  e.length = 1.01 * (b - a).norm();
  e.x1 = a, e.x2 = b;
  e.v1 = noise3(seed, 1), e.v2 = noise3(seed, 2);
  if (!beam) return e;
  e.tangent = Vec3(0.8, 0.6, 0);
  const Quat along = Quat::FromTwoVectors(e.tangent, b - a);
  e.q1 = exp_so3(bend * noise3(seed, 3)) * along, e.q2 = exp_so3(bend * noise3(seed, 4)) * along;
  e.w1 = noise3(seed, 5), e.w2 = noise3(seed, 6);
  return e;
}

// Increments of a node: position 0..2, rotation 3..5 (material).
AxisEnds moved(const AxisEnds& e, const double* u, const double* du = nullptr) {
  AxisEnds m = e;
  m.x1 += Eigen::Map<const Vec3>(u), m.x2 += Eigen::Map<const Vec3>(u + (e.beam ? 6 : 3));
  if (e.beam) {
    m.q1 = m.q1 * exp_so3(Eigen::Map<const Vec3>(u + 3)),
    m.q2 = m.q2 * exp_so3(Eigen::Map<const Vec3>(u + 9));
  }
  if (du) {
    m.v1 += Eigen::Map<const Vec3>(du), m.v2 += Eigen::Map<const Vec3>(du + (e.beam ? 6 : 3));
    if (e.beam) m.w1 += Eigen::Map<const Vec3>(du + 3), m.w2 += Eigen::Map<const Vec3>(du + 9);
  }
  return m;
}

constexpr double kRadius = 0.05, kStiffness = 1e5;

struct Situation {
  const char* name;
  Vec3 a1, a2, b1, b2;       // the trial
  double before = 0;         // m, how much further apart at the start, along z
  Vec3 slip = Vec3::Zero();  // m, of a in the step
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

struct Rig {
  AxisEnds a0, b0, a, b;  // start and trial
  LinePairSide::Settings settings;
  std::array<std::vector<LinePairHistory>, 6> history;

  Rig(const Situation& s, bool beam_a, bool beam_b, double friction) {
    settings.law.reach = 2 * kRadius;
    settings.law.normal = {kStiffness, 1e-3, 50};
    settings.law.friction.axial = settings.law.friction.lateral = friction;
    settings.law.friction.axial_length = settings.law.friction.lateral_length = 5e-3;
    settings.slave_radius = kRadius;
    a = element(beam_a, s.a1, s.a2, 1, 0.02), b = element(beam_b, s.b1, s.b2, 2, 0.02);
    double u[12] = {};
    Eigen::Map<Vec3>(u, 3) = Eigen::Map<Vec3>(u + (beam_a ? 6 : 3), 3) = -s.slip + Vec3(0, 0, s.before);
    if (beam_a)
      Eigen::Map<Vec3>(u + 3, 3) = 0.02 * noise3(1, 7), Eigen::Map<Vec3>(u + 9, 3) = 0.01 * noise3(1, 8);
    a0 = moved(a, u);
    b0 = b;
    if (beam_b) b0.q1 = b0.q1 * exp_so3(0.01 * noise3(2, 7)), b0.q2 = b0.q2 * exp_so3(0.01 * noise3(2, 8));
    if (s.before == 0) {  // a step before lays down history
      double w[12] = {};
      Eigen::Map<Vec3>(w, 3) = Eigen::Map<Vec3>(w + (beam_a ? 6 : 3), 3) = Vec3(2e-4, -3e-4, 0);
      const AxisEnds older = moved(a0, w);
      std::array<std::vector<LinePairHistory>, 6> none;
      each(a0, b0, older, b0, none,
           [&](size_t k, const LinePairSide& side) { side.keep(side.panels(), history[k]); });
    }
  }

  // Both sides, elements and joints.
  void each(const AxisEnds& a1, const AxisEnds& b1, const AxisEnds& sa, const AxisEnds& sb,
            const std::array<std::vector<LinePairHistory>, 6>& past,
            const std::function<void(size_t, const LinePairSide&)>& what) const {
    const PairAxis A(a1, sa), B(b1, sb);
    for (size_t k = 0; k < 6; ++k)
      what(k, LinePairSide(k < 3 ? A : B, k < 3 ? B : A, static_cast<FootOf>(k % 3), settings, past[k]));
  }

  int unknowns() const { return (a.beam ? 12 : 6) + (b.beam ? 12 : 6); }

  // f, K, C of one of the six parts, or of all (-1), in the order of the part's slave and master -> a, b.
  void forces(const std::vector<double>& u, const std::vector<double>& du, int part, std::vector<double>& f,
              std::vector<double>* K, std::vector<double>* C) const {
    const int n = unknowns(), na = a.beam ? 12 : 6;
    f.assign(static_cast<size_t>(n), 0);
    if (K) K->assign(static_cast<size_t>(n * n), 0), C->assign(static_cast<size_t>(n * n), 0);
    const AxisEnds at = moved(a, u.data(), du.data()), bt = moved(b, u.data() + na, du.data() + na);
    const PairAxis A(at, a0), B(bt, b0);
    each(at, bt, a0, b0, history, [&](size_t k, const LinePairSide& s) {
      if (part >= 0 && static_cast<size_t>(part) != k) return;
      const bool swapped = k >= 3;
      const PairAxis &slave = swapped ? B : A, &master = swapped ? A : B;
      LinePairForces g(slave.now.count(), master.now.count());
      s.add(s.panels(), K, g);
      std::vector<double> ff(static_cast<size_t>(n), 0), kk(static_cast<size_t>(n * n), 0), cc = kk;
      to_nodes(g, slave, master, ff.data(), kk.data(), cc.data());
      const int ns = swapped ? n - na : na;
      const auto index = [&](int i) { return !swapped ? i : i < ns ? i + na : i - ns; };
      for (int i = 0; i < n; ++i) {
        f[static_cast<size_t>(index(i))] += ff[static_cast<size_t>(i)];
        for (int j = 0; K && j < n; ++j) {
          (*K)[static_cast<size_t>(index(i) * n + index(j))] += kk[static_cast<size_t>(i * n + j)];
          (*C)[static_cast<size_t>(index(i) * n + index(j))] += cc[static_cast<size_t>(i * n + j)];
        }
      }
    });
  }
  double potential(const std::vector<double>& u) const {
    double sum = 0;
    each(moved(a, u.data()), moved(b, u.data() + (a.beam ? 12 : 6)), a0, b0, history,
         [&](size_t, const LinePairSide& s) { sum += s.potential(s.panels()); });
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

TEST(LinePair, Tangents) {
  double worst = 0;
  for_all([&](const std::string& name, const Rig& rig, double) {
    const int n = rig.unknowns();
    const size_t size = static_cast<size_t>(n);
    const std::vector<double> zero(size, 0);
    for (int part = 0; part < 6; ++part) {
      std::vector<double> f, K, C, none;
      rig.forces(zero, zero, part, f, &K, &C);
      double largest = 0;
      for (const double k : K) largest = std::max(largest, std::abs(k));
      if (part % 3 == 0 && name.find("end ") != 0) {
        EXPECT_GT(largest, 1) << name;
      }
      double largest_c = 0;
      for (const double k : C) largest_c = std::max(largest_c, std::abs(k));
      for (int d = 0; d < 3; ++d) {
        std::vector<double> dir(size);
        for (int i = 0; i < n; ++i) dir[static_cast<size_t>(i)] = noise(i, 100 + d);
        const double e = getenv("EE") ? atof(getenv("EE")) : 2e-6;
        const auto at = [&](double t, bool rate) {
          std::vector<double> u(size), out;
          for (size_t i = 0; i < size; ++i) u[i] = t * dir[i];
          rate ? rig.forces(zero, u, part, out, nullptr, nullptr)
               : rig.forces(u, zero, part, out, nullptr, nullptr);
          return out;
        };
        for (const bool rate : {false, true}) {
          const auto p = at(e, rate), m = at(-e, rate), pp = at(2 * e, rate), mm = at(-2 * e, rate);
          double off = 0, norm = 0;
          for (int i = 0; i < n; ++i) {
            const size_t r = static_cast<size_t>(i);
            double exact = 0;
            for (int j = 0; j < n; ++j)
              exact += (rate ? C : K)[static_cast<size_t>(i * n + j)] * dir[static_cast<size_t>(j)];
            const double difference = (8 * (p[r] - m[r]) - (pp[r] - mm[r])) / (12 * e);
            off = std::max(off, std::abs(difference - exact)), norm = std::max(norm, std::abs(exact));
          }
          if (norm == 0 && off == 0) continue;
          const double error = off / std::max(norm, 1e-3 * (rate ? largest_c : largest));
          worst = std::max(worst, error);
          EXPECT_LT(error, 1e-6) << name << ", part " << part << (rate ? ", C" : ", K");
        }
      }
    }
  });
  printf("  largest error of a tangent %.1e\n", worst);
}

}  // namespace
}  // namespace hawser
