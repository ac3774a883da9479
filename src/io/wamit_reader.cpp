// Reader of WAMIT's files: required rows, and scaling by length, density and gravity to SI units.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <string_view>

#include "hawser/advice/hydrodynamic_files.hpp"
#include "hydrodynamic_parts.hpp"
#include "number_table.hpp"

namespace hawser::io {
namespace {

using model::HydrodynamicData;

constexpr int kMostBodies = 20;

[[noreturn]] void refuse(const NumberTable& table, const NumberRow& row, const std::string& text) {
  throw std::runtime_error(fmt::format("{}:{}: {}", table.path, row.line, text));
}

// A mode number of the file, from 1, as an index from 0.
int mode_of(const NumberTable& table, const NumberRow& row, size_t column, int modes) {
  const double mode = row.values[column];
  if (mode != std::floor(mode) || mode < 1 || mode > modes)
    refuse(table, row,
           fmt::format("{:g} is no mode of motion: it is a whole number from 1 to {}", mode, modes));
  return static_cast<int>(mode) - 1;
}

// False for WAMIT's periods 0 (infinite frequency) and -1 (zero frequency); refuses other negative periods.
bool is_wave(const NumberTable& table, const NumberRow& row) {
  const double period = row.values[0];
  if (period < 0 && period != -1)
    refuse(
        table, row,
        fmt::format("the period is {:g} s: it is above 0 s, or 0 (infinite frequency) or -1 (zero frequency)",
                    period));
  return period > 0;
}

NumberTable table_of(const std::string& stem, const char* ending, const std::vector<size_t>& columns,
                     std::vector<std::string>& read) {
  NumberTable table = read_number_table(stem + ending, columns);
  if (!table.path.empty()) read.push_back(table.path);
  return table;
}

NumberTable required(const std::string& stem, const char* ending, const std::vector<size_t>& columns,
                     const char* quantity, std::vector<std::string>& read) {
  NumberTable table = table_of(stem, ending, columns, read);
  if (table.path.empty())
    throw std::runtime_error(
        fmt::format("{}{}: there is no such file, which has {}; 'wamit' is the path of WAMIT's files without "
                    "their endings",
                    stem, ending, quantity));
  return table;
}

// Refuses a row that gives an entry again with another value. scale: size of the entries, as the values;
// cause: of the difference, as a question.
void check_again(const NumberTable& table, const NumberRow& row, Complex before, Complex value, double scale,
                 const char* cause = "are these rows of two runs?") {
  constexpr double kRounded = 0.01, kSmall = 1e-3;
  if (std::abs(value - before) <= std::max(kRounded * std::abs(before), kSmall * scale)) return;
  const auto text = [](Complex z) {
    return z.imag() == 0 ? fmt::format("{:.5g}", z.real())
                         : fmt::format("({:.5g}, {:.5g})", z.real(), z.imag());
  };
  refuse(table, row,
         fmt::format("gives {} for an entry that the file has already as {} (in SI units): {}", text(value),
                     text(before), cause));
}

// Diagonal entries but yaw's are clearly above the noise of entries that symmetry makes zero, and two runs in
// one file repeat them too.
bool is_clear(int i, int j) { return i == j && i % 6 != 5; }

// Entries without rows at any frequency are zero by symmetry; a significant entry that lacks rows at some
// frequencies is an error. given: by frequency, including infinity.
void check_rows(const HydrodynamicData& data, const std::map<double, Eigen::MatrixXi>& given) {
  constexpr double kCounts = 1e-3;
  Eigen::MatrixXd largest = Eigen::MatrixXd::Zero(6 * data.bodies, 6 * data.bodies);
  for (const Eigen::MatrixXd& A : data.added_mass) largest = largest.cwiseMax(A.cwiseAbs());
  for (const auto& [omega, rows] : given)
    for (Eigen::Index i = 0; i < largest.rows(); ++i)
      for (Eigen::Index j = 0; j < largest.cols(); ++j) {
        if (rows(i, j) || !(largest(i, j) > kCounts * std::sqrt(largest(i, i) * largest(j, j)))) continue;
        throw std::runtime_error(fmt::format(
            "{}: has no row {} {} ({}) {}, though other periods have one: complete the file",
            data.radiation_file, i + 1, j + 1, advice::modes_text(static_cast<int>(i), static_cast<int>(j)),
            std::isinf(omega) ? "at period 0 (infinite frequency)"
                              : fmt::format("at {:.6g} s", 2 * M_PI / omega)));
      }
}

// Refuses significant entries of a degree of freedom whose diagonal entry has no row. The length of a cube of
// the largest added mass A makes translations and rotations comparable:
//   |A_ij| > kCounts A l^k,   l = (A/rho)^(1/3),   k = 0 for translations, 1 for each rotation
void check_diagonal(const HydrodynamicData& data, const std::map<double, Eigen::MatrixXi>& given,
                    double density) {
  constexpr double kCounts = 1e-3;
  const Eigen::Index n = 6 * data.bodies;
  Eigen::MatrixXd largest = data.infinite.cwiseAbs();
  for (const Eigen::MatrixXd& A : data.added_mass) largest = largest.cwiseMax(A.cwiseAbs());
  Eigen::MatrixXi has_rows = Eigen::MatrixXi::Zero(n, n);
  for (const auto& [omega, rows] : given) has_rows = has_rows.cwiseMax(rows);
  double mass = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    if (!rotates(static_cast<int>(i))) mass = std::max(mass, largest(i, i));
  if (!(mass > 0)) return;
  const double length = std::cbrt(mass / density);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const int rotations = rotates(static_cast<int>(i)) + rotates(static_cast<int>(j));
      if (has_rows(j, j) || !(largest(i, j) > kCounts * mass * std::pow(length, rotations))) continue;
      const auto entry = [](Eigen::Index row, Eigen::Index column) {
        return fmt::format("{} {} ({})", row + 1, column + 1,
                           advice::modes_text(static_cast<int>(row), static_cast<int>(column)));
      };
      throw std::runtime_error(fmt::format("{}: has no rows {}, although it has rows {}: complete the file",
                                           data.radiation_file, entry(j, j), entry(i, j)));
    }
}

// A = rho L^k Abar, B = rho omega L^k Bbar; k = 3 between translations, 5 between rotations, else 4.
void read_radiation(const std::string& stem, const HydrodynamicForm& form, std::vector<std::string>& read,
                    HydrodynamicData& data, bool& has_infinite, Eigen::MatrixXd& zero_frequency) {
  const NumberTable table = required(stem, ".1", {4, 5}, "added mass and damping", read);
  data.radiation_file = table.path;
  int modes = 6;
  for (const NumberRow& row : table.rows)
    for (const size_t column : {1, 2})
      modes = std::max(modes, 1 + mode_of(table, row, column, 6 * kMostBodies));
  data.bodies = (modes + 5) / 6;
  const Eigen::Index n = 6 * data.bodies;
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n, n);
  struct Frequency {
    Eigen::MatrixXd added, damping;
    Eigen::MatrixXi given;  // 1 if the entry has a row
  };
  const Eigen::MatrixXi no_rows = Eigen::MatrixXi::Zero(n, n);
  Eigen::MatrixXi at_infinity = no_rows;
  std::map<double, Frequency> by_omega;
  has_infinite = false;
  data.infinite = none;
  for (const NumberRow& row : table.rows) {
    const double period = row.values[0];
    const int i = mode_of(table, row, 1, modes);
    const int j = mode_of(table, row, 2, modes);
    const double scale = form.density * std::pow(form.length, 3 + rotates(i) + rotates(j));
    const double added = scale * row.values[3];
    if (period == 0) {
      has_infinite = true;
      if (at_infinity(i, j) && is_clear(i, j))
        check_again(table, row, data.infinite(i, j), added, std::abs(added));
      data.infinite(i, j) = added;
      at_infinity(i, j) = 1;
    }
    const bool wave = is_wave(table, row);
    if (period < 0) {
      if (zero_frequency.size() == 0) zero_frequency = none;
      zero_frequency(i, j) = added;
    }
    if (!wave) continue;
    if (row.values.size() < 5)
      refuse(table, row, "a row at a period above 0 has 5 numbers (period, two modes, added mass, damping)");
    const double omega = 2 * M_PI / period;
    Frequency& at = by_omega.try_emplace(omega, Frequency{none, none, no_rows}).first->second;
    const double damping = scale * omega * row.values[4];
    if (at.given(i, j) && is_clear(i, j)) {
      const Complex before(at.added(i, j), at.damping(i, j) / omega);
      const Complex again(added, damping / omega);
      check_again(table, row, before, again, std::abs(again));
    }
    at.added(i, j) = added;
    at.damping(i, j) = damping;
    at.given(i, j) = 1;
  }
  std::map<double, Eigen::MatrixXi> given;
  for (const auto& [omega, at] : by_omega) given[omega] = at.given;
  for (auto& [omega, at] : by_omega) {
    data.omega.push_back(omega);
    data.added_mass.push_back(std::move(at.added));
    data.damping.push_back(std::move(at.damping));
  }
  if (data.omega.size() < 2)
    throw std::runtime_error(table.path +
                             ": has fewer than two periods above 0, and memory needs a range of them");
  if (has_infinite) given[HUGE_VAL] = at_infinity;
  check_diagonal(data, given, form.density);
  check_rows(data, given);
}

// A file that lists zero entries lists all entries of each body; a missing one was lost.
void check_all_listed(const std::string& path, const Eigen::MatrixXi& given) {
  for (Eigen::Index i = 0; i < given.rows(); ++i)
    for (Eigen::Index j = i / 6 * 6; j < i / 6 * 6 + 6; ++j)
      if (!given(i, j))
        throw std::runtime_error(fmt::format("{}: has rows of zero and no row {} {} ({}): complete the file",
                                             path, i + 1, j + 1,
                                             advice::modes_text(static_cast<int>(i), static_cast<int>(j))));
}

// C33 = rho g L², C34, C35: L³, the rest: L⁴ times Cbar.
void read_hydrostatics(const std::string& stem, const HydrodynamicForm& form, std::vector<std::string>& read,
                       HydrodynamicData& data) {
  const NumberTable table = required(stem, ".hst", {3}, "hydrostatic stiffness", read);
  const int n = 6 * data.bodies;
  data.hydrostatic = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixXi given = Eigen::MatrixXi::Zero(n, n);
  bool has_zeros = false;
  for (const NumberRow& row : table.rows) {
    const int i = mode_of(table, row, 0, n);
    const int j = mode_of(table, row, 1, n);
    const double value =
        form.density * form.gravity * std::pow(form.length, 2 + rotates(i) + rotates(j)) * row.values[2];
    if (given(i, j) && is_clear(i, j))
      check_again(table, row, data.hydrostatic(i, j), value, std::abs(value));
    given(i, j) = 1;
    has_zeros = has_zeros || row.values[2] == 0;
    data.hydrostatic(i, j) = value;
  }
  if (has_zeros) check_all_listed(table.path, given);
  // The upper triangle alone stands for both.
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (i % 6 > 1 && i % 6 < 5 && j % 6 > 1 && j % 6 < 5 && given(i, j) && !given(j, i))
        data.hydrostatic(j, i) = data.hydrostatic(i, j);
}

// Checks columns from `first` on: modulus, phase [deg], real and imaginary part of one number agree to a few
// digits; phases of numbers near zero are ignored. Modulus and phase that are both zero are not given.
void check_parts(const NumberTable& table, const NumberRow& row, size_t first, double largest) {
  constexpr double kRounded = 0.01, kSmall = 0.01;
  const double modulus = row.values[first];
  const double phase = row.values[first + 1];
  const Complex parts(row.values[first + 2], row.values[first + 3]);
  const double scale = std::max(modulus, std::abs(parts));
  if (scale <= kSmall * largest || (modulus == 0 && phase == 0)) return;
  // A negative real number may have its modulus and the phase 0.
  if (std::abs(parts - modulus * std::polar(1.0, phase * kDegree)) <= 2 * kRounded * scale) return;
  if (parts.imag() == 0 && std::abs(std::abs(parts.real()) - std::abs(modulus)) <= kRounded * scale) return;
  if (&row == &table.rows.back())
    refuse(table, row,
           "the last row is incomplete, its modulus and phase are not those of its real and "
           "imaginary part: is the file truncated?");
  refuse(table, row,
         fmt::format(
             "modulus {:g} and phase {:g} deg are not those of the real and imaginary part, {:g} and {:g}, "
             "which are {:.6g} and {:.4g} deg",
             modulus, phase, parts.real(), parts.imag(), std::abs(parts), std::arg(parts) / kDegree));
}

// Largest modulus per mode in a column of a table.
std::vector<double> largest_by_mode(const NumberTable& table, size_t mode, size_t column) {
  std::vector<double> largest(6 * kMostBodies + 1, 0);
  for (const NumberRow& row : table.rows)
    if (const double m = row.values[mode]; m >= 0 && m <= 6 * kMostBodies)
      largest[static_cast<size_t>(m)] =
          std::max(largest[static_cast<size_t>(m)], std::abs(row.values[column]));
  return largest;
}

// X = rho g L^m (re + i im): m = 2 of forces, 3 of moments.
void read_excitation(const std::string& stem, const HydrodynamicForm& form, std::vector<std::string>& read,
                     HydrodynamicData& data) {
  NumberTable table = table_of(stem, ".3", {7}, read);
  if (table.path.empty()) table = table_of(stem, ".2", {7}, read);
  if (table.path.empty()) return;
  data.excitation_file = table.path;
  WaveForceRows rows(data.bodies, form.mirrored);
  const std::vector<double> largest = largest_by_mode(table, 2, 3);
  for (const NumberRow& row : table.rows) {
    if (!is_wave(table, row)) continue;
    const int mode = mode_of(table, row, 2, 6 * data.bodies);
    check_parts(table, row, 3, largest[static_cast<size_t>(mode + 1)]);
    const double scale = form.density * form.gravity * std::pow(form.length, 2 + rotates(mode));
    rows.add(2 * M_PI / row.values[0], row.values[1], mode, scale * Complex(row.values[5], row.values[6]));
  }
  data.excitation = rows.tables(table.path);
}

// Mean forces in a regular wave: rho g A² L^k re, k = 1 for forces, 2 for moments; only equal pairs of
// directions (and, in .12d, of periods) are used. Negative modes are moments about other axes.
bool read_drift(const std::string& stem, const char* ending, const HydrodynamicForm& form,
                std::vector<std::string>& read, HydrodynamicData& data, std::vector<std::string>& notes) {
  const size_t periods = ending == std::string_view(".12d") ? 2 : 1;
  const size_t mode_at = periods + 2;
  const NumberTable table = table_of(stem, ending, {mode_at + 5}, read);
  if (table.path.empty()) return false;
  WaveForceRows rows(data.bodies, form.mirrored);
  const std::vector<double> largest = largest_by_mode(table, mode_at, mode_at + 1);
  bool heave = false;
  for (const NumberRow& row : table.rows) {
    if (row.values[0] != row.values[periods - 1] || row.values[periods] != row.values[periods + 1]) continue;
    if (!is_wave(table, row) || row.values[mode_at] < 0) continue;
    const int mode = mode_of(table, row, mode_at, 6 * data.bodies);
    check_parts(table, row, mode_at + 1, largest[static_cast<size_t>(mode + 1)]);
    heave = heave || mode % 6 == 2;
    const double scale = form.density * form.gravity * std::pow(form.length, 1 + rotates(mode));
    rows.add(2 * M_PI / row.values[0], row.values[periods], mode, scale * row.values[mode_at + 3]);
  }
  data.drift = rows.tables(table.path);
  if (!heave) notes.push_back(advice::no_vertical_drift(table.path));
  return true;
}

// Periods of .12d are rounded; smaller relative differences are equal.
constexpr double kSamePeriod = 1e-4;

// Between two neighbouring frequencies the forces are interpolated from those of the pair and of the two
// alone; where the former are far from the mean of the latter, neither gives the slow force between them.
// This is the mean deviation of surge and sway, as a fraction of the drift.
double sparseness(const std::vector<ComplexVec6>& values, size_t n) {
  double differs = 0, all = 0;
  for (const int mode : {0, 1})
    for (size_t i = 0; i + 1 < n; ++i) {
      const Complex value = values[i * n + i][mode];
      const Complex next = values[(i + 1) * n + i + 1][mode];
      differs += std::abs(values[i * n + i + 1][mode] - 0.5 * (value + next));
      all += 0.5 * (std::abs(value) + std::abs(next));
    }
  return all > 0 ? differs / all : 0;
}

// F_ij = rho g L^k (re + i im) of the rows of one direction [deg]; half of the matrix is given, F_ji = conj
// F_ij. sparse: receives the largest sparseness().
model::DifferenceForces difference_forces(const NumberTable& table, double direction,
                                          const HydrodynamicForm& form, const std::vector<double>& largest,
                                          double& sparse) {
  std::vector<const NumberRow*> rows;
  std::vector<double> omega;
  for (const NumberRow& row : table.rows) {
    if (row.values[2] != direction || row.values[3] != direction) continue;
    rows.push_back(&row);
    for (const size_t column : {0, 1}) {
      if (!(row.values[column] > 0))
        refuse(table, row, "the periods of difference-frequency forces are above 0 s");
      omega.push_back(2 * M_PI / row.values[column]);
    }
  }
  std::sort(omega.begin(), omega.end());
  std::vector<double> distinct;
  for (const double w : omega)
    if (distinct.empty() || w > distinct.back() * (1 + kSamePeriod)) distinct.push_back(w);
  const auto place = [&distinct](double period) {
    const double w = 2 * M_PI / period;
    const auto next = std::lower_bound(distinct.begin(), distinct.end(), w * (1 - kSamePeriod));
    return static_cast<size_t>(next - distinct.begin());
  };
  const size_t n = distinct.size();
  std::vector<ComplexVec6> values(n * n, ComplexVec6::Zero());
  std::vector<bool> given(n * n, false);
  std::vector<std::array<bool, 6>> given_mode(n * n, std::array<bool, 6>{});
  for (const NumberRow* row : rows) {
    const int mode = mode_of(table, *row, 4, 6);
    check_parts(table, *row, 5, largest[static_cast<size_t>(mode + 1)]);
    const double scale = form.density * form.gravity * std::pow(form.length, 1 + rotates(mode));
    const Complex value = scale * Complex(row->values[7], row->values[8]);
    const size_t i = place(row->values[0]);
    const size_t j = place(row->values[1]);
    const size_t at = i * n + j;
    const size_t mirrored = j * n + i;
    const size_t m = static_cast<size_t>(mode);
    if (given_mode[at][m])
      check_again(table, *row, values[at][mode], value, scale * largest[m + 1],
                  "are these rows of two runs, or is F_ji not the conjugate of F_ij?");
    given_mode[at][m] = given_mode[mirrored][m] = true;
    values[at][mode] = value;
    values[mirrored][mode] = std::conj(value);
    given[at] = given[mirrored] = true;
  }
  if (const auto missing = std::find(given.begin(), given.end(), false); missing != given.end()) {
    const auto k = static_cast<size_t>(missing - given.begin());
    throw std::runtime_error(
        fmt::format("{}: has no row for the periods {:.5g} and {:.5g} s at {:g} deg: difference-frequency "
                    "forces are needed for every pair of periods",
                    table.path, 2 * M_PI / distinct[k / n], 2 * M_PI / distinct[k % n], direction));
  }
  std::vector<ComplexVec6> diagonal;
  for (size_t i = 0; i < n; ++i) diagonal.push_back(values[i * n + i]);
  sparse = std::max(sparse, sparseness(values, n));
  return {{WaveForceTable(distinct, {direction * kDegree}, diagonal)},
          DifferenceForceTable(distinct, std::move(values))};
}

constexpr std::array kDriftEndings = {".8", ".7", ".9", ".12d"};  // the first that exists is read

// Path of the first file of second-order forces; empty: none.
std::string drift_file(const std::string& stem) {
  for (const char* ending : kDriftEndings)
    if (std::string path = number_table_path(stem + ending); !path.empty()) return path;
  return "";
}

// Rows of two waves of different directions are not used.
bool read_difference(const std::string& stem, const HydrodynamicForm& form, std::vector<std::string>& read,
                     HydrodynamicData& data, std::vector<std::string>& notes) {
  const NumberTable table = table_of(stem, ".12d", {9}, read);
  if (table.path.empty()) return false;
  const std::vector<double> largest = largest_by_mode(table, 4, 5);
  std::set<double> directions;
  for (const NumberRow& row : table.rows)
    if (row.values[2] == row.values[3]) directions.insert(row.values[2]);
  if (directions.empty())
    throw std::runtime_error(fmt::format(
        "{}: has no row of two waves of one direction, and 'second_order: full' needs those", table.path));
  constexpr double kSparse = 0.5;
  double sparse = 0;
  for (const double direction : directions)
    data.difference.push_back(difference_forces(table, direction, form, largest, sparse));
  if (sparse > kSparse) notes.push_back(advice::periods_too_sparse(table.path, sparse));
  return true;
}

}  // namespace

HydrodynamicData read_wamit(const std::string& stem, const HydrodynamicForm& form, SecondOrder order,
                            std::vector<std::string>& read, std::vector<std::string>& notes) {
  HydrodynamicData data;
  data.excitation_file = stem + ".3";
  bool has_infinite = false;
  Eigen::MatrixXd zero_frequency;
  read_radiation(stem, form, read, data, has_infinite, zero_frequency);
  read_hydrostatics(stem, form, read, data);
  check_mirrored(form, data);
  read_excitation(stem, form, read, data);
  if (order == SecondOrder::none) {
    data.unread_drift_file = drift_file(stem);
  } else {
    const bool full = order == SecondOrder::full;
    bool found = full && data.bodies == 1 && read_difference(stem, form, read, data, notes);
    for (const char* ending : kDriftEndings)
      found = found || (!full && read_drift(stem, ending, form, read, data, notes));
    if (!found)
      throw std::runtime_error(fmt::format("{}: 'second_order' needs {}, and there is none", stem,
                                           full ? "a file .12d of one body" : "a file .8, .9, .7 or .12d"));
  }
  finish_coefficients(data, has_infinite, zero_frequency, notes);
  return data;
}

}  // namespace hawser::io
