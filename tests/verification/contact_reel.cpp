// The reel of cases/reel: turns by geometry, tension by statics, and the energy balance. Data of the case:
// drum 3.6 m, hose radius 0.425 m, 0.1 rad/s after a start that costs 5 s, 250 m of 273.4 kg/m.
#include <algorithm>
#include <cstdlib>

#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"
#include "verification/contact_rig.hpp"

namespace hawser::test::contact_reel_test {
namespace {

// Three turns; five with HAWSER_FULL.
double end() { return std::getenv("HAWSER_FULL") ? 325 : 200; }  // s

constexpr double kBarrel = 3.6, kHose = 0.425, kRho = kBarrel + kHose, kLength = 250, kRate = 0.1, kRamp = 10;

// Angle of the drum; its rate rises by the quintic 10 z³ - 15 z⁴ + 6 z⁵.
double drum_angle(double t) {
  const double z = std::min(t / kRamp, 1.0);
  return kRate * (kRamp * std::pow(z, 4) * (2.5 - 3 * z + z * z) + std::max(t - kRamp, 0.0));
}

struct Wound {
  double time = 0, by_contact = 0, by_length = 0;  // s; turns on the drum
};
struct Reeled {
  double penetration = 0, audit = 0, cpu = 0;  // m; energy error over the work brought in; s
  std::vector<Wound> wound;                    // every 25 s
  std::vector<double> moment;                  // at nodes well inside the wound part, over EI/rho
  // Tension [N] at the tied end; tension less the weight below, 6 m below the last node in contact and at 230
  // m.
  Series tied, leaving, hanging;
  long steps = 0, iterations = 0;
};

using model::ContactMethod;

Reeled run(ContactMethod method, int elements, double duration,
           std::shared_ptr<const Surface> instead = nullptr, bool flat = false) {
  model::Case c = io::read_case(HAWSER_SOURCE_DIR "/cases/reel/reel.yaml");
  EXPECT_EQ(c.contact.method, ContactMethod::line);  // the method in the case
  c.contact.method = method;
  if (flat) c.volumes[0].smooth = false;
  c.lines[0].sections[0].elements = elements;
  const std::vector<run::LoadedVolume> volumes = run::load_volumes(c);
  std::vector<std::shared_ptr<const Surface>> surfaces = run::surfaces(volumes);
  if (instead) surfaces = {instead};
  Simulation s(PETSC_COMM_WORLD, c, surfaces);
  s.solve_statics();
  Dynamics& d = s.dynamics();
  d.start(s.state());

  const model::LineType& type = c.line_types[0];
  const Vec3 load = c.lines[0].loads[0].per_length - type.mass_per_length * 9.80665 * Vec3::UnitZ();
  const double h = kLength / elements;
  const double EI = type.EI2;
  NodeField tension(s, "effective_tension");
  NodeField normal(s, "contact_normal_force");
  NodeField moment(s, "bending_moment");
  const Energy e0 = s.system().energy(d.committed_kinematics());
  const double z0 = s.state().x.back().z();
  Reeled out;
  const double before = cpu_seconds();
  double last_angle = 0;
  size_t last = 0;
  d.run(
      duration, [](double t) { return 25 * (std::floor(t / 25 + 1e-9) + 1); },
      [&](const StepInfo& i) {
        ++out.steps;
        out.iterations += i.iterations;
        const Kinematics k = d.committed_kinematics();
        const std::vector<double>& T = tension.at(k);
        const std::vector<double>& N = normal.at(k);
        // Angle along the hose from end A, which is at the drum's angle, to the last node on the barrel (the
        // next node may carry a share of an element's contact).
        const auto turn = [&](size_t n) {
          const double a = std::atan2(k.x[n - 1].z(), k.x[n - 1].x()) - std::atan2(k.x[n].z(), k.x[n].x());
          return std::remainder(a, 2 * M_PI);
        };
        double angle = 0;
        last = 0;
        last_angle = 0;
        for (size_t n = 1; n < k.x.size(); ++n) {
          angle += turn(n);
          if (N[n] > 0 && std::hypot(k.x[n].x(), k.x[n].z()) < kRho + 0.001) {
            last = n;
            last_angle = angle;
          }
        }
        out.tied.add(i, T[0]);
        const auto less_weight = [&](size_t n) {
          return T[n] - load.norm() * (kLength - h * static_cast<double>(n));
        };
        const size_t below = last + static_cast<size_t>(std::lround(6 / h));
        if (below < T.size()) out.leaving.add(i, less_weight(below));
        out.hanging.add(i, less_weight(static_cast<size_t>(std::lround(230 / h))));
        if (std::abs(std::remainder(i.time, 25)) < 1e-6) {
          // A stiff hose lifts off earlier than a string: 1 - cos alpha = EI/(2 T rho²).
          const double hangs = load.norm() * (kLength - kRho * drum_angle(i.time));
          const double alpha = std::acos(1 - EI / (2 * hangs * kRho * kRho));
          out.wound.push_back(
              {i.time, (last_angle + alpha) / (2 * M_PI), (k.x.back().z() - z0) / (2 * M_PI * kRho)});
        }
        return true;
      });
  out.cpu = cpu_seconds() - before;
  out.penetration = s.line_volume_contact()->largest_penetration().depth;
  const std::vector<double>& M = moment.at(d.committed_kinematics());
  // Bending decays over sqrt(EI/T) = 1.2 m: exclude nodes near the clamp and the lift-off.
  const size_t clear = static_cast<size_t>(std::lround(5 / h));
  for (size_t n = clear; n + clear < last; ++n) out.moment.push_back(M[n] / (EI / kRho));
  const Energy e = s.system().energy(d.committed_kinematics());
  const double brought = e.work + d.support_work() - (e.potential - e0.potential);
  out.audit = (e.kinetic + e.strain - e0.kinetic - e0.strain + e.friction + e.damping) / brought - 1;
  return out;
}

void print(const char* method, const Reeled& r) {
  std::printf(
      "reel, %s: penetration %.2f mm, energy not accounted for %.3f %%, %ld steps, %.1f iterations a step, "
      "%.3f CPU s a second\n",
      method, 1e3 * r.penetration, 100 * r.audit, r.steps,
      static_cast<double>(r.iterations) / static_cast<double>(r.steps), r.cpu / end());
  std::printf(
      "reel, %s: tension noise %.0f N at the tied end, %.0f N at 230 m, 6 m below the last node in contact "
      "%.0f N (15 to 60 s), %.0f N (until 35 s before the end)\n",
      method, r.tied.noise(15, end() - 15), r.hanging.noise(15, end() - 15), r.leaving.noise(15, 60),
      r.leaving.noise(15, end() - 35));
}

// Checks turns by two measures, moment on the drum, penetration and energy.
void expect_wound(const char* method, const Reeled& r) {
  EXPECT_LE(r.penetration, 0.01 * kHose);
  EXPECT_LT(std::abs(r.audit), 0.01);

  double by_contact = 0, by_length = 0;
  for (const Wound& w : r.wound) {
    const double turns = drum_angle(w.time) / (2 * M_PI);
    EXPECT_NEAR(w.by_contact, turns, 0.05) << "at " << w.time << " s";
    EXPECT_NEAR(w.by_length, turns, 0.01) << "at " << w.time << " s";
    by_contact = std::max(by_contact, std::abs(w.by_contact - turns));
    by_length = std::max(by_length, std::abs(w.by_length - turns));
  }
  EXPECT_EQ(r.wound.size(), static_cast<size_t>(end() / 25));
  std::printf("reel, %s: wound %.4f turns, off by up to %.4f by contact, %.4f by the length drawn up\n",
              method, r.wound.back().by_contact, by_contact, by_length);

  Samples moment;
  int off = 0;
  for (const double m : r.moment) {
    moment.add(m);
    off += std::abs(m - 1) > 0.02;
  }
  std::printf(
      "reel, %s: moment on the drum %.4f EI/(R+r), rms %.4f, between %.4f and %.4f, %d of %zu nodes off by 2 "
      "%%\n",
      method, moment.mean(), moment.rms(), moment.least, moment.most, off, r.moment.size());
  EXPECT_GT(r.moment.size(), end() / 4);
  EXPECT_NEAR(moment.mean(), 1, 2e-3);
  EXPECT_EQ(off, 0);  // 2 %: influence of the adjacent first turns
}

TEST(Reel, SeveralTurns) {
  const Reeled r = run(ContactMethod::line, 250, end());
  print("line", r);
  expect_wound("line", r);
  EXPECT_LT(r.tied.noise(15, end() - 15), 1000);
  EXPECT_LT(r.leaving.noise(15, 60), 200);
  EXPECT_LT(r.leaving.noise(15, end() - 35), 200);
  EXPECT_LT(r.hanging.noise(15, end() - 15), 100);
#if defined(NDEBUG) && !defined(__SANITIZE_ADDRESS__)
  EXPECT_LT(r.cpu / end(), 0.1);
#endif
}

// The paper's method, contact at the nodes on flat facets. Elements of 1 m are coarse on a drum of 4 m: the
// lift-off point jumps from node to node.
TEST(Reel, FiveTurnsByNodes) {
  if (!std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  const Reeled r = run(ContactMethod::nodes, 250, 325, nullptr, true);
  print("nodes", r);
  expect_wound("nodes", r);
  EXPECT_LT(r.hanging.noise(15, end() - 15), 1000);
  EXPECT_LT(r.leaving.noise(15, 60), 5000);
}

// The tension noise of contact at the nodes does not come from the facets; it falls with the element length.
TEST(Reel, TensionNoiseOfNodes) {
  const auto nodes = ContactMethod::nodes;
  const auto smooth = round_drum(kBarrel, 5.5);
  const double coarse = run(nodes, 250, 65, smooth).leaving.noise(15, 60);
  const double faceted = run(nodes, 500, 65, nullptr, true).leaving.noise(15, 60);
  const double fine = run(nodes, 500, 65, smooth).leaving.noise(15, 60);
  std::printf(
      "reel, nodes: tension noise below the drum: smooth drum, elements of 1 m %.0f N; of 0.5 m %.0f N, on "
      "facets %.0f N\n",
      coarse, fine, faceted);
  EXPECT_LT(fine, 0.6 * coarse);
  EXPECT_LT(faceted, 0.6 * coarse);
}

}  // namespace
}  // namespace hawser::test::contact_reel_test
