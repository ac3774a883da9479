// Low-pass filter of a body's position and heading.
#include "hawser/kernels/slow_pose.hpp"

#include <cmath>

namespace hawser {

SlowPose SlowPose::at(const Vec3& pose) {
  SlowPose out;
  out.place = out.filtered = out.last = pose;
  return out;
}

// y'' + 2 c y' + c² (y - x) = 0, z' = c (y' - z), slow pose y + 2 z/c, with x = x_0 + s t:
//   y = x - 2 s/c + (a + b t) exp(-c t),   z = s + (z_0 - s + c (b - c a) t - c² b t²/2) exp(-c t)
SlowPose SlowPose::after(const Vec3& pose, double h, double period) const {
  const double c = 2 * M_PI / period;
  SlowPose out;
  out.last = pose;
  out.last.z() = last.z() + std::remainder(pose.z() - last.z(), 2 * M_PI);
  const Vec3 s = (out.last - last) / h, lag = 2 / c * s;
  const Vec3 a = filtered - last + lag, b = rate - s + c * a;
  const double decay = std::exp(-c * h);
  const Vec3 decaying = decay * (a + h * b);
  out.filtered = out.last - lag + decaying;
  out.rate = s + decay * b - c * decaying;
  out.drift = s + decay * (drift - s + c * h * (b - c * a) - 0.5 * c * c * h * h * b);
  out.place = out.filtered + 2 / c * out.drift;
  return out;
}

// The same with s = pose/h and everything else zero: a = 2 s/c, b = s.
SlowPose::Derivatives SlowPose::derivatives(double h, double period) {
  const double c = 2 * M_PI / period, ch = c * h, decay = std::exp(-ch);
  const double decaying = decay * (2 / c + h), rate = 1 + decay - c * decaying;
  const double drift = 1 - decay * (1 + ch + 0.5 * ch * ch);
  return {(h - 2 / c + decaying + 2 / c * drift) / h, (3 * rate - 2 * drift) / h};
}

}  // namespace hawser
