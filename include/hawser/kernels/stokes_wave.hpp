// A steady wave of finite height by Stokes' expansion to the fifth order in k H/2: Fenton (1985), "A
// fifth-order Stokes theory for steady waves", J. Waterway, Port, Coastal and Ocean Engineering 111(2), with
// its coefficients of Table 1. See docs/theory/waves.md.
#pragma once

#include <array>

#include "hawser/kernels/waves.hpp"

namespace hawser {

struct StokesInput {
  double height = 0, period = 0;  // m, crest to trough; s, at a fixed place
  double depth = 0;               // m, of the mean water; <= 0: infinite
  double gravity = 9.80665;       // m/s²
  double direction = 0;           // rad, where it goes to
  double phase = 0;               // rad: the crest is where k x - omega t + phase = 0
  // m/s, along the wave, uniform, that it rides on: Euler's mean velocity at a place under the troughs, or
  // with `transport` the mean over the depth of what is carried along (Stokes' mean velocity).
  double current = 0;
  bool transport = false;
};

class StokesWave {
 public:
  // std::invalid_argument with a sentence: a height, period or depth that makes no sense; higher than any
  // wave of its length and depth can be (highest_wave); too long for its depth (Ursell number above 100);
  // a current that the wave cannot run against.
  explicit StokesWave(const StokesInput& input);

  double number() const { return k_; }     // 1/m
  double omega() const { return omega_; }  // rad/s
  double length() const;                   // m
  double depth() const { return depth_; }  // m; of deep water one at which nothing moves any more
  double drift() const { return drift_; }  // m/s, Euler's mean velocity
  double ursell() const;                   // H L²/d³; the theory is for less than about 40
  double head() const { return head_; }    // m²/s², of Bernoulli's law in the moving frame, from the bed
  WaveComponent component() const;         // linear, of half its height

  // As of WaveField::at; the acceleration is that of the water, with its convective part. What is above the
  // surface has the motion of the surface.
  WaveMotion at(const Vec3& x, double t, double factor = 1, double rate = 0) const;
  // Pressure of the wave over rho g, m, as of WaveField::head. In axes that move with it, at the speed c, the
  // flow is steady; with its velocity u along and w upwards, R = head() and the depth d, by Bernoulli's law
  //   head = (R - ((u - c)² + w²)/2)/g - d
  double head_at(const Vec3& x, double t, double factor = 1) const;

 private:
  // Velocity along the wave and upwards, m/s; the derivatives of the first by the way along it and by height,
  // 1/s; of both by time, m/s².
  struct Flow {
    double u = 0, w = 0, ux = 0, uz = 0, ut = 0, wt = 0;
  };
  Flow flow(double theta, double y) const;
  double over_bed(double z, double surface) const;
  double at_phase(double theta) const;
  double angle(double x, double y, double t) const;

  StokesInput input_;
  double k_ = 0, omega_ = 0, depth_ = 0, drift_ = 0, head_ = 0;
  double cos_ = 1, sin_ = 0;           // of the direction
  std::array<double, 6> surface_{};    // m, of cos(j theta)
  std::array<double, 6> potential_{};  // m/s, j times of cosh(j k y) cos(j theta)
};

// Height [m] of the highest wave of a length [m] on a depth [m] (<= 0: infinite): Williams (1981), as fitted
// by Fenton (1990), "Nonlinear wave theories", The Sea 9, eq. 32.
double highest_wave(double length, double depth);

}  // namespace hawser
