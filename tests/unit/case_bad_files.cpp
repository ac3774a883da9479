// Each file of tests/data/bad has one mistake; its first line gives the expected message.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"
#include "hawser/run/volumes.hpp"

namespace hawser::case_bad_files_test {
namespace {

namespace fs = std::filesystem;

const std::string kFolder = HAWSER_SOURCE_DIR "/tests/data/bad/";

std::vector<std::string> bad_files() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kFolder))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string message_of(const std::string& path) {
  try {
    run::load_volumes(io::read_case(path));
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

class BadFile : public testing::TestWithParam<std::string> {};

TEST_P(BadFile, IsRefusedWithOneSentence) {
  const std::string path = kFolder + GetParam() + ".yaml";
  std::ifstream in(path);
  std::string expected;
  std::getline(in, expected);
  const std::string mark = "# expect: ";
  ASSERT_TRUE(expected.starts_with(mark)) << path;
  expected = expected.substr(mark.size());
  ASSERT_GE(expected.size(), 10U) << path;

  std::string message = message_of(path);
  ASSERT_FALSE(message.empty()) << "was accepted";
  EXPECT_TRUE(std::regex_search(message, std::regex(GetParam() + "\\.yaml:[0-9]+: "))) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  // Messages name files by their absolute paths; expectations don't.
  for (std::size_t at = 0; (at = message.find(kFolder, at)) != std::string::npos;)
    message.erase(at, kFolder.size());
  EXPECT_NE(message.find(expected), std::string::npos)
      << "message:  " << message << "\nexpected: " << expected;
}

INSTANTIATE_TEST_SUITE_P(Case, BadFile, testing::ValuesIn(bad_files()),
                         [](const testing::TestParamInfo<std::string>& p) { return p.param; });

TEST(CaseBadFiles, AreManyAndTheirBaseIsAccepted) {
  EXPECT_GE(bad_files().size(), 100U);
  EXPECT_EQ(message_of(kFolder + "base.yml"), "");
}

TEST(CaseBadFiles, FilesThatCannotBeRead) {
  EXPECT_NE(message_of(kFolder + "nowhere.yaml").find("nowhere.yaml: there is no such case file"),
            std::string::npos);
  EXPECT_NE(message_of(kFolder).find("is a directory, not a case file"), std::string::npos);
  const fs::path empty = fs::path(testing::TempDir()) / "hawser_empty.yaml";
  std::ofstream(empty).close();
  EXPECT_NE(message_of(empty.string()).find("hawser_empty.yaml:1: the file is empty"), std::string::npos);
}

}  // namespace
}  // namespace hawser::case_bad_files_test
