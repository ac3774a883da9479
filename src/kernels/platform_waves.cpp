// Tables of wave forces on platforms and their sums over the components of a sea.
#include "hawser/kernels/platform_waves.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/kernels/table_places.hpp"

namespace hawser {
namespace {

// Bilinear interpolation in a table with this number of columns.
ComplexVec6 bilinear(const std::vector<ComplexVec6>& values, size_t columns, const TablePlace& row,
                     const TablePlace& column) {
  const auto along = [&](size_t r) -> ComplexVec6 {
    const ComplexVec6* first = &values[r * columns];
    return (1 - column.weight) * first[column.low] + column.weight * first[column.high];
  };
  return (1 - row.weight) * along(row.low) + row.weight * along(row.high);
}

// Distance of a point from the origin [m] along waves to a direction [rad].
double distance_along(const Eigen::Vector2d& point, double direction) {
  return point.x() * std::cos(direction) + point.y() * std::sin(direction);
}

}  // namespace

WaveForceTable::WaveForceTable(std::vector<double> omega, std::vector<double> directions,
                               std::vector<ComplexVec6> values)
    : omega_(std::move(omega)), directions_(std::move(directions)), values_(std::move(values)) {
  if (omega_.empty() || directions_.empty() || values_.size() != omega_.size() * directions_.size())
    throw std::invalid_argument("a table of wave forces needs a value for each frequency and direction");
  if (!std::is_sorted(omega_.begin(), omega_.end()) ||
      !std::is_sorted(directions_.begin(), directions_.end()))
    throw std::invalid_argument("frequencies and directions of wave forces must grow");
}

ComplexVec6 WaveForceTable::at(double omega, double direction) const {
  return bilinear(values_, omega_.size(), direction_place(directions_, direction),
                  frequency_place(omega_, omega));
}

// The elevation at c is that at the origin times exp(-i k c.d) for a wave to the direction d:
//   X at c = X exp(i k c.d)
WaveForceTable WaveForceTable::with_phases_at(const Eigen::Vector2d& c,
                                              const std::vector<double>& numbers) const {
  WaveForceTable out = *this;
  for (size_t row = 0; row < directions_.size(); ++row) {
    const double distance = distance_along(c, directions_[row]);
    for (size_t i = 0; i < omega_.size(); ++i)
      out.values_[row * omega_.size() + i] *= std::polar(1.0, numbers[i] * distance);
  }
  return out;
}

ComplexVec6 WaveForceTable::by_direction(double omega, double direction) const {
  const TablePlace row = direction_place(directions_, direction);
  if (row.low == row.high) return ComplexVec6::Zero();
  const TablePlace column = frequency_place(omega_, omega);
  const ComplexVec6 change = bilinear(values_, omega_.size(), {row.high, row.high, 0}, column) -
                             bilinear(values_, omega_.size(), {row.low, row.low, 0}, column);
  return change / all_round(directions_[row.high] - directions_[row.low]);
}

DifferenceForceTable::DifferenceForceTable(std::vector<double> omega, std::vector<ComplexVec6> values)
    : omega_(std::move(omega)), values_(std::move(values)) {
  if (omega_.empty() || values_.size() != omega_.size() * omega_.size())
    throw std::invalid_argument("difference-frequency forces need a value for each pair of frequencies");
}

ComplexVec6 DifferenceForceTable::at(double first, double second) const {
  return bilinear(values_, omega_.size(), frequency_place(omega_, first), frequency_place(omega_, second));
}

PlatformWaves::PlatformWaves(const std::vector<WaveComponent>& sea, double heading,
                             const WaveForceTable& first, const Eigen::Vector2d& first_point,
                             const WaveForceTable& mean, const DifferenceForceTable& difference,
                             SecondOrder order)
    : components_(sea),
      first_table_(first),
      mean_table_(mean),
      difference_table_(difference),
      order_(order),
      heading_(heading),
      first_point_(first_point) {
  first_.assign(sea.size(), ComplexVec6::Zero());
  if (order_ == SecondOrder::full) add_full();
  turn_to(heading);
}

void PlatformWaves::turn_to(double heading) {
  heading_ = heading;
  const auto n = static_cast<Eigen::Index>(components_.size());
  for (size_t i = 0; i < components_.size() && !first_table_.none(); ++i) {
    const WaveComponent& w = components_[i];
    const double direction = std::atan2(w.y, w.x) - heading;
    const double distance = distance_along(first_point_, direction);
    first_[i] = w.amplitude * std::polar(1.0, -w.number * distance) * first_table_.at(w.omega, direction);
  }
  mean_drift_ = mean_drift(heading).force;
  if (order_ != SecondOrder::newman) return;
  Eigen::MatrixXd drift(6, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const WaveComponent& w = components_[static_cast<size_t>(i)];
    drift.col(i) = mean_table_.at(w.omega, std::atan2(w.y, w.x) - heading).real();
  }
  modes_.clear();
  add_newman(drift);
}

PlatformWaves::MeanDrift PlatformWaves::mean_drift(double heading) const {
  MeanDrift out;
  if (order_ == SecondOrder::none) return out;
  for (const WaveComponent& w : components_) {
    const double square = w.amplitude * w.amplitude;
    const double direction = std::atan2(w.y, w.x) - heading;
    if (order_ == SecondOrder::full) {
      out.force += square * difference_table_.at(w.omega, w.omega).real();
      continue;
    }
    out.force += square * mean_table_.at(w.omega, direction).real();
    out.by_heading -= square * mean_table_.by_direction(w.omega, direction).real();
  }
  return out;
}

// Newman (1974) in the form of Standing, Brendling and Wilson (1987): F_ij = sqrt(D_i D_j) if both have the
// same sign, else 0. The sum is a difference of two squares.
void PlatformWaves::add_newman(const Eigen::MatrixXd& drift) {
  for (int freedom = 0; freedom < 6; ++freedom)
    for (const double sign : {1.0, -1.0}) {
      Mode mode{freedom, sign, {}};
      double all = 0;
      for (size_t i = 0; i < components_.size(); ++i) {
        const double D = std::max(sign * drift(freedom, static_cast<Eigen::Index>(i)), 0.0);
        mode.amplitude.emplace_back(components_[i].amplitude * std::sqrt(D));
        all += D;
      }
      if (all > 0) modes_.push_back(std::move(mode));
    }
}

// sum_ij z_i conj(z_j) F_ij with z_i = a_i exp(i phase_i) and F Hermitian. With its eigenvalues and
// eigenvectors, F = sum_m weight_m v_m v_m^H, it equals sum_m weight_m |sum_i v_mi z_i|². Small modes are
// excluded.
void PlatformWaves::add_full() {
  constexpr double kNegligible = 1e-4;
  const auto n = static_cast<Eigen::Index>(components_.size());
  std::vector<Eigen::MatrixXcd> F(6, Eigen::MatrixXcd::Zero(n, n));
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const WaveComponent& a = components_[static_cast<size_t>(i)];
      const WaveComponent& b = components_[static_cast<size_t>(j)];
      const ComplexVec6 value = a.amplitude * b.amplitude * difference_table_.at(a.omega, b.omega);
      for (int freedom = 0; freedom < 6; ++freedom) F[static_cast<size_t>(freedom)](i, j) = value[freedom];
    }
  for (int freedom = 0; freedom < 6; ++freedom) {
    const Eigen::MatrixXcd& matrix = F[static_cast<size_t>(freedom)];
    if (matrix.cwiseAbs().maxCoeff() == 0) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> modes(matrix);
    const double largest = modes.eigenvalues().cwiseAbs().maxCoeff();
    for (Eigen::Index m = 0; m < n; ++m) {
      if (std::abs(modes.eigenvalues()[m]) < kNegligible * largest) continue;
      const Eigen::VectorXcd v = modes.eigenvectors().col(m);
      modes_.push_back({freedom, modes.eigenvalues()[m], {v.begin(), v.end()}});
    }
  }
}

std::vector<ComplexVec6> PlatformWaves::first_order(double x, double y) const {
  std::vector<ComplexVec6> out = first_;
  for (size_t i = 0; i < components_.size(); ++i) {
    const WaveComponent& w = components_[i];
    out[i] *= std::polar(1.0, -w.number * (w.x * x + w.y * y) - w.phase);
  }
  return out;
}

PlatformWaves::Forces PlatformWaves::at(double time, double x, double y) const {
  Forces out;
  std::vector<Complex> turn(components_.size());
  for (size_t i = 0; i < components_.size(); ++i) {
    const WaveComponent& w = components_[i];
    const double phase = w.omega * time - w.number * (w.x * x + w.y * y) - w.phase;
    turn[i] = {std::cos(phase), std::sin(phase)};
    const ComplexVec6& X = first_[i];
    out.first += turn[i].real() * X.real() - turn[i].imag() * X.imag();
  }
  for (const Mode& m : modes_) {
    Complex sum = 0;
    for (size_t i = 0; i < turn.size(); ++i) sum += m.amplitude[i] * turn[i];
    out.slow[m.freedom] += m.weight * std::norm(sum);
  }
  if (!modes_.empty()) out.slow -= mean_drift_;
  return out;
}

}  // namespace hawser
