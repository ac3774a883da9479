// Retardation functions from radiation damping, and their first and second integrals as a table.
#include "hawser/kernels/radiation_memory.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "hawser/math/gauss_points.hpp"

namespace hawser {
namespace {

// The memory ends where K is below this fraction of K(0), and its integral below this fraction of its
// maximum. The error is then less than about 1e-4 of the peak of B, which matters for bodies that oscillate
// at a frequency with little damping.
constexpr double kNegligible = 2e-4;
// Points of the table per period of the highest frequency.
constexpr double kPointsPerPeriod = 12;
constexpr double kLongest = 400;  // s
// K has ended at the time t if it is small from t to kUpTo t; at least kMinPeriods periods of the highest
// frequency are examined.
constexpr size_t kUpTo = 4, kMinPeriods = 40;
constexpr double kMaxPoints = 20000;

double sinc(double x) { return std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x; }

constexpr auto& kGaussPoints = GaussPoints<4>::unit;
constexpr auto& kGaussWeights = GaussPoints<4>::weight;

}  // namespace

RadiationMemory::RadiationMemory(const std::vector<double>& omega, const Eigen::MatrixXd& damping)
    : omega_(omega), damping_(damping) {
  if (omega.empty() || static_cast<Eigen::Index>(omega.size()) != damping.rows())
    throw std::invalid_argument("radiation damping needs a row for each frequency");
  double before = 0;
  for (const double w : omega) {
    if (!(w > before)) throw std::invalid_argument("frequencies of radiation damping must grow from above 0");
    before = w;
  }
  if (damping.size() == 0 || damping.isZero(0))
    throw std::invalid_argument("a radiation memory needs an entry with damping");
  tabulate();
}

// Between omega_k and omega_k+1, B = B_k + s_k (omega - omega_k); integration by parts:
//   K = (2/pi) [B_N sin(omega_N t)/t + sum_k s_k (cos omega_k+1 t - cos omega_k t)/t²]
// where the difference of cosines is -(b² - a²)/2 t² sinc((a + b) t/2) sinc((b - a) t/2).
Eigen::RowVectorXd RadiationMemory::retardation(double t) const {
  const Eigen::Index last = damping_.rows() - 1;
  Eigen::RowVectorXd K = damping_.row(last) * (omega_.back() * sinc(omega_.back() * t));
  double a = 0;
  for (Eigen::Index k = 0; k <= last; ++k) {
    const double b = omega_[static_cast<size_t>(k)];
    const double cosines = -0.5 * (b * b - a * a) * sinc(0.5 * (a + b) * t) * sinc(0.5 * (b - a) * t);
    K += damping_.row(k) * (cosines / (b - a));
    if (k > 0) K -= damping_.row(k - 1) * (cosines / (b - a));
    a = b;
  }
  return (2 / M_PI) * K;
}

void RadiationMemory::tabulate() {
  const Eigen::Index n = entries();
  spacing_ = 2 * M_PI / omega_.back() / kPointsPerPeriod;
  const auto max_points = static_cast<size_t>(std::min(kLongest / spacing_, kMaxPoints));
  const Eigen::RowVectorXd scale = retardation(0).cwiseAbs();
  Eigen::RowVectorXd S = Eigen::RowVectorXd::Zero(n);
  Eigen::RowVectorXd rate = S;
  Eigen::RowVectorXd largest_rate = rate;
  size_t needed = 1;
  const auto keep = [&](const Eigen::RowVectorXd& K) {
    for (const Eigen::RowVectorXd* row : {&std::as_const(S), &std::as_const(rate), &K})
      table_.insert(table_.end(), row->begin(), row->end());
  };
  keep(retardation(0));
  const auto min_points = static_cast<size_t>(static_cast<double>(kMinPeriods) * kPointsPerPeriod);
  for (size_t p = 1; p <= max_points && p < std::max(kUpTo * needed, min_points); ++p) {
    const double from = static_cast<double>(p - 1) * spacing_;
    S += spacing_ * rate;
    for (int q = 0; q < 4; ++q) {
      const Eigen::RowVectorXd K = retardation(from + kGaussPoints[q] * spacing_);
      rate += (kGaussWeights[q] * spacing_) * K;
      S += (kGaussWeights[q] * spacing_ * (1 - kGaussPoints[q]) * spacing_) * K;
    }
    const Eigen::RowVectorXd K = retardation(static_cast<double>(p) * spacing_);
    largest_rate = largest_rate.cwiseMax(rate.cwiseAbs());
    const auto small = [](const auto& x, const auto& scales) {
      return (x.cwiseAbs().array() <= kNegligible * scales.array()).all();
    };
    if (!small(K, scale) || !small(rate, largest_rate)) needed = p + 1;
    keep(K);
  }
  needed = std::min(needed, table_.size() / static_cast<size_t>(3 * n) - 1);
  table_.resize((needed + 1) * static_cast<size_t>(n) * 3);
  length_ = static_cast<double>(needed) * spacing_;
}

// Quintic Hermite interpolation of S from S, S', K at both ends.
void RadiationMemory::integrals(double t, double* S, double* rate) const {
  const auto n = static_cast<size_t>(entries());
  const bool beyond = t >= length_;
  const size_t points = table_.size() / (3 * n);
  const size_t p = std::min(static_cast<size_t>(t / spacing_), points - 2);
  const double s = beyond ? 1 : t / spacing_ - static_cast<double>(p);
  const double r = 1 - s;
  const double h = spacing_;
  const double s3 = s * s * s;
  const double r3 = r * r * r;
  const double value0 = r3 * (1 + s * (3 + 6 * s));
  const double value1 = s3 * (1 + r * (3 + 6 * r));
  const double slope0 = h * s * r3 * (1 + 3 * s);
  const double slope1 = -h * r * s3 * (1 + 3 * r);
  const double curve0 = 0.5 * h * h * s * s * r3;
  const double curve1 = 0.5 * h * h * r * r * s3;
  const double* S0 = &table_[3 * n * p];
  const double* rate0 = S0 + n;
  const double* K0 = rate0 + n;
  const double* S1 = K0 + n;
  const double* rate1 = S1 + n;
  const double* K1 = rate1 + n;
  const auto row = [n](const double* values) {
    return Eigen::Map<const Eigen::ArrayXd>(values, static_cast<int>(n));
  };
  Eigen::Map<Eigen::ArrayXd>(S, static_cast<int>(n)) = value0 * row(S0) + slope0 * row(rate0) +
                                                       curve0 * row(K0) + value1 * row(S1) +
                                                       slope1 * row(rate1) + curve1 * row(K1);
  if (!rate) return;
  const double dvalue = 30 * s * s * r * r / h;
  const double dslope0 = r * r * (1 + 2 * s - 15 * s * s);
  const double dslope1 = s * s * (1 + 2 * r - 15 * r * r);
  const double dcurve0 = 0.5 * h * s * r * r * (2 - 5 * s);
  const double dcurve1 = -0.5 * h * r * s * s * (2 - 5 * r);
  for (size_t i = 0; i < n; ++i)
    rate[i] = beyond ? 0
                     : dvalue * (S1[i] - S0[i]) + dslope0 * rate0[i] + dslope1 * rate1[i] + dcurve0 * K0[i] +
                           dcurve1 * K1[i];
}

// On an interval B = c + s u, the integral of B/(u² - w²) is
//   [(c + s w) ln|u - w| - (c - s w) ln(u + w)]/(2 w).
// At a row with u = w, c + s w is B of that row on both sides: the logarithms cancel.
Eigen::RowVectorXd added_mass_by_damping(const std::vector<double>& omega, const Eigen::MatrixXd& damping,
                                         double at) {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(damping.cols());
  Eigen::RowVectorXd from = sum;
  double a = 0;
  const auto log_distance = [at](double u) {
    const double d = std::abs(u - at);
    return d > 1e-12 * at ? std::log(d) : 0;
  };
  for (Eigen::Index k = 0; k < damping.rows(); ++k) {
    const double b = omega[static_cast<size_t>(k)];
    const Eigen::RowVectorXd s = (damping.row(k) - from) / (b - a);
    const Eigen::RowVectorXd c = from - s * a;
    sum += (c + s * at) * (log_distance(b) - log_distance(a)) -
           (c - s * at) * (std::log(b + at) - std::log(a + at));
    from = damping.row(k);
    a = b;
  }
  return sum / (M_PI * at);
}

Eigen::RowVectorXd RadiationMemory::added_mass_by_damping(double omega) const {
  return hawser::added_mass_by_damping(omega_, damping_, omega);
}

}  // namespace hawser
