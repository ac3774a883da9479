// Typical input errors, each in an otherwise valid case of tests/data/slips: each is refused or noted
// specifically, with at most two other notes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"

namespace hawser::slips_test {
namespace {

const std::vector<std::string> kModels = {"mooring", "taut",   "riser", "hose", "lay",
                                          "lift",    "vessel", "cable", "grid"};

std::string text_of(const std::string& model) {
  std::ifstream in(HAWSER_SOURCE_DIR "/tests/data/slips/" + model + ".yaml");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Writes heights of 96 to 116 m below x = 0 to 800 m; the height at (400, 0) is `there`.
void write_bed(const std::string& path, double there, double sign = 1, const std::string& before = "") {
  std::ofstream out(path, std::ios::binary);
  out << before;
  for (int x = -200; x <= 1000; x += 100)
    for (int y = -200; y <= 200; y += 100)
      out << x << ", " << y << ", " << (x == 400 && y == 0 ? there : sign * -(100 + 0.02 * x)) << "\n";
}

std::string folder() { return testing::TempDir(); }

// Notes of a case, or the sentence of its refusal.
std::vector<std::string> warnings_of(const std::string& model, const std::vector<std::string>& set) {
  try {
    return io::read_case_text(text_of(model), folder() + "/" + model + ".yaml", {}, MPI_COMM_SELF, set).notes;
  } catch (const InputError& e) {
    return {e.what()};
  }
}

struct Slip {
  std::string model, name;
  std::vector<std::string> set;
  std::string part;  // part of the sentence
};

const std::string kSection = "lines.mooring.sections[0].", kChain = "line_types.chain.",
                  kModule = "bodies.module.floating.", kHarmonic = "bodies.vessel.motion.harmonic.",
                  kPipe = "line_types.riser.pipe.", kHose = "line_types.hose.",
                  kJonswap = "environment.waves.jonswap.", kRao = "bodies.vessel.motion.rao.rows=";

const std::vector<Slip> kSlips = {
    // The sea
    {"mooring", "density in t/m3", {"environment.water.density=1.025"}, "is it in t/m^3? ('1.025 t/m^3')"},
    {"mooring", "density in lb/ft3", {"environment.water.density=64"}, "below the density of water"},
    {"mooring", "a seabed and no water", {"environment.water=null"}, "so the lines hang in air"},
    {"mooring", "gravity ten times", {"environment.gravity=98.0665"}, "above gravity on Earth"},
    {"mooring", "gravity in km/s2", {"environment.gravity=0.00980665"}, "below gravity on Earth"},
    {"mooring", "depth of the water in km", {"environment.water.depth=0.2"}, "but the water depth is 0.2 m"},
    {"mooring", "depth of the bed in mm", {"environment.seabed.depth=200000"}, "the depth of the oceans"},
    {"mooring", "a digit too many", {"environment.seabed.depth=2000"}, "no line reaches the seabed"},
    {"mooring", "z of the bed for its depth", {"environment.seabed.depth=-200"}, "below the seabed"},
    {"mooring", "current in cm/s", {"environment.current={speed: 80}"}, "is it in cm/s? ('80 cm/s')"},
    {"mooring", "current in mm/s", {"environment.current={speed: 500}"}, "above currents at sea"},
    {"taut", "current in cm/s in a profile", {"environment.current.profile[0].speed=100"}, "currents at sea"},
    {"taut", "direction in radians", {"environment.current.direction_deg=1.5708"}, "if radians are meant"},
    {"hose",
     "direction in radians, rounded",
     {"environment.current.direction_deg=3.14"},
     "if radians are meant"},
    {"taut",
     "profile upwards",
     {"environment.current.profile=[{depth: 900, speed: 0.2}, {depth: 0, speed: 1}]"},
     "depths must increase from row to row"},
    {"taut", "z in a profile", {"environment.current.profile[1].depth=-900"}, "out of range"},
    {"riser", "wave height in cm", {"environment.waves.regular.height=600"}, "heights of waves"},
    {"riser", "frequency for period", {"environment.waves.regular.period=0.09"}, "periods of waves"},
    {"riser",
     "height and period swapped",
     {"environment.waves.regular.height=11", "environment.waves.regular.period=4"},
     "would break"},
    {"vessel", "hs in cm", {kJonswap + "hs=400"}, "significant heights of seas"},
    {"vessel", "tp in ms", {kJonswap + "tp=10000"}, "peak periods of seas"},
    {"vessel", "peak frequency for tp", {kJonswap + "tp=0.1"}, "is it a frequency in Hz? ('10 s')"},
    {"vessel", "gamma of another sea", {kJonswap + "gamma=33"}, "gamma"},
    {"vessel", "wave direction in radians", {kJonswap + "direction_deg=3.1416"}, "if radians are meant"},
    {"riser", "waves in statics", {"dynamics=null", "output=null"}, "they act in dynamics only"},
    {"hose",
     "spectrum in rad/s read as Hz",
     {"environment.waves={spectrum: {rows: [[0.3, 0], [0.6, 4], [0.9, 1], [1.5, 0]]}}"},
     "which would break"},
    {"hose",
     "spectrum in Hz read as rad/s",
     {"environment.waves={spectrum: {frequency: rad_s, rows: [[0.05, 0], [0.1, 30], [0.15, 5], [0.3, 0]]}}"},
     "longer than any swell"},
    {"hose",
     "a tabulated sea of deeper water",
     {"environment.water.depth=20",
      "environment.waves={spectrum: {frequency: hz, rows: [[0.04, 0], [0.07, 600], [0.1, 0]]}}"},
     "times the water depth of 20 m: waves break"},
    {"hose", "ramp in ms", {"environment.current.ramp=20000"}, "longer than the run"},
    {"mooring",
     "stiffness of the soil in kN",
     {"environment.seabed.normal_stiffness={per_area: 100}"},
     "is it in kN? ('100 kN/m3')"},
    {"cable",
     "stiffness of the soil in kN, per length",
     {"environment.seabed.normal_stiffness={per_length: 16}"},
     "is it in kN? ('16 kN/m2')"},
    {"mooring", "friction in %", {"environment.seabed.friction=6"}, "above friction on a seabed"},
    {"mooring", "friction in %, refused", {"environment.seabed.friction=60"}, "out of range"},
    {"mooring",
     "a bed as steep as a wall",
     {"environment.seabed.slope_deg=80"},
     "environment.seabed.slope_deg"},
    // Line types
    {"mooring", "EA in kN", {kChain + "EA=1.6e6"}, "is it in kN?"},
    {"mooring", "EA in MN", {kChain + "EA=1600"}, "too much for an EA"},
    {"mooring", "EA with a digit too many", {kChain + "EA=1.6e11"}, "that of a solid steel bar is 206"},
    {"mooring", "breaking load in kN", {kChain + "breaking_load=13000"}, "is it in kN? ('13000 kN')"},
    {"mooring", "mass in t/m", {kChain + "mass_per_length=0.39"}, "is it in t/m? ('0.39 t/m')"},
    {"mooring", "mass in kg/km", {kChain + "mass_per_length=390000"}, "is it in kg/km? ('390000 kg/km')"},
    {"mooring", "diameter in mm", {kChain + "outer_diameter=250"}, "is it in mm? ('250 mm')"},
    {"mooring",
     "diameter of the bar",
     {kChain + "outer_diameter=0.14"},
     "1.8 times the diameter of its own bar"},
    {"taut", "nominal diameter in mm", {kChain + "diameter=100"}, "the diameter is in m, or with its unit"},
    {"taut", "an unknown grade", {kChain + "grade=R9"}, "no grade"},
    {"mooring", "displaced diameter in mm", {kChain + "displaced_diameter=250"}, "is it in mm? ('250 mm')"},
    {"mooring", "drag diameter in mm", {kChain + "drag_diameter=140"}, "times the outer diameter"},
    {"mooring", "contact diameter in mm", {kChain + "contact_diameter=250"}, "times the outer diameter"},
    {"mooring", "drag coefficient ten times", {kChain + "Cd_normal=14"}, "drag coefficients across a line"},
    {"mooring", "drag along for that across", {kChain + "Cd_axial=2.4"}, "drag coefficients along a line"},
    {"mooring", "added mass in %", {kChain + "Ca_normal=100"}, "added mass coefficients"},
    {"hose", "damping in %", {kHose + "stiffness_damping=5"}, "stiffness-proportional damping"},
    {"mooring", "marine growth in mm", {kChain + "marine_growth={thickness: 50}"}, "above marine growth"},
    {"mooring",
     "growth in t/m3",
     {kChain + "marine_growth={thickness: 0.05, density: 1.325}"},
     "the density of marine growth"},
    {"hose", "EA of a hose in kN", {kHose + "EA=62000"}, "less than that of rubber"},
    {"hose", "EI in kN m2", {kHose + "EI=196"}, "times EI"},
    {"hose", "GJ in kN m2", {kHose + "GJ=196"}, "times EI"},
    {"hose", "EI of a riser ten times as thick", {kHose + "EI=60 GN m2"}, "a radius of gyration sqrt(EI/EA)"},
    {"cable",
     "EI of a cable in kN m2",
     {"line_types.cable.EI=19.9", "line_types.cable.GJ=19.9"},
     "loose wires"},
    {"hose", "bend radius in mm", {kHose + "minimum_bend_radius=3000"}, "may be bent to"},
    {"hose", "mass of a hose in t/m", {kHose + "mass_per_length=0.12"}, "is it in t/m? ('0.12 t/m')"},
    {"hose", "diameter in inches", {kHose + "outer_diameter=20"}, "less than any line"},
    {"riser", "pipe in mm", {kPipe + "outer_diameter=350", kPipe + "wall_thickness=25"}, "mm"},
    {"riser", "wall in mm", {kPipe + "wall_thickness=25"}, "wall"},
    {"riser", "wall a tenth", {kPipe + "wall_thickness=0.0018"}, "D/t"},
    {"riser", "modulus in GPa", {kPipe + "material={E: 207, density: 7850}"}, "too much for an EA"},
    {"riser",
     "density of steel in t/m3",
     {kPipe + "material={E: 207 GPa, density: 7.85}"},
     "the density of walls"},
    {"riser", "coating in mm", {kPipe + "coatings=[{thickness: 3, density: 900}]"}, "is it in mm? ('3 mm')"},
    {"riser",
     "coating in t/m3",
     {kPipe + "coatings=[{thickness: 3 mm, density: 0.9}]"},
     "the density of coatings"},
    {"riser", "contents in t/m3", {"line_types.riser.contents.density=0.8"}, "usual contents of pipes"},
    {"riser", "pressure in bar", {"line_types.riser.contents.pressure=200"}, "is it in"},
    {"riser",
     "pressure in psi",
     {"line_types.riser.contents.pressure=3000 MPa"},
     "operating pressures of pipes"},
    {"riser", "expansion in 1e-6/K", {"line_types.riser.thermal_expansion=11.7"}, "strain"},
    {"riser", "temperature of a furnace", {"lines.riser.temperature_change=1500"}, "changes of temperature"},
    {"riser", "breaking load in t", {"line_types.riser.breaking_load=900"}, "lines break at"},
    // Lines
    {"mooring", "length in km", {kSection + "length=0.76"}, "apart"},
    {"mooring", "ten times the length", {kSection + "length=7600"}, "is so much slack intended"},
    {"mooring", "too short", {kSection + "length=715"}, "the breaking load of"},
    {"mooring", "two elements", {kSection + "elements=2"}, "2 elements for a line"},
    {"mooring", "z down", {"lines.mooring.end_a.anchor=[700, 0, 200]"}, "z points up"},
    {"mooring",
     "an anchor in mid-water",
     {"lines.mooring.end_a.anchor=[700, 0, -160]"},
     "an anchor in mid-water"},
    {"mooring", "an anchor under the bed", {"lines.mooring.end_a.anchor=[700, 0, -220]"}, "below the seabed"},
    {"taut",
     "chain and rope swapped",
     {"lines.leg.sections=[{type: rope, length: 1290, elements: 60}, {type: chain, length: 210, elements: "
      "42}]"},
     "are the ends swapped"},
    {"riser", "direction upwards", {"lines.riser.end_a.direction=[-0.2, 0, 1]"}, "is it reversed"},
    {"cable", "direction from B to A", {"lines.cable.end_a.direction=[-0.9, 0, 0.3]"}, "is it reversed"},
    {"cable",
     "stiffener from its tip",
     {"lines.cable.bend_stiffeners[0].EI=[[0, 0], [2, 1.0e5], [7, 1.0e6]]"},
     "stiffer at its tip"},
    {"cable",
     "stiffener in kN m2",
     {"lines.cable.bend_stiffeners[0].EI=[[0, 1000], [5, 100], [7, 0]]"},
     "are they N m²"},
    {"mooring",
     "a buoy in litres",
     {"lines.mooring.masses=[{at: 100, mass: 2000, volume: 1500, Ca: 0.5}]"},
     "is the volume in litres"},
    {"mooring",
     "a clump in t",
     {"lines.mooring.masses=[{at: 100, mass: 2, volume: 1.5, Ca: 0.5}]"},
     "the mass in t"},
    {"mooring",
     "a clump denser than lead",
     {"lines.mooring.masses=[{at: 100, mass: 20000, volume: 0.2}]"},
     "heavier than lead"},
    {"mooring",
     "a buoy that breaks the line",
     {"lines.mooring.masses=[{at: 500, mass: 1.0e6, volume: 5000, Ca: 0.5}]"},
     "of buoyancy"},
    {"mooring",
     "drag area in cm2",
     {"lines.mooring.masses=[{at: 500, mass: 1000, volume: 3, drag_area: 20000}]"},
     "volume^(2/3)"},
    {"mooring", "a force in kN", {"lines.mooring.loads=[{at: 300, force: [200, 0, 0]}]"}, "is it in kN?"},
    {"mooring",
     "a force in mN",
     {"lines.mooring.loads=[{at: 300, force: [5.0e9, 0, 0]}]"},
     "twice the breaking load"},
    {"mooring", "a load in kN/m", {"lines.mooring.loads=[{per_length: [0, 0.2, 0]}]"}, "is it in kN/m?"},
    {"mooring", "a load in MN/m", {"lines.mooring.loads=[{per_length: [0, 5.0e6, 0]}]"}, "times the weight"},
    {"mooring",
     "a place beyond the end",
     {"lines.mooring.loads=[{at: 7600, force: [2.0e5, 0, 0]}]"},
     "beyond the end"},
    {"mooring",
     "target in kN",
     {"lines.mooring.target={tension: 1500}"},
     "less than the smallest weight that hangs"},
    {"mooring", "target in mN", {"lines.mooring.target={tension: 1.5e9}"}, "more than the breaking load"},
    {"mooring", "a winch in mm/s", {"lines.mooring.end_b.feed={stock: 40, speed: 300}"}, "are paid out"},
    {"mooring",
     "a winch's tension in kN",
     {"lines.mooring.end_b.feed={stock: 40, tension: 900}"},
     "of the line's weight"},
    // Bodies
    {"lift", "mass in t", {kModule + "mass=40"}, "is it in t? ('40 t')"},
    {"lift", "a body of air", {kModule + "mass=120", kModule + "in_water.volume=20"}, "an air bag"},
    {"lift", "volume in litres", {kModule + "in_water.volume=9000"}, "kg/m³"},
    {"lift", "inertia in t m2", {kModule + "inertia=[130, 160, 220]"}, "radius of gyration"},
    {"lift", "inertia a thousand times", {kModule + "inertia=[1.3e9, 1.6e9, 2.2e9]"}, "radius of gyration"},
    {"lift", "height in mm", {kModule + "in_water.height=4000"}, "times the side of a cube"},
    {"lift", "drag area in cm2", {kModule + "in_water.drag_area=[200000, 280000, 300000]"}, "volume^(2/3)"},
    {"lift", "added mass in %", {kModule + "in_water.Ca=[80, 100, 100]"}, "added mass coefficients"},
    {"lift", "weight forgotten", {"bodies.hook.floating.weight=false"}, "has no weight"},
    {"lift",
     "buoyancy forgotten",
     {kModule + "in_water=null", "bodies.module.position=[0, 0, -20]", "lines.hoist.sections[0].length=86.4"},
     "has no buoyancy"},
    {"lift",
     "spring in another unit",
     {"bodies.hook.floating.stiffness=[1.0e12, 0, 0]"},
     "gives a natural period of"},
    {"mooring", "amplitude in mm", {kHarmonic + "amplitude=[0, 0, 2000]"}, "is an acceleration of"},
    {"mooring", "frequency for period of a motion", {kHarmonic + "period=0.1"}, "is an acceleration of"},
    {"mooring",
     "a table in mm",
     {"bodies.vessel.motion={table: {rows: [[0, 0, 0, 0], [5, 0, 0, 0], [30, 9000, 0, 0], [60, 0, 0, 0]]}}"},
     "are its columns s and m"},
    {"hose", "a tanker at 100 m/s", {"bodies.tanker.motion.velocity=[100, 0, 0]"}, "the speed of vessels"},
    {"hose",
     "turning in deg/s",
     {"bodies.tanker.motion={rotation: {axis: [0, 0, 1], rate: 30}, ramp: 20}"},
     "turning rates"},
    {"lift",
     "centre of mass in cm",
     {kModule + "centre_of_mass=[0, 0, -100]"},
     "floating.centre_of_mass: is at z = -94 m, below the bottom of the water at z = -90 m"},
    {"hose", "heading in radians", {"bodies.tanker.rotation_deg=[0, 0, 1.5708]"}, "if radians are meant"},
    {"cable", "no ramp", {"bodies.vessel.motion.ramp=0"}, "starts at t = 0 with"},
    {"vessel",
     "phases in radians",
     {kRao + "[[5, 180, 0.05, 4.71, 0, 0, 0.1, 0.17, 0, 0, 0.2, 1.74, 0, 0], [12, 180, 0.7, 4.71, 0, 0, 0.9, "
             "0.02, 0, 0, 1.3, 1.59, 0, 0], [30, 180, 1, 4.71, 0, 0, 1, 0, 0, 0, 0.25, 1.57, 0, 0]]"},
     "all phases are within"},
    {"vessel",
     "rotations in rad/m",
     {kRao + "[[5, 180, 0.05, 270, 0, 0, 0.1, 10, 0, 0, 0.0035, 100, 0, 0], [12, 180, 0.7, 270, 0, 0, 0.9, "
             "1, 0, 0, 0.0227, 91, 0, 0], [30, 180, 1, 270, 0, 0, 1, 0, 0, 0, 0.0044, 90, 0, 0]]"},
     "are they in rad/m"},
    {"vessel",
     "frequencies for periods",
     {kRao + "[[1.26, 180, 0.05, 270, 0, 0, 0.1, 10, 0, 0, 0.2, 100, 0, 0], [0.52, 180, 0.7, 270, 0, 0, 0.9, "
             "1, 0, 0, 1.3, 91, 0, 0], [0.21, 180, 1, 270, 0, 0, 1, 0, 0, 0, 0.25, 90, 0, 0]]"},
     "is the first column a frequency"},
    {"vessel",
     "directions in radians",
     {kRao + "[[5, 1.5708, 0, 0, 0.1, 270, 0.1, 10, 0.2, 100, 0, 0, 0, 0], [30, 1.5708, 0, 0, 1, 270, 1, 0, "
             "0.25, 90, 0, 0, 0, 0], [5, 3.1416, 0.05, 270, 0, 0, 0.1, 10, 0, 0, 0.2, 100, 0, 0], [30, "
             "3.1416, 1, 270, 0, 0, 1, 0, 0, 0, 0.25, 90, 0, 0]]"},
     "all directions are within"},
    {"vessel", "responses to no waves", {"environment.waves=null"}, "give 'environment: {waves: ...}'"},
    // What is run
    {"mooring", "step in ms", {"dynamics.step=100"}, "longer than the duration"},
    {"mooring", "steps too long", {"dynamics.step=1"}, "10 steps in a period"},
    {"mooring", "outputs in ms", {"output.every=1000"}, "longer than the run"},
    {"hose",
     "error tolerance in mm",
     {"dynamics.error_tolerance=1"},
     "local errors that do not affect results"},
    {"lay",
     "rollers that bend too much",
     {"supports.stinger.path.segments=[{length: 20}, {length: 100, radius: 15}]"},
     "radius"},
    {"lay",
     "elements too long for rollers",
     {"lines.pipe.sections[0].element_length=12"},
     "bending moments on rollers"},
    {"lay",
     "a pipeline that floats",
     {"line_types.pipe.pipe.wall_thickness=0.006"},
     "anchored on the seabed and floats"},
    // A measured bed
    {"grid", "a mark for no data", {"environment.seabed.grid.file=nodata.xyz"}, "it is a no-data value"},
    {"grid", "a height in mm", {"environment.seabed.grid.file=mm.xyz"}, "from all other heights"},
    {"grid", "depths as heights", {"environment.seabed.grid.file=depths.xyz"}, "below the seabed"},
};

class Slips : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    write_bed(folder() + "/bed.xyz", -108);
    write_bed(folder() + "/nodata.xyz", -9999);
    write_bed(folder() + "/mm.xyz", -10800);
    write_bed(folder() + "/depths.xyz", 108, -1);
    write_bed(folder() + "/marked.xyz", -108, 1, "\xef\xbb\xbf");
    write_bed(folder() + "/utf16.xyz", -108, 1, "\xff\xfe");
  }
};

TEST_F(Slips, TheModelsAreClean) {
  for (const std::string& name : kModels)
    EXPECT_EQ(warnings_of(name, {}), std::vector<std::string>{}) << name;
}

TEST_F(Slips, EachIsRefusedOrNoted) {
  EXPECT_GE(kSlips.size(), 80U);
  for (const Slip& s : kSlips) {
    const std::vector<std::string> found = warnings_of(s.model, s.set);
    const auto is_it = [&](const std::string& n) { return n.find(s.part) != std::string::npos; };
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), is_it))
        << s.model << ": " << s.name << ": " << s.part << "\n"
        << testing::PrintToString(found);
    EXPECT_LE(found.size(), 3U) << s.model << ": " << s.name << "\n" << testing::PrintToString(found);
  }
}

// Warnings of what affects all results precede those about resolution.
TEST_F(Slips, ByWhatTheyCanChange) {
  const std::vector<std::string> found =
      warnings_of("mooring", {"output.every=8", "environment.water.density=1.025"});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NE(found[0].find("the density of water"), std::string::npos) << found[0];
}

// Some spreadsheets begin tables with a UTF-8 byte order mark; UTF-16 is refused.
TEST_F(Slips, MarksBeforeTexts) {
  EXPECT_EQ(warnings_of("grid", {"environment.seabed.grid.file=marked.xyz"}), std::vector<std::string>{});
  const std::vector<std::string> found = warnings_of("grid", {"environment.seabed.grid.file=utf16.xyz"});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].find("UTF-16; save it as UTF-8"), std::string::npos) << found[0];
}

// Rows of a profile without a direction have that of the current.
TEST_F(Slips, OneDirectionOfAProfile) {
  const auto rows = [](const std::vector<std::string>& set) {
    return io::read_case_text(text_of("taut"), "taut.yaml", {}, MPI_COMM_SELF, set)
        .environment.water.current.profile;
  };
  for (const model::CurrentRow& r : rows({})) EXPECT_DOUBLE_EQ(r.direction, M_PI / 2);
  const auto own = rows({"environment.current.profile[1].direction_deg=45"});
  EXPECT_DOUBLE_EQ(own[0].direction, M_PI / 2);
  EXPECT_DOUBLE_EQ(own[1].direction, M_PI / 4);
}

}  // namespace
}  // namespace hawser::slips_test
