// Lower bounds of the distance between an element axis and a volume from known distances, which save most
// searches for contact.
#include "hawser/kernels/clearance_tube.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser {
namespace {

constexpr double kRounding = 1e-12;  // of coordinates
constexpr double kMargin = 1e-9;     // of distances

}  // namespace

double smallest_between(double w, double a, double b, double slope, double bend) {
  const double span = slope * w;
  const double straight = 0.5 * (a + b - span);
  if (!(a > 0 && b > 0)) return straight;
  const double p = a * a;
  const double q = b * b;
  // Half the second derivative of the squared distance is at most |x'|² + distance |x''|.
  const double c = span * span + (std::max(a, b) + span) * bend * w * w;
  if (!(c > 0)) return std::min(a, b);
  // Minimum of (1 - t) p + t q - c t (1 - t).
  const double t = std::clamp(0.5 - (q - p) / (2 * c), 0.0, 1.0);
  const double square = (1 - t) * p + t * q - c * t * (1 - t);
  return square > 0 ? std::max(straight, std::sqrt(square)) : straight;
}

void ClearanceTube::set(const BezierAxis& axis, double clearance) {
  double size = 0;
  for (const Vec3& p : axis.b) size = std::max(size, p.cwiseAbs().maxCoeff());
  at_ = axis;
  clearance_ = (1 - kMargin) * clearance - kRounding * size;
}

double ClearanceTube::radius_about(const BezierAxis& axis) const {
  if (!(clearance_ > 0)) return -1;
  return clearance_ - (1 + kMargin) * at_.farthest_distance(axis);
}

double least_distance(const std::vector<ClearancePoint>& places, double slope, double bend, double& worst) {
  double smallest = std::numeric_limits<double>::infinity();
  const auto take = [&](double distance, double xi) {
    if (!(distance >= smallest)) {
      smallest = distance;
      worst = xi;
    }
  };
  take(places.front().distance - slope * places.front().xi, 0);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const ClearancePoint& a = places[i];
    const ClearancePoint& b = places[i + 1];
    take(smallest_between(b.xi - a.xi, a.distance, b.distance, slope, bend), 0.5 * (a.xi + b.xi));
  }
  take(places.back().distance - slope * (1 - places.back().xi), 1);
  return smallest;
}

}  // namespace hawser
