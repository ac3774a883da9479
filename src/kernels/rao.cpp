// Interpolation of response amplitude operators in frequency and direction, symmetry of the vessel, and its
// motion as a sum of responses to the wave components.
#include "hawser/kernels/rao.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hawser {
namespace {

constexpr double kSame = 1e-9;  // rad and rad/s: equal directions or frequencies

}  // namespace

RaoTable::RaoTable(std::vector<Row> rows) {
  if (rows.empty()) throw std::invalid_argument("a table of responses needs rows");
  const auto add = [](std::vector<double>& list, double x) {
    if (std::none_of(list.begin(), list.end(), [x](double y) { return std::abs(x - y) < kSame; }))
      list.push_back(x);
  };
  for (Row& r : rows) {
    if (!(r.omega > 0)) throw std::invalid_argument("frequencies of responses must be above 0");
    r.direction = all_round(r.direction);
    if (2 * M_PI - r.direction < kSame) r.direction = 0;
    add(omega_, r.omega);
    add(direction_, r.direction);
  }
  std::sort(omega_.begin(), omega_.end());
  std::sort(direction_.begin(), direction_.end());
  rows_.resize(omega_.size() * direction_.size());
  std::vector<char> given(rows_.size(), 0);
  const auto place = [](const std::vector<double>& list, double x) {
    return static_cast<size_t>(std::lower_bound(list.begin(), list.end(), x - kSame) - list.begin());
  };
  for (const Row& r : rows) {
    const size_t i = place(direction_, r.direction) * omega_.size() + place(omega_, r.omega);
    if (given[i]) throw std::invalid_argument("a frequency and direction of responses is there twice");
    rows_[i] = r.response;
    given[i] = 1;
    for (size_t k = 0; k < 6; ++k) largest_[k] = std::max(largest_[k], std::abs(r.response[k]));
  }
  if (std::find(given.begin(), given.end(), 0) != given.end())
    throw std::invalid_argument("every direction of responses needs the same frequencies");
}

Response RaoTable::at(double omega, double direction) const {
  const auto [i, next, z] = frequency_place(omega_, omega);
  const auto [a, b, y] = direction_place(direction_, direction);
  Response r;
  for (size_t k = 0; k < 6; ++k)
    r[k] = (1 - y) * ((1 - z) * row(a, i)[k] + z * row(a, next)[k]) +
           y * ((1 - z) * row(b, i)[k] + z * row(b, next)[k]);
  return r;
}

std::vector<RaoTable::Turn> RaoTable::turns(double omega, double direction) const {
  constexpr double kSmall = 0.1;  // fraction of the largest amplitude in the table
  std::vector<Turn> out;
  const auto [i, next, z] = frequency_place(omega_, omega);
  if (omega - omega_[i] < kSame || omega_[next] - omega < kSame) return out;
  const auto [a, b, y] = direction_place(direction_, direction);
  for (size_t d : {a, b}) {
    const size_t other = d == a ? b : a;
    if (a != b && std::abs(std::remainder(direction - direction_[other], 2 * M_PI)) < kSame) continue;
    for (size_t k = 0; k < 6; ++k) {
      const std::complex<double> p = row(d, i)[k];
      const std::complex<double> q = row(d, next)[k];
      const double small = std::min(std::abs(p), std::abs(q));
      if (!(small > kSmall * largest_[k]) || !((p * std::conj(q)).real() < 0)) continue;
      // Distance of the straight line from zero.
      const double smallest = std::abs((p * std::conj(q)).imag()) / std::abs(q - p);
      out.push_back({k, direction_[d], omega_[i], omega_[next], std::abs(std::arg(q / p)), small, smallest});
    }
    if (a == b) break;
  }
  return out;
}

std::vector<RaoTable::Row> with_other_side(const std::vector<RaoTable::Row>& rows) {
  std::vector<RaoTable::Row> out = rows;
  for (RaoTable::Row r : rows) {
    if (std::abs(std::remainder(r.direction, M_PI)) < kSame) continue;
    r.direction = -r.direction;
    for (const size_t k : {1, 3, 5}) r.response[k] = -r.response[k];
    out.push_back(r);
  }
  return out;
}

RaoMotion::RaoMotion(const RaoTable& table, const WaveField& waves, const Vec3& origin, double heading,
                     double yaw) {
  const double c = std::cos(heading);
  const double s = std::sin(heading);
  const auto turned = [&](double x, double y, double z) { return Vec3(c * x - s * y, s * x + c * y, z); };
  for (const WaveComponent& w : waves.components()) {
    const Response r = table.at(w.omega, std::atan2(w.y, w.x) - heading - yaw);
    // Elevation at the origin a cos(omega t - psi); motion a Re(r exp(i (omega t - psi))).
    const double psi = w.number * (w.x * origin.x() + w.y * origin.y()) + w.phase;
    double cosines[6], sines[6];  // coefficients of cos and sin omega t
    for (size_t k = 0; k < 6; ++k) {
      const std::complex<double> z = w.amplitude * r[k] * std::polar(1.0, -psi);
      cosines[k] = z.real();
      sines[k] = -z.imag();
    }
    terms_.push_back({w.omega, w.number * w.x, w.number * w.y, turned(cosines[0], cosines[1], cosines[2]),
                      turned(sines[0], sines[1], sines[2]), turned(cosines[3], cosines[4], cosines[5]),
                      turned(sines[3], sines[4], sines[5])});
    highest_ = std::max(highest_, w.omega);
  }
}

void RaoMotion::at(double t, Vec3& offset, Vec3& rotation, const Vec3& drifted) const {
  offset.setZero();
  rotation.setZero();
  for (const Term& m : terms_) {
    const double angle = m.omega * t - m.kx * drifted.x() - m.ky * drifted.y();
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    offset += c * m.offset_cos + s * m.offset_sin;
    rotation += c * m.rotation_cos + s * m.rotation_sin;
  }
}

void RaoMotion::rows(double first, double step, size_t count, const Vec3& drifted, std::vector<Vec3>& offset,
                     std::vector<Vec3>& rotation) const {
  // A phase increases by omega step per row: exp(i phase) is multiplied by a constant factor, whose rounding
  // errors accumulate until the next row that is computed with cosines.
  constexpr size_t kCosines = 256;
  const auto n = static_cast<Eigen::Index>(terms_.size());
  Eigen::Matrix<double, 6, Eigen::Dynamic> cosines(6, n);
  Eigen::Matrix<double, 6, Eigen::Dynamic> sines(6, n);
  Eigen::VectorXd c(n);
  Eigen::VectorXd s(n);
  Eigen::VectorXd before(n);
  Eigen::VectorXd by_c(n);
  Eigen::VectorXd by_s(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Term& m = terms_[static_cast<size_t>(k)];
    cosines.col(k) << m.offset_cos, m.rotation_cos;
    sines.col(k) << m.offset_sin, m.rotation_sin;
    by_c[k] = std::cos(m.omega * step);
    by_s[k] = std::sin(m.omega * step);
  }
  for (size_t i = 0; i < count; ++i) {
    if (i % kCosines == 0)
      for (Eigen::Index k = 0; k < n; ++k) {
        const Term& m = terms_[static_cast<size_t>(k)];
        const double angle =
            m.omega * (first + static_cast<double>(i) * step) - m.kx * drifted.x() - m.ky * drifted.y();
        c[k] = std::cos(angle);
        s[k] = std::sin(angle);
      }
    const Vec6 x = cosines * c + sines * s;
    offset.emplace_back(x.head<3>());
    rotation.emplace_back(x.tail<3>());
    before = c;
    c = c.cwiseProduct(by_c) - s.cwiseProduct(by_s);
    s = s.cwiseProduct(by_c) + before.cwiseProduct(by_s);
  }
}

}  // namespace hawser
