// Coefficient files of the tutorial's spar, changed in one place, and what is reported of them.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/model/check.hpp"

namespace hawser::spar_files {

using Row = std::vector<double>;
using Change = std::function<void(std::vector<Row>&)>;

// The set with the rows of one file changed by `change`: the sentence of the refusal, or all notes.
class SparFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / "hawser_spar_files" / test->test_suite_name() /
              test->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    for (const char* ending : {".1", ".3", ".hst"}) with(ending, [](auto&) {});
  }
  static std::vector<Row> rows_of(const std::string& ending) {
    std::ifstream file(HAWSER_SOURCE_DIR "/docs/tutorial/spar" + ending);
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
      std::istringstream in(line);
      rows.emplace_back();
      for (double x = 0; in >> x;) rows.back().push_back(x);
    }
    return rows;
  }
  void write(const std::string& ending, const std::string& text) {
    std::ofstream((folder_ / "spar").string() + ending) << text;
  }
  void with(const std::string& ending, const Change& change) {
    std::vector<Row> rows = rows_of(ending);
    change(rows);
    std::string text;
    for (const Row& r : rows) text += fmt::format("{:.10g}\n", fmt::join(r, " "));
    write(ending, text);
  }
  std::string reported(const std::string& keys = "", const std::string& rest = "",
                       const std::vector<std::string>& bodies = {"spar"}) {
    std::string text = "hawser: 1\nenvironment: {gravity: 9.80665, water: {density: 1025, depth: 200}" +
                       waves_ + "}\nbodies:\n";
    for (const std::string& name : bodies)
      text += "  " + name +
              ": {floating: {mass: 2.8981e7, centre_of_mass: [0, 0, -50], inertia: [2e10, 2e10, 1e9], "
              "hydrodynamics: {wamit: " +
              (folder_ / "spar").string() + keys + "}}}\n";
    text += "statics: false\ndynamics: {duration: 20}\n" + rest;
    try {
      const model::Case c = io::read_case_text(text, "spar.yaml", {}, MPI_COMM_SELF);
      std::string out;
      for (const model::Issue& i : model::check(c)) out += i.text + "\n";
      for (const std::string& n : c.notes) out += n + "\n";
      return out;
    } catch (const std::exception& e) {
      return e.what();
    }
  }
  // Expects one sentence that contains `part`.
  void expect(const std::string& part, const std::string& keys = "", const std::string& rest = "") {
    const std::string text = reported(keys, rest);
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 1) << text;
    for (const char* ending : {".1", ".3", ".hst"}) with(ending, [](auto&) {});
  }

  std::string waves_;  // of the environment
  std::filesystem::path folder_;
};

}  // namespace hawser::spar_files
