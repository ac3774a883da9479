// Any mutation of a case file gives a case or a one-sentence message.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "hawser/base/error.hpp"
#include "hawser/io/case_reader.hpp"

namespace hawser::case_fuzz_test {
namespace {

namespace fs = std::filesystem;

std::string mutate(std::string s, std::mt19937& random) {
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  const std::string special = ":{}[],-&*!|>'\"%@`#?\n\t \\.~<=0e+";
  const std::size_t times = 1 + below(4);
  for (std::size_t t = 0; t < times && !s.empty(); ++t) {
    const std::size_t at = below(s.size());
    switch (below(7)) {
      case 0:
        s.resize(at);
        break;
      case 1:
        s[at] = static_cast<char>(below(256));
        break;
      case 2:
        s[at] = special[below(special.size())];
        break;
      case 3:
        s.insert(at, 1, special[below(special.size())]);
        break;
      case 4:
        s.erase(at, 1 + below(20));
        break;
      case 5:
        s.insert(below(s.size()), s.substr(at, 1 + below(60)));
        break;
      default:
        s.erase(at, 1);
        break;
    }
  }
  return s;
}

TEST(CaseFuzz, MutatedReelIsACaseOrASentence) {
  std::ifstream in(HAWSER_SOURCE_DIR "/cases/reel/reel.yaml");
  std::ostringstream original;
  original << in.rdbuf();
  ASSERT_GT(original.str().size(), 1000U);

  // A small closed mesh replaces the drum to speed up 2000 readings.
  const fs::path folder = fs::path(testing::TempDir()) / "hawser_fuzz";
  fs::create_directories(folder);
  std::ofstream(folder / "drum.stl")
      << "solid t\n"
         "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 9 0 vertex 9 0 0 endloop "
         "endfacet\n"
         "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 9 0 0 vertex 0 0 9 endloop "
         "endfacet\n"
         "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 9 vertex 0 9 0 endloop "
         "endfacet\n"
         "facet normal 0 0 0 outer loop vertex 9 0 0 vertex 0 9 0 vertex 0 0 9 endloop "
         "endfacet\nendsolid t\n";
  const std::string path = (folder / "reel.yaml").string();
  ASSERT_NO_THROW(io::read_case_text(original.str(), path));

  std::mt19937 random(20061);
  int accepted = 0, refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = mutate(original.str(), random);
    try {
      io::read_case_text(text, path);
      ++accepted;
    } catch (const InputError& e) {
      const std::string message = e.what();
      ++refused;
      ASSERT_TRUE(message.starts_with(path)) << message;
      ASSERT_EQ(message.find('\n'), std::string::npos) << message;
    } catch (const std::exception& e) {
      FAIL() << "mutation " << i << ": " << e.what() << "\n" << text;
    }
  }
  // Both must occur for the mutations to be a test.
  EXPECT_GT(accepted, 100);
  EXPECT_GT(refused, 500);
}

TEST(CaseFuzz, EveryTruncationOfTheReel) {
  std::ifstream in(HAWSER_SOURCE_DIR "/cases/reel/reel.yaml");
  std::ostringstream all;
  all << in.rdbuf();
  const std::string path = (fs::path(testing::TempDir()) / "hawser_fuzz" / "reel.yaml").string();
  for (std::size_t n = 0; n < all.str().size(); n += 7) {
    try {
      io::read_case_text(all.str().substr(0, n), path);
    } catch (const InputError&) {
    } catch (const std::exception& e) {
      FAIL() << "the first " << n << " bytes: " << e.what();
    }
  }
}

}  // namespace
}  // namespace hawser::case_fuzz_test
