// Farms: objects that are placed and rotated, objects that places share, refusals with file and line, and
// notes that are joined over many places.
#include "hawser/model/farm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/io/case_json.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/schema.hpp"
#include "hawser/model/summary.hpp"
#include "hawser/run/volumes.hpp"
#include "support/shapes.hpp"

namespace hawser::farm_test {
namespace {

namespace fs = std::filesystem;

std::string folder() {
  const fs::path path = fs::path(testing::TempDir()) / "hawser_farm";
  fs::create_directories(path);
  return path.string();
}
void write(const std::string& name, const std::string& text) { std::ofstream(folder() + "/" + name) << text; }

// A platform with one of every object that a place rotates.
const std::string kPlatform = R"(hawser: 1
environment:
  water: {density: 1025, depth: 50}
  seabed: {depth: 50, normal_stiffness: {per_area: 1e5}}
line_types:
  rope: {outer_diameter: 0.1, mass_per_length: 20, EA: 2e7, bending: false}
  pipe: {outer_diameter: 0.2, mass_per_length: 60, EA: 1e9, EI: 1e6, GJ: 1e6}
bodies:
  float:
    position: [1, 2, 3]
    rotation_deg: [10, 20, 30]
    motion:
      harmonic: {amplitude: [1, 0.5, 0.2], phase_deg: [0, 70, 20], rotation_amplitude_deg: [3, 5, 2], rotation_phase_deg: [40, 0, 80], period: 9}
      drift: {offset: [1, 2, 0], rotation_deg: [0, 0, 5], harmonic: {amplitude: [2, 1, 0], phase_deg: [10, 50, 0], period: 50},
              table: {rows: [[0, 0, 0, 0, 0, 0, 0], [50, 1, 2, 0, 0, 0, 3], [100, 2, 0, 0, 1, 0, 0]]}}
  wagon: {position: [5, 0, -3], motion: {velocity: [0.1, 0.2, 0], rotation: {axis: [1, 1, 0], rate: 0.1}}}
  sled: {position: [0, 9, -3], motion: {table: {rows: [[0, 0, 0, 0], [50, 3, 1, 0], [100, 2, 5, 1]]}}}
  buoy: {position: [20, 0, -2], rotation_deg: [0, 0, 15], floating: {mass: 1000, inertia: [100, 200, 300], velocity: [1, 2, 0], stiffness: [100, 100, 50],
         positioning: {place: [21, 1, 0], heading_deg: 20, proportional: [10, 10, 100], derivative: [100, 100, 1000]}, loads: [{force: [10, 0, 0]}, {force: [0, 7, 0], axes: body}]}}
volumes:
  pile: {shape: {cylinder: {from: [30, 40, -20], to: [30, 40, 5], radius: 1}}, normal_stiffness: {per_length: 1e5}}
  hull: {mesh: hull.obj, body: float, normal_stiffness: {per_area: 1e5}}
joints:
  bridle: {start: [-20, 5, -30]}
lines:
  leg 1:
    sections: [{type: rope, length: 60, elements: 6}]
    end_a: {anchor: [-60, 10, -50]}
    end_b: {joint: bridle}
  leg 2:
    sections: [{type: rope, length: 40, elements: 4}]
    end_a: {joint: bridle}
    end_b: {body: float, at: [-3, 0, -1]}
  riser:
    sections: [{type: pipe, length: 90, elements: 9}]
    end_a: {anchor: [20, 30, -10], direction: [0.6, 0, 0.8], clamped: true}
    end_b: {body: buoy, at: [0, 0, 1], direction: [0, 0.6, 0.8], clamped: true}
    start: {points: [[20, 30, -10], [20, 20, -50], [20, 0, -1]]}
links:
  spring: {end_a: {body: buoy, at: [0, 0, 0]}, end_b: {anchor: [40, 3, -2]}, stiffness: 10}
  pennant: {end_a: {body: buoy, at: [0, 0, 0]}, end_b: {anchor: [-20, 3, -50]}, stiffness: 10}
  guy: {end_a: {line: riser, at: end_b}, end_b: {body: float, at: [1, 1, 1]}, stiffness: 10}
dynamics: {duration: 10}
)";

const std::string kSea = R"(
environment:
  water: {density: 1025, depth: 50}
  seabed: {depth: 50, normal_stiffness: {per_area: 1e5}}
dynamics: {duration: 10}
)";

model::Case read(const std::string& text, const std::vector<std::string>& changes = {}) {
  return io::read_case_text(text, folder() + "/farm.yaml", {}, MPI_COMM_SELF, changes);
}
std::string why_not(const std::string& text, const std::vector<std::string>& changes = {}) {
  try {
    read(text, changes);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

class FarmFiles : public testing::Test {
 protected:
  void SetUp() override {
    write("platform.yaml", kPlatform);
    std::ofstream out(folder() + "/hull.obj");
    const TriangleMesh m = test::box_mesh({-3, -2, -2}, {3, 2, 2});
    for (const Vec3& x : m.vertices) out << "v " << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
    for (const auto& t : m.triangles) out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  }
};

TEST_F(FarmFiles, PlacesAreTheFileMovedAndTurned) {
  const model::Case alone = io::read_case(folder() + "/platform.yaml");
  const model::Case farm =
      read("hawser: 1\nfarm: {of: platform.yaml, at: {A1: [500, -300], B: [700, 100, 33]}}\n" + kSea);
  ASSERT_EQ(farm.bodies.size(), 10u) << "four of each and what carries the piles";
  ASSERT_EQ(farm.lines.size(), 6u);
  EXPECT_EQ(farm.line_types.size(), 2u);
  for (const auto& [place, offset, heading] :
       {std::tuple{"A1/", Vec3(500, -300, 0), 0.0}, {"B/", Vec3(700, 100, 0), 33 * M_PI / 180}}) {
    const Quat turn = exp_so3(heading * Vec3::UnitZ());
    const auto moved = [&](const Vec3& x) { return Vec3(turn * x + offset); };
    for (const model::Body& b : alone.bodies) {
      const int i = farm.body_index(place + b.name);
      ASSERT_GE(i, 0) << place << b.name;
      const RigidMotion here = model::rigid_motion(b);
      const RigidMotion there = model::rigid_motion(farm.bodies[i]);
      for (double t = 0; t < 10; t += 0.7) {
        const RigidPose p = here.at(t);
        const RigidPose q = there.at(t);
        EXPECT_LT((q.position - moved(p.position)).norm(), 1e-11) << place << b.name << " " << t;
        EXPECT_LT((q.rotation.toRotationMatrix() - (turn * p.rotation).toRotationMatrix()).norm(), 1e-12);
        EXPECT_LT((q.velocity - turn * p.velocity).norm(), 1e-12) << place << b.name << " " << t;
        EXPECT_LT((q.angular_acceleration - turn * p.angular_acceleration).norm(), 1e-12);
      }
    }
    const model::BodyMass& buoy = *farm.bodies[farm.body_index(std::string(place) + "buoy")].mass;
    EXPECT_LT((buoy.velocity - turn * Vec3(1, 2, 0)).norm(), 1e-14);
    EXPECT_EQ(buoy.loads[0].force, Vec3(10, 0, 0)) << "forces in axes of space stay as wind does";
    EXPECT_EQ(buoy.loads[1].force, Vec3(0, 7, 0));
    EXPECT_LT((*buoy.positioning->place - moved(Vec3(21, 1, 0))).norm(), 1e-11);
    EXPECT_NEAR(*buoy.positioning->heading, 20 * M_PI / 180 + heading, 1e-12);
    for (const model::Line& l : alone.lines) {
      const model::Line& m = farm.line(place + l.name);
      for (const LineEnd end : kLineEnds) {
        EXPECT_LT(
            (model::end_position(farm, m.end(end)) - moved(model::end_position(alone, l.end(end)))).norm(),
            1e-10)
            << m.name;
        const model::End& e = l.end(end);
        const model::End& f = m.end(end);
        const bool anchor = e.kind == model::EndKind::anchor;
        if (!anchor) {
          EXPECT_EQ(f.carrier, place + e.carrier);
        }
        if (e.direction) {
          EXPECT_LT((*f.direction - (anchor ? Vec3(turn * *e.direction) : *e.direction)).norm(), 1e-14)
              << m.name;
        }
      }
      for (size_t i = 0; i < l.points.size(); ++i)
        EXPECT_LT((m.points[i] - moved(l.points[i])).norm(), 1e-10);
    }
    const model::Link& spring =
        *std::find_if(farm.links.begin(), farm.links.end(),
                      [&](const model::Link& l) { return l.name == std::string(place) + "spring"; });
    EXPECT_LT((spring.end_b.at - moved({40, 3, -2})).norm(), 1e-11);
    EXPECT_EQ(spring.end_a.body, std::string(place) + "buoy");
    EXPECT_EQ(spring.end_a.at, Vec3::Zero());
    // Objects fixed in space by the file are attached to a stationary body at the place.
    const auto pile = std::find_if(farm.volumes.begin(), farm.volumes.end(), [&](const model::Volume& v) {
      return v.name == std::string(place) + "pile";
    });
    ASSERT_NE(pile, farm.volumes.end());
    const model::Body& carrier = farm.bodies[farm.body_index(pile->body)];
    EXPECT_EQ(carrier.name + "/", place);
    EXPECT_LT((model::rigid_motion(carrier).at(3).to_space({30, 40, 5}) - moved({30, 40, 5})).norm(), 1e-11);
  }
}

TEST_F(FarmFiles, CopiesShareMeshes) {
  const model::Case farm =
      read("hawser: 1\nfarm: {of: platform.yaml, at: [[500, -300], [700, 100, 33]]}\n" + kSea);
  const auto volumes = run::load_volumes(farm);
  ASSERT_EQ(volumes.size(), 4u);
  EXPECT_EQ(volumes[1].name, "T1/hull");
  EXPECT_EQ(volumes[3].name, "T2/hull");
  EXPECT_EQ(volumes[1].surface, volumes[3].surface);
  EXPECT_EQ(volumes[1].facets, volumes[3].facets);
}

// All places share one copy of what does not depend on the place: the mass of a buoy, but not that of one
// with a position; at a rotated place, only objects without a direction.
TEST_F(FarmFiles, CopiesShareWhatIsTheSame) {
  std::string text = kPlatform;
  const std::string positioning = "         positioning";
  const size_t from = text.find(positioning);
  const size_t to = text.find("loads:", from);
  text.replace(from, to - from, "weight: true, in_water: {volume: 1, height: 1}, ");
  write("adrift.yaml", text);
  const model::Case farm =
      read("hawser: 1\nfarm: {of: adrift.yaml, at: [[500, -300], [700, 100], [900, 100, 90]]}\n" + kSea);
  const auto mass = [&](const char* name) -> const model::BodyMass& {
    return *farm.bodies[farm.body_index(name)].mass;
  };
  EXPECT_EQ(&mass("T1/buoy"), &mass("T2/buoy"));
  EXPECT_NE(&mass("T1/buoy"), &mass("T3/buoy"));
  EXPECT_EQ(&*mass("T1/buoy").in_water, &*mass("T3/buoy").in_water);
  EXPECT_EQ(mass("T1/buoy").velocity, Vec3(1, 2, 0));
  EXPECT_LT((mass("T3/buoy").velocity - Vec3(-2, 1, 0)).norm(), 1e-14);
}

TEST_F(FarmFiles, AnchorsAndPointsFollowTheBed) {
  // The bed rises by 2 m per 100 m to the east, and is 10 m deeper than the platform's own bed at x = 0.
  const std::string text =
      "hawser: 1\nfarm: {of: platform.yaml, at: [[500, -300], [700, 100, 90]]}\n"
      "environment:\n  water: {density: 1025, depth: 60}\n"
      "  seabed: {depth: 60, slope_deg: 1.1457628381751, slope_direction_deg: 180, normal_stiffness: "
      "{per_area: 1e5}}\n"
      "dynamics: {duration: 10}\n";
  const model::Case farm = read(text);
  const model::End& one = farm.line("T1/leg 1").end_a;
  const model::End& two = farm.line("T2/leg 1").end_a;
  EXPECT_NEAR(one.at.x(), 440, 1e-10);
  EXPECT_NEAR(one.at.z(), -60 + 0.02 * 440, 1e-9);
  EXPECT_NEAR(two.at.x(), 690, 1e-10);
  EXPECT_NEAR(two.at.z(), -60 + 0.02 * 690, 1e-9);
  EXPECT_NEAR(farm.line("T1/riser").end_a.at.z(), -10, 1e-12) << "above the bed";
  EXPECT_NEAR(farm.line("T1/riser").points[0].z(), -10, 1e-12);
  EXPECT_NEAR(farm.line("T1/riser").points[1].z(), -60 + 0.02 * 520, 1e-9);
  const auto anchor = [&](const std::string& name) {
    return std::find_if(farm.links.begin(), farm.links.end(),
                        [&](const model::Link& l) { return l.name == name; })
        ->end_b.at;
  };
  EXPECT_NEAR(anchor("T1/spring").z(), -2, 1e-12) << "above the bed";
  EXPECT_NEAR(anchor("T1/pennant").z(), -60 + 0.02 * 480, 1e-9);
}

TEST_F(FarmFiles, PlacesByRowsListAndFile) {
  write("places.csv", "# x y heading\n0, 0\n1000, 0, 90\n");
  const auto places = [](const std::string& how) {
    return read("hawser: 1\nfarm: {of: platform.yaml, " + how + "}\n" + kSea).farm->parts.at(0).places;
  };
  const auto rows = places(
      "name: WT, heading_deg: 30, rows: {rows: 2, columns: 3, spacing: [1000, 800], stagger: 400, from: [10, "
      "20], "
      "direction_deg: 90}");
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[0].name, "WT1");
  EXPECT_NEAR(rows[1].x, 10, 1e-9);
  EXPECT_NEAR(rows[1].y, 1020, 1e-9);
  EXPECT_EQ(rows[4].name, "WT5");
  EXPECT_NEAR(rows[4].x, 10 - 800, 1e-9);
  EXPECT_NEAR(rows[4].y, 20 + 1000 + 400, 1e-9);
  EXPECT_NEAR(rows[4].heading, M_PI / 6, 1e-15);
  const auto listed = places("heading_deg: 45, at: [[0, 0], [1000, 0, 90]]");
  const auto filed = places("heading_deg: 45, file: places.csv");
  for (const auto& p : {listed, filed}) {
    ASSERT_EQ(p.size(), 2u);
    EXPECT_EQ(p[1].name, "T2");
    EXPECT_EQ(p[1].x, 1000);
    EXPECT_NEAR(p[0].heading, M_PI / 4, 1e-15);
    EXPECT_NEAR(p[1].heading, M_PI / 2, 1e-15);
  }
}

// Objects of the farm's own file may be attached to placed ones and use their line types.
TEST_F(FarmFiles, OwnLinesReferToPlaces) {
  const model::Case farm = read(
      "hawser: 1\nfarm: {of: platform.yaml, at: [[0, 0], [200, 0]]}\n"
      "lines:\n  cable: {sections: [{type: rope, length: 220, elements: 22}], end_a: {body: T1/float, at: "
      "[3, 0, 0]}, "
      "end_b: {body: T2/float, at: [-3, 0, 0]}}\n"
      "links: {tie: {end_a: {line: T1/riser, at: end_b}, end_b: {body: T2/buoy, at: [0, 0, 0]}, stiffness: "
      "1}}\n"
      "contact: {volumes: [T1/hull, T2/hull]}\n"
      "output: {histories: [{line: T2/leg 1, at: end_a, name: anchor}, {body: T1/buoy}]}\n" +
      kSea);
  EXPECT_EQ(farm.line("cable").end_b.carrier, "T2/float");
  EXPECT_NEAR(farm.links.front().end_a.arc, 90, 1e-12);
  const std::string text = model::summary(farm);
  for (const char* part :
       {"farm: 2 places",
        "platform.yaml at 2 places, at each 3 lines (19 elements), 4 bodies, 3 links, 2 volumes",
        "T2: (200, 0) m, heading 0 deg", "beside them 1 line (22 elements), 0 bodies, 1 link, 0 volumes",
        "lines: 7 ("})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
  EXPECT_EQ(text.find("  T2/leg 1"), std::string::npos) << "copies are described once";
  EXPECT_NE(io::case_json(farm).find("\"platforms\": [{\"file\": \"platform.yaml\""), std::string::npos);
  EXPECT_EQ(std::count_if(farm.inputs.begin(), farm.inputs.end(),
                          [](const std::string& f) { return f.ends_with("/platform.yaml"); }),
            1);
}

TEST_F(FarmFiles, SetChangesThePlatform) {
  const std::string text = "hawser: 1\nfarm: {of: platform.yaml, at: [[0, 0], [200, 0]]}\n" + kSea;
  const model::Case farm = read(text, {"farm.of.lines.leg 1.sections[0].length=61", "farm.at[1][0]=300"});
  EXPECT_EQ(farm.line("T2/leg 1").sections[0].length, 61);
  EXPECT_EQ(farm.farm->parts[0].places[1].x, 300);
  EXPECT_EQ(farm.change_notes.size(), 2u);
  EXPECT_NE(why_not(text, {"farm.of.lines.leg 7.sections[0].length=61"}).find("platform.yaml with --set"),
            std::string::npos);
  EXPECT_NE(why_not(text, {"farm[1].of.title=x"}).find("there is one platform, farm[0]"), std::string::npos);
}

// Lengths found by targets apply to a single place.
TEST_F(FarmFiles, LengthsOfOnePlace) {
  const model::Case farm = read("hawser: 1\nfarm: {of: platform.yaml, at: [[0, 0], [200, 0]]}\n" + kSea);
  const model::Case other = io::with_lengths(farm, {{"lines.T2/riser.sections[0]", 93}});
  EXPECT_EQ(other.line("T1/riser").sections[0].length, 90);
  EXPECT_EQ(other.line("T2/riser").sections[0].length, 93);
  EXPECT_EQ(other.inputs, farm.inputs);
  for (const model::Link& l : other.links)
    EXPECT_TRUE(l.end_a.line != "T2/riser" || l.end_a.arc == 93) << "at end B";
}

TEST_F(FarmFiles, Refusals) {
  const auto farm = [](const std::string& keys) {
    return "hawser: 1\nfarm: {of: platform.yaml, " + keys + "}\n" + kSea;
  };
  const auto expect = [](const std::string& why, const std::vector<std::string>& parts) {
    EXPECT_FALSE(why.empty()) << parts[0];
    EXPECT_EQ(why.find('\n'), std::string::npos) << why;
    for (const std::string& part : parts) EXPECT_NE(why.find(part), std::string::npos) << part << "\n" << why;
  };
  expect(why_not(farm("at: [[0, 0]], rows: {rows: 1, columns: 1, spacing: [1, 1]}")),
         {"farm.yaml:2: farm: ", "exclude each other"});
  expect(why_not(farm("at: [[0, 0], [1e-4, 0]]")), {"farm.yaml:2: farm.at[1]: T2 is at the place of T1"});
  expect(why_not(farm("at: [[0, 2e6]]")), {"farm.yaml:2: farm.at[0]: T1 is 2e+06 m from the origin"});
  expect(why_not(farm("at: [[0, 0, 1, 2]]")), {"farm.yaml:2: farm.at[0]: expected a list of 2 to 3 numbers"});
  expect(why_not(farm("at: []")), {"farm.yaml:2: farm.at: "});
  expect(why_not(farm("file: nothing.csv")), {"farm.yaml:2: farm.file: "});
  write("twice.csv", "# x y\n0, 0\n200, 0\n0, 0\n");
  expect(why_not(farm("file: twice.csv")), {"farm.yaml:2: farm.file: twice.csv:4: T3 is at the place of T1"});
  expect(why_not("hawser: 1\nfarm: {of: nothing.yaml, at: [[0, 0]]}\n" + kSea),
         {"farm.yaml:2: farm.of: ", "nothing.yaml"});
  expect(
      why_not("hawser: 1\nfarm: [{of: platform.yaml, at: [[0, 0]]}, {of: platform.yaml, at: [[200, 0]]}]\n" +
              kSea),
      {"farm.yaml:2: farm[1].at[0]: there is another place called 'T1'"});
  // References to missing objects.
  expect(
      why_not(
          farm("at: [[0, 0]]") +
          "links: {a: {end_a: {body: T2/float, at: [0, 0, 0]}, end_b: {anchor: [0, 0, 0]}, stiffness: 1}}\n"),
      {"farm.yaml:", "links.a.end_a.body: no body is called 'T2/float'; did you mean 'T1/float'"});
  // Faults in the platform's file.
  write("platform.yaml", kPlatform + "stages: {}\n");
  expect(why_not(farm("at: [[0, 0]]")), {"/platform.yaml:", "stages"});
  std::string text = kPlatform;
  text.replace(text.find("length: 40, elements: 4"), 10, "length: -4");
  write("platform.yaml", text);
  expect(why_not(farm("at: [[0, 0]]")),
         {"/platform.yaml:31: lines.leg 2.sections[0].length: '-4' is out of range"});
  // Faults that appear only in the combined case name file, line and place.
  text = kPlatform;
  text.replace(text.find("end_b: {joint: bridle}"), 22, "end_b: free");
  write("platform.yaml", text);
  expect(why_not(farm("at: [[0, 0]]")), {"/platform.yaml:", "joints.T1/bridle: joins 1 end of a line"});
  // One sea and one set of line types.
  text = kPlatform;
  text.replace(text.find("density: 1025"), 13, "density: 1000");
  write("platform.yaml", text);
  expect(why_not(farm("at: [[0, 0]]")),
         {"/platform.yaml:3: environment.water.density: 1000 kg/m³ is 1025 kg/m³ in"});
  write("platform.yaml", kPlatform);
  const std::string other =
      "line_types: {rope: {outer_diameter: 0.1, mass_per_length: 20, EA: 3e7, bending: false}}\n";
  expect(why_not(farm("at: [[0, 0]]") + other),
         {"/platform.yaml:6: line_types.rope: is another line type than that of", "/farm.yaml:"});
  const std::string same =
      "line_types: {rope: {outer_diameter: 0.1, mass_per_length: 20, EA: 20 MN, bending: false}}\n";
  EXPECT_EQ(why_not(farm("at: [[0, 0]]") + same), "");
  expect(why_not(farm("at: [[0, 0]]") + "bodies: {T1: {position: [0, 0, 0]}}\n"),
         {"farm.yaml:", "bodies.T1: a place of the farm is called so"});
  text = kPlatform;
  text.replace(text.find("stiffness: [100, 100, 50]"), 25, "stiffness: [100, 200, 50]");
  write("platform.yaml", text);
  EXPECT_EQ(why_not(farm("at: [[0, 0, 180]]")), "");
  expect(
      why_not(farm("at: [[0, 0, 30]]")),
      {"/platform.yaml:", "bodies.T1/buoy.floating.stiffness: 100 along x and 200 along y cannot be turned"});
  write("platform.yaml", "hawser: 1\nfarm: {of: platform.yaml, at: [[0, 0]]}\n");
  expect(why_not(farm("at: [[0, 0]]")),
         {"/platform.yaml:2: farm: a platform of a farm cannot contain a farm"});
}

TEST_F(FarmFiles, NotesOfManyPlacesAreOne) {
  std::string text = kPlatform;
  text.replace(text.find("mass: 1000, inertia: [100, 200, 300]"), 36, "mass: 1000, inertia: [1e7, 1e7, 1e7]");
  text.replace(text.find("EA: 2e7"), 7, "EA: 2e12");
  write("platform.yaml", text + "contact: {volumes: []}\n");
  const model::Case one = read("hawser: 1\nfarm: {of: platform.yaml, at: [[0, 0]]}\n" + kSea);
  const model::Case many =
      read("hawser: 1\nfarm: {of: platform.yaml, rows: {rows: 4, columns: 5, spacing: [500, 500]}}\n" + kSea);
  ASSERT_FALSE(one.notes.empty());
  EXPECT_EQ(one.notes.size(), many.notes.size());
  const auto with = [&](const model::Case& c, const std::string& part) {
    return std::count_if(c.notes.begin(), c.notes.end(),
                         [&](const std::string& n) { return n.find(part) != std::string::npos; });
  };
  EXPECT_EQ(with(many, "(and so at 19 more places, T2 to T20)"), with(one, "T1/"));
  EXPECT_GE(with(one, "/platform.yaml:13: bodies.T1/float.motion.harmonic: "), 1) << one.notes[0];
  EXPECT_GE(with(one, "/platform.yaml:6: line_types.rope: "), 1);
  EXPECT_EQ(with(one, "/platform.yaml: 'contact' is not used: a farm has its own"), 1);
}

// A place turns body and motion together, so that notes on the axes of a rotation are those of the file, for
// all places in one.
TEST_F(FarmFiles, RotationsOfBodiesAreJudgedInAxesOfTheFile) {
  const auto notes = [&](const std::string& float_) {
    write("ship.yaml", R"(hawser: 1
line_types: {rope: {outer_diameter: 0.1, mass_per_length: 20, EA: 2e7, bending: false}}
lines:
  west:
    sections: [{type: rope, length: 80, elements: 8}]
    end_a: {anchor: [-60, 0, -50]}
    end_b: {body: float, at: [-8, 0, -5]}
bodies: {float: {)" + float_ +
                           ", ramp: 9}}}\n");
    const model::Case c = read(
        "hawser: 1\nfarm: {of: ship.yaml, at: [[0, 0], [900, 0, -60], [0, 900, 90], [900, 900, 180]]}\n" +
        kSea);
    std::vector<std::string> out;
    for (const std::string& n : c.notes)
      if (n.find("turns the body") != std::string::npos) out.push_back(n);
    return out;
  };
  const std::string roll = "motion: {harmonic: {rotation_amplitude_deg: [5, 0, 0], period: 10}";
  const std::string table = "motion: {table: {rows: [[0, 0, 0, 0, 0, 0, 0], [60, 0, 0, 0, 5, 0, 0]]}";
  for (const std::string& motion : {roll, table}) {
    EXPECT_EQ(notes(motion), std::vector<std::string>{});
    const std::vector<std::string> found = notes("rotation_deg: [0, 0, 90], " + motion);
    ASSERT_EQ(found.size(), 1U) << testing::PrintToString(found);
    EXPECT_NE(
        found[0].find("turns the body about (1, 0, 0) in space, and that is (0, -1, 0) of its own axes"),
        std::string::npos)
        << found[0];
    EXPECT_NE(found[0].find("(and so at 3 more places, T2 to T4)"), std::string::npos) << found[0];
  }
}

}  // namespace
}  // namespace hawser::farm_test
