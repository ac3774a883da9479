// The smallest case, statics only, without a body, from case file to results file: tensions by the elastic
// catenary.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "hawser/base/error.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/kernels/catenary.hpp"
#include "hawser/run/driver.hpp"

namespace hawser::hanging_line_test {

TEST(HangingLine, TensionsOfTheElasticCatenary) {
  const std::string out = ::testing::TempDir() + "hanging-line.h5";
  run::RunOptions options;
  options.case_path = HAWSER_SOURCE_DIR "/cases/hanging-line/hanging-line.yaml";
  options.output = out;
  options.quiet = true;
  ASSERT_EQ(run::run(MPI_COMM_WORLD, options), 0);

  const io::h5::Id file = io::h5::open_read(out);
  const auto tension = io::h5::read_array(file, "fields/effective_tension").values;
  ASSERT_EQ(tension.size(), 41u);
  // Irvine (1981), by the closed form, which has its own tests.
  const CatenaryShape exact =
      catenary(Vec3::Zero(), Vec3(100, 0, 20), {{120, Vec3(0, 0, -980.665), 5e8, Vec3::Zero()}});
  EXPECT_NEAR(tension.front(), exact.tension_a().norm(), 5e-4 * exact.tension_a().norm());
  EXPECT_NEAR(tension.back(), exact.tension_b().norm(), 5e-4 * exact.tension_b().norm());
  for (const char* end : {".h5", ".xdmf"}) std::filesystem::remove(out.substr(0, out.size() - 3) + end);
}

// Numbers that solve the equations but are no valid result, or overflow, are rejected with one sentence.
TEST(HangingLine, NonsenseIsRefused) {
  struct Wrong {
    const char *from, *to, *sentence;
  };
  const std::string still = "statics: false\ndynamics: {duration: 1, step: 0.1}\n\nlines:";
  const std::string pulled =
      "dynamics: {duration: 5, step: 0.01}\nlines:\n  chain:\n    loads: [{at: 60, force: [0, 0, -1.0e9], "
      "ramp: 1}]\n";
  const Wrong wrong[] = {
      {"lines:", "environment: {gravity: 1.0e50}\n\nlines:", "too much for an EA of 5e+08 N"},
      {"mass_per_length: 100", "mass_per_length: 1.0e54", "too much for an EA of 5e+08 N"},
      {"mass_per_length: 100", "mass_per_length: 1.0e7", "is stretched by 1.16e+03 %"},
      {"lines:\n  chain:\n", "lines:\n  chain:\n    loads: [{at: 60, force: [0, 0, -1.0e200]}]\n",
       "'-1.0e200' is out of range; a number is 0 or between 1e-60 and 1e+60 in size"},
      {"EA: 500 MN", "EA: 1.0e18", "the tension of line chain is accurate to"},
      {"lines:", still.c_str(), nullptr},
      {"lines:\n  chain:\n", pulled.c_str(), "no line with such an EA can carry 50 %"},
  };
  std::ostringstream text;
  text << std::ifstream(HAWSER_SOURCE_DIR "/cases/hanging-line/hanging-line.yaml").rdbuf();
  const std::string file = ::testing::TempDir() + "nonsense";
  for (const Wrong& w : wrong) {
    std::string changed = text.str();
    const size_t at = changed.find(w.from);
    ASSERT_NE(at, std::string::npos);
    changed.replace(at, std::string(w.from).size(), w.to);
    std::ofstream(file + ".yaml") << changed;
    run::RunOptions options;
    options.case_path = file + ".yaml";
    options.output = file + ".h5";
    options.quiet = true;
    std::string message;
    try {
      EXPECT_EQ(run::run(MPI_COMM_WORLD, options), 0);
    } catch (const std::exception& e) {
      message = e.what();
    }
    if (w.sentence)
      EXPECT_NE(message.find(w.sentence), std::string::npos) << w.to << ": " << message;
    else
      EXPECT_EQ(message, "");
  }
  for (const char* end : {".yaml", ".h5", ".xdmf"}) std::filesystem::remove(file + end);
}

}  // namespace hawser::hanging_line_test
