// main of every test program. --file=SUBJECT,... runs the tests of the files SUBJECT.*cpp. PETSc and MPI are
// initialised before the first test; ranks above 0 do not print; a failure on any rank is a failure of the
// program. testing::TempDir() is a new folder, the same on all ranks, which is removed when the tests have
// ended; TEST_TMPDIR gives another folder, as for a program that a test starts.
#include <gtest/gtest.h>
#include <petscsys.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "hawser/base/singleton.hpp"

namespace {

// Selects the tests of the source files with these subjects: "joints,events" selects joints.np1_2_3.cpp and
// events.np1_2.cpp.
void choose_files(const std::string& subjects) {
  const ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
  std::string filter;
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const ::testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k) {
      const ::testing::TestInfo& test = *suite.GetTestInfo(k);
      const std::string file = std::filesystem::path(test.file()).filename().string();
      if (("," + subjects + ",").find("," + file.substr(0, file.find('.')) + ",") != std::string::npos)
        filter += std::string(suite.name()) + "." + test.name() + ":";
    }
  }
  if (filter.empty()) throw std::runtime_error("no test of the files " + subjects);
  GTEST_FLAG_SET(filter, filter);
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--gtest_list_tests") {
      ::testing::InitGoogleTest(&argc, argv);
      return RUN_ALL_TESTS();
    }
  ::testing::InitGoogleTest(&argc, argv);
  for (int i = 1; i < argc; ++i)
    if (const std::string argument = argv[i]; argument.starts_with("--file="))
      choose_files(argument.substr(7));
  hawser::start_singleton();
  if (PetscInitialize(&argc, &argv, nullptr, nullptr)) return 1;
  int rank = 0;
  MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
  if (rank > 0) {
    auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
  }
  std::string folder = (std::filesystem::temp_directory_path() / "hawser-test-XXXXXX").string();
  const bool own = !std::getenv("TEST_TMPDIR");
  if (own && rank == 0 && !mkdtemp(folder.data())) throw std::runtime_error("cannot make " + folder);
  MPI_Bcast(folder.data(), static_cast<int>(folder.size()), MPI_CHAR, 0, PETSC_COMM_WORLD);
  setenv("TEST_TMPDIR", folder.c_str(), 0);
  int bad = RUN_ALL_TESTS();
  MPI_Allreduce(MPI_IN_PLACE, &bad, 1, MPI_INT, MPI_MAX, PETSC_COMM_WORLD);
  if (std::error_code error; own && rank == 0) std::filesystem::remove_all(folder, error);
  PetscFinalize();
  return bad;
}
