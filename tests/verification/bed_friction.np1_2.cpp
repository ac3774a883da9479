// Statics of lines on a seabed with friction: anchor loads against Coulomb's balance along the bed, and
// tensions of random legs against the independent solver of support/leg_on_bed.hpp.
#include <fmt/format.h>

#include <cstdlib>
#include <random>

#include "../regression/runs.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/run/simulation.hpp"
#include "support/leg_on_bed.hpp"

namespace hawser::test::bed_friction {
namespace {

struct Shown {
  int exit = -1;
  std::vector<double> position, tension, force, friction;
  size_t nodes() const { return tension.size(); }
};

std::string base_of(const std::string& name) { return runs::folder("bed_friction") + "/" + name; }

Shown run(const std::string& name, const std::string& text) {
  const std::string base = base_of(name);
  runs::write_case(base + ".yaml", text);
  run::RunOptions options;
  options.case_path = base + ".yaml";
  options.quiet = true;
  Shown s;
  try {
    s.exit = run::run(MPI_COMM_WORLD, options);
  } catch (const std::exception& e) {
    if (runs::rank_of(MPI_COMM_WORLD) == 0) printf("  %s: %s\n", name.c_str(), e.what());
    return s;
  }
  MPI_Barrier(MPI_COMM_WORLD);
  const io::h5::Id file = io::h5::open_read(base + ".h5");
  const auto field = [&](const char* of) { return io::h5::read_array(file, of).values; };
  s.position = field("fields/position");
  s.tension = field("fields/effective_tension");
  s.force = field("fields/seabed_force");
  s.friction = field("fields/seabed_friction");
  MPI_Barrier(MPI_COMM_WORLD);
  return s;
}

double norm(const std::vector<double>& v, size_t n) {
  return std::hypot(v[3 * n], v[3 * n + 1], v[3 * n + 2]);
}

// Largest ratio of friction to normal force among the nodes whose normal force is above `least` [N].
double friction_over_normal(const Shown& s, double least) {
  double most = 0;
  for (size_t n = 0; n < s.nodes(); ++n) {
    const double force = norm(s.force, n);
    const double friction = norm(s.friction, n);
    const double normal = std::sqrt(std::max(0.0, force * force - friction * friction));
    if (normal > least) most = std::max(most, friction / normal);
  }
  return most;
}

// 500 m of studless R3 chain of 84 mm in 100 m of water, 480 m between its ends, friction 0.6. By Coulomb's
// balance the anchor load is the fairlead load less 0.6 of the normal force of the bed.
std::string chain(const std::string& bed, const std::string& lines) {
  return "hawser: 1\nenvironment: {water: {depth: 100}, seabed: {depth: 100, friction: 0.6" + bed +
         "}}\nline_types:\n  chain: {library: chain-studless, diameter: 84 mm, grade: R3}\n"
         "contact: {between_lines: false}\n" +
         lines;
}
std::string one_leg(const std::string& anchor, const std::string& more = "") {
  return "lines:\n  chain: {sections: [{type: chain, length: 500, elements: 250}], end_a: {anchor: [0, 0, "
         "-10]}, "
         "end_b: {anchor: [480, 0, " +
         anchor + "]}" + more + "}\n";
}

TEST(BedFriction, AnchorLoads) {
  struct Row {
    const char* name;
    std::string text;
    double right;  // N
  };
  const std::string full = ", friction_in_statics: full";
  const std::string joined =
      "joints: {conn: {start: [400, 0, -99.86]}}\nlines:\n"
      "  upper: {sections: [{type: chain, length: 420, elements: 210}], end_a: {anchor: [0, 0, -10]}, end_b: "
      "{joint: "
      "conn}}\n"
      "  ground: {sections: [{type: chain, length: 80, elements: 40}], end_a: {joint: conn}, end_b: {anchor: "
      "[480, 0, "
      "-100]}}\n";
  for (const Row& r : std::vector<Row>{
           {"padeye", chain(full, one_leg("-99.8")), 273.6e3},
           {"padeye_as_laid", chain("", one_leg("-99.8")), 273.6e3},
           {"on_bed", chain("", one_leg("-100")), 270.6e3},
           {"joint", chain("", joined), 270.6e3},
           {"buoy", chain(full, one_leg("-100", ", masses: [{at: 460, mass: 100, volume: 1.6}]")),
            279.7e3}}) {
    const Shown s = run(r.name, r.text);
    ASSERT_EQ(s.exit, 0) << r.name;
    EXPECT_NEAR(s.tension.back(), r.right, 0.01 * r.right) << r.name;
    EXPECT_LE(friction_over_normal(s, 10), 0.6 * 1.001) << r.name;
    // Statics does not move an end.
    EXPECT_EQ(s.position[3 * (s.nodes() - 1)], 480) << r.name;
  }
}

// The anchor load is a continuous function of the padeye height from 1 m under the bed to 1 m above it: it
// changes by less than 2.7 % from one height to the next.
TEST(BedFriction, HeightOfThePadeye) {
  double last = 0;
  for (const double z :
       {-101.0, -100.5, -100.1, -100.0, -99.95, -99.9, -99.86, -99.85, -99.8, -99.5, -99.0}) {
    const Shown s = run("height", chain("", one_leg(fmt::format("{}", z))));
    ASSERT_EQ(s.exit, 0) << z;
    EXPECT_EQ(s.position.back(), z);
    // Up to 21 m of chain hang between the padeye and the bed.
    if (last > 0) {
      EXPECT_NEAR(s.tension.back(), last, 0.027 * last) << z;
    }
    last = s.tension.back();
  }
}

// Friction holds a slack chain on a bed of 10 degrees. H and V at the top are those of a quasi-static
// program.
TEST(BedFriction, SlackChainOnASlope) {
  const Shown s = run("slope", R"(hawser: 1
environment: {water: {depth: 400}, seabed: {depth: 100, slope_deg: 10, slope_direction_deg: 0, friction: 0.5}}
line_types: {c: {outer_diameter: 0.1, mass_per_length: 60, EA: 250 MN, bending: false}}
contact: {between_lines: false}
lines:
  m: {sections: [{type: c, length: 230, element_length: 2}], end_a: {anchor: [150, 0, -126.449047106]}, end_b: {anchor: [0, 0, -10]}}
)");
  ASSERT_EQ(s.exit, 0);
  EXPECT_NEAR(s.tension.back(), std::hypot(3207, 50830), 0.01 * 50930);
  EXPECT_LT(s.tension.front(), 100);
}

// Friction holds a chain on soft level ground: the anchor tension is below 0.5 % of the fairlead tension.
TEST(BedFriction, HeldBeforeTheAnchor) {
  const Shown s = run("held", R"(hawser: 1
environment: {water: {depth: 100}, seabed: {depth: 100, friction: 0.5}}
line_types: {c: {outer_diameter: 0.15, mass_per_length: 140, EA: 600 MN, bending: false}}
contact: {between_lines: false}
lines:
  m: {sections: [{type: c, length: 830, element_length: 5}], end_a: {anchor: [800, 0, -99.925]}, end_b: {anchor: [0, 0, -10]}}
)");
  ASSERT_EQ(s.exit, 0);
  EXPECT_LT(s.tension.front(), 0.005 * s.tension.back());
}

// Taut leg from an anchor on the bed. By hand: T = EA (distance of the ends - length)/length. If statics
// moved the anchor by half a diameter, T would change by two fifths.
TEST(BedFriction, ATautLegIsHeldWhereItsEndsAre) {
  const double length = std::hypot(60, 60) * (1 - 79.1e3 / 100e6);
  const Shown s = run("taut", fmt::format(R"(hawser: 1
environment: {{gravity: 0, water: {{depth: 60}}, seabed: {{depth: 60}}}}
line_types: {{r: {{outer_diameter: 0.12, mass_per_length: 11.6, EA: 100 MN, bending: false}}}}
lines:
  r: {{sections: [{{type: r, length: {:.9f}, elements: 20}}], end_a: {{anchor: [0, 0, 0]}}, end_b: {{anchor: [60, 0, -60]}}}}
)",
                                          length));
  ASSERT_EQ(s.exit, 0);
  const double right = 100e6 * (std::hypot(60, 60) / length - 1);
  EXPECT_NEAR(s.tension.back(), right, 0.01 * right);
}

// Largest tension [N] at the anchor when friction is mobilised over d [m] and rigid friction would leave
// none. EA u'' = mu w min(u/d, 1), l² = EA d/(mu w): beyond the point where rigid friction has reduced the
// tension to zero, the tension is mu w l/sinh(x) with coth(x) = x.
double left_by_mobilisation(const LegOnBed& leg, double d) {
  return 0.66 * std::sqrt(leg.EA * leg.friction * leg.weight * d);
}

// The same line in air on a bed at z = 0 and on one at z = 3 m.
TEST(BedFriction, ABedAboveZero) {
  const double w = 60 * 9.80665;
  const double rest = 0.05 - w / (1e6 * 0.1);
  const LegOnBed leg{.length = 60, .weight = w, .EA = 250e6, .friction = 0.5, .x = 50, .z = 20 - rest};
  const std::optional<LegLoads> own = LegSolver(leg).solve();
  ASSERT_TRUE(own);
  for (const double height : {0.0, 3.0}) {
    const Shown s = run("above", fmt::format(R"(hawser: 1
environment: {{seabed: {{depth: {}, normal_stiffness: {{per_area: 1 MN/m3}}, friction: {{axial: 0.5, lateral: 0.5, mobilisation_length: 0.1 mm}}}}}}
line_types: {{c: {{outer_diameter: 0.1, mass_per_length: 60, EA: 250 MN, bending: false}}}}
contact: {{between_lines: false}}
lines:
  m: {{sections: [{{type: c, length: 60, elements: 120}}], end_a: {{anchor: [0, 0, {}]}}, end_b: {{anchor: [50, 0, {}]}}}}
)",
                                             0 - height, height, height + 20));
    ASSERT_EQ(s.exit, 0) << height;
    EXPECT_NEAR(s.tension.back(), own->fairlead, 0.01 * own->fairlead) << height;
    EXPECT_NEAR(s.tension.front(), own->anchor, 0.01 * own->fairlead + left_by_mobilisation(leg, 1e-4))
        << height;
  }
}

struct Leg {
  std::string text;
  LegOnBed own;
  // The leg for an anchor below the bed when the part on the bed is shorter than `moves_aside`: all of it
  // lies on the lowered, steeper bed beside the anchor.
  LegOnBed beside_anchor;
  double moves_aside = 0;                 // m from the anchor over which the bed is lowered
  double friction = 0, mobilisation = 0;  // m; 0: full friction
};

// Random legs: chains of 60 to 120 mm in 40 to 150 m of water; slopes up to 10 degrees, on which friction
// holds the chain; padeyes from 1 m below the bed to 3 m above it; slack to nearly lifted; in one piece, with
// a joint or a buoy on the bed, or on a gridded bed; friction as laid with a short mobilisation length, or
// full.
Leg random_leg(int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const auto pick = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  constexpr double kGravity = 9.80665;
  constexpr double kDensity = 1025;
  const double d = std::vector<double>{0.06, 0.08, 0.1, 0.12}[static_cast<size_t>(pick(4))];
  const double outer = 1.8 * d;
  const double mass = 20000 * d * d;
  const double w = (mass - kDensity * M_PI / 4 * outer * outer) * kGravity;
  const double EA = 0.854e11 * d * d;
  const double slope = uniform(-10, 10) * M_PI / 180;
  const double mu = std::max(uniform(0.3, 1), 1.3 * std::abs(std::tan(slope)) + 0.05);
  const double depth = uniform(40, 150);
  const double heights[] = {-std::min(uniform(0, 1), 0.025 * depth), 0, uniform(0, 0.5), uniform(0.5, 3)};
  const double padeye = heights[pick(4)];
  const bool full = uniform(0, 1) < 0.4;
  const int kind = pick(5);  // plain, joint, buoy, grid, plain
  const double rest = 0.5 * outer - w / (1e6 * outer);
  const double fairlead = -uniform(5, 15);
  const double length = uniform(3, 7) * depth;
  const double height = depth + fairlead - rest;
  const double slackest = length - 0.98 * height;
  const double tautest = 0.998 * std::sqrt(length * length - height * height);
  const double away = (slackest + uniform(0.03, 0.9) * (tautest - slackest)) * std::cos(slope);
  const double bed = -depth - away * std::tan(slope);
  const double azimuth = uniform(-M_PI, M_PI);
  const double down = slope >= 0 ? azimuth : azimuth + M_PI;
  const int elements = std::max(60, static_cast<int>(length));
  Leg out;
  out.friction = mu;
  out.mobilisation = full ? 0 : 1e-4;
  LegOnBed& own = out.own;
  own = {length, w, EA, mu, slope, 0, away, fairlead - (bed + rest), 0, 0};
  if (padeye > rest) own.padeye = padeye - rest;
  const double under = std::max(0.0, rest - padeye);
  // An end under the bed: the leg starts at the nearest point of the bed.
  own.x += under * std::sin(slope) * std::cos(slope);
  own.z += under * std::pow(std::sin(slope), 2);
  out.moves_aside = std::min(under / 0.005, kind == 1 ? 0.25 * length : length);
  std::string more;
  if (kind == 2) {
    own.lift = uniform(2, 6) * w;
    own.lifted_from = 0.2 * length;
    more = fmt::format(", masses: [{{at: {}, mass: 50, volume: {}}}]", length - own.lifted_from,
                       (50 * kGravity + own.lift) / (kDensity * kGravity));
  }
  out.beside_anchor = own;
  if (under > 0) out.beside_anchor.slope += under / out.moves_aside;
  out.beside_anchor.x = away;
  out.beside_anchor.z = fairlead - (bed + padeye);
  std::string ground = fmt::format("depth: {}, slope_deg: {}, slope_direction_deg: {}", depth,
                                   std::abs(slope) * 180 / M_PI, down * 180 / M_PI);
  if (kind == 3) {
    const double steep = std::tan(std::abs(slope));
    if (runs::rank_of(MPI_COMM_WORLD) == 0) {
      std::ofstream grid(base_of("grid.xyz"));
      grid.precision(12);
      for (int i = -4; i <= 4; ++i)
        for (int j = -4; j <= 4; ++j)
          grid << 500 * i << ' ' << 500 * j << ' '
               << -depth - steep * 500 * (i * std::cos(down) + j * std::sin(down)) << '\n';
    } else {
      base_of("grid.xyz");
    }
    ground = "grid: {file: grid.xyz}";
  }
  const std::string anchor = fmt::format("{{anchor: [{}, {}, {}]}}", away * std::cos(azimuth),
                                         away * std::sin(azimuth), bed + padeye);
  std::string lines = fmt::format(
      "lines:\n  m: {{sections: [{{type: c, length: {}, elements: {}}}], end_a: {{anchor: [0, 0, {}]}}, "
      "end_b: {}{}}}\n",
      length, elements, fairlead, anchor, more);
  if (kind == 1) {
    const double lower = 0.25 * length;
    lines = fmt::format(
        "joints: {{j: {{start: [{}, {}, {}]}}}}\nlines:\n"
        "  u: {{sections: [{{type: c, length: {}, elements: {}}}], end_a: {{anchor: [0, 0, {}]}}, end_b: "
        "{{joint: j}}}}\n"
        "  m: {{sections: [{{type: c, length: {}, elements: {}}}], end_a: {{joint: j}}, end_b: {}}}\n",
        (away - lower * std::cos(slope)) * std::cos(azimuth),
        (away - lower * std::cos(slope)) * std::sin(azimuth), bed + rest + lower * std::sin(slope),
        length - lower, 3 * elements / 4, fairlead, lower, elements / 4, anchor);
  }
  out.text = fmt::format(
      "hawser: 1\nenvironment: {{water: {{depth: 1000}}, seabed: {{{}, normal_stiffness: {{per_area: 1 "
      "MN/m3}}, friction: {{axial: {}, lateral: {}, "
      "mobilisation_length: {}}}, friction_in_statics: {}}}}}\n"
      "line_types: {{c: {{outer_diameter: {}, mass_per_length: {}, EA: {}, bending: false}}}}\n"
      "contact: {{between_lines: false}}\n{}",
      ground, mu, mu, full ? "1 mm" : "0.1 mm", full ? "full" : "as_laid", outer, mass, EA, lines);
  return out;
}

TEST(BedFriction, RandomLegs) {
  const int legs = std::getenv("HAWSER_FULL") ? 300 : runs::size_of(MPI_COMM_WORLD) == 1 ? 8 : 2;
  int solved = 0;
  int tried = 0;
  for (int seed = 0; tried < legs; ++seed) {
    const Leg leg = random_leg(seed);
    std::optional<LegLoads> own = LegSolver(leg.own).solve();
    if (own && own->lying < leg.moves_aside) own = LegSolver(leg.beside_anchor).solve();
    // Compared are legs with at least 5 % of their length on the bed. A leg with a buoy must also have
    // tension at its anchor, because on a slack line the buoy rises.
    if (!own || own->lying < 0.05 * leg.own.length) continue;
    if (leg.own.lift > 0 && !(own->anchor > 5 * leg.own.lift)) continue;
    ++tried;
    const Shown s = run("leg", leg.text);
    if (s.exit != 0) continue;
    ++solved;
    EXPECT_NEAR(s.tension.front(), own->fairlead, 0.01 * own->fairlead) << "seed " << seed << "\n"
                                                                        << leg.text;
    EXPECT_NEAR(s.tension.back(), own->anchor,
                0.01 * std::max(own->anchor, own->fairlead) + left_by_mobilisation(leg.own, leg.mobilisation))
        << "seed " << seed << "\n"
        << leg.text;
    EXPECT_LE(friction_over_normal(s, 1e-3 * leg.own.weight), leg.friction * 1.001) << "seed " << seed;
  }
  if (runs::rank_of(MPI_COMM_WORLD) == 0) printf("  %d of %d legs solved\n", solved, tried);
  EXPECT_GE(solved, 0.98 * tried);
}

// A taut and a slack chain of 100 mm that spans a ridge or a trench of a gridded bed: friction stays within
// Coulomb's limit, and elements of half the length change the end tensions by less than 1 %.
TEST(BedFriction, RidgesAndTrenches) {
  if (ranks_of(MPI_COMM_WORLD) > 1 && !std::getenv("HAWSER_FULL")) GTEST_SKIP() << "long; set HAWSER_FULL";
  constexpr double kLength = 400;
  constexpr double kDepth = 80;
  constexpr double kWeight = (200 - 1025 * M_PI / 4 * 0.18 * 0.18) * 9.80665;
  for (const double height : {-3.0, 3.0}) {
    if (height > 0 && runs::size_of(MPI_COMM_WORLD) > 1 && !std::getenv("HAWSER_FULL")) continue;
    const std::string grid = base_of("hill.xyz");
    if (runs::rank_of(MPI_COMM_WORLD) == 0) {
      std::ofstream out(grid);
      for (int i = -10; i <= 60; ++i)
        for (int j = -2; j <= 2; ++j)
          out << 10 * i << ' ' << 100 * j << ' '
              << -kDepth + height * std::exp(-std::pow((10 * i - 260) / 20.0, 2)) << '\n';
    }
    MPI_Barrier(MPI_COMM_WORLD);
    for (const double away : {360.0, 385.0}) {
      double top[2] = {0, 0};
      double anchor[2] = {0, 0};
      for (const int fine : {0, 1}) {
        const Shown s = run("hill", fmt::format(R"(hawser: 1
environment: {{water: {{depth: 1000}}, seabed: {{grid: {{file: hill.xyz}}, normal_stiffness: {{per_area: 1 MN/m3}}, friction: 0.6}}}}
line_types: {{c: {{outer_diameter: 0.18, mass_per_length: 200, EA: 854 MN, bending: false}}}}
contact: {{between_lines: false}}
lines:
  m: {{sections: [{{type: c, length: {}, elements: {}}}], end_a: {{anchor: [0, 0, -10]}}, end_b: {{anchor: [{}, 0, {}]}}}}
)",
                                                kLength, fine ? 800 : 400, away, -kDepth));
        ASSERT_EQ(s.exit, 0) << height << " m, " << away << " m away";
        EXPECT_LE(friction_over_normal(s, 1e-3 * kWeight), 0.6 * 1.001) << height;
        top[fine] = s.tension.front();
        anchor[fine] = s.tension.back();
      }
      if (runs::rank_of(MPI_COMM_WORLD) == 0)
        printf("  %+.0f m, %.0f m away: %.2f and %.2f kN, at the anchor %.2f and %.2f kN\n", height, away,
               top[0] / 1e3, top[1] / 1e3, anchor[0] / 1e3, anchor[1] / 1e3);
      EXPECT_NEAR(top[0], top[1], 0.01 * top[1]) << height;
      EXPECT_NEAR(anchor[0], anchor[1], 0.01 * top[1]) << height;
    }
  }
}

// Statics of slack legs needs fewer than 220 Newton iterations and no dynamic relaxation.
TEST(BedFriction, SlackLegsComeToRestSoon) {
  for (const int seed : {0, 41, 58, 81, 121, 174, 292}) {
    const model::Case c = io::read_case_text(random_leg(seed).text, "leg.yaml", {}, MPI_COMM_WORLD);
    run::Simulation sim(MPI_COMM_WORLD, c);
    const StaticsReport report = sim.solve_statics();
    EXPECT_LT(report.iterations, 220) << "seed " << seed;
    EXPECT_EQ(report.relaxation_steps, 0) << "seed " << seed;
  }
}

}  // namespace
}  // namespace hawser::test::bed_friction
