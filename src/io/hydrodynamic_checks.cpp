// Checks of added mass and damping: impossible and implausible values.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/advice/hydrodynamic_files.hpp"
#include "hawser/kernels/radiation_memory.hpp"
#include "hydrodynamic_parts.hpp"

namespace hawser::io {
namespace {

using model::HydrodynamicData;

// Largest magnitude of each diagonal entry of added mass.
Eigen::VectorXd largest_diagonal(const HydrodynamicData& data) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(6 * data.bodies);
  for (const Eigen::MatrixXd& A : data.added_mass) largest = largest.cwiseMax(A.diagonal().cwiseAbs());
  return largest;
}

// At infinite frequency the water moves with the body and the added mass is nonnegative. At single
// frequencies it may be negative (a moonpool, a gap between hulls), but not on average.
void check_sign(const HydrodynamicData& data, const Eigen::VectorXd& scale) {
  constexpr double kNoise = 0.02;
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    double mean = 0;
    for (const Eigen::MatrixXd& A : data.added_mass) mean += A(i, i) / static_cast<double>(data.omega.size());
    const bool at_infinity = data.infinite(i, i) < -kNoise * scale[i];
    if (at_infinity || mean < -kNoise * scale[i])
      throw std::runtime_error(fmt::format(
          "{}: added mass of {} {} is negative, {:.4g}: no body can have that; does the file have the other "
          "sign?",
          data.radiation_file, advice::modes_text(static_cast<int>(i), static_cast<int>(i)),
          at_infinity ? "at infinite frequency" : "on average", at_infinity ? data.infinite(i, i) : mean));
  }
}

// Added mass tends to its value at omega = 0 in long waves and to that at infinite frequency in short waves.
// If the file has both and they fit the opposite ends, it is refused; one alone may fit by chance.
void check_limits(const HydrodynamicData& data, bool has_infinite, const Eigen::MatrixXd& zero_frequency,
                  const Eigen::VectorXd& scale, std::vector<std::string>& notes) {
  const bool has_zero = zero_frequency.size() > 0;
  double straight = 0, crossed = 0;
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    if (!(scale[i] > 0)) continue;
    const double longest = data.added_mass.front()(i, i);
    const double shortest = data.added_mass.back()(i, i);
    if (has_zero) {
      straight += std::abs(longest - zero_frequency(i, i)) / scale[i];
      crossed += std::abs(shortest - zero_frequency(i, i)) / scale[i];
    }
    if (has_infinite) {
      straight += std::abs(shortest - data.infinite(i, i)) / scale[i];
      crossed += std::abs(longest - data.infinite(i, i)) / scale[i];
    }
  }
  constexpr double kClear = 0.1;
  if (!(straight > kClear && crossed < 0.5 * straight)) return;
  const std::string text = advice::frequency_limits_swapped(data.radiation_file);
  if (has_zero && has_infinite) throw std::runtime_error(text);
  notes.push_back(text);
}

// Root of the mean square of the differences from `reference`.
double deviation(const std::vector<double>& x, double reference) {
  double sum = 0;
  for (const double value : x) sum += (value - reference) * (value - reference);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

double mean(const std::vector<double>& x) {
  double sum = 0;
  for (const double value : x) sum += value;
  return sum / static_cast<double>(x.size());
}

// Sums over the diagonal entries that vary with frequency, relative to the largest added mass of each entry:
// deviation of the added mass from its mean, and deviations of the values at infinite frequency that
// Ogilvie's relation yields from each row, from their mean and from the value of the file.
struct OgilvieSpread {
  double added = 0, about_mean = 0, about_file = 0;
  size_t rows = 0;  // number of frequencies
};

// Computed with the damping multiplied by a power of omega.
OgilvieSpread ogilvie_spread(const HydrodynamicData& data, bool has_infinite, const Eigen::VectorXd& scale,
                             double power) {
  constexpr size_t kRows = 60;
  constexpr double kInside = 0.6, kVaries = 0.1;
  Eigen::MatrixXd damping(std::ssize(data.omega), scale.size());
  for (Eigen::Index k = 0; k < damping.rows(); ++k) {
    const auto row = static_cast<size_t>(k);
    damping.row(k) = std::pow(data.omega[row], power) * data.damping[row].diagonal().transpose();
  }
  std::vector<size_t> rows;
  std::vector<Eigen::RowVectorXd> above_infinite;
  for (size_t k = 0; k < data.omega.size(); k += std::max<size_t>(1, data.omega.size() / kRows)) {
    if (data.omega[k] > kInside * data.omega.back()) break;
    rows.push_back(k);
    above_infinite.push_back(added_mass_by_damping(data.omega, damping, data.omega[k]));
  }
  OgilvieSpread out;
  out.rows = rows.size();
  if (rows.size() < 3) return out;
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    if (!(scale[i] > 0)) continue;
    std::vector<double> infinite, added;
    for (size_t r = 0; r < rows.size(); ++r) {
      added.push_back(data.added_mass[rows[r]](i, i) / scale[i]);
      infinite.push_back(added.back() - above_infinite[r][i] / scale[i]);
    }
    const double middle = mean(infinite);
    const double of_added = deviation(added, mean(added));
    if (of_added < kVaries * std::abs(mean(added))) continue;
    out.added += of_added;
    out.about_mean += deviation(infinite, middle);
    out.about_file += deviation(infinite, has_infinite ? data.infinite(i, i) / scale[i] : middle);
  }
  return out;
}

// By Ogilvie's relation each row yields the added mass at infinite frequency; all rows must agree. With
// damping that is divided by omega once too often or not at all, they agree better after its correction. The
// mean of the rows is compared then, since the value of the file differs from it if the table ends early.
void check_ogilvie(const HydrodynamicData& data, bool has_infinite, const Eigen::VectorXd& scale,
                   std::vector<std::string>& notes) {
  constexpr double kApart = 0.5;
  constexpr double kBetter = 0.5;
  constexpr size_t kMinRows = 6;  // with fewer rows the integral over B is too coarse to compare powers
  const OgilvieSpread given = ogilvie_spread(data, has_infinite, scale, 0);
  for (const double power : {1.0, -1.0}) {
    if (given.rows < kMinRows) break;
    const OgilvieSpread other = ogilvie_spread(data, has_infinite, scale, power);
    if (!(other.about_mean < kBetter * given.about_mean)) continue;
    notes.push_back(
        advice::damping_over_frequency(data.radiation_file, power > 0, given.about_mean / other.about_mean));
    return;
  }
  if (given.about_file > kApart * given.added)
    notes.push_back(advice::added_mass_not_of_damping(data.radiation_file, given.about_file / given.added));
}

// Deviation of each value from linear interpolation between its neighbours, 0 if it lies between them; 0 for
// the first and the last.
std::vector<double> off_line(const HydrodynamicData& data, const std::vector<Eigen::MatrixXd>& matrices,
                             Eigen::Index i, Eigen::Index j) {
  std::vector<double> off(data.omega.size(), 0);
  for (size_t k = 1; k + 1 < off.size(); ++k) {
    const double fraction = (data.omega[k] - data.omega[k - 1]) / (data.omega[k + 1] - data.omega[k - 1]);
    const double before = matrices[k - 1](i, j);
    const double value = matrices[k](i, j);
    const double after = matrices[k + 1](i, j);
    if (value > std::max(before, after) || value < std::min(before, after))
      off[k] = std::abs(value - (1 - fraction) * before - fraction * after);
  }
  return off;
}

// Notes a single value far from its neighbours in an otherwise smooth series.
void note_wild(const HydrodynamicData& data, const std::vector<Eigen::MatrixXd>& matrices,
               const char* quantity, std::vector<std::string>& notes) {
  // Fraction of the diagonal. Well-resolved peaks of semi-submersibles deviate by a tenth.
  constexpr double kFar = 0.3, kTimes = 4;
  if (data.omega.size() < 8) return;
  Eigen::VectorXd scale = Eigen::VectorXd::Zero(6 * data.bodies);
  for (const Eigen::MatrixXd& m : matrices) scale = scale.cwiseMax(m.diagonal().cwiseAbs());
  int count = 0;
  double largest = 0;
  advice::IsolatedValue wild;
  for (Eigen::Index i = 0; i < scale.size(); ++i)
    for (Eigen::Index j = i; j < scale.size(); ++j) {
      const double size = std::sqrt(scale[i] * scale[j]);
      const std::vector<double> off = off_line(data, matrices, i, j);
      const auto worst = static_cast<size_t>(std::max_element(off.begin(), off.end()) - off.begin());
      if (!(off[worst] > kFar * size)) continue;
      double next = 0;
      for (size_t k = 1; k + 1 < off.size(); ++k)
        if (k + 1 < worst || k > worst + 1) next = std::max(next, off[k]);
      if (off[worst] < kTimes * next) continue;
      ++count;
      if (off[worst] < largest * size) continue;
      largest = off[worst] / size;
      wild = {.quantity = quantity,
              .i = static_cast<int>(i),
              .j = static_cast<int>(j),
              .period = 2 * M_PI / data.omega[worst],
              .value = matrices[worst](i, j),
              .at_shorter = matrices[worst + 1](i, j),
              .at_longer = matrices[worst - 1](i, j)};
    }
  if (count > 0) notes.push_back(advice::far_from_neighbours(data.radiation_file, wild, count - 1));
}

}  // namespace

void check_coefficients(const HydrodynamicData& data, bool has_infinite,
                        const Eigen::MatrixXd& zero_frequency, std::vector<std::string>& notes) {
  const Eigen::VectorXd scale = largest_diagonal(data);
  check_sign(data, scale);
  check_limits(data, has_infinite, zero_frequency, scale, notes);
  check_ogilvie(data, has_infinite, scale, notes);
  note_wild(data, data.added_mass, "added mass", notes);
  note_wild(data, data.damping, "damping", notes);
}

}  // namespace hawser::io
