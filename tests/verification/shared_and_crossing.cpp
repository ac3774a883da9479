// Random sets of lines with common ends, bodies and joints, or that cross on the bed. Where lines do not
// touch, tensions are those without contact; where lines cross, the right one is on top. Ten sets, a hundred
// with HAWSER_FULL.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "hawser/io/case_reader.hpp"
#include "support/rig.hpp"

namespace hawser::test::shared_and_crossing {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double in(double low, double high) {  // the same with every library
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  int of(int n) { return static_cast<int>(in(0, n)); }

 private:
  std::mt19937 engine_;
};

struct Set {
  std::string name, head, lines;
  std::string text(const std::string& contact) const { return head + contact + "lines:\n" + lines; }
};

std::string line(const std::string& name, const std::string& type, double length, double element,
                 const std::string& a, const std::string& b, const std::string& more = "") {
  return fmt::format(
      "  {}: {{sections: [{{type: {}, length: {:.9g}, elements: {}}}], end_a: {}, end_b: {}{}}}\n", name,
      type, length, std::max(4, static_cast<int>(length / element)), a, b, more);
}
std::string anchored(const Vec3& x) {
  return fmt::format("{{anchor: [{:.9g}, {:.9g}, {:.9g}]}}", x.x(), x.y(), x.z());
}

// Legs from a fairlead to a bed or through the air with random azimuths and slack; their ends are at one
// point of a body, or nearer to each other than their radii.
Set legs(Random& r) {
  const double d = r.in(0.06, 0.3);
  const double depth = r.in(40, 120);
  const double near = r.of(2) ? 0 : r.in(0.1, 0.9) * d / 2;
  const bool air = r.of(3) == 0;
  Set s{"legs",
        fmt::format(
            "hawser: 1\n{}line_types: {{c: {{outer_diameter: {:.6g}, mass_per_length: {:.6g}, EA: {:.6g}, "
            "bending: false}}}}\nbodies: {{p: {{}}}}\n",
            air ? ""
                : fmt::format("environment: {{water: {{depth: {0:.9g}}}, seabed: {{depth: {0:.9g}}}}}\n",
                              depth),
            d, 3000 * d * d + 1300 * d * d, 5e9 * d * d),
        ""};
  double azimuth = r.in(0, 2 * M_PI);
  const int n = 2 + r.of(3);
  for (int i = 0; i < n; ++i) {
    const double far = r.in(1.0, 2.5) * depth;
    const Vec3 to(far * std::cos(azimuth), far * std::sin(azimuth), -depth);
    const Vec3 at(near * std::cos(azimuth), near * std::sin(azimuth), -5);
    const double length = (to - at).norm() * (1 + r.in(0.002, 0.04));
    s.lines += line(fmt::format("l{}", i), "c", length, length / 50, anchored(to),
                    fmt::format("{{body: p, at: [{:.9g}, {:.9g}, {:.9g}]}}", at.x(), at.y(), at.z()));
    azimuth += r.in(0.08, 0.6);
  }
  return s;
}

// A line whose ends are at the same place.
Set loop(Random& r) {
  const double d = r.in(0.02, 0.3);
  const double apart = r.of(2) ? 0 : r.in(0, 0.95) * d;
  const double length = r.in(5, 40);
  return {"loop",
          fmt::format(
              "hawser: 1\nline_types: {{c: {{outer_diameter: {:.6g}, mass_per_length: {:.6g}, EA: {:.6g}, "
              "bending: false}}}}\n",
              d, 5000 * d * d, 2e10 * d * d),
          line("m", "c", length, length / (20 + 10 * r.of(3)), anchored({0, 0, 0}), anchored({apart, 0, 0}))};
}

// A line to a joint, from which two or three lines lead at small angles.
Set joint(Random& r) {
  const double d = r.in(0.05, 0.25);
  const double h = r.in(10, 30);
  Set s{"joint",
        fmt::format(
            "hawser: 1\nline_types: {{c: {{outer_diameter: {:.6g}, mass_per_length: {:.6g}, EA: {:.6g}, "
            "bending: false}}}}\njoints: {{j: {{start: [0, 0, {:.6g}]}}}}\n",
            d, 4000 * d * d, 5e9 * d * d, -h),
        ""};
  s.lines += line("up", "c", h * 1.05, 1, anchored({0, 0, 0}), "{joint: j}");
  double azimuth = r.in(0, 6);
  for (int i = 0, n = 2 + r.of(2); i < n; ++i) {
    const Vec3 to(20 * std::cos(azimuth), 20 * std::sin(azimuth), -h - r.in(5, 15));
    s.lines += line(fmt::format("l{}", i), "c", (to - Vec3(0, 0, -h)).norm() * r.in(1.02, 1.1), 0.7,
                    "{joint: j}", anchored(to));
    azimuth += r.in(0.15, 0.5);
  }
  return s;
}

// A chain or cable that descends to the bed across a pipeline, at any angle, in any order of the lines.
struct Crossing {
  Set set;
  double radii, under;  // m; height of the pipe's axis
  bool pipe_first;
};
Crossing crossing(Random& r) {
  const double pipe = r.in(0.3, 1.0);
  const double d = r.in(0.05, 0.3);
  const double depth = r.in(50, 150);
  const double at = r.in(0.6, 0.9);
  const double far = 3 * depth;
  const double angle = r.in(0.7, 2.4);
  const double axis = -depth + pipe / 2;
  const Vec3 place(at * far, 0, axis);
  const Vec3 half(50 * std::cos(angle), 50 * std::sin(angle), 0);
  Crossing c{
      {"crossing",
       fmt::format(
           "hawser: 1\nenvironment: {{water: {{depth: {0:.9g}}}, seabed: {{depth: {0:.9g}}}}}\nline_types:\n"
           "  c: {{outer_diameter: {1:.6g}, mass_per_length: {2:.6g}, EA: {3:.6g}, bending: false}}\n"
           "  p: {{pipe: {{outer_diameter: {4:.6g}, wall_thickness: {5:.6g}}}, contents: {{density: "
           "900}}}}\n",
           depth, d, 5000 * d * d, 8e9 * d * d, pipe, 0.04 * pipe),
       ""},
      (pipe + d) / 2,
      axis,
      r.of(2) == 0};
  const std::string chain = line("chain", "c", std::hypot(far, depth) * r.in(1.01, 1.06), far / 200,
                                 anchored({0, 0, -5}), anchored({far, 0, -depth}));
  const std::string pipeline = line("pipe", "p", 100, 2, anchored(place - half), anchored(place + half),
                                    r.of(2) ? ", start: straight" : "");
  c.set.lines = c.pipe_first ? pipeline + chain : chain + pipeline;
  return c;
}

struct AtRest {
  std::vector<double> tension;
  std::vector<Vec3> x;
  double force = 0;
};

AtRest at_rest(const std::string& text, const std::string& name) {
  Simulation sim(PETSC_COMM_SELF, io::read_case_text(text, name + ".yaml"));
  sim.solve_statics();
  AtRest out{std::vector<double>(sim.state().x.size(), 0), sim.state().x,
             sim.line_pairs() ? sim.line_pairs()->normal_force() : 0};
  const FieldRegistry fields = sim.system().fields();
  for (const FieldSource& f : fields.sources())
    if (f.name == "effective_tension") f.fill(sim.state().at_rest(), out.tension);
  return out;
}

void expect_untouched(const Set& s, unsigned seed) {
  SCOPED_TRACE(fmt::format("{} {}", s.name, seed));
  const AtRest with = at_rest(s.text(""), s.name);
  const AtRest without = at_rest(s.text("contact: {between_lines: false}\n"), s.name);
  double off = 0, most = 0;
  for (size_t n = 0; n < with.tension.size(); ++n) {
    off = std::max(off, std::abs(with.tension[n] - without.tension[n]));
    most = std::max(most, without.tension[n]);
  }
  EXPECT_LT(off, 1e-3 * most);
}

void expect_over(const Crossing& c, unsigned seed) {
  SCOPED_TRACE(fmt::format("crossing {}", seed));
  const AtRest r = at_rest(c.set.text(""), "crossing");
  const size_t first = c.pipe_first ? 51 : 0;
  // Where the chain crosses the middle of the pipe.
  const Vec3 pipe = r.x[(c.pipe_first ? 0 : r.x.size() - 51) + 25];
  for (size_t n = first + 1; n < first + r.x.size() - 51; ++n) {
    if (!(r.x[n - 1].x() <= pipe.x() && r.x[n].x() > pipe.x())) continue;
    const double t = (pipe.x() - r.x[n - 1].x()) / (r.x[n].x() - r.x[n - 1].x());
    const double z = r.x[n - 1].z() + t * (r.x[n].z() - r.x[n - 1].z());
    EXPECT_GT(z - pipe.z(), 0.9 * c.radii);
    EXPECT_LT(pipe.z() - c.under, 0.05 * c.radii);  // not lifted
    // If the chain is not above the pipe, it presses on it.
    if (z - pipe.z() < 0.99 * c.radii) {
      EXPECT_GT(r.force, 0);
    }
  }
}

TEST(SharedAndCrossing, AtRandom) {
  const unsigned sets = std::getenv("HAWSER_FULL") ? 100 : 10;
  for (unsigned seed = 0; seed < sets; ++seed) {
    Random r(seed + 1);
    try {
      switch (seed % 5) {
        case 0:
        case 1:
          expect_untouched(legs(r), seed);
          break;
        case 2:
          expect_untouched(loop(r), seed);
          break;
        case 3:
          expect_untouched(joint(r), seed);
          break;
        default:
          expect_over(crossing(r), seed);
      }
    } catch (const std::exception& e) {
      ADD_FAILURE() << seed << ": " << e.what();
    }
  }
}

}  // namespace
}  // namespace hawser::test::shared_and_crossing
