// Case C09: a stiff line under a far tension T leaves a circle of radius rho (of its centreline) without
// friction, with contact at the nodes or along the elements. Elastica: it leaves at alpha before the point
// where T's direction is tangent, 1 - cos alpha = EI/(2 T rho²). There the drum exerts a point force P = T
// sin alpha. On the drum the tension is T cos alpha and the pressure T cos alpha/rho. The line of action of T
// passes rho + EI/(2 T rho) from the axis.
#include "verification/contact_rig.hpp"

namespace hawser::test::contact_lift_off_test {
namespace {

struct Row {
  double EI, rho, T;  // N m², m, N
  double alpha, P, tension, pressure, M,
      offset;  // rad, N, N, N/m, N m, m: closed form, checked by a BVP solver
};
constexpr Row kRows[] = {
    {196133, 4.025, 200e3, 0.2466584256, 48832.97822, 193946.7459, 48185.52693, 48728.69565, 0.2436434783},
    {100e3, 5, 50e3, 0.2837941092, 14000, 48000, 9600, 20000, 0.4},
    {1e6, 10, 200e3, 0.2240752853, 44440.97209, 195000, 19500, 100000, 0.5},
    {120e3, 4.025, 10e3, 0.8897015468, 7768.838629, 6296.439181, 1564.332716, 29813.6646, 2.98136646}};
constexpr double kWrap = 2.2;  // rad, from the clamp to where T's direction is tangent

struct Found {
  Samples curvature, moment, tension, pressure;  // on the middle half of the drum
  double P = 0, lift_off = 0;                    // N; rad before the direction of T
  double offset = 0;                             // m
  int iterations = 0, unstable = 0;
};

struct Drum {
  int facets = 0;    // 0: smooth
  double phase = 0;  // rad
};

Found solve(const Row& row, model::ContactMethod method, int elements_a_radian, const Drum& shape = {}) {
  const int facets = shape.facets;
  const double phase = shape.phase;
  const double r = 0.1 * row.rho;
  const double leg = 8 * std::sqrt(row.EI / row.T);
  std::vector<Vec3> path = capstan_path(row.rho, kWrap, 0, leg);
  path.erase(path.begin());
  const double length = path_length(path);
  const int n = static_cast<int>(std::ceil(length / row.rho * elements_a_radian));
  const double h = length / n;
  model::LineType type = beam_type(1e9, row.EI, row.EI, 10);
  type.outer_diameter = type.contact_diameter = 2 * r;
  model::Case c = one_line(type, length, n, clamp(on_circle(row.rho, 0), along_circle(0)), {});
  c.lines[0].start = model::Start::points;
  c.lines[0].points = path;
  c.lines[0].loads.push_back({row.T / h * along_circle(kWrap), length - h, length, 0, 0});
  model::Volume drum;
  drum.name = "drum";
  drum.basis = model::StiffnessBasis::per_length;
  drum.normal_stiffness = row.pressure / (1e-6 * row.rho);
  drum.smoothing = 1e-7 * row.rho;
  c.volumes.push_back(drum);
  c.contact.method = method;
  Simulation s(PETSC_COMM_WORLD, c,
               {facets ? faceted_drum(facets, row.rho - r, 8, 3, phase) : round_drum(row.rho - r, 8)});
  const StaticsReport report = s.solve_statics();

  const Kinematics k = s.state().at_rest();
  const auto of = [&](const char* name) { return NodeField(s, name).at(k); };
  const std::vector<double> curvature = of("curvature");
  const std::vector<double> moment = of("bending_moment");
  const std::vector<double> tension = of("effective_tension");
  const std::vector<double> normal = of("contact_normal_force");
  const std::vector<double> force = of("contact_force");
  const double lift = kWrap - row.alpha;
  const double facet = 2 * M_PI / 96;
  // Average over whole facets, from the middle of one to the middle of another.
  const auto middle = [&](double angle) {
    return (std::floor((angle + phase) / facet) + 0.5) * facet - phase;
  };
  const double from = middle(0.25 * lift);
  const double to = middle(0.75 * lift);
  Found f;
  f.iterations = report.iterations;
  f.unstable = report.negative_eigenvalues;
  double sum = 0;
  double start = to;
  int inside = 0;
  Vec3 rest = Vec3::Zero();
  for (size_t i = 1; i < k.x.size(); ++i) {
    const double angle = std::atan2(k.x[i].z(), k.x[i].x());
    if (normal[i] > 0 && angle > to) rest += Eigen::Map<const Vec3>(force.data() + 3 * i);
    if (angle < from || angle > to) continue;
    f.curvature.add(curvature[i]);
    f.moment.add(moment[i]);
    f.tension.add(tension[i]);
    sum += normal[i];
    ++inside;
    if (!facets) start = angle + 0.5 * h / row.rho;  // a node carries the pressure of half its elements
  }
  const double pressure = facets ? sum / (row.rho * (to - from)) : sum / (inside * h);
  f.pressure.add(pressure);
  // Beyond `to` the drum exerts the pressure up to the lift-off, and P there: two components, two unknowns.
  double low = start;
  double high = kWrap;
  for (int i = 0; i < 80; ++i) {
    const double q = 0.5 * (low + high);
    const Vec3 arc = row.rho * Vec3(std::sin(q) - std::sin(start), 0, std::cos(start) - std::cos(q));
    const Vec3 point = rest - pressure * arc;
    f.P = point.dot(on_circle(1, q));
    (point.dot(along_circle(q)) > 0 ? low : high) = q;
  }
  f.lift_off = kWrap - low;
  f.offset = 2 * (k.x.back().dot(on_circle(1, kWrap)) - row.rho);
  return f;
}

void check_step(const Row& row, model::ContactMethod method, int elements_a_radian, double tolerance) {
  const Found f = solve(row, method, elements_a_radian);
  std::printf(
      "lift-off %s, EI %.0f T %.0f, %d elements a radian: curvature %+.3f %%, moment %+.3f %%, tension %+.3f "
      "%%, pressure %+.3f %%, P %+.2f %%, angle %.4f (%.4f) rad, offset %+.3f %%; %d iterations\n",
      method == model::ContactMethod::line ? "along the line" : "at the nodes", row.EI, row.T,
      elements_a_radian, 100 * (f.curvature.mean() * row.rho - 1), 100 * (f.moment.mean() / row.M - 1),
      100 * (f.tension.mean() / row.tension - 1), 100 * (f.pressure.mean() / row.pressure - 1),
      100 * (f.P / row.P - 1), f.lift_off, row.alpha, 100 * (f.offset / row.offset - 1), f.iterations);
  EXPECT_EQ(f.unstable, 0);
  EXPECT_NEAR(f.curvature.mean() * row.rho, 1, tolerance);
  EXPECT_LT(f.curvature.rms() * row.rho, tolerance);
  EXPECT_NEAR(f.moment.mean(), row.M, tolerance * row.M);
  EXPECT_NEAR(f.tension.mean(), row.tension, tolerance * row.tension);
  EXPECT_NEAR(f.pressure.mean(), row.pressure, 10 * tolerance * row.pressure);
  EXPECT_NEAR(f.P, row.P, 10 * tolerance * row.P);
  EXPECT_NEAR(f.lift_off, row.alpha, 2 * tolerance);
  EXPECT_NEAR(f.offset, row.offset, 2 * tolerance * row.offset);
}

class LiftOff : public ::testing::TestWithParam<Row> {};
class LineLiftOff : public ::testing::TestWithParam<Row> {};

TEST_P(LiftOff, SmoothDrum) { check_step(GetParam(), model::ContactMethod::nodes, 60, 1e-3); }
TEST_P(LineLiftOff, Fine) { check_step(GetParam(), model::ContactMethod::line, 60, 1e-3); }
TEST_P(LineLiftOff, Coarse) { check_step(GetParam(), model::ContactMethod::line, 15, 5e-3); }

// On 96 flat facets the line lies on the edges. Each edge carries p rho 2 pi/96 (a quarter of P in the first
// row), and the line lifts off from one of them, so P depends on the position of the edges. Its mean over
// positions of the drum is compared; the range is printed.
TEST_P(LiftOff, Facets) {
  const Row& row = GetParam();
  Samples P, curvature, scatter, offset, angle;
  const int positions = 12;
  for (int i = 0; i < positions; ++i) {
    const Found f = solve(row, model::ContactMethod::nodes, 60, {96, 2 * M_PI / 96 * i / positions});
    P.add(f.P / row.P);
    curvature.add(f.curvature.mean() * row.rho);
    scatter.add(f.curvature.rms() * row.rho);
    offset.add(f.offset / row.offset);
    angle.add(f.lift_off - row.alpha);
  }
  std::printf(
      "lift-off from 96 facets, EI %.0f T %.0f: curvature %+.3f %% (%.2f %% rms along the line), P %+.2f "
      "%% (between %+.1f and %+.1f %%), angle %+.4f rad, offset %+.2f %%\n",
      row.EI, row.T, 100 * (curvature.mean() - 1), 100 * scatter.mean(), 100 * (P.mean() - 1),
      100 * (P.least - 1), 100 * (P.most - 1), angle.mean(), 100 * (offset.mean() - 1));
  EXPECT_NEAR(curvature.mean(), 1, 5e-3);
  EXPECT_LT(scatter.mean(), 1e-2);
  EXPECT_NEAR(P.mean(), 1, 0.05);
  EXPECT_NEAR(angle.mean(), 0, 0.02);
  EXPECT_NEAR(offset.mean(), 1, 0.01);
}

const auto kName = [](const auto& row) { return "row" + std::to_string(row.index + 1); };
INSTANTIATE_TEST_SUITE_P(Rows, LiftOff, ::testing::ValuesIn(kRows), kName);
INSTANTIATE_TEST_SUITE_P(Rows, LineLiftOff, ::testing::ValuesIn(kRows), kName);

}  // namespace
}  // namespace hawser::test::contact_lift_off_test
