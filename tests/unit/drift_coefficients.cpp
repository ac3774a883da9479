// Mean drift coefficients of other signs, units and periods, and slow drift without the input that it needs.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include "hawser/model/check_drift.hpp"
#include "support/spar_files.hpp"

namespace hawser::drift_coefficients_test {
namespace {

constexpr const char* kNewman = ", second_order: newman";

class DriftCoefficients : public spar_files::SparFiles {
 protected:
  // Surge and sway of waves ahead and from the sides, over rho g; heave so that there is no note of its
  // absence.
  void write_drift(double surge, double sway, const std::vector<double>& periods = {2, 5, 10, 20, 30}) {
    std::string text;
    const auto row = [&](double period, int direction, int mode, double value) {
      text += fmt::format("{0} {1} {1} {2} {3} {4} {5} 0\n", period, direction, mode, std::abs(value),
                          value < 0 ? 180 : 0, value);
    };
    for (const double period : periods)
      for (const auto& [direction, along, across] :
           {std::tuple(0, 1, 0), {90, 0, 1}, {180, -1, 0}, {270, 0, -1}}) {
        row(period, direction, 1, surge * along);
        row(period, direction, 2, sway * across);
        row(period, direction, 3, 0.01);
      }
    write(".8", text);
  }
};

TEST_F(DriftCoefficients, SignAndSize) {
  write_drift(1, 1);
  EXPECT_EQ(reported(kNewman), "");
  write_drift(-1, 1);
  expect("the mean drift force of the files in surge is against the waves at most frequencies", kNewman);
  write_drift(1, -1);
  expect("the mean drift force of the files in sway is against the waves at most frequencies", kNewman);
  write_drift(-5e-3, -5e-3);  // that of a deeply submerged body
  EXPECT_EQ(reported(kNewman), "");
  // A cube of the spar's volume has a width of 30.5 m, and a wall of this width a drift force of rho g 15.2
  // m.
  write_drift(200, 200);
  expect("is 13.1 times that of a wall of 30.5 m, the width of the body", kNewman);
  write_drift(1e4, 1e4);
  const std::string text = reported(kNewman);
  EXPECT_NE(text.find("hydrodynamics.wamit: the mean drift force of the files, 1.01e+08 N/m² at"),
            std::string::npos)
      << text;
  EXPECT_EQ(reported(), "");
}

TEST(DriftSize, SentenceNamesWamitForItsFilesOnly) {
  const model::DriftSize size{400, 1e8, 10, 30};
  model::BodyHydrodynamics h;
  EXPECT_TRUE(
      model::text_of(size, h).ends_with("divided by rho g (WAMIT), for the length scale of the case?"));
  h.format = model::BodyHydrodynamics::Format::bemio;
  EXPECT_TRUE(model::text_of(size, h).ends_with("are its values those divided by rho g?"));
}

// Frequencies in place of periods put nearly all waves beyond the file, whether first-order forces act or
// not.
TEST_F(DriftCoefficients, OtherPeriodsThanTheSea) {
  waves_ = ", waves: {jonswap: {hs: 3, tp: 11}}";
  write_drift(1, 1);
  EXPECT_EQ(reported(kNewman).find("drift forces"), std::string::npos) << reported(kNewman);
  write_drift(1, 1, {0.2, 0.6, 1.2});
  for (const char* keys : {", second_order: newman", ", second_order: newman, excitation: false"}) {
    const std::string text = reported(keys);
    EXPECT_NE(text.find("longer periods than the drift forces of the files, which end at 1.2 s: add these"),
              std::string::npos)
        << text;
  }
}

TEST_F(DriftCoefficients, MooredWithoutDriftOrDamping) {
  constexpr const char* kLine =
      "line_types: {chain: {library: chain-studless, diameter: 100 mm, grade: R4}}\nlines: {mooring: "
      "{sections: "
      "[{type: chain, length: 300, elements: 10}], end_a: {anchor: [276, 0, -100]}, end_b: {body: spar, at: "
      "[6, 0, "
      "-20]}}}\n";
  const auto has = [&](const std::string& keys, const std::string& part) {
    return reported(keys, kLine).find(part) != std::string::npos;
  };
  const std::string no_drift = "mean and slow drift do not act on this moored body, although ";
  const std::string no_damping = "slow drift excites surge and sway on the mooring at their natural periods";
  write_drift(1, 1);
  EXPECT_FALSE(has("", no_drift));  // no waves
  waves_ = ", waves: {jonswap: {hs: 3, tp: 11}}";
  EXPECT_TRUE(has("", no_drift)) << reported("", kLine);
  EXPECT_FALSE(has("", no_damping));
  EXPECT_FALSE(has(", second_order: none", no_drift));
  EXPECT_FALSE(has(kNewman, no_drift));
  EXPECT_TRUE(has(kNewman, no_damping)) << reported(kNewman, kLine);
  EXPECT_FALSE(has(", second_order: mean", no_damping));
  EXPECT_FALSE(has(", second_order: newman, quadratic_damping: [1e5, 1e5, 0, 0, 0, 0]", no_damping));
  EXPECT_EQ(reported().find(no_drift), std::string::npos);  // without lines
}

}  // namespace
}  // namespace hawser::drift_coefficients_test
