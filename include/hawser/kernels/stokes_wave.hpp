// Steady wave of finite height by Stokes' expansion to the fifth order in k H/2: Fenton (1985), "A
// fifth-order Stokes theory for steady waves", J. Waterway, Port, Coastal and Ocean Engineering 111(2),
// coefficients of Table 1. See docs/theory/waves.md.
#pragma once

#include <array>

#include "hawser/kernels/waves.hpp"

namespace hawser {

struct StokesInput {
  double height = 0, period = 0;  // m, crest to trough; s, at a fixed point
  double depth = 0;               // m, mean water depth; <= 0: infinite
  double gravity = 9.80665;       // m/s²
  double direction = 0;           // rad, where the wave goes
  double phase = 0;               // rad: the crest is where k x - omega t + phase = 0
  // Uniform current along the wave, m/s: the Eulerian mean velocity at a point below the troughs or, with
  // `transport`, the depth-averaged mass transport velocity (Stokes' mean velocity).
  double current = 0;
  bool transport = false;
};

class StokesWave {
 public:
  // Throws std::invalid_argument with a message for an invalid height, period or depth, a wave higher than
  // the highest possible one (highest_wave), one too long for its depth (Ursell number above 100), or an
  // opposing current that the wave cannot run against.
  explicit StokesWave(const StokesInput& input);

  double number() const { return k_; }     // 1/m
  double omega() const { return omega_; }  // rad/s
  double length() const;                   // m
  double depth() const { return depth_; }  // m; for deep water a depth without motion
  double drift() const { return drift_; }  // m/s, Eulerian mean velocity
  double ursell() const;                   // H L²/d³; the theory is valid below about 40
  double head() const { return head_; }    // m²/s², Bernoulli constant in the moving frame, from the bed
  WaveComponent component() const;         // linear wave of the same height

  // As WaveField::at; the acceleration is the material one of the water. Above the surface the motion is that
  // of the surface.
  WaveMotion at(const Vec3& x, double t, double factor = 1, double rate = 0) const;
  // Wave pressure over rho g [m], as WaveField::head. The flow is steady in axes that move with the wave
  // speed c; with its velocity u along the wave and w upwards, R = head() and the depth d, Bernoulli's law
  // gives
  //   head = (R - ((u - c)² + w²)/2)/g - d
  double head_at(const Vec3& x, double t, double factor = 1) const;

 private:
  // Velocity along the wave and upwards, m/s; derivatives of the former along the wave and by height, 1/s;
  // time derivatives of both, m/s².
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
  std::array<double, 6> surface_{};    // m, coefficients of cos(j theta)
  std::array<double, 6> potential_{};  // m/s, j times the coefficients of cosh(j k y) cos(j theta)
};

// Height [m] of the highest wave of a length [m] at a depth [m] (<= 0: infinite): Williams (1981), fit by
// Fenton (1990), "Nonlinear wave theories", The Sea 9, eq. 32.
double highest_wave(double length, double depth);

}  // namespace hawser
