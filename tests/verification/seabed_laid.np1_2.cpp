// Lines laid on the seabed over their whole length, from case files to results files: friction holds them in
// statics.
#include "../regression/runs.hpp"

namespace hawser::test::seabed_laid {
namespace {

using runs::Edits;

// A pipe of 100 kg/m along x on soil of 1e6 N/m², friction 0.5 mobilised at 5 mm.
std::string pipe(const Edits& edits) {
  std::string text = R"(hawser: 1
environment: {gravity: 10, seabed: {depth: 50, normal_stiffness: {per_length: 1e6}, friction: FRICTION}}
line_types:
  pipe: {outer_diameter: 0.1, mass_per_length: 100, EA: 5e8, BENDING}
lines:
  pipe:
    sections: [{type: pipe, length: LENGTH, elements: ELEMENTS}]
    end_a: END_A
    end_b: free
    start: START
    loads: [{at: end_b, force: [FORCE, 0, 0]}]
    temperature_change: WARMER
)";
  Edits all = edits;
  for (const auto& [from, to] : Edits{{"FRICTION", "{axial: 0.5, lateral: 0.5, mobilisation_length: 5 mm}"},
                                      {"BENDING", "bending: false"},
                                      {"LENGTH", "1200"},
                                      {"ELEMENTS", "1200"},
                                      {"END_A", "free"},
                                      {"START", "{points: [[0, 0, -49.951], [1200, 0, -49.951]]}"},
                                      {"FORCE", "0"},
                                      {"WARMER", "0"}})
    all.emplace_back(from, to);
  for (const auto& [from, to] : all)
    if (const size_t at = text.find(from); at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

struct Shown {
  std::vector<double> position, tension;
  size_t nodes() const { return tension.size(); }
  double x(size_t n) const { return position[3 * n]; }
};
Shown run(const std::string& name, const std::string& text) {
  const std::string base = runs::folder("seabed_laid") + "/" + name;
  runs::write_case(base + ".yaml", text);
  run::RunOptions options;
  options.case_path = base + ".yaml";
  options.quiet = true;
  EXPECT_EQ(run::run(MPI_COMM_WORLD, options), 0) << name;
  MPI_Barrier(MPI_COMM_WORLD);
  const io::h5::Id file = io::h5::open_read(base + ".h5");
  return {io::h5::read_array(file, "fields/position").values,
          io::h5::read_array(file, "fields/effective_tension").values};
}

// Pulled at one end, the other held or free: elastic up to F = sqrt(EA tau d), above that a part slips.
// Closed form, with the axis or the underside given on the bed.
TEST(SeabedLaid, PullOut) {
  struct Row {
    const char* force;
    double u, tension;  // m; N, 50 m from the end
  };
  for (const Row& r : {Row{"17677.66953", 0.0025, 8716.305381908778},
                       {"35355.33906", 0.005, 17432.610763817556},
                       {"50000", 0.0075, 26378.682326731465},
                       {"100000", 0.0225, 75000},
                       {"200000", 0.0825, 175000},
                       {"400000", 0.3225, 375000}})
    for (const auto& [a, start] : {std::pair{"free", "{points: [[0, 0, -49.951], [1200, 0, -49.951]]}"},
                                   {"{anchor: [0, 0, -50], direction: [1, 0, 0]}", "straight"}}) {
      const Shown s = run("pull", pipe({{"FORCE", r.force}, {"END_A", a}, {"START", start}}));
      ASSERT_EQ(s.nodes(), 1201U);
      const double u = s.x(1200) - 1200;
      const double tension = s.tension[1150];
      if (runs::rank_of(MPI_COMM_WORLD) == 0)
        printf("  F %s N, end A %s: u %+.4f %%, tension %+.4f %%\n", r.force, a[0] == 'f' ? "free" : "held",
               100 * (u / r.u - 1), 100 * (tension / r.tension - 1));
      EXPECT_NEAR(u, r.u, 5e-3 * r.u) << r.force;
      EXPECT_NEAR(tension, r.tension, 5e-3 * r.tension) << r.force;
    }
}

// A beam laid without tension, both ends free, heated by 60 K. Closed form: displacement of the ends, force
// in the middle, and the slipping length of each half, where the displacement exceeds the mobilisation
// length.
TEST(SeabedLaid, Heating) {
  struct Row {
    const char* length;
    double end, middle, slips;  // m; N; m
  };
  for (const Row& r : {Row{"600", 0.1656248683617732, -146944.69911537858, 287.80890488030343},
                       {"2000", 0.2489017043064301, -350615.49150208966, 631.2851402664203},
                       {"4000", 0.2489020, -350999.99972262495, 631.2893218813451}}) {
    const std::string l = r.length;
    const double length = std::stod(l);
    const double element = 2;
    const Shown s = run("heat", pipe({{"BENDING", "EI: 1e7, GJ: 1e7, thermal_expansion: 1.17e-5"},
                                      {"LENGTH", l},
                                      {"ELEMENTS", std::to_string(std::stoi(l) / 2)},
                                      {"START", "{points: [[0, 0, -49.951], [" + l + ", 0, -49.951]]}"},
                                      {"WARMER", "60 K"}}));
    const double end = s.x(s.nodes() - 1) - length;
    const double middle = s.tension[s.nodes() / 2];
    const auto moved = [&](size_t n) { return s.x(n) - element * static_cast<double>(n); };
    size_t n = s.nodes() - 1;
    while (moved(n - 1) > 0.005) --n;
    const double slips =
        length - element * (static_cast<double>(n) - (moved(n) - 0.005) / (moved(n) - moved(n - 1)));
    if (runs::rank_of(MPI_COMM_WORLD) == 0)
      printf("  %s m: end %+.3f %%, force in the middle %+.3f %%, length that slips %+.3f %%\n", r.length,
             100 * (end / r.end - 1), 100 * (middle / r.middle - 1), 100 * (slips / r.slips - 1));
    EXPECT_NEAR(end, r.end, 5e-3 * r.end);
    EXPECT_NEAR(middle, r.middle, -5e-3 * r.middle);
    EXPECT_NEAR(slips, r.slips, 5e-3 * r.slips);
    EXPECT_NEAR(s.x(0), -end, 1e-6);
  }
}

// A current across exerts 0.5*1025*1.2*0.1*0.25 N/m; friction of the submerged chain exceeds this and holds
// it. The chain has no tension, and its elements tighten and slacken in turn during statics. With
// `friction_in_statics: none` and no given start shape there is no friction.
TEST(SeabedLaid, ACurrentAcross) {
  const Edits sea{
      {"gravity: 10", "gravity: 10, water: {depth: 50}, current: {speed: 0.5, direction_deg: 90}"},
      {"START", "{points: [[0, 0, -50], [1200, 0, -50]]}"},
      {"END_A", "{anchor: [0, 0, -50]}"}};
  const Shown s = run("current", pipe(sea));
  const double drag = 0.5 * 1025 * 1.2 * 0.1 * 0.25, pressed = 1000 - 1025 * 10 * M_PI / 4 * 0.01;
  for (size_t n = 20; n < s.nodes(); ++n) {
    EXPECT_NEAR(s.position[3 * n + 1], 0.005 * drag / (0.5 * pressed), 1e-6) << n;
  }
  const Shown held =
      run("no_friction", pipe({{"friction: FRICTION", "friction_in_statics: none, friction: FRICTION"},
                               {"FORCE", "1e5"},
                               {"END_A", "{anchor: [0, 0, -50]}"}}));
  EXPECT_NEAR(held.x(1200) - 1200, 1e5 * 1200 / 5e8, 1e-3);
}

}  // namespace
}  // namespace hawser::test::seabed_laid
