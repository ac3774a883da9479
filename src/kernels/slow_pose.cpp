// Low-pass filter of a body's position and heading.
#include "hawser/kernels/slow_pose.hpp"

#include <cmath>

namespace hawser {
namespace {
constexpr int kHeadingOrder = 3;
}

template <int N>
SlowPose<N> SlowPose<N>::at(const Vec3& pose) {
  SlowPose out;
  out.place = out.last = pose;
  out.delayed = pose.replicate<N, 1>();
  return out;
}

// y_k' = c (y_(k-1) - y_k), y_0 = x, k = 1 ... N; slow pose y_n + (n/c) y_n', n the order. With x = x_0 + u t
//   y_k(t) = x - k u/c + exp(-c t) sum_(j<k) (c t)^j/j! d_(k-j),   d_k = y_k(0) - x_0 + k u/c.
template <int N>
SlowPose<N> SlowPose<N>::after(const Vec3& pose, double h, double period) const {
  const double c = 2 * M_PI / period;
  SlowPose out;
  out.last = pose;
  out.last.z() = last.z() + std::remainder(pose.z() - last.z(), 2 * M_PI);
  const Vec3 lag = (out.last - last) / (c * h);
  const auto y = [](const SlowPose& of, int k) { return of.delayed.template segment<3>(3 * (k - 1)); };
  for (int k = 1; k <= N; ++k) {
    Vec3 sum = out.last - k * lag;
    double weight = std::exp(-c * h);
    for (int j = 0; j < k; ++j) {
      sum += weight * (y(*this, k - j) - last + (k - j) * lag);
      weight *= c * h / (j + 1);
    }
    out.delayed.template segment<3>(3 * (k - 1)) = sum;
  }
  const auto rate = [&](int k) { return Vec3(c * (y(out, k - 1) - y(out, k))); };
  for (int i = 0; i < 3; ++i) {
    const int n = i < 2 ? N : kHeadingOrder;
    out.drift[i] = rate(n)[i];
    out.speed[i] = rate(n)[i] + n * (rate(n - 1)[i] - rate(n)[i]);
    out.place[i] = y(out, n)[i] + n / c * rate(n)[i];
  }
  return out;
}

// The filter is linear: these are place and speed after a unit step from zero.
template <int N>
typename SlowPose<N>::Derivatives SlowPose<N>::derivatives(double h, double period) {
  const SlowPose unit = SlowPose().after(Vec3::UnitX(), h, period);
  return {unit.place.x(), unit.speed.x()};
}

template struct SlowPose<3>;
template struct SlowPose<5>;

}  // namespace hawser
