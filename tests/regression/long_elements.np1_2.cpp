// Whole runs with elements and steps that are too long, and what they are told, on any number of ranks.
#include "hawser/io/hdf5.hpp"
#include "regression/runs.hpp"

namespace hawser::runs::long_elements {
namespace {

// A chain from the bed to a fairlead that heaves until it snaps taut.
const char* const kChain = R"(hawser: 1
environment: {water: {depth: 50}, seabed: {depth: 50, friction: 0.5}}
line_types:
  chain: {outer_diameter: 0.252, mass_per_length: 390, EA: 1.674 GN, bending: false, Cd_normal: 1.37}
bodies:
  vessel: {motion: {harmonic: {amplitude: [0, 0, HEAVE], period: 4}, ramp: 4}}
lines:
  chain:
    sections: [{type: chain, length: 130.72, elements: ELEMENTS}]
    end_a: {anchor: [120, 0, -50]}
    end_b: {body: vessel, at: [0, 0, 0]}
dynamics: {duration: 10STEP}
output: {every: 1}
)";

std::string told(const std::string& path) {
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
  std::string run(const std::string& heave, const std::string& elements, const std::string& step) {
    const std::string input = path + "/case.yaml";
    write_case(input, kChain, {{"HEAVE", heave}, {"ELEMENTS", elements}, {"STEP", step}});
    run_on_all({input, path + "/all.h5"});
    run_on_one({input, path + "/one.h5"});
    if (rank_of(MPI_COMM_WORLD) != 0) return "";
    const std::string all = told(path + "/all.h5");
    EXPECT_EQ(all, told(path + "/one.h5"));
    return all;
  }
};

TEST_F(LongElements, AreTold) {
  const std::string coarse = run("0.5", "4", ""), fine = run("0.5", "30", "");
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  EXPECT_NE(coarse.find("line chain sags between the nodes of its elements of 32.7 m"), std::string::npos)
      << coarse;
  EXPECT_EQ(fine, "");
}

TEST_F(LongElements, SoAreLongStepsOfASnap) {
  const std::string coarse = run("4", "20", ", step: 0.25"), fine = run("4", "20", ", step: 0.02");
  if (rank_of(MPI_COMM_WORLD) != 0) return;
  EXPECT_NE(coarse.find("the largest tension of line chain ("), std::string::npos) << coarse;
  EXPECT_NE(coarse.find("is that of a blow which is not resolved: "), std::string::npos) << coarse;
  EXPECT_EQ(fine, "");
}

}  // namespace
}  // namespace hawser::runs::long_elements
