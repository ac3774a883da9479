// The smallest case, statics only and without a body, from the case file to the results file.
#include <gtest/gtest.h>

#include <filesystem>

#include "hawser/app/driver.hpp"
#include "hawser/io/hdf5.hpp"
#include "hawser/kernels/catenary.hpp"

namespace hawser::hanging_line_test {

TEST(HangingLine, TensionsOfTheElasticCatenary) {
  const std::string out = ::testing::TempDir() + "hanging-line.h5";
  app::RunOptions options;
  options.case_path = HAWSER_SOURCE_DIR "/cases/hanging-line/hanging-line.yaml";
  options.output = out;
  options.quiet = true;
  ASSERT_EQ(app::run(MPI_COMM_WORLD, options), 0);

  const io::h5::Id file = io::h5::open_read(out);
  const auto tension = io::h5::read_array(file, "fields/effective_tension").values;
  ASSERT_EQ(tension.size(), 41u);
  // Irvine (1981), by the closed form that has its own tests.
  const CatenaryShape exact =
      catenary(Vec3::Zero(), Vec3(100, 0, 20), {{120, Vec3(0, 0, -980.665), 5e8, Vec3::Zero()}});
  EXPECT_NEAR(tension.front(), exact.tension_a().norm(), 5e-4 * exact.tension_a().norm());
  EXPECT_NEAR(tension.back(), exact.tension_b().norm(), 5e-4 * exact.tension_b().norm());
  for (const char* end : {".h5", ".xdmf"}) std::filesystem::remove(out.substr(0, out.size() - 3) + end);
}

}  // namespace hawser::hanging_line_test
