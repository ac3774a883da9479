// The reel of cases/reel on a round drum: contact along the hose has less than 0.3 of the tension noise of
// contact at the nodes, where the lift-off point jumps from node to node.
#include "hawser/io/case_reader.hpp"
#include "verification/contact_rig.hpp"

namespace hawser::test::line_contact_reel_test {
namespace {

constexpr double kBarrel = 3.6, kHose = 0.425, kLength = 250;  // m

struct Drawn {
  double noise = 0;        // N, rms of the tension 6 m below the drum about a line through 10 s
  double penetration = 0;  // m
  double audit = 0;        // energy error over the work brought in
  double cpu = 0;          // s a simulated second
  int steps = 0, iterations = 0;
};

Drawn draw(model::ContactMethod method, int elements, double duration) {
  model::Case c = io::read_case(HAWSER_SOURCE_DIR "/cases/reel/reel.yaml");
  c.contact.method = method;
  c.lines[0].sections[0].elements = elements;
  Simulation s(PETSC_COMM_WORLD, c, {round_drum(kBarrel, 5.5)});
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());
  const model::LineType& type = c.line_types[0];
  const double load =
      (c.lines[0].loads[0].per_length - type.mass_per_length * 9.80665 * Vec3::UnitZ()).norm();
  const double h = kLength / elements;
  NodeField tension(s, "effective_tension");
  const Energy e0 = s.system().energy(d.committed_kinematics());
  Series tension_below;
  Drawn out;
  const double before = cpu_seconds();
  d.run(
      duration, [](double t) { return t + 1000; },
      [&](const StepInfo& i) {
        ++out.steps;
        out.iterations += i.iterations;
        const Kinematics k = d.committed_kinematics();
        size_t n = k.x.size() - 1;
        while (n > 0 && k.x[n].z() < -6) --n;  // between n and n + 1: 6 m below the axis
        const double part = (k.x[n].z() + 6) / (k.x[n].z() - k.x[n + 1].z());
        const std::vector<double>& T = tension.at(k);
        const double arc = h * (static_cast<double>(n) + part);
        tension_below.add(i, (1 - part) * T[n] + part * T[n + 1] - load * (kLength - arc));
        return true;
      });
  out.cpu = (cpu_seconds() - before) / duration;
  out.penetration = s.line_volume_contact()->largest_penetration().depth;
  const Energy e = s.system().energy(d.committed_kinematics());
  const double brought = e.work + d.support_work() - (e.potential - e0.potential);
  out.audit = (e.kinetic + e.strain - e0.kinetic - e0.strain + e.friction + e.damping) / brought - 1;
  out.noise = tension_below.noise(15, duration - 5);
  return out;
}

TEST(LineReel, IsDrawnUpEvenly) {
  for (const int elements : {250, 125}) {
    Drawn by[2];
    for (const auto method : {model::ContactMethod::nodes, model::ContactMethod::line}) {
      Drawn& r = by[method == model::ContactMethod::line];
      r = draw(method, elements, 65);
      std::printf(
          "reel, %s, %d elements: tension noise %.0f N rms; penetration %.2f mm; energy not accounted for "
          "%.3f "
          "%%; %d steps, %.1f iterations a step, %.3f CPU s a second\n",
          method == model::ContactMethod::line ? "line" : "nodes", elements, r.noise, 1e3 * r.penetration,
          100 * r.audit, r.steps, static_cast<double>(r.iterations) / r.steps, r.cpu);
      EXPECT_LT(std::abs(r.audit), 0.01);
      EXPECT_LT(r.penetration, 0.01 * kHose);
    }
    EXPECT_LT(by[1].noise, 0.3 * by[0].noise);
  }
}

}  // namespace
}  // namespace hawser::test::line_contact_reel_test
