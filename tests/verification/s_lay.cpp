// Statics of a 12 in pipe over a stinger of 120 m radius to a bed 110 m below its top. The upper end is held
// horizontally at a given tension T0; no friction, uniform weight. Over a rigid arc, a soft arc, and rollers
// every 4 degrees. References: multiple shooting of the inextensible elastica (checked by scipy's solve_bvp
// to 1e-11), and the invariant along the pipe, H = T0 + M0²/(2 EI) - w h.
#include "verification/s_lay.hpp"

namespace hawser::s_lay_test {
namespace {

// Difference in per cent.
double off(double found, double expected) { return 100 * std::abs(found / expected - 1); }

struct Rigid {
  double T0, lift_off, P, x_td, kappa_sag;  // N, deg, N, m, 1/m
};
// H is T0 + EI / (2 R²) - w h, because the arc bends the pipe at the top already.
constexpr Rigid kRigid[] = {{200e3, 38.36858402, 29452.06101, 261.6394364, 0.005088074583},
                            {250e3, 34.94418983, 31795.10144, 289.8975419, 0.00380039448},
                            {300e3, 32.34086984, 33934.10919, 315.793124, 0.003016752252},
                            {400e3, 28.55796352, 37768.13661, 362.1813511, 0.002124353075},
                            {600e3, 23.84724283, 44310.62186, 440.5848892, 0.001327649541}};

TEST(SLay, OverARigidArc) {
  const bool all = std::getenv("HAWSER_FULL");
  for (const Rigid& r : kRigid) {
    if (!all && (r.T0 == 250e3 || r.T0 == 400e3)) continue;
    Setting s;
    s.T0 = r.T0;
    s.lift_off = r.lift_off;
    s.x_td = r.x_td;
    s.arc = 1e10;
    s.bed = 1e6;
    s.over = 0.75;
    const Laid l = laid(s);
    const double H = r.T0 + kEI / (2 * kRadius * kRadius) - kWeight * (kTop + kDepth);
    printf(
        "  T0 %6.0f kN: H %+.4f %%, touchdown %+.3f m, sag %+.3f %%, lift-off %.3f deg (%.3f), %.0f N "
        "(%.0f)\n",
        r.T0 / 1e3, 100 * (l.H / H - 1), l.x_td - r.x_td, 100 * (l.kappa_sag / r.kappa_sag - 1), l.last_touch,
        r.lift_off, l.last_force, r.P);
    EXPECT_LT(off(l.T0, r.T0), 1e-3);
    EXPECT_LT(off(l.H, H), 0.1);
    // On a soft bed the touchdown is earlier by the characteristic length of a beam on it.
    EXPECT_NEAR(l.x_td + std::pow(4 * kEI / s.bed, 0.25), r.x_td, 0.5);
    EXPECT_LT(off(l.kappa_sag, r.kappa_sag), 0.5);
    EXPECT_NEAR(l.last_touch, r.lift_off, 0.3);
    EXPECT_LT(off(l.last_force, r.P), 3);
  }
}

struct Soft {
  double T0, kc, kb, lift_off, x_td, last, depth, total, kappa_ob, kappa_sag, H;
};
constexpr Soft kSoft[] = {{300e3, 1e6, 1e5, 32.3, 309.5, 34.01547647, 0.007431489227, 234436.5275,
                           0.008856841451, 0.00301397806, 224474.5573},
                          {200e3, 1e7, 1e5, 38.4, 255.4, 39.29781496, 0.001042034461, 206754.1814,
                           0.008456080534, 0.005085152541, 124342.1082}};

TEST(SLay, OverASoftArc) {
  for (const Soft& r : kSoft) {
    Setting s;
    s.T0 = r.T0;
    s.lift_off = r.lift_off;
    s.x_td = r.x_td;
    s.arc = r.kc;
    s.bed = r.kb;
    const Laid l = laid(s);
    printf(
        "  T0 %6.0f kN: H %+.4f %%, total %+.4f %%, depth %+.4f %%, overbend %+.4f %%, sag %+.4f %%, %.3f "
        "deg\n",
        r.T0 / 1e3, 100 * (l.H / r.H - 1), 100 * (l.total / r.total - 1), 100 * (l.depth / r.depth - 1),
        100 * (l.kappa_ob / r.kappa_ob - 1), 100 * (l.kappa_sag / r.kappa_sag - 1), l.last_touch);
    EXPECT_LT(off(l.H, r.H), 0.3);
    EXPECT_LT(off(l.total, r.total), 0.3);
    EXPECT_LT(off(l.kappa_ob, r.kappa_ob), 0.3);
    EXPECT_LT(off(l.kappa_sag, r.kappa_sag), 0.3);
    EXPECT_NEAR(l.last_touch, r.last, 0.3);
  }
}

struct Rolled {
  double T0, lift_off, x_td;
  std::vector<double> F, kappa;  // of rollers every 4 degrees, up to the last in contact
  double M0, H, kappa_sag;
};
const Rolled kRolled[] = {
    {200e3,
     36,
     261.3559581,
     {19806.72788, 19719.55575, 19583.4058, 19362.52108, 19196.52983, 18558.70285, 21153.46029, 0,
      63956.52007},
     {0.008699891563, 0.008698255832, 0.008695857129, 0.008691366918, 0.00868990515, 0.008672064178,
      0.008711847823, 0, 0.01161820969},
     -326264.9556,
     124419.3176,
     0.005084155197},
    {300e3,
     32,
     315.8620551,
     {26790.18332, 26706.12877, 26558.23819, 26382.25903, 26044.38514, 26064.40057, 24448.98178, 49366.84863},
     {0.008827582157, 0.008826068001, 0.008823250634, 0.008820424473, 0.008812678069, 0.008819000721,
      0.008766444222, 0.008935732554},
     -331054.6494,
     224461.2957,
     0.003014756158},
    {400e3,
     28,
     362.2378914,
     {33778.5034, 33674.92066, 33601.74891, 33135.70523, 33924.79833, 29567.04908, 61034.09128},
     {0.008954672478, 0.008952455426, 0.008952366822, 0.008939009073, 0.008972269985, 0.008819383609,
      0.009385334673},
     -335811.9794,
     324503.5958,
     0.00212307804}};

TEST(SLay, OverRollers) {
  for (const Rolled& r : kRolled) {
    Setting s;
    s.T0 = r.T0;
    s.lift_off = r.lift_off;
    s.x_td = r.x_td;
    s.bed = 1e6;
    s.rollers = 9;
    s.over = kRadius * 4 * M_PI / 180 / 16;
    const Laid l = laid(s);
    printf("  T0 %6.0f kN: M0 %+.4f %%, H %+.4f %%, sag %+.4f %%\n", r.T0 / 1e3,
           100 * (l.M0 / std::abs(r.M0) - 1), 100 * (l.H / r.H - 1), 100 * (l.kappa_sag / r.kappa_sag - 1));
    // An endless row of rollers under a pipe with this tension; the first roller is excluded, because the
    // clamp is beside it.
    for (size_t i = 1; i < 3; ++i) {
      const double angle = 4 * static_cast<double>(i + 1) * M_PI / 180;
      const double w_n = kWeight * std::cos(angle);
      const double T = r.T0 - kWeight * kRadius * (1 - std::cos(angle));
      const double beta = 0.5 * kSpacing * std::sqrt(T / kEI);
      const double peak = (1 / kRadius + w_n / T) * beta / std::tanh(beta) - w_n / T;
      const double force = (T / kRadius + w_n) * kSpacing;
      printf("    endless row: %+.3f %% of the force, %+.3f %% of the curvature\n",
             100 * (l.roller_force[i] / force - 1), 100 * (l.roller_kappa[i] / peak - 1));
      EXPECT_LT(off(l.roller_force[i], force), 0.2) << i;
      EXPECT_LT(off(l.roller_kappa[i], peak), 0.2) << i;
    }
    for (size_t i = 0; i < r.F.size(); ++i) {
      printf("    %2zu deg: %8.1f N (%8.1f)  %.6f 1/m (%.6f)\n", 4 * (i + 1), l.roller_force[i], r.F[i],
             l.roller_kappa[i], r.kappa[i]);
      if (r.F[i] == 0) {
        EXPECT_EQ(l.roller_force[i], 0) << i;
        continue;
      }
      EXPECT_LT(off(l.roller_force[i], r.F[i]), 1) << i;
      EXPECT_LT(off(l.roller_kappa[i], r.kappa[i]), 1) << i;
    }
    for (size_t i = r.F.size(); i < l.roller_force.size(); ++i) EXPECT_EQ(l.roller_force[i], 0) << i;
    EXPECT_LT(off(l.M0, std::abs(r.M0)), 0.2);
    EXPECT_LT(off(l.H, r.H), 0.1);
    EXPECT_LT(off(l.kappa_sag, r.kappa_sag), 0.5);
    EXPECT_NEAR(l.H, r.T0 + l.M0 * l.M0 / (2 * kEI) - kWeight * (kTop + kDepth), 1e-4 * l.H);
  }
}

// cases/s-lay: the mean overbend moment is EI/R, and peaks on rollers in the middle of the short row are
// within 2 % of those of an endless row.
TEST(SLay, TheCase) {
  const model::Case c = io::read_case(HAWSER_SOURCE_DIR "/cases/s-lay/simple.yaml");
  const auto volumes = run::load_volumes(c);
  run::Simulation sim(PETSC_COMM_SELF, c, run::surfaces(volumes));
  const StaticsReport report = sim.solve_statics();
  EXPECT_LE(report.iterations, 60);
  EXPECT_LT(report.norms.relative(), 1e-8);
  EXPECT_EQ(report.relaxation_steps, 0);
  const Kinematics at = sim.state().at_rest();
  const std::vector<double> moment = test::NodeField(sim, "bending_moment").at(at);
  const std::vector<double> tension = test::NodeField(sim, "effective_tension").at(at);
  const std::vector<Vec3> forces = sim.line_volume_contact()->forces_by_volume(at);
  const double EI = 1.62726e7;
  const double R = 151.325;
  const double s = 12 * R / 150;
  const double weight = 852.5;
  const auto node = [&](size_t box) {
    const Vec3 x = model::support_point(c, c.supports[box - 1], c.supports[box - 1].at);
    size_t best = 0;
    for (size_t n = 0; n < moment.size(); ++n)
      if ((at.x[n] - x).norm() < (at.x[best] - x).norm()) best = n;
    return best;
  };
  const auto arc = [&](size_t n) { return sim.mesh().node(n).arc; };
  double mean = 0, both = 0, row = 0;
  for (size_t n = node(6); n < node(9); ++n)
    mean += 0.5 * (moment[n] + moment[n + 1]) * (arc(n + 1) - arc(n));
  mean /= arc(node(9)) - arc(node(6));
  EXPECT_LT(off(mean, EI / R), 0.5);
  for (const size_t box : {7u, 8u}) {  // in the middle of the row, above water
    const size_t n = node(box);
    const double w = weight * std::cos(0.08 * static_cast<double>(box - 4));
    const double T = tension[n];
    const double beta = 0.5 * s * std::sqrt(T / EI);
    const double peak = EI * ((1 / R + w / T) * beta / std::tanh(beta) - w / T);
    const double found = std::max({moment[n - 1], moment[n], moment[n + 1]});
    printf("  roller %zu: moment %+.2f %% of an endless row's\n", box, 100 * (found / peak - 1));
    EXPECT_LT(off(found, peak), 2);
    both += forces[c.supports[box - 1].first].norm();
    row += (T / R + w) * s;
  }
  printf("  mean %+.2f %%, reactions of both %+.2f %%, %d iterations\n", 100 * (mean * R / EI - 1),
         100 * (both / row - 1), report.iterations);
  EXPECT_LT(off(both, row), 2);
}

// With a node on each roller two elements per spacing are sufficient.
TEST(SLay, RollersOfAFinerMesh) {
  std::vector<double> kappa;
  for (const int parts : {2, 4, 8}) {
    Setting s;
    s.T0 = 300e3;
    s.lift_off = 32;
    s.x_td = 315.8620551;
    s.bed = 1e6;
    s.rollers = 10;
    s.over = kSpacing / parts;
    const Laid l = laid(s);
    kappa.push_back(l.roller_kappa.at(1));
  }
  const double expected = 0.008826068001;
  printf("  curvature at the second roller: %+.4f %% %+.4f %% %+.4f %%\n", 100 * (kappa[0] / expected - 1),
         100 * (kappa[1] / expected - 1), 100 * (kappa[2] / expected - 1));
  for (const double k : kappa) EXPECT_LT(off(k, expected), 0.05);
}

// Rollers anywhere within elements. Curvature at nodes only is smaller by up to F l / 4 / EI.
TEST(SLay, RollersBetweenNodes) {
  const double expected[] = {0.008827582157, 0.008826068001, 0.008823250634, 0.008820424473};
  double least = 0;
  for (const double parts : {2.5, 3.3, 4.6}) {
    Setting s;
    s.T0 = 300e3;
    s.lift_off = 32;
    s.x_td = 315.8620551;
    s.bed = 1e6;
    s.rollers = 10;
    s.over = kSpacing / parts;
    const Laid l = laid(s);
    s.peaks = false;
    const Laid nodes = laid(s);
    for (size_t i = 1; i < 4; ++i) {
      const double shown = l.roller_kappa.at(i);
      const double at_nodes = nodes.roller_kappa.at(i);
      printf("  %.1f elements, roller %zu: curvature %+.3f %%, of the nodes alone %+.3f %%\n", parts, i + 1,
             100 * (shown / expected[i] - 1), 100 * (at_nodes / expected[i] - 1));
      EXPECT_LT(off(shown, expected[i]), 0.3) << parts << " " << i;
      least = std::min(least, at_nodes / expected[i] - 1);
    }
  }
  EXPECT_LT(least, -0.01);  // the peaks between nodes matter
}

}  // namespace
}  // namespace hawser::s_lay_test
