// A heavy tensioned pipe of 40 m lies on a roller of radius 0.25 m that moves along under it. With contact
// along the line the reaction is a smooth function of the roller's position for any element length; with
// contact at the nodes it is not.
#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "verification/contact_rig.hpp"
#include "verification/statics_newton.hpp"

namespace hawser::test::line_contact_roller_test {
namespace {

constexpr double kSpan = 40, kRoller = 0.25, kPipe = 0.16;  // m

struct Ridden {
  double mean = 0, least = 1e300, most = -1e300;  // N
  double ripple = 0;                              // rms deviation from a polynomial, over the mean
  double worst = 0;                               // largest deviation from it, over the mean
  double iterations = 0;
  int most_iterations = 0, failed = 0, lost = 0;  // positions without contact
};

// Least squares by a polynomial of degree seven, in Legendre's basis.
std::vector<double> smooth(const std::vector<double>& y) {
  using Row = Eigen::Matrix<double, 8, 1>;
  const auto row = [&](size_t i) {
    const double t = 2 * static_cast<double>(i) / static_cast<double>(y.size() - 1) - 1;
    Row p;
    p[0] = 1;
    p[1] = t;
    for (int k = 2; k < 8; ++k) p[k] = ((2 * k - 1) * t * p[k - 1] - (k - 1) * p[k - 2]) / k;
    return p;
  };
  Eigen::Matrix<double, 8, 8> A = Eigen::Matrix<double, 8, 8>::Zero();
  Row b = Row::Zero();
  for (size_t i = 0; i < y.size(); ++i) {
    A += row(i) * row(i).transpose();
    b += y[i] * row(i);
  }
  const Row c = A.ldlt().solve(b);
  std::vector<double> f;
  for (size_t i = 0; i < y.size(); ++i) f.push_back(c.dot(row(i)));
  return f;
}

// The roller moves 4.2 m in steps of 5 cm, past the middle; equilibrium at each position.
Ridden ride(double element, model::ContactMethod method) {
  model::LineType type = beam_type(1e8, 3.1e7, 3.1e7, 180);
  type.outer_diameter = type.contact_diameter = 2 * kPipe;
  const int n = static_cast<int>(std::lround(kSpan / element));
  model::Case c = one_line(type, kSpan, n, anchor({0, 0, 0}), anchor({kSpan, 0, 0}));
  c.environment.gravity = 9.81;
  c.contact.method = method;
  c.lines[0].start = model::Start::straight;
  // Without the roller the sag is 1.02 m. In the first two seconds the roller rises and lifts the pipe by
  // 0.35 m; then it moves along at 1 m/s.
  model::Body carriage;
  carriage.name = "carriage";
  carriage.position = Vec3(kSpan / 2 - 3.1, 0, -0.67 - kRoller - kPipe);
  model::TableMotion motion;
  for (double t = 0; t < 8; t += 0.25) {
    motion.time.push_back(t);
    motion.offset.push_back({std::max(t - 2, 0.0), 0, std::min(t - 2, 0.0)});
  }
  carriage.motion = motion;
  c.bodies.push_back(carriage);
  model::Volume roller;
  roller.name = "roller";
  roller.body = "carriage";
  roller.basis = method == model::ContactMethod::nodes ? model::StiffnessBasis::per_point
                                                       : model::StiffnessBasis::per_length;
  roller.normal_stiffness = method == model::ContactMethod::nodes ? 2e7 : 2e8;
  c.volumes.push_back(roller);
  Simulation s(PETSC_COMM_WORLD, c, {round_drum(kRoller, 2)});
  Ridden out;
  std::vector<double> reaction;
  s.solve_statics();
  const auto follow = [&](double time) {
    const State last = s.state();
    s.state().time = time;
    try {
      return newton(s.system(), s.state(), 1e-8) - 1;  // newton() adds one more iteration
    } catch (const std::runtime_error&) {
      s.state() = last;
      s.state().time = time;
      return -1;
    }
  };
  for (int i = 1; i <= 600; ++i) follow(0.005 * i);
  for (int i = 0; i <= 84; ++i) {
    const int iterations = follow(3 + 0.05 * i + 0.00131);
    if (iterations < 0) ++out.failed;
    s.system().commit(s.state().at_rest());
    const Kinematics k = s.state().at_rest();
    double z = 0;
    const std::vector<double> force = NodeField(s, "contact_force").at(k);
    for (size_t j = 2; j < force.size(); j += 3) z += force[j];
    reaction.push_back(z);
    if (z <= 0) ++out.lost;
    out.least = std::min(out.least, z);
    out.most = std::max(out.most, z);
    if (i == 0) continue;
    out.iterations += iterations / 84.0;
    out.most_iterations = std::max(out.most_iterations, iterations);
  }
  const std::vector<double> line = smooth(reaction);
  double square = 0;
  for (size_t i = 0; i < reaction.size(); ++i) {
    out.mean += reaction[i] / static_cast<double>(reaction.size());
    square += std::pow(reaction[i] - line[i], 2) / static_cast<double>(reaction.size());
    out.worst = std::max(out.worst, std::abs(reaction[i] - line[i]));
  }
  out.ripple = std::sqrt(square) / out.mean;
  out.worst /= out.mean;
  return out;
}

void print(const char* method, double element, const Ridden& r) {
  std::printf(
      "roller, %s, elements of %.1f m: reaction %.3f kN (%.3f to %.3f), rms about its smooth course %.4f %%, "
      "most %.4f %%; "
      "%.1f iterations, most %d, %d failed; %d of 85 places without contact\n",
      method, element, r.mean / 1e3, r.least / 1e3, r.most / 1e3, 100 * r.ripple, 100 * r.worst, r.iterations,
      r.most_iterations, r.failed, r.lost);
}

class Roller : public ::testing::TestWithParam<double> {};

TEST_P(Roller, ReactionIsSmooth) {
  const Ridden r = ride(GetParam(), model::ContactMethod::line);
  print("line", GetParam(), r);
  EXPECT_LT(r.ripple, 1e-3);
  EXPECT_LT(r.worst, 1e-3);
  EXPECT_LE(r.most_iterations, 5);
  EXPECT_EQ(r.lost, 0);
}
// The same roller with contact at the nodes: the reaction varies by more than 10 kN.
TEST_P(Roller, NodesMissIt) {
  const Ridden r = ride(GetParam(), model::ContactMethod::nodes);
  print("nodes", GetParam(), r);
  EXPECT_GT(r.most - r.least, 10e3);
}
INSTANTIATE_TEST_SUITE_P(Elements, Roller, ::testing::Values(4.0, 2.0, 1.0, 0.5), [](const auto& e) {
  return "mm" + std::to_string(static_cast<int>(1000 * e.param));
});

// The pipe of cases/roller, drawn over the roller with friction. In an automatic step a third of the contact
// comes on and as much leaves; the energy balance with the work of friction closes within 1e-4.
TEST(LineRoller, EnergyCloses) {
  model::Case c = io::read_case(HAWSER_SOURCE_DIR "/cases/roller/roller.yaml");
  c.dynamics.max_step = 0.06;  // by default 0.25 s, with an energy error of 0.03 %
  Simulation s(PETSC_COMM_WORLD, c, run::surfaces(run::load_volumes(c)));
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const Energy e0 = s.system().energy(d.committed_kinematics());
  int steps = 0;
  d.run(
      40, [](double t) { return t + 100; }, [&](const StepInfo&) { return ++steps > 0; });
  const Energy e = s.system().energy(d.committed_kinematics());
  const double brought = e.work + d.support_work() - (e.potential - e0.potential);
  const double audit = (e.kinetic + e.strain - e0.kinetic - e0.strain + e.friction + e.damping) / brought - 1;
  std::printf(
      "roller of the case, 40 s in %d steps: friction took %.0f of %.0f J, not accounted for %.5f %%\n",
      steps, e.friction, brought, 100 * audit);
  EXPECT_LT(steps, 1000);
  EXPECT_GT(e.friction, 0.5 * brought);
  EXPECT_LT(std::abs(audit), 1e-4);
}

}  // namespace
}  // namespace hawser::test::line_contact_roller_test
