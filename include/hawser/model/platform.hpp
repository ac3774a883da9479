// Floating platforms: hydrodynamic coefficients, dynamic positioning and applied forces.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hawser/kernels/platform_hydrostatics.hpp"
#include "hawser/math/types.hpp"
#include "hawser/model/hydrodynamic_data.hpp"

namespace hawser::model {

struct Body;
struct BodyMass;
struct Case;

// Wave and radiation loads on a large floating body by coefficients of a diffraction program.
struct BodyHydrodynamics {
  enum class Format { wamit, capytaine, bemio } format = Format::wamit;
  std::string files;            // absolute path; WAMIT: without extensions
  double length = 1;            // m, ULEN of the WAMIT files
  int body = 1;                 // number of the body in the files, from 1
  Vec3 in_file = Vec3::Zero();  // m, body origin in the axes of the files
  SecondOrder second_order = SecondOrder::none;
  bool second_order_given = false;
  bool excitation = true;  // first-order wave forces act
  bool mirrored = false;   // wave forces from the other side are mirror images of those in the files
  bool gravity_in_stiffness = false;  // the hydrostatic stiffness includes the contribution of weight
  double volume = 0;                  // m³ displaced at `place`; 0: mass over density
  std::optional<Vec3> place;          // m, reference position of the body origin
  std::optional<double> heading;      // rad, reference heading
  double follow_period = 100;  // s: waves and coefficients follow motion slower than this; 0: they do not
  Mat6 stiffness = Mat6::Zero(), damping = Mat6::Zero();  // additional, about the body origin: N/m ... N m s
  // Wave-drift damping by frequency [rad/s, increasing]: surge and sway forces and yaw moment per velocity
  // and per squared wave amplitude; N s/m³, N s/m², N m s/m².
  std::vector<std::pair<double, Mat3>> drift_damping;
  Mat6 quadratic_damping = Mat6::Zero();  // factors of |v| v of the six velocities: N/(m/s)² ... N m/(rad/s)²
  std::shared_ptr<const HydrodynamicData> data;
  const char* key() const;  // key of the case file that gives the files
  // First row of this body in the matrices of the files.
  Eigen::Index first_row() const { return 6 * (static_cast<Eigen::Index>(body) - 1); }
  // First-order wave forces of the files that act on this body; null: none, or `excitation` is false.
  const WaveForceTable* wave_forces() const;
  // Waves exert forces of first or second order on this body.
  bool waves_act() const { return excitation || second_order != SecondOrder::none; }
};

// Dynamic positioning (model/positioning.hpp): thrusters control the low-frequency position and heading of a
// floating body.
struct DynamicPositioning {
  std::optional<Vec3> place;      // m, body origin; z is not controlled
  std::optional<double> heading;  // rad
  // Gains in surge, sway and yaw: N/m, N m/rad; N s/m, N m s/rad; N/(m s), N m/(rad s).
  Vec3 proportional = Vec3::Zero(), derivative = Vec3::Zero(), integral = Vec3::Zero();
  double filter = 60;  // s: faster motion is filtered out
  // N, limits in surge and sway; half axes of the ellipse that limits combined forces.
  Eigen::Vector2d max_force = Eigen::Vector2d::Constant(HUGE_VAL);
  double max_moment = HUGE_VAL;  // N m, yaw
};

// Wave-drift damping matrix in the given sea, about the body origin, axes of its heading: the sum over
// components of amplitude² times `drift_damping`, linear between its frequencies. N s/m, N s, N m s.
Mat6 wave_drift_damping(const BodyHydrodynamics& h, const std::vector<WaveComponent>& sea);

// Force on a floating body, constant or time dependent.
struct BodyLoad {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // N, N m
  std::vector<std::pair<double, Vec6>> table;  // s; N, N m, added to the constant part; linear between rows
  Vec3 at = Vec3::Zero();                      // m, body frame
  bool body_fixed = false;                     // body axes; else space axes
};

// Volume of water that a body with hydrodynamics displaces at `place`, m³: the given one, or that of its
// mass.
double displaced_volume(const BodyMass& body, double density);
// Hydrostatics of the pressure alone, about the body origin, with the water level at 0; weight acts
// separately. Files with gravity include -m g zG in C44 and C55, m g xG in C46 and m g yG in C56 (WAMIT
// manual 7, section 4.2). The body needs hydrodynamics; density [kg/m³] of water, gravity [m/s²].
PlatformHydrostatics hydrostatics(const BodyMass& body, double density, double gravity);
// Stiffness matrix of heave [N/m], roll and pitch [N m/rad] with weight: C, less m g z_G for both rotations.
Mat3 restoring(const BodyMass& body, const PlatformHydrostatics& hydrostatics, double gravity);

// Fractions of a sea's energy outside a table of wave forces: at directions (relative to the bow) without
// nearby rows, and at periods shorter or longer than those of the table. heading: of the body, rad.
struct Coverage {
  double uncovered = 0, shorter_waves = 0, longer_waves = 0;
  double direction = 0;  // rad, the first direction not covered
};
Coverage coverage(const WaveForceTable& table, const std::vector<WaveComponent>& sea, double heading);

// Mean direction of a sea by the energy of its waves, rad, and the fraction of the energy that goes to
// directions more than kFarFromMean from it; zeros without waves.
struct MeanDirection {
  double direction = 0, far = 0;
};
constexpr double kFarFromMean = 45 * M_PI / 180;
MeanDirection mean_direction(const std::vector<WaveComponent>& sea);

// Forces of all difference frequencies of the direction of the files nearest to the mean direction of a sea,
// for a body with this heading [rad]; the files must have them.
const DifferenceForces& difference_forces(const BodyHydrodynamics& h, const std::vector<WaveComponent>& sea,
                                          double heading);

// Lines on a body with hydrodynamics that `hawser check` prints.
std::string platform_text(const Case& c, const Body& b);

// Groups of bodies that interact by radiation: bodies with the same files, the first that is their body 1
// with the first that is their body 2, and so on. Bodies with single-body files are groups of their own.
std::vector<std::vector<int>> radiating_groups(const Case& c);

}  // namespace hawser::model
