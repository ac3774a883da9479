// Completion of coefficients after reading: symmetric matrices, passive damping, added mass at infinite
// frequency.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "hawser/advice/hydrodynamic_files.hpp"
#include "hawser/kernels/radiation_memory.hpp"
#include "hawser/kernels/waves.hpp"
#include "hydrodynamic_parts.hpp"

namespace hawser::io {
namespace {

using model::HydrodynamicData;

struct Weighted {
  double value, weight;
};

// The value with half of the weight on each side. Reorders.
double median(std::vector<Weighted>& values) {
  std::sort(values.begin(), values.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  double remaining = 0;
  for (const Weighted& w : values) remaining += w.weight;
  for (const Weighted& w : values)
    if ((remaining -= 2 * w.weight) <= 0) return w.value;
  return values.back().value;
}

// A(inf) = A(omega) - (2/pi) PV int_0^inf B(u)/(u² - omega²) du (Kotik and Mangulis 1962), of each entry the
// median over ln omega: single rows next to irregular frequencies, gaps and the end of the table have large
// errors. The contribution beyond the end is a constant, which is included in A(inf), and a part that
// increases as omega²: a weight by ln omega favours rows without it. The last row, where B may jump to 0, has
// none unless it is the only one.
void estimate_infinite(HydrodynamicData& data, std::vector<std::string>& notes) {
  const Eigen::Index n = 6 * data.bodies;
  const size_t rows = data.omega.size();
  const size_t used = std::max<size_t>(rows - 1, 1);
  Eigen::MatrixXd damping(rows, n * n);
  Eigen::MatrixXd integrals(used, n * n);
  for (size_t k = 0; k < rows; ++k) damping.row(static_cast<Eigen::Index>(k)) = data.damping[k].reshaped();
  Eigen::VectorXd weight(used);
  for (size_t k = 0; k < used; ++k) {
    const double omega = data.omega[k];
    const double before = data.omega[k > 0 ? k - 1 : 0];
    const double after = data.omega[std::min(k + 1, used - 1)];
    weight[static_cast<Eigen::Index>(k)] = std::log((omega + after) / (before + omega));
    integrals.row(static_cast<Eigen::Index>(k)) =
        data.added_mass[k].reshaped().transpose() - added_mass_by_damping(data.omega, damping, omega);
  }
  data.infinite.resize(n, n);
  std::vector<Weighted> by_row(used);
  for (Eigen::Index entry = 0; entry < n * n; ++entry) {
    for (size_t k = 0; k < used; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      by_row[k] = {integrals(row, entry), weight[row]};
    }
    data.infinite.reshaped()[entry] = median(by_row);
  }
  data.infinite_estimated = true;
  notes.push_back(advice::infinite_frequency_estimated(data.radiation_file));
}

void make_symmetric(Eigen::MatrixXd& m) { m = (0.5 * (m + m.transpose())).eval(); }

// Notes degrees of freedom, except yaw (of round bodies noise), of which most of the damping is negative.
// Called before negative eigenvalues are removed.
void note_negative(const HydrodynamicData& data, std::vector<std::string>& notes) {
  constexpr double kCounts = 1e-4;  // of omega A: above noise
  for (Eigen::Index i = 0; i < data.infinite.rows(); ++i) {
    if (i % 6 == 5) continue;
    double sum = 0, all = 0, largest = 0, before = 0;
    for (size_t k = 0; k < data.omega.size(); ++k) {
      const double B = data.damping[k](i, i);
      const double width = data.omega[k] - before;
      before = data.omega[k];
      sum += width * B;
      all += width * std::abs(B);
      largest =
          std::max(largest, -B / (data.omega[k] * std::max(std::abs(data.added_mass[k](i, i)), 1e-300)));
    }
    if (largest > kCounts && sum < -0.5 * all)
      notes.push_back(advice::mostly_negative_damping(data.radiation_file, static_cast<int>(i)));
  }
}

// Radiation only dissipates energy: removes negative eigenvalues of B in the metric of the added mass, which
// makes translations and rotations comparable. Irregular frequencies of panel methods and noise of small
// entries cause some. Large changes are refused.
void make_passive(HydrodynamicData& data, std::vector<std::string>& notes) {
  constexpr double kRefused = 0.3, kReported = 0.02;  // fractions of the damping
  const Eigen::Index n = data.infinite.rows();
  Eigen::VectorXd scale(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    double largest = std::abs(data.infinite(i, i));
    for (const Eigen::MatrixXd& A : data.added_mass) largest = std::max(largest, std::abs(A(i, i)));
    scale[i] = largest > 0 ? std::sqrt(largest) : 1;
  }
  double negative_area = 0, all = 0, worst = 0, period = 0, before = 0;
  for (size_t k = 0; k < data.omega.size(); ++k) {
    Eigen::MatrixXd& B = data.damping[k];
    const Eigen::MatrixXd scaled = scale.cwiseInverse().asDiagonal() * B * scale.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(scaled);
    const Eigen::VectorXd positive = modes.eigenvalues().cwiseMax(0);
    const double negative = (positive - modes.eigenvalues()).sum();
    const double width = data.omega[k] - before;
    before = data.omega[k];
    negative_area += width * negative;
    all += width * positive.sum();
    if (negative > worst) {
      worst = negative;
      period = 2 * M_PI / data.omega[k];
    }
    if (!(negative > 0)) continue;
    const Eigen::MatrixXd root = scale.asDiagonal() * modes.eigenvectors();
    B = root * positive.asDiagonal() * root.transpose();
  }
  const double fraction = negative_area / std::max(all, 1e-300);
  if (negative_area > kRefused * all)
    throw std::runtime_error(advice::too_much_negative_damping(data.radiation_file, fraction, period));
  if (negative_area > kReported * all)
    notes.push_back(advice::negative_damping_excluded(data.radiation_file, fraction, period));
}

// Largest asymmetry of a matrix relative to the diagonal entries of `of`.
double asymmetry(const Eigen::MatrixXd& m, const Eigen::VectorXd& diagonal) {
  double largest = 0;
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const double scale = std::sqrt(std::abs(diagonal[i] * diagonal[j]));
      if (scale > 0) largest = std::max(largest, std::abs(m(i, j) - m(j, i)) / scale);
    }
  return largest;
}
double asymmetry(const Eigen::MatrixXd& m) { return asymmetry(m, m.diagonal()); }

// Largest asymmetry of the stiffness in heave, roll and pitch of a body.
void make_stiffness_symmetric(HydrodynamicData& data, std::vector<std::string>& notes) {
  constexpr double kAsymmetry = 0.05;
  for (int b = 0; b < data.bodies; ++b) {
    auto C = data.hydrostatic.block<3, 3>(6 * b + 2, 6 * b + 2);
    const double largest = C.cwiseAbs().maxCoeff();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < i; ++j) {
        const double scale = j == 0 ? std::sqrt(std::abs(C(0, 0)) * largest) : largest;
        if (std::abs(C(i, j) - C(j, i)) > kAsymmetry * scale)
          notes.push_back(advice::asymmetric_stiffness(data.radiation_file, 6 * b + 2 + j, 6 * b + 2 + i,
                                                       C(j, i), C(i, j)));
      }
    C = (0.5 * (C + C.transpose())).eval();
  }
}

}  // namespace

void check_mirrored(const HydrodynamicForm& form, const HydrodynamicData& data) {
  if (form.mirrored && data.bodies > 1)
    throw std::runtime_error(fmt::format(
        "{}: has {} bodies, which are no mirror image of themselves: 'symmetry: port_starboard' is for files "
        "of one body",
        data.radiation_file, data.bodies));
}

void note_depth(const HydrodynamicForm& form, double depth, const HydrodynamicData& data,
                std::vector<std::string>& notes) {
  constexpr double kFar = 0.05;
  const double depth_in_data = std::isfinite(depth) ? depth : 0;
  const auto number = [&](double h) { return wave_number(data.omega.front(), h, form.gravity); };
  if (!(form.gravity > 0) || std::abs(number(depth_in_data) / number(form.depth) - 1) < kFar) return;
  notes.push_back(advice::other_water_depth(data.radiation_file, depth_in_data, form.depth));
}

void finish_coefficients(HydrodynamicData& data, bool has_infinite, const Eigen::MatrixXd& zero_frequency,
                         std::vector<std::string>& notes) {
  constexpr double kAsymmetry = 0.05;
  double asymmetric = has_infinite ? asymmetry(data.infinite) : 0;
  double period = 0;  // s, of the largest; 0: infinite frequency
  const char* quantity = "added mass";
  Eigen::VectorXd damped = Eigen::VectorXd::Zero(6 * data.bodies);
  for (const Eigen::MatrixXd& B : data.damping) damped = damped.cwiseMax(B.diagonal().cwiseAbs());
  for (size_t k = 0; k < data.omega.size(); ++k) {
    if (const double value = asymmetry(data.added_mass[k]); value > asymmetric) {
      asymmetric = value;
      period = 2 * M_PI / data.omega[k];
      quantity = "added mass";
    }
    if (const double value = asymmetry(data.damping[k], damped); value > asymmetric) {
      asymmetric = value;
      period = 2 * M_PI / data.omega[k];
      quantity = "damping";
    }
    make_symmetric(data.added_mass[k]);
    make_symmetric(data.damping[k]);
  }
  make_stiffness_symmetric(data, notes);
  if (asymmetric > kAsymmetry)
    notes.push_back(advice::asymmetric_matrix(data.radiation_file, quantity, asymmetric, period));
  if (has_infinite)
    make_symmetric(data.infinite);
  else
    estimate_infinite(data, notes);
  check_coefficients(data, has_infinite, zero_frequency, notes);
  note_negative(data, notes);
  make_passive(data, notes);
}

}  // namespace hawser::io
