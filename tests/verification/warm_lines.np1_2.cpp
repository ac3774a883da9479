// Lines warmer or colder than when they were cut to length, from case files to results files. (On the bed:
// seabed_laid.)
#include <fmt/format.h>

#include "../regression/runs.hpp"
#include "hawser/kernels/response_curve.hpp"

namespace hawser::test::warm_lines_test {
namespace {

using runs::Edits;

runs::Results run(const std::string& name, const std::string& text, const Edits& edits) {
  const std::string base = runs::folder("warm_lines") + "/" + name;
  runs::write_case(base + ".yaml", text, edits);
  runs::run_on_all({base + ".yaml", base + ".h5"});
  return runs::read(base + ".h5");
}

// Values of the last output.
std::vector<double> last(const runs::Results& r, const std::string& field) {
  const auto& all = r.fields.at(field);
  return {all.end() - static_cast<std::ptrdiff_t>(all.size() / r.output_times.size()), all.end()};
}

const std::string kBar = R"(hawser: 1
environment: {gravity: 0}
line_types:
  bar: {outer_diameter: 0.5, mass_per_length: 100, EA: STIFF, BENDING, thermal_expansion: 2e-5}
  rest: {outer_diameter: 0.5, mass_per_length: 100, EA: 2e8, BENDING}
lines:
  bar:
    sections: [{type: bar, length: 30, elements: 12}, {type: rest, length: 10, elements: 4}]
    end_a: {anchor: [0, 0, 0], direction: [1, 0, 0]}
    end_b: {anchor: [40, 0, 0]}
    start: straight
    temperature_change: WARMER
)";
const char* const kBeam = "EI: 1e9, GJ: 1e9";

// Between two fixed points the force is uniform and the total elongation is zero: integral of T/EA + alpha dT
// = 0. Beams, heated; cables, cooled; by a table; a profile along the line.
TEST(WarmLines, BetweenFixedPoints) {
  struct Row {
    const char *name, *stiff, *bending, *warmer;
    double force, at_15;  // N; m, displacement of the node at 15 m towards end B
  };
  const double alpha = 2e-5;
  const double EA = 1e8;
  const double rest = 2e8;
  const double flexible = 30 / EA + 10 / rest;
  const double even = -alpha * 50 * 30 / flexible;
  // 20 K at 5 m, 100 K from 25 m on: 5 m at 20 K, 20 m at 60 K on average, 5 m at 100 K up to 30 m.
  const double sum = 5 * 20 + 20 * 60 + 5 * 100;
  const double profile = -alpha * sum / flexible;
  const double to_15 = alpha * (5 * 20 + 10 * 40);
  const ResponseCurve table(std::vector<ResponseCurve::Row>{{-1, -1e8}, {1e-3, 1e5}, {2e-3, 1.5e5}}, false);
  // Strain relative to that without tension.
  double low = 0;
  double high = alpha * 400;
  while (high - low > 1e-15) {
    const double e = 0.5 * (low + high);
    (30 * (e - alpha * 400) + 10 * table.at(e).force / rest > 0 ? high : low) = e;
  }
  const double cold = table.at(low).force;
  for (const Row& r : {Row{"beam", "1e8", kBeam, "50", even, 15 * (even / EA + alpha * 50)},
                       {"cable", "1e8", "bending: false", "-50 degC", -even, -15 * (even / EA + alpha * 50)},
                       {"profile", "1e8", kBeam, "[[5, 20], [25, 100]]", profile, 15 * profile / EA + to_15},
                       {"table", "{table: [[-1, -1e8], [1e-3, 1e5], [2e-3, 1.5e5]]}", "bending: false",
                        "-400", cold, 15 * (low - alpha * 400)}}) {
    const runs::Results s =
        run(r.name, kBar,
            {{"STIFF", r.stiff}, {"BENDING", r.bending}, {"BENDING", r.bending}, {"WARMER", r.warmer}});
    const auto tension = last(s, "effective_tension");
    const auto x = last(s, "position");
    if (runs::rank_of(MPI_COMM_WORLD) == 0)
      printf("  %s: force %+.1e of %.1f kN\n", r.name, tension[3] / r.force - 1, r.force / 1e3);
    for (const double T : tension) EXPECT_NEAR(T, r.force, 1e-7 * std::abs(r.force)) << r.name;
    EXPECT_NEAR(x[3 * 6] - 15, r.at_15, 1e-9) << r.name;
  }
}

// A heated beam with one free end, and a cooled cable between fixed ends, start at their cold length and
// oscillate: the total energy is constant at the initial strain energy, of EA (alpha dT)² L/2 for the beam.
TEST(WarmLines, ReleasedTheySwing) {
  for (const char* bending : {kBeam, "bending: false"}) {
    const bool beam = bending == kBeam;
    const runs::Results s =
        run("swing", kBar + "statics: false\ndynamics: {duration: 0.05, step: 1e-4, rho_infinity: 1}\n",
            {{"STIFF", "1e8"},
             {"BENDING", bending},
             {"BENDING", bending},
             {"WARMER", beam ? "50" : "-50"},
             {"end_b: {anchor: [40, 0, 0]}", beam ? "end_b: free" : "end_b: {anchor: [40.01, 0, 0]}"}});
    const double strain = 2e-5 * 50 + (beam ? 0 : 0.01 / 40);
    const double there = 0.5 * 1e8 * strain * strain * 30 + (beam ? 0 : 0.5 * 2e8 * 6.25e-8 * 10);
    const auto kinetic = s.column("energy", 0);
    const auto strained = s.column("energy", 1);
    EXPECT_NEAR(strained[0] + kinetic[0], there, 1e-9 * there);
    double most = 0, worst = 0;
    for (size_t i = 0; i < kinetic.size(); ++i) {
      most = std::max(most, kinetic[i]);
      worst = std::max(worst, std::abs(kinetic[i] + strained[i] - there));
      EXPECT_NEAR(kinetic[i] + strained[i], there, 1e-9 * there) << i;
    }
    if (runs::rank_of(MPI_COMM_WORLD) == 0)
      printf("  %s: energy off by %.1e of %.2f kJ, %.0f %% of it of motion at most\n",
             beam ? "beam" : "cable", worst / there, there / 1e3, 100 * most / there);
    EXPECT_GT(most, (beam ? 0.8 : 0.02) * there);
  }
}

// A chain from an anchor to a ship that is 0.2 % longer by its temperature has the shape of a chain made 0.2
// % longer with the same total weight; start shapes are equal, too.
TEST(WarmLines, AMooringIsALongerOne) {
  const std::string text = R"(hawser: 1
environment: {water: {depth: 200}, seabed: {depth: 200, friction: 0.6}}
line_types: {chain: {outer_diameter: 1e-3, contact_diameter: 0.216, mass_per_length: MASS, EA: STIFF, bending: false, Cd_normal: 0, Ca_normal: 0, thermal_expansion: 1e-5}}
lines:
  chain:
    sections: [{type: chain, length: LENGTH, elements: 170}]
    end_a: {anchor: [0, 0, -200]}
    end_b: {anchor: [AWAY, 0, -14]}
    temperature_change: WARMER
)";
  for (const char* away : {"760", "800"}) {  // a fifth lies on the bed; hardly any
    const Edits all{{"AWAY", away}};
    const auto with = [&](const Edits& edits) {
      Edits e = edits;
      e.insert(e.end(), all.begin(), all.end());
      return run("mooring", text, e);
    };
    const Edits made{{"MASS", "250"}, {"STIFF", "1e9"}, {"LENGTH", "850"}};
    const auto by = [&](const char* kelvin) {
      Edits e = made;
      e.emplace_back("WARMER", kelvin);
      return with(e);
    };
    const runs::Results warm = by("200");
    const runs::Results cold = by("0");
    const runs::Results longer =
        with({{"MASS", "249.500998003992"}, {"STIFF", "1.002e9"}, {"LENGTH", "851.7"}, {"WARMER", "0"}});
    const double T = last(warm, "effective_tension").back();
    const double T0 = last(longer, "effective_tension").back();
    const double Tc = last(cold, "effective_tension").back();
    const double apart = runs::largest_difference(last(warm, "position"), last(longer, "position"));
    if (runs::rank_of(MPI_COMM_WORLD) == 0)
      printf("  ends %s m apart: %.4f kN, %+.1e; cold %.1f kN; places %.1e m\n", away, T / 1e3, T / T0 - 1,
             Tc / 1e3, apart);
    EXPECT_NEAR(T, T0, 1e-5 * T0);
    EXPECT_GT(Tc, 1.005 * T);
    EXPECT_LT(apart, 1e-3);
  }
}

// Start shapes of all kinds are those of the longer line: 30 m are cold, the rest is 0.2 % longer.
TEST(WarmLines, StartShapesAreLonger) {
  const std::string text = R"(hawser: 1
environment: {water: {depth: 200}, seabed: {depth: 200, friction: 0.6}, current: {speed: 1}}
line_types:
  cold: {outer_diameter: THICK, mass_per_length: 250, EA: 1e9, bending: false}
  warm: {outer_diameter: THICK, displaced_diameter: DISPLACED, mass_per_length: MASS, EA: STIFF, bending: false, Cd_normal: DRAG, Cd_axial: 0, thermal_expansion: 1e-5}
lines:
  chain:
    sections: [{type: cold, length: 30, elements: 6}, {type: warm, length: LENGTH, elements: 164}]
    end_a: {anchor: END_A}
    end_b: END_B
    start: START
    buried: BURIED
    temperature_change: WARMER
statics: false
dynamics: {duration: 1e-3, step: 1e-3}
)";
  struct Row {
    const char *name, *thick, *end_a, *end_b, *start, *buried;
    double within = 1e-6;  // m
  };
  const char* none = "[]";
  for (const Row& r :
       {Row{"from the bed", "0.2", "[0, 0, -199.9]", "{anchor: [780, 0, -14]}", "auto", none},
        Row{"hanging free", "0.2", "[0, 0, 900]", "free", "hanging", none},
        Row{"slack on the bed", "0.2", "[0, 0, -199.9]", "{anchor: [700, 0, -199.9]}", "auto", none},
        Row{"afloat", "0.6", "[0, 0, 0]", "{anchor: [700, 0, 0]}", "auto", none},
        Row{"in a current", "0.55", "[0, 0, -50]", "free", "auto", none,
            0.3},  // the start shape does not iterate the drag
        Row{"out of the soil", "0.2", "[-20, 0, -210]", "{anchor: [760, 0, -14]}", "auto",
            "[{to: 25, resistance: {axial: 10 kN/m, normal: 50 kN/m}}]"}}) {
    const auto start = [&](double e, const char* kelvin) {
      const double thick = std::stod(r.thick);
      const runs::Results s = run("start", text,
                                  {{"THICK", r.thick},
                                   {"THICK", r.thick},
                                   {"DISPLACED", fmt::format("{:.17g}", thick / std::sqrt(1 + e))},
                                   {"DRAG", fmt::format("{:.17g}", 1 / (1 + e))},
                                   {"MASS", fmt::format("{:.17g}", 250 / (1 + e))},
                                   {"STIFF", fmt::format("{:.17g}", 1e9 * (1 + e))},
                                   {"LENGTH", fmt::format("{:.17g}", 820 * (1 + e))},
                                   {"END_A", r.end_a},
                                   {"END_B", r.end_b},
                                   {"START", r.start},
                                   {"BURIED", r.buried},
                                   {"WARMER", kelvin}});
      const auto& x = s.fields.at("position");
      return std::vector<double>(x.begin(), x.begin() + 3 * 171);
    };
    const auto warm = start(0, "[[0, 0], [29.9, 0], [30, 200]]");
    const auto longer = start(2e-3, "0");
    const auto cold = start(0, "0");
    const double apart = runs::largest_difference(warm, longer);
    if (runs::rank_of(MPI_COMM_WORLD) == 0)
      printf("  %s: %.1e m apart, %.1e m from the cold one\n", r.name, apart,
             runs::largest_difference(warm, cold));
    EXPECT_LT(apart, r.within) << r.name;
    EXPECT_GT(runs::largest_difference(warm, cold), std::max(0.1, 3 * r.within)) << r.name;
  }
}

}  // namespace
}  // namespace hawser::test::warm_lines_test
