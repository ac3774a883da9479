// WAMIT's files into SI units: which rows there must be, scales by length, density and gravity.
#include "hawser/io/wamit_reader.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "hawser/kernels/radiation_memory.hpp"
#include "number_table.hpp"

namespace hawser::io {
namespace {

using model::HydrodynamicData;

constexpr double kDegree = M_PI / 180;
constexpr int kMostBodies = 20;

bool rotates(int mode) { return mode % 6 >= 3; }  // modes from 0

[[noreturn]] void refuse(const NumberTable& table, const NumberRow& row, const std::string& text) {
  throw std::runtime_error(fmt::format("{}:{}: {}", table.path, row.line, text));
}

// A mode of motion, from 1 in the file, as an index from 0.
int mode_of(const NumberTable& table, const NumberRow& row, size_t column, int modes) {
  const double mode = row.values[column];
  if (mode != std::floor(mode) || mode < 1 || mode > modes)
    refuse(table, row,
           fmt::format("{:g} is no mode of motion: it is a whole number from 1 to {}", mode, modes));
  return static_cast<int>(mode) - 1;
}

NumberTable table_of(const std::string& stem, const char* ending, const std::vector<size_t>& columns,
                     std::vector<std::string>& read) {
  NumberTable table = read_number_table(stem + ending, columns);
  if (!table.path.empty()) read.push_back(table.path);
  return table;
}

NumberTable required(const std::string& stem, const char* ending, const std::vector<size_t>& columns,
                     const char* what, std::vector<std::string>& read) {
  NumberTable table = table_of(stem, ending, columns, read);
  if (table.path.empty())
    throw std::runtime_error(
        fmt::format("{}{}: there is no such file, which has {}; 'wamit' is the path of WAMIT's files without "
                    "their endings",
                    stem, ending, what));
  return table;
}

// A = rho L^k Abar, B = rho omega L^k Bbar; k = 3 between translations, 5 between rotations, else 4.
void read_radiation(const std::string& stem, const WamitForm& form, std::vector<std::string>& read,
                    HydrodynamicData& data, bool& has_infinite) {
  const NumberTable table = required(stem, ".1", {4, 5}, "added mass and damping", read);
  int modes = 6;
  for (const NumberRow& row : table.rows)
    for (const size_t column : {1, 2})
      modes = std::max(modes, 1 + mode_of(table, row, column, 6 * kMostBodies));
  data.bodies = (modes + 5) / 6;
  const Eigen::Index n = 6 * data.bodies;
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(n, n);
  struct Frequency {
    Eigen::MatrixXd added, damping;
  };
  std::map<double, Frequency> by_omega;
  has_infinite = false;
  data.infinite = none;
  for (const NumberRow& row : table.rows) {
    const double period = row.values[0];
    const int i = mode_of(table, row, 1, modes), j = mode_of(table, row, 2, modes);
    const double scale = form.density * std::pow(form.length, 3 + rotates(i) + rotates(j));
    if (period == 0) {
      has_infinite = true;
      data.infinite(i, j) = scale * row.values[3];
    }
    if (period <= 0) continue;
    if (row.values.size() < 5)
      refuse(table, row, "a row at a period above 0 has 5 numbers (period, two modes, added mass, damping)");
    const double omega = 2 * M_PI / period;
    Frequency& at = by_omega.try_emplace(omega, Frequency{none, none}).first->second;
    at.added(i, j) = scale * row.values[3];
    at.damping(i, j) = scale * omega * row.values[4];
  }
  for (auto& [omega, at] : by_omega) {
    data.omega.push_back(omega);
    data.added_mass.push_back(std::move(at.added));
    data.damping.push_back(std::move(at.damping));
  }
  if (data.omega.size() < 2)
    throw std::runtime_error(table.path +
                             ": has fewer than two periods above 0, and memory needs a range of them");
}

// C33 = rho g L², C34, C35: L³, the rest: L⁴ times Cbar.
void read_hydrostatics(const std::string& stem, const WamitForm& form, std::vector<std::string>& read,
                       HydrodynamicData& data) {
  const NumberTable table = required(stem, ".hst", {3}, "hydrostatic stiffness", read);
  const int n = 6 * data.bodies;
  data.hydrostatic = Eigen::MatrixXd::Zero(n, n);
  for (const NumberRow& row : table.rows) {
    const int i = mode_of(table, row, 0, n), j = mode_of(table, row, 1, n);
    data.hydrostatic(i, j) =
        form.density * form.gravity * std::pow(form.length, 2 + rotates(i) + rotates(j)) * row.values[2];
  }
}

// Values by frequency, direction [rad, 0 to 2 pi] and mode. Rows that are excluded are zero; the directions
// -180 and 180 degrees are the same.
class ForceRows {
 public:
  ForceRows(int bodies, bool mirrored) : bodies_(bodies), mirrored_(mirrored) {}
  void add(double period, double direction_deg, int mode, Complex value) {
    double direction = std::fmod(direction_deg, 360.0);
    if (direction < 0) direction += 360;
    if (direction > 360 - 1e-6) direction = 0;
    const long key = std::lround(1e6 * direction);
    directions_[key] = direction * kDegree;
    auto& at = values_[{2 * M_PI / period, key}];
    at.resize(static_cast<size_t>(6 * bodies_));
    at[static_cast<size_t>(mode)] = value;
  }
  // Of each body. A pair of frequency and direction without any row: refused.
  std::vector<WaveForceTable> tables(const std::string& path) {
    if (mirrored_) add_other_side(path);
    std::vector<double> omega, directions;
    for (const auto& [at, value] : values_)
      if (omega.empty() || at.first > omega.back()) omega.push_back(at.first);
    for (const auto& [key, direction] : directions_) directions.push_back(direction);
    std::vector<WaveForceTable> out;
    for (int body = 0; body < bodies_; ++body) {
      std::vector<ComplexVec6> values;
      for (const auto& [key, direction] : directions_)
        for (const double w : omega) {
          const auto found = values_.find({w, key});
          if (found == values_.end())
            throw std::runtime_error(
                fmt::format("{}: has no rows at {:.6g} s for {:g} deg, though other directions have them",
                            path, 2 * M_PI / w, direction / kDegree));
          values.push_back(Eigen::Map<const ComplexVec6>(&found->second[static_cast<size_t>(6 * body)]));
        }
      out.emplace_back(omega, directions, std::move(values));
    }
    return out;
  }

 private:
  static constexpr long kRound = 360000000;  // key of 360 deg

  // X(-beta) is X(beta) with sway, roll and yaw reversed.
  void add_other_side(const std::string& path) {
    const auto on = [this](bool port) {
      return std::any_of(directions_.begin(), directions_.end(), [port](const auto& d) {
        return port ? d.first > 0 && d.first < kRound / 2 : d.first > kRound / 2;
      });
    };
    if (on(true) && on(false))
      throw std::runtime_error(path +
                               ": has directions on both sides of the body, and 'symmetry: port_starboard' "
                               "makes the other side of files of one side");
    const auto given = values_;
    for (const auto& [at, value] : given) {
      const auto [omega, key] = at;
      if (key == 0 || key == kRound / 2) continue;
      std::vector<Complex> image = value;
      for (size_t mode = 1; mode < image.size(); mode += 2) image[mode] = -image[mode];
      directions_[kRound - key] = 2 * M_PI - directions_.at(key);
      values_[{omega, kRound - key}] = std::move(image);
    }
  }

  int bodies_;
  bool mirrored_;
  std::map<long, double> directions_;
  std::map<std::pair<double, long>, std::vector<Complex>> values_;
};

// X = rho g L^m (re + i im): m = 2 of forces, 3 of moments.
void read_excitation(const std::string& stem, const WamitForm& form, std::vector<std::string>& read,
                     HydrodynamicData& data) {
  NumberTable table = table_of(stem, ".3", {7}, read);
  if (table.path.empty()) table = table_of(stem, ".2", {7}, read);
  if (table.path.empty()) return;
  ForceRows rows(data.bodies, form.mirrored);
  for (const NumberRow& row : table.rows) {
    if (!(row.values[0] > 0)) continue;
    const int mode = mode_of(table, row, 2, 6 * data.bodies);
    const double scale = form.density * form.gravity * std::pow(form.length, 2 + rotates(mode));
    rows.add(row.values[0], row.values[1], mode, scale * Complex(row.values[5], row.values[6]));
  }
  data.excitation = rows.tables(table.path);
}

// Mean forces in a regular wave: rho g A² L^k re, k = 1 of forces, 2 of moments; of two directions only equal
// ones count. Modes below 0 are moments about other axes.
bool read_drift(const std::string& stem, const char* ending, const WamitForm& form,
                std::vector<std::string>& read, HydrodynamicData& data) {
  const NumberTable table = table_of(stem, ending, {8}, read);
  if (table.path.empty()) return false;
  ForceRows rows(data.bodies, form.mirrored);
  for (const NumberRow& row : table.rows) {
    if (row.values[1] != row.values[2] || !(row.values[0] > 0) || row.values[3] < 0) continue;
    const int mode = mode_of(table, row, 3, 6 * data.bodies);
    const double scale = form.density * form.gravity * std::pow(form.length, 1 + rotates(mode));
    rows.add(row.values[0], row.values[1], mode, scale * row.values[6]);
  }
  data.drift = rows.tables(table.path);
  return true;
}

// Periods of .12d are rounded: those that differ by less than this share are one.
constexpr double kSamePeriod = 1e-4;

// F_ij = rho g L^k (re + i im); half of the matrix is given, F_ji = conj F_ij. One direction.
bool read_difference(const std::string& stem, const WamitForm& form, std::vector<std::string>& read,
                     HydrodynamicData& data, std::vector<std::string>& notes) {
  const NumberTable table = table_of(stem, ".12d", {9}, read);
  if (table.path.empty()) return false;
  std::vector<double> omega;
  double direction = HUGE_VAL;
  for (const NumberRow& row : table.rows) {
    for (const size_t column : {0, 1})
      if (row.values[column] > 0) omega.push_back(2 * M_PI / row.values[column]);
    if (row.values[2] == row.values[3] && std::abs(row.values[2]) < std::abs(direction))
      direction = row.values[2];
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
  bool others = false;
  for (const NumberRow& row : table.rows) {
    if (row.values[2] != direction || row.values[3] != direction) {
      others = true;
      continue;
    }
    const int mode = mode_of(table, row, 4, 6);
    const double scale = form.density * form.gravity * std::pow(form.length, 1 + rotates(mode));
    const Complex value = scale * Complex(row.values[7], row.values[8]);
    const size_t i = place(row.values[0]), j = place(row.values[1]);
    values[i * n + j][mode] = value;
    values[j * n + i][mode] = std::conj(value);
    given[i * n + j] = given[j * n + i] = true;
  }
  if (const auto missing = std::find(given.begin(), given.end(), false); missing != given.end()) {
    const auto k = static_cast<size_t>(missing - given.begin());
    throw std::runtime_error(
        fmt::format("{}: has no row for the periods {:.5g} and {:.5g} s: difference-frequency forces are "
                    "needed for every pair of periods",
                    table.path, 2 * M_PI / distinct[k / n], 2 * M_PI / distinct[k % n]));
  }
  if (others)
    notes.push_back(fmt::format("{}: its rows at {:g} deg are used; those at other directions are not",
                                table.path, direction));
  std::vector<ComplexVec6> diagonal;
  for (size_t i = 0; i < n; ++i) diagonal.push_back(values[i * n + i]);
  data.drift = {WaveForceTable(distinct, {direction * kDegree}, diagonal)};
  data.difference = DifferenceForceTable(distinct, std::move(values));
  return true;
}

// A(inf) = A(omega) + int_0^inf K sin(omega t) dt/omega (Ogilvie 1964), averaged over the frequencies.
void estimate_infinite(HydrodynamicData& data, std::vector<std::string>& notes) {
  const Eigen::Index n = 6 * data.bodies, rows = static_cast<Eigen::Index>(data.omega.size());
  Eigen::MatrixXd damping(rows, n * n);
  for (Eigen::Index k = 0; k < rows; ++k) damping.row(k) = data.damping[static_cast<size_t>(k)].reshaped();
  const RadiationMemory memory(data.omega, damping);
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(n, n);
  for (const Eigen::MatrixXd& A : data.added_mass) mean += A / static_cast<double>(rows);
  data.infinite = mean + memory.added_mass_below_infinite(data.omega).reshaped(n, n);
  data.infinite_estimated = true;
  notes.push_back(
      data.name +
      ".1: has no row of infinite frequency (period 0); its added mass is estimated from the other "
      "rows by Ogilvie's relation");
}

void make_symmetric(Eigen::MatrixXd& m) { m = (0.5 * (m + m.transpose())).eval(); }

// Waves that a body makes only take energy: B without its negative eigenvalues, in the metric of the added
// mass, so that translations and rotations compare. The irregular frequencies of panel methods and the noise
// of small entries have some. Refused where that is much of it.
void make_passive(HydrodynamicData& data, std::vector<std::string>& notes) {
  constexpr double kMuch = 0.3, kSome = 0.02;
  const Eigen::Index n = data.infinite.rows();
  Eigen::VectorXd scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    double most = std::abs(data.infinite(i, i));
    for (const Eigen::MatrixXd& A : data.added_mass) most = std::max(most, std::abs(A(i, i)));
    scale[i] = most > 0 ? std::sqrt(most) : 1;
  }
  double taken = 0, all = 0, worst = 0, period = 0, before = 0;
  for (size_t k = 0; k < data.omega.size(); ++k) {
    Eigen::MatrixXd& B = data.damping[k];
    const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * B * scale.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scaled);
    const Eigen::VectorXd positive = modes.eigenvalues().cwiseMax(0);
    const double negative = (positive - modes.eigenvalues()).sum(), width = data.omega[k] - before;
    before = data.omega[k];
    taken += width * negative;
    all += width * positive.sum();
    if (negative > worst) {
      worst = negative;
      period = 2 * M_PI / data.omega[k];
    }
    if (!(negative > 0)) continue;
    const Eigen::MatrixXd root = scale.asDiagonal() * modes.eigenvectors();
    B = root * positive.asDiagonal() * root.transpose();
  }
  const std::string found = fmt::format(
      "{}.1: radiation damping of {:.2g} % of its sum over the frequencies is "
      "negative, most at {:.4g} s",
      data.name, 100 * taken / std::max(all, 1e-300), period);
  if (taken > kMuch * all)
    throw std::runtime_error(found + ": waves that a body makes cannot drive it; is the sign that of WAMIT?");
  if (taken > kSome * all) notes.push_back(found + "; it is excluded");
}

// Of a matrix over its largest diagonal entries.
double asymmetry(const Eigen::MatrixXd& m) {
  double most = 0;
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const double scale = std::sqrt(std::abs(m(i, i) * m(j, j)));
      if (scale > 0) most = std::max(most, std::abs(m(i, j) - m(j, i)) / scale);
    }
  return most;
}

}  // namespace

HydrodynamicData read_wamit(const std::string& stem, const WamitForm& form, SecondOrder order,
                            std::vector<std::string>& read, std::vector<std::string>& notes) {
  HydrodynamicData data;
  data.name = stem;
  bool has_infinite = false;
  read_radiation(stem, form, read, data, has_infinite);
  read_hydrostatics(stem, form, read, data);
  if (form.mirrored && data.bodies > 1)
    throw std::runtime_error(fmt::format(
        "{}.1: has {} bodies, which are no mirror image of themselves: 'symmetry: port_starboard' is for "
        "files of one body",
        stem, data.bodies));
  read_excitation(stem, form, read, data);
  if (order != SecondOrder::none) {
    const bool found = (data.bodies == 1 && read_difference(stem, form, read, data, notes)) ||
                       (order != SecondOrder::full && (read_drift(stem, ".8", form, read, data) ||
                                                       read_drift(stem, ".7", form, read, data) ||
                                                       read_drift(stem, ".9", form, read, data)));
    if (!found)
      throw std::runtime_error(
          fmt::format("{}: 'second_order' needs {}, and there is none", stem,
                      order == SecondOrder::full ? "a file .12d of one body" : "a file .12d, .8, .9 or .7"));
  }
  constexpr double kAsymmetry = 0.05;
  double asymmetric = has_infinite ? asymmetry(data.infinite) : 0;
  std::string worst = "at infinite frequency";
  for (size_t k = 0; k < data.omega.size(); ++k) {
    if (const double here = asymmetry(data.added_mass[k]); here > asymmetric) {
      asymmetric = here;
      worst = fmt::format("at {:.4g} s", 2 * M_PI / data.omega[k]);
    }
    make_symmetric(data.added_mass[k]);
  }
  for (Eigen::MatrixXd& m : data.damping) make_symmetric(m);
  if (asymmetric > kAsymmetry)
    notes.push_back(
        fmt::format("{}.1: added mass differs from its transpose by up to {:.2g} % of the diagonal, "
                    "{}; the mean of both is used",
                    stem, 100 * asymmetric, worst));
  if (has_infinite)
    make_symmetric(data.infinite);
  else
    estimate_infinite(data, notes);
  make_passive(data, notes);
  return data;
}

}  // namespace hawser::io
