// Whole runs with elements and steps that are too long, and their warnings, the same on any number of ranks.
#include <fmt/format.h>

#include "hawser/base/mpi.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/mesh/partition.hpp"
#include "hawser/record/edge_errors.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::long_elements {
namespace {

// A chain from the bed to a fairlead that heaves until the chain snaps taut. Between lines there is no
// contact, because impacts of the slack chain on itself would shorten the steps.
const char* const kChain = R"(hawser: 1
environment: {water: {depth: 50}, seabed: {depth: 50, friction: 0.5}}
line_types:
  chain: {outer_diameter: 0.252, mass_per_length: 390, EA: 1.674 GN, bending: false, Cd_normal: 1.37}
bodies:
  vessel: {motion: {harmonic: {amplitude: [0, 0, HEAVE], period: 4}, ramp: 4}}
lines:
  chain:
    sections: [{type: chain, length: 130.72, elements: ELEMENTS}]
    end_a: {anchor: [120, 0, -49.874]}
    end_b: {body: vessel, at: [0, 0, 0]}
contact: {between_lines: false}
dynamics: {duration: 10STEP}
output: {every: 1}
)";

// A cable across a current jet, at rest, and a stiff riser in a wave.
const char* const kJet = R"(hawser: 1
environment:
  water: {depth: 100}
  current: {profile: [{depth: 0, speed: 0.2}, {depth: 44, speed: 0.2}, {depth: 45, speed: 1.5}, {depth: 49, speed: 1.5}, {depth: 50, speed: 0.2}]}
line_types: {cable: {outer_diameter: 0.3, mass_per_length: 200, EA: 100 MN, bending: false}}
lines:
  cable:
    sections: [{type: cable, length: 99.5, elements: ELEMENTS}]
    end_a: {anchor: [0, 0, -100]}
    end_b: {anchor: [0, 0, 0]}
)";
const char* const kRiser = R"(hawser: 1
environment:
  water: {depth: 100}
  waves: {regular: {height: 1.5, period: 4}, ramp: 4}
line_types:
  pipe: {outer_diameter: 0.3, mass_per_length: 72.45, EA: 1.0e10, EI: 1.0e12, GJ: 1.0e12, Cd_normal: 1.2, Ca_normal: 1}
lines:
  pipe:
    sections: [{type: pipe, length: 105, elements: ELEMENTS}]
    end_a: {anchor: [0, 0, -100], direction: [0, 0, 1], clamped: true}
    end_b: {anchor: [0, 0, 5], direction: [0, 0, 1], clamped: true}
dynamics: {duration: 15, step: 0.05}
output: {every: 5}
)";

// A load of 1 kN at its end pulls a rope over the edge of a box by ten degrees, without friction.
const char* const kEdge = R"(hawser: 1
environment: {gravity: 0}
line_types: {rope: {outer_diameter: 0.02, mass_per_length: 1, EA: 2 MN, STIFFNESS}}
volumes: {box: {shape: {box: {centre: [-1.5, 0, -1.5], size: [3, 2, 3]}}}}
lines:
  rope:
    sections: [{type: rope, length: 2.02, elements: ELEMENTS}]
    end_a: {anchor: [-0.99, 0, 0.01]}
    end_b: free
    start: {points: [[-0.99, 0, 0.01], [0, 0, 0.01], [0.001736, 0, 0.009848], [1.085, 0, -0.1812]]}
    loads: [{at: end_b, force: [984.808, 0, -173.648]}]
)";

// A rope draped over a taut wire; the turn of its elements there is no touchdown.
const char* const kDrape = R"(hawser: 1
line_types: {rope: {outer_diameter: 0.04, mass_per_length: 4, EA: 20 MN, bending: false}}
lines:
  wire:
    sections: [{type: rope, length: 4, elements: 40}]
    end_a: {anchor: [-2, 0, 0]}
    end_b: {anchor: [2, 0, 0]}
  rope:
    sections: [{type: rope, length: 4.1, elements: 41}]
    end_a: {anchor: [0, -1, -1.7]}
    end_b: {anchor: [0, 1, -1.7]}
    start: {points: [[0, -1, -1.7], [0, -0.05, 0.02], [0, 0, 0.05], [0, 0.05, 0.02], [0, 1, -1.7]]}
)";

std::string message(const std::string& path) {
  io::h5::quiet();
  const io::h5::Id file = io::h5::open_read(path);
  std::string out;
  if (io::h5::exists(file, "messages"))
    for (const std::string& m : io::h5::read_texts(file, "messages"))
      if (m.starts_with("warning")) out += m + "\n";
  return out;
}

struct LongElements : testing::Test {
  const std::string path = folder("long-elements");
  std::string run(const char* text, const std::vector<std::pair<std::string, std::string>>& with) {
    const std::string input = path + "/case.yaml";
    write_case(input, text, with);
    run_on_all({input, path + "/all.h5"});
    run_on_one({input, path + "/one.h5"});
    if (rank_of(MPI_COMM_WORLD) != 0) return "";
    const std::string all = message(path + "/all.h5");
    EXPECT_EQ(all, message(path + "/one.h5"));
    return all;
  }
  std::string run(const std::string& heave, const std::string& elements, const std::string& step) {
    return run(kChain, {{"HEAVE", heave}, {"ELEMENTS", elements}, {"STEP", step}});
  }
};

// Both elements beside one with 1 kN hang down by 49 degrees; their tensions are 1 kN/cos 49. The ranks cut
// the line between its two bends, whose errors cancel: a third of one of them counts.
TEST(EdgeErrorsOnRanks, OfALineThatIsCutBetweenItsTurns) {
  const model::Case c = io::read_case_text(R"(
hawser: 1
line_types: {wire: {outer_diameter: 0.05, mass_per_length: 5, EA: 1.0e8, bending: false}}
lines:
  sling:
    sections: [{type: wire, length: 6, elements: 3}]
    end_a: {anchor: [0, 0, 0]}
    end_b: {anchor: [5.9, 0, 0]}
)",
                                           "/nowhere/case.yaml");
  const Mesh mesh = build_mesh(c);
  const int ranks = ranks_of(MPI_COMM_WORLD);
  const int last = ranks - 1;
  const LocalMesh local = local_mesh(mesh, std::vector{0, 0, last, last}, rank_of(MPI_COMM_WORLD), ranks);
  const double a = 49 * M_PI / 180;
  const double T = 1000 / std::cos(a);
  const double up = T * std::sin(a);
  const std::vector<Vec3> x{{-2 * std::cos(a), 0, -2 * std::sin(a)},
                            {0, 0, 0},
                            {2, 0, 0},
                            {2 + 2 * std::cos(a), 0, -2 * std::sin(a)}};
  const std::vector<double> force{0, up, up, 0};
  const std::vector<double> before{T, T, 1000, T};
  const std::vector<double> after{T, 1000, T, T};
  State s;
  s.resize(static_cast<size_t>(local.nodes()));
  std::vector<double> F, none, T1, T2;
  for (int n = 0; n < local.nodes(); ++n) {
    const int g = local.global[n];
    s.x[n] = x[g];
    if (!local.owns(n)) continue;
    F.insert(F.end(), {0, 0, force[g]});
    none.insert(none.end(), {0, 0, 0});
    T1.push_back(before[g]);
    T2.push_back(after[g]);
  }
  record::EdgeErrors errors(MPI_COMM_WORLD, c, local);
  errors.update(s.at_rest(), {F, none, T1, T2});
  EXPECT_NE(errors.warning(0, T).find("by 1.6e+02 N"), std::string::npos) << errors.warning(0, T);
}

TEST_F(LongElements, AreReported) {
  const std::string coarse = run("0.5", "4", "");
  const std::string fine = run("0.5", "30", "");
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  EXPECT_NE(coarse.find("line chain sags between the nodes of its elements of 32.7 m"), std::string::npos)
      << coarse;
  EXPECT_EQ(fine, "");
}

// Rows and warnings of several lines are in the order of the case, whichever ranks have the lines.
TEST_F(LongElements, OfSeveralLinesAreReportedInTheirOrder) {
  std::string lines;
  int y = 0;
  for (const char* name : {"z", "a", "m", "b", "y", "c"}) {
    lines += fmt::format(
        "  {}: {{sections: [{{type: chain, length: 130.72, elements: 4}}], end_a: {{anchor: [120, {}, "
        "-49.874]}}, end_b: {{body: vessel, at: [0, {}, 0]}}}}\n",
        name, y, y);
    y += 100;
  }
  std::string text = kChain;
  const size_t from = text.find("  chain:\n    sections");
  const size_t to = text.find("contact:");
  text.replace(from, to - from, lines);
  const std::string all = run(text.c_str(), {{"HEAVE", "0.5"}, {"STEP", ", step: 0.1"}, {"10,", "1,"}});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  size_t last = 0;
  for (const char* name : {"z", "a", "m", "b", "y", "c"}) {
    const size_t at = all.find("line " + std::string(name) + " sags between the nodes");
    ASSERT_NE(at, std::string::npos) << name << "\n" << all;
    EXPECT_GE(at, last) << all;
    last = at;
  }
  const auto rows = [&](const char* file) {
    const io::h5::Id results = io::h5::open_read(path + file);
    const io::h5::Id set = io::h5::own(H5Dopen2(results, "summary", H5P_DEFAULT), H5Dclose, "summary");
    const io::h5::Id type = io::h5::own(H5Dget_type(set), H5Tclose, "summary");
    const io::h5::Id space = io::h5::own(H5Dget_space(set), H5Sclose, "summary");
    std::string bytes(H5Tget_size(type) * static_cast<size_t>(H5Sget_simple_extent_npoints(space)), ' ');
    EXPECT_GE(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), 0);
    return bytes;
  };
  EXPECT_EQ(rows("/all.h5"), rows("/one.h5"));
}

TEST_F(LongElements, SoAreLongStepsOfASnap) {
  const std::string coarse = run("4", "20", ", step: 0.25, resolve_impacts: false");
  const std::string fine = run("4", "20", ", step: 0.02");
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  EXPECT_NE(coarse.find("the largest tension of line chain ("), std::string::npos) << coarse;
  EXPECT_NE(coarse.find("is due to an impact that is not resolved: "), std::string::npos) << coarse;
  EXPECT_EQ(fine, "");
}

// Drag of 733 N instead of 2.66 kN.
TEST_F(LongElements, MissACurrentBetweenTheirNodes) {
  const std::string coarse = run(kJet, {{"ELEMENTS", "10"}});
  const std::string fine = run(kJet, {{"ELEMENTS", "200"}});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  EXPECT_NE(
      coarse.find("line cable has elements of 9.95 m at arc length 54.73 m (45 m below the still water, "
                  "t = 0 s), between whose nodes the current is not linear"),
      std::string::npos)
      << coarse;
  EXPECT_NE(coarse.find("wrong by about 71 % of their largest sum, 2.5 kN"), std::string::npos) << coarse;
  EXPECT_EQ(fine, "");
}

// Wave forces on elements of 5 m are 12 % larger than on elements of 0.5 m.
TEST_F(LongElements, MissWavesBetweenTheirNodes) {
  const std::string coarse = run(kRiser, {{"ELEMENTS", "21"}});
  const std::string fine = run(kRiser, {{"ELEMENTS", "140"}});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  EXPECT_NE(coarse.find("line pipe has elements of 5 m at arc length 97.5 m (2.5 m below the still water"),
            std::string::npos)
      << coarse;
  EXPECT_NE(coarse.find("between whose nodes the waves are not linear"), std::string::npos) << coarse;
  EXPECT_EQ(fine, "");
}

// One element of 0.1 m lies across the wire.
TEST_F(LongElements, OverAnotherLineLeaveNoBed) {
  const std::string all = run(kDrape, {});
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  EXPECT_NE(all.find("line rope turns by "), std::string::npos) << all;
  EXPECT_EQ(all.find("leaves the bed"), std::string::npos) << all;
}

// Both ends have 1 kN, because only the frictionless edge acts between them. The reported error is the true
// one.
TEST_F(LongElements, TakeTensionOverAnEdge) {
  const bool first = rank_of(MPI_COMM_WORLD) == 0;
  const auto at_end_a = [&] {  // N; 1 kN on other ranks
    if (!first) return 1000.0;
    const io::h5::Id file = io::h5::open_read(path + "/all.h5");
    return io::h5::read_array(file, "fields/effective_tension").values.front();
  };
  const std::string coarse = run(kEdge, {{"ELEMENTS", "10"}, {"STIFFNESS", "bending: false"}});
  if (first) {
    const size_t at = coarse.find(" tension there by ");
    ASSERT_NE(at, std::string::npos) << coarse;
    EXPECT_NEAR(std::stod(coarse.substr(at + 18)), 1000 - at_end_a(), 1) << coarse;
    EXPECT_GT(1000 - at_end_a(), 10);
    EXPECT_NE(coarse.find("'EI' of 10 N m² or more"), std::string::npos) << coarse;
  }
  const std::string fine = run(kEdge, {{"ELEMENTS", "808"}, {"STIFFNESS", "bending: false"}});
  EXPECT_NEAR(at_end_a(), 1000, 5);
  EXPECT_EQ(fine, "");
  const std::string beam = run(kEdge, {{"ELEMENTS", "10"}, {"STIFFNESS", "EI: 10, GJ: 10"}});
  EXPECT_NEAR(at_end_a(), 1000, 5);
  EXPECT_EQ(beam.find("over a volume"), std::string::npos) << beam;
}

}  // namespace
}  // namespace hawser::runs::long_elements
