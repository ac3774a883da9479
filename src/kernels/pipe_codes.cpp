// Formulas of pipe codes, with the symbols of docs/theory/pipe-codes.md.
#include "hawser/kernels/pipe_codes.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

constexpr double kResistance = 1.15;    // gamma_m
constexpr double kRelieving = 1 / 1.1;  // functional factor where functional loads reduce the sum
// Combinations a (system) and b (local), table 4-4.
struct Combination {
  double functional, environmental;
};
constexpr Combination kCombinations[] = {{1.2, 0.7}, {1.1, 1.3}};
constexpr double kMinOvality = 0.005;

double elastic_collapse(const PipeSteel& s) {
  return 2 * s.modulus * std::pow(s.wall / s.outer, 3) / (1 - s.poisson * s.poisson);
}

// Smallest positive root of (p - p_el)(p² - p_p²) = p p_el p_p f_0 D/t: the difference of the sides decreases
// from p_el p_p² at 0 to a negative value at the smaller of p_el and p_p.
double collapse_pressure(const PipeSteel& s) {
  const double elastic = elastic_collapse(s);
  const double plastic = 2 * s.smys * s.material_factor * s.fabrication * s.wall / s.outer;
  const double oval = std::max(s.ovality, kMinOvality) * s.outer / s.wall;
  double low = 0;
  double high = std::min(elastic, plastic);
  for (int k = 0; k < 100; ++k) {
    const double p = 0.5 * (low + high);
    ((p - elastic) * (p * p - plastic * plastic) > p * elastic * plastic * oval ? low : high) = p;
  }
  return 0.5 * (low + high);
}

// The utilisation increases with each load's magnitude, so the larger of both functional factors governs.
double larger(const Combination& c, double condition, const auto& size) {
  return std::max(size(c.functional * condition, c.environmental),
                  size(kRelieving * condition, c.environmental));
}

PipeDesign design(const Combination& c, const PipeLoads& rest, const PipeLoads& now, double condition) {
  const auto sum = [](double functional, double environmental, double rest_, double now_) {
    return functional * rest_ + environmental * (now_ - rest_);
  };
  return {larger(c, condition,
                 [&](double f, double e) {
                   return std::hypot(sum(f, e, rest.moment_2, now.moment_2),
                                     sum(f, e, rest.moment_3, now.moment_3));
                 }),
          larger(c, condition,
                 [&](double f, double e) { return std::abs(sum(f, e, rest.tension, now.tension)); })};
}

}  // namespace

PipeCodes::PipeCodes(const PipeSteel& s) : steel_(s), factor_(kResistance * s.safety_class) {
  const double yields = s.material_factor * s.smys;
  const double breaks = s.material_factor * s.smts;
  const double mean = s.outer - s.wall;
  const double inner = s.outer - 2 * s.wall;
  hardening_ = std::clamp((60 - s.slenderness()) / 90, 0.0, 0.5);
  flow_ = 1 - hardening_ + hardening_ * breaks / yields;
  moment_ = yields * mean * mean * s.wall;
  tension_ = M_PI * yields * mean * s.wall;
  burst_ = 2 * s.wall / mean * std::min(yields, breaks / 1.15) * 2 / std::sqrt(3.0);
  collapse_ = collapse_pressure(s);
  const double yield_pressure = 2 * s.smys * s.wall / s.outer;
  const double elastic = elastic_collapse(s);
  api_collapse_ = yield_pressure * elastic / std::hypot(yield_pressure, elastic);
  api_burst_ = 0.45 * (s.smys + s.smts) * std::log(s.outer / inner);
  api_yield_ = s.smys * M_PI / 4 * (s.outer * s.outer - inner * inner);
}

double PipeCodes::local_buckling(const PipeDesign& loads, double outside, double inside) const {
  const double pulled = factor_ * loads.tension / (flow_ * tension_);
  const double bent = factor_ * loads.moment / (flow_ * moment_) + pulled * pulled;
  const double overpressure = (inside - outside) / burst_;
  const double weaker =
      overpressure < 2.0 / 3 ? 1 - hardening_ : 1 - 3 * hardening_ * (1 - overpressure);  // alpha_p
  const double pressed =
      overpressure > 0 ? weaker * overpressure / flow_ : factor_ * (outside - inside) / collapse_;
  return bent * bent + pressed * pressed;
}

double PipeCodes::local_buckling(const PipeLoads& rest, const PipeLoads& now, double condition,
                                 double outside, double inside) const {
  double worst = 0;
  for (const Combination& c : kCombinations)
    worst = std::max(worst, local_buckling(design(c, rest, now, condition), outside, inside));
  return worst;
}

double PipeCodes::pulled(const PipeLoads& rest, const PipeLoads& now, double condition) const {
  double largest = 0;
  for (const Combination& c : kCombinations)
    largest = std::max(largest, design(c, rest, now, condition).tension / tension_);
  return largest;
}

double PipeCodes::bending_and_pressure(double strain, double outside, double inside) const {
  constexpr double kInstallation = 3.33;                            // f_1
  const double collapse_factor = steel_.cold_expanded ? 0.6 : 0.7;  // f_o
  const double g = 1 / (1 + 10 * steel_.ovality);                   // the code's ovality is half of DNV's
  return kInstallation * strain * 2 * steel_.slenderness() / g +
         std::max(outside - inside, 0.0) / (collapse_factor * api_collapse_);
}

double PipeCodes::tension_and_pressure(double tension, double outside, double inside) const {
  const double pulled = std::abs(tension) / api_yield_;
  return std::max(std::hypot((inside - outside) / api_burst_, pulled) / 0.9, pulled / 0.6);
}

}  // namespace hawser
