// `temperature_change` of a line: reading of the key, and free strain of the elements.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "hawser/io/case_reader.hpp"
#include "hawser/mesh/mesh.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/summary.hpp"

namespace hawser::temperature_change_test {
namespace {

using Rows = std::vector<std::pair<double, double>>;

model::Case read(const std::string& change, const std::string& expansion = "1e-5") {
  return io::read_case_text(R"(hawser: 1
environment: {gravity: 9.81}
line_types:
  cold: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, EI: 1e4, GJ: 1e4}
  pipe: {outer_diameter: 0.2, mass_per_length: 50, EA: 1e8, bending: false, thermal_expansion: )" +
                                expansion + R"(}
lines:
  a:
    sections: [{type: cold, length: 20, elements: 2}, {type: pipe, length: 80, elements: 4, grading: 3}]
    end_a: {anchor: [0, 0, 0]}
    end_b: free
    temperature_change: )" + change +
                                "\n",
                            HAWSER_SOURCE_DIR "/tests/temperature_change.yaml");
}

Rows rows_of(const std::string& change) { return read(change).lines[0].temperature_change; }

TEST(TemperatureChange, IsReadInKelvinAndAlongTheLine) {
  EXPECT_EQ(rows_of("60"), (Rows{{0, 60}}));
  EXPECT_EQ(rows_of("60 K"), (Rows{{0, 60}}));
  EXPECT_EQ(rows_of("-60 degC"), (Rows{{0, -60}}));
  EXPECT_EQ(rows_of("0"), Rows{});
  EXPECT_EQ(rows_of("[[10, 60], [50, -20], [100, 0]]"), (Rows{{10, 60}, {50, -20}, {100, 0}}));
  for (const char* unit : {"", " 1/K", " 1/degC", " 1/°C"})
    EXPECT_EQ(read("60", std::string("1.17e-5") + unit).line_type("pipe").thermal_expansion, 1.17e-5);
  EXPECT_EQ(read("60").line_type("cold").thermal_expansion, 0);
}

// Temperature is linear between the rows and constant beyond: 60 K up to 10 m, -20 K at 50 m, zero from 90 m
// on.
TEST(TemperatureChange, MeanIsTheIntegral) {
  const model::Line line = read("[[10, 60], [50, -20], [90, 0]]").lines[0];
  const auto mean = [&](double from, double to) { return model::mean_temperature_change(line, from, to); };
  EXPECT_DOUBLE_EQ(mean(0, 10), 60);
  EXPECT_DOUBLE_EQ(mean(0, 20), (600 + 500) / 20.0);
  EXPECT_DOUBLE_EQ(mean(20, 30), 30);
  EXPECT_DOUBLE_EQ(mean(10, 50), 20);
  EXPECT_DOUBLE_EQ(mean(0, 100), (600 + 800 - 400) / 100.0);
  EXPECT_DOUBLE_EQ(mean(95, 100), 0);
  EXPECT_DOUBLE_EQ(mean(30, 30), 20);
  EXPECT_EQ(model::mean_temperature_change(read("-7").lines[0], 3, 40), -7);
  EXPECT_EQ(model::mean_temperature_change(read("0").lines[0], 3, 40), 0);
}

// The total elongation is independent of element boundaries; a type without expansion has none.
TEST(TemperatureChange, ElementsAddUp) {
  const model::Case c = read("[[10, 60], [50, -20], [90, 0]]");
  const Mesh mesh = build_mesh(c);
  double sum = 0;
  for (int i = 0; i < mesh.elements(); ++i) {
    const Element e = mesh.element(i);
    EXPECT_EQ(e.free_strain != 0, !e.beam);
    sum += e.free_strain * e.length;
  }
  EXPECT_NEAR(sum, 1e-5 * (400 - 100 - 400), 1e-15);
  EXPECT_NEAR(model::expansion_of(c, c.lines[0]), sum, 1e-15);
}

TEST(TemperatureChange, IsInTheSummary) {
  for (const auto& [change, expansion, text] :
       {std::tuple{"60", "1e-5", "warmer by 60 K, 0.048 m longer without tension"},
        std::tuple{"-60", "1e-5", "colder by 60 K, 0.048 m shorter without tension"},
        std::tuple{"60", "-1e-5", "warmer by 60 K, 0.048 m shorter without tension"},
        std::tuple{"[[0, -60], [100, 0]]", "1e-5", "colder by 0 to 60 K, 0.0192 m shorter without tension"},
        std::tuple{"[[0, 0], [100, 60]]", "1e-5", "warmer by 0 to 60 K, 0.0288 m longer without tension"},
        std::tuple{"[[0, -20], [100, 60]]", "1e-5", "warmer by -20 to 60 K"}}) {
    const std::string s = model::summary(read(change, expansion));
    EXPECT_NE(s.find(text), std::string::npos) << text << "\n" << s;
  }
  EXPECT_EQ(model::summary(read("0")).find("without tension"), std::string::npos);
}

}  // namespace
}  // namespace hawser::temperature_change_test
