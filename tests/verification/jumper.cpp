// A flexible jumper between a point 55 m deep and a vessel, at rest, with its top moved by 10 m in 27 s, and
// in waves: Low & Langley (2006), Proc. OMAE, "Dynamic analysis of a flexible hanging riser in the time and
// frequency domain"; pinned ends, no axial drag.
#include "support/rig.hpp"

namespace hawser::test::jumper_test {
namespace {

constexpr int kElements = 85;

model::Case jumper() {
  model::LineType t = beam_type(5e8, 120.8e3, 120.8e3, 165);
  t.outer_diameter = t.contact_diameter = 0.396;
  t.Cd_normal = 1;
  t.Ca_normal = 1;
  t.rotary_inertia = Vec3(2, 1, 1);
  model::Case c = one_line(t, 170, kElements, anchor({-100, 0, -55}), {});
  c.environment.gravity = 9.807;
  c.environment.water.present = true;
  c.environment.water.depth = 100;
  c.environment.water.density = 1000;
  model::Body b;
  b.name = "vessel";
  b.position = Vec3(0, 0, -5);
  c.bodies.push_back(b);
  model::End e;
  e.kind = model::EndKind::body;
  e.carrier = "vessel";
  c.lines[0].end_b = e;
  return c;
}

void move(model::Case& c, int direction, double amplitude, double period) {
  model::HarmonicMotion m;
  m.amplitude[direction] = amplitude;
  m.period = period;
  c.bodies[0].motion = m;
  c.bodies[0].ramp = period;
}

Vec3 reaction(Simulation& sim, const std::vector<double>& all, bool top) {
  return Eigen::Map<const Vec3>(all.data() + 3 * sim.local().block[static_cast<size_t>(top ? kElements : 0)]);
}

struct History {
  std::vector<double> time, top, bottom;  // s, N, N
  double least = 1e99, most = 0, bottom_least = 1e99, bottom_most = 0;
};

// Steps of 0.1 s; the history begins at `from`.
History run(model::Case c, double from, double until) {
  c.dynamics.enabled = true;
  c.dynamics.duration = until;
  c.dynamics.step = 0.1;
  Simulation sim(PETSC_COMM_SELF, c);
  sim.solve_statics();
  sim.dynamics().start(sim.state());
  History h;
  sim.dynamics().run(
      until, [until](double) { return until; },
      [&](const StepInfo& info) {
        if (info.time < from - 1e-6) return true;
        const auto& r = sim.dynamics().reactions();
        const double T = reaction(sim, r, true).norm();
        const double B = reaction(sim, r, false).norm();
        h.time.push_back(info.time);
        h.top.push_back(T);
        h.bottom.push_back(B);
        h.least = std::min(h.least, T);
        h.most = std::max(h.most, T);
        h.bottom_least = std::min(h.bottom_least, B);
        h.bottom_most = std::max(h.bottom_most, B);
        return true;
      });
  return h;
}

// s from the reference's start, kN.
using Curve = std::vector<std::pair<double, double>>;

// Root mean square difference, kN. Fails if a point of the curve is outside the history.
double from_curve(const Curve& curve, const History& h, double start) {
  double sum = 0;
  for (const auto& [t, kN] : curve) {
    const auto after = std::lower_bound(h.time.begin() + 1, h.time.end(), t + start - 1e-6);
    if (h.time.front() > t + start + 1e-6 || after == h.time.end()) {
      ADD_FAILURE() << t << " s is not in the run";
      return 1e99;
    }
    const size_t j = static_cast<size_t>(after - h.time.begin());
    const size_t i = j - 1;
    const double s = (t + start - h.time[i]) / (h.time[j] - h.time[i]);
    sum += std::pow(1e-3 * ((1 - s) * h.top[i] + s * h.top[j]) - kN, 2);
  }
  return std::sqrt(sum / static_cast<double>(curve.size()));
}

// Low & Langley's curves at intervals, digitised by MoorDyn's authors (MoorDyn 2,
// tests/Mooring/lowe_and_langley_2006), and curves of own spectral elements of order 10.
const Curve kPublished1 = {{0, 49.728},  {5, 41.645},  {10, 44.447}, {15, 46.701}, {20, 48.375},
                           {25, 52.143}, {30, 44.221}, {35, 42.547}, {40, 47.023}, {45, 46.636},
                           {50, 51.724}, {55, 48.214}, {60, 41.581}, {65, 45.670}, {75, 49.535}};
const Curve kPublished3 = {{5, 45.220},  {10, 39.037}, {15, 43.287}, {20, 55.395}, {25, 57.778},
                           {30, 48.665}, {35, 43.030}, {40, 38.328}, {45, 52.626}, {50, 56.587},
                           {55, 53.624}, {60, 44.221}, {65, 36.783}, {70, 46.186}, {75, 55.621}};
const Curve kPublished4 = {{0, 44.413},  {2, 42.010},  {4, 50.746},  {6, 52.692},  {8, 46.454},
                           {10, 43.746}, {12, 42.315}, {14, 50.632}, {16, 52.616}, {18, 46.512},
                           {20, 43.650}, {22, 42.430}, {24, 50.613}, {26, 52.673}, {28, 46.607}};
const Curve kSpectral1 = {{0, 50.063869},  {6.5, 41.672368},  {13, 47.260759}, {19.5, 47.782946},
                          {26, 51.608014}, {32.5, 41.659315}, {39, 46.74077},  {45.5, 46.885345},
                          {52, 52.304482}, {58.5, 42.219738}, {65, 45.794721}, {71.5, 46.415505},
                          {78, 52.299609}};
const Curve kSpectral2 = {{0, 48.535732},  {6.5, 45.179206},  {13, 48.974848}, {19.5, 44.958931},
                          {26, 49.179457}, {32.5, 44.594472}, {39, 49.317603}, {45.5, 44.443657},
                          {52, 49.288996}, {58.5, 44.415214}, {65, 49.135733}, {71.5, 44.556734},
                          {78, 48.866093}};
const Curve kSpectral3 = {{0, 56.028791},  {6.5, 43.308609},  {13, 38.210697}, {19.5, 54.966922},
                          {26, 57.377608}, {32.5, 44.535438}, {39, 36.900628}, {45.5, 53.363904},
                          {52, 57.759454}, {58.5, 46.560536}, {65, 37.227579}, {71.5, 50.908102},
                          {78, 57.42682}};

// Planar elastica by multiple shooting to 1e-10: forces and angles of the ends, the lowest point, the largest
// curvature.
TEST(Jumper, AtRest) {
  for (const int elements : {kElements, 2 * kElements}) {
    model::Case c = jumper();
    c.lines[0].sections[0].elements = elements;
    Simulation sim(PETSC_COMM_SELF, c);
    const StaticsReport report = sim.solve_statics();
    const auto& r = sim.system().reactions();
    const auto at = [&](int node) {
      return Vec3(Eigen::Map<const Vec3>(r.data() + 3 * sim.local().block[static_cast<size_t>(node)]));
    };
    const Vec3 top = at(elements);
    const Vec3 bottom = at(0);
    const State& s = sim.state();
    double lowest = 0;
    for (const Vec3& x : s.x) lowest = std::min(lowest, x.z());
    const auto angle = [&](const Quat& q) {
      const Vec3 t = q * Vec3::UnitX();
      return std::atan2(t.z(), t.x());
    };
    std::vector<double> curvature(s.x.size());
    const FieldRegistry fields = sim.system().fields();
    for (const FieldSource& f : fields.sources())
      if (f.name == "curvature") f.fill(s.at_rest(), curvature);
    const double most = *std::max_element(curvature.begin(), curvature.end());
    printf(
        "  %d elements, %d iterations; H %+.5f %%, V top %+.5f %%, bottom %+.5f %%, T top %+.5f %%, bottom "
        "%+.5f %%, angles %+.5f, %+.5f %%, lowest %+.4f %%, curvature %+.4f %%\n",
        elements, report.iterations, 100 * (top.x() / 11398.26215 - 1), 100 * (top.z() / 45713.36315 - 1),
        100 * (bottom.z() / 24036.86756 - 1), 100 * (top.norm() / 47112.97009 - 1),
        100 * (bottom.norm() / 26602.46947 - 1), 100 * (angle(s.q.front()) / -1.112867193 - 1),
        100 * (angle(s.q.back()) / 1.32295534 - 1), 100 * (lowest / -91.86880598 - 1),
        100 * (most / 0.03515141178 - 1));
    EXPECT_NEAR(top.x(), 11398.26215, 1e-3 * 11398.26215);
    EXPECT_NEAR(top.z(), 45713.36315, 1e-3 * 45713.36315);
    EXPECT_NEAR(top.norm(), 47112.97009, 1e-3 * 47112.97009);
    EXPECT_NEAR(bottom.z(), 24036.86756, 1e-3 * 24036.86756);
    EXPECT_NEAR(bottom.norm(), 26602.46947, 1e-3 * 26602.46947);
    EXPECT_NEAR(angle(s.q.front()), -1.112867193, 1e-3 * 1.112867193);
    EXPECT_NEAR(angle(s.q.back()), 1.32295534, 1e-3 * 1.32295534);
    EXPECT_NEAR(lowest, -91.86880598, 1e-3 * 91.87);
    EXPECT_NEAR(most, 0.03515141178, 1e-3 * 0.03515);
  }
}

// Extremes of the published curves over the 80 s shown, and the curves. For case 2 there is no published
// curve; the spectral elements replace it, whose root mean square difference from it is 0.15 kN.
TEST(Jumper, TopMoves) {
  struct Row {
    const char* name;
    int direction;
    double least, most, within;  // kN
    Curve published, spectral;
  };
  for (const Row& row : {Row{"1, in x", 0, 41.48419, 52.23946, 0.5, kPublished1, kSpectral1},
                         {"2, in y", 1, 44.39017, 49.324396, 0.5, {}, kSpectral2},
                         {"3, in z", 2, 36.78279, 57.77810, 1.5, kPublished3, kSpectral3}}) {
    model::Case c = jumper();
    move(c, row.direction, 10, 27);
    const History h = run(c, 27, 107);
    const double spectral = from_curve(row.spectral, h, 27);
    printf("  case %s: %.2f ... %.2f kN (%+.2f, %+.2f); off the spectral elements by %.2f kN (rms)\n",
           row.name, 1e-3 * h.least, 1e-3 * h.most, 1e-3 * h.least - row.least, 1e-3 * h.most - row.most,
           spectral);
    EXPECT_NEAR(1e-3 * h.least, row.least, row.within) << row.name;
    EXPECT_NEAR(1e-3 * h.most, row.most, row.within) << row.name;
    EXPECT_LT(spectral, row.within) << row.name;
    if (row.published.empty()) continue;
    const double published = from_curve(row.published, h, 27);
    printf("    off the published curve by %.2f kN (rms)\n", published);
    EXPECT_LT(published, 0.5) << row.name;
  }
}

// Amplitude 5 m, 10 s, along x, without stretching as in the paper. Wheeler's stretching, the default of a
// case, gives extremes 1.2 kN lower.
TEST(Jumper, WavesPass) {
  model::Case c = jumper();
  model::Waves& w = c.environment.water.waves;
  w.systems.emplace_back().rows = {{10, 10, 0, 230 * M_PI / 180}};
  w.ramp = 10;
  w.stretching = Stretching::none;
  const History h = run(c, 20, 50);
  const double published = from_curve(kPublished4, h, 20);
  printf("  case 4, waves: %.2f ... %.2f kN (%+.2f, %+.2f), off the curve by %.2f kN (rms)\n", 1e-3 * h.least,
         1e-3 * h.most, 1e-3 * h.least - 42.00998, 1e-3 * h.most - 53.14973, published);
  EXPECT_NEAR(1e-3 * h.least, 42.00998, 0.5);
  EXPECT_NEAR(1e-3 * h.most, 53.14973, 0.5);
  EXPECT_LT(published, 0.5);
}

// The surface is far above the jumper. Reference: spectral elements, two meshes of which differ by 5 N; last
// period of 60 s.
TEST(Jumper, Submerged) {
  struct Row {
    double amplitude, period, least, most, mean, bottom_least, bottom_most;
  };
  for (const Row& row : {Row{2, 12, 36416.842, 57702.208, 47105.18697, 24183.54508, 29070.97051},
                         {3, 10, 23568.791, 70110.702, 47095.73444, 20569.84673, 32981.18303}}) {
    model::Case c = jumper();
    c.environment.water.surface = 100;
    c.environment.water.depth = 300;
    move(c, 2, row.amplitude, row.period);
    const History h = run(c, 60 - row.period, 60);
    double mean = 0;  // trapezoidal mean over the period
    for (size_t i = 1; i < h.top.size(); ++i) mean += h.top[i] / static_cast<double>(h.top.size() - 1);
    const double error[] = {h.least / row.least, h.most / row.most, mean / row.mean,
                            h.bottom_least / row.bottom_least, h.bottom_most / row.bottom_most};
    printf("  heave %g m: top %+.3f, %+.3f %%, mean %+.3f %%, bottom %+.3f, %+.3f %%\n", row.amplitude,
           100 * (error[0] - 1), 100 * (error[1] - 1), 100 * (error[2] - 1), 100 * (error[3] - 1),
           100 * (error[4] - 1));
    for (const double e : error) EXPECT_NEAR(e, 1, 0.01) << row.amplitude;
  }
}

}  // namespace
}  // namespace hawser::test::jumper_test
