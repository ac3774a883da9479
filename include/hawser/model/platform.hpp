// A floating platform of the case: its hydrodynamic coefficients and constant forces on it.
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

// What the sea does to a large floating body by the coefficients of a diffraction program.
struct BodyHydrodynamics {
  enum class Format { wamit, capytaine, bemio } format = Format::wamit;
  std::string files;            // path, absolute; of WAMIT's files without their endings
  double length = 1;            // m, ULEN of the files
  int body = 1;                 // which of the files' bodies it is
  Vec3 in_file = Vec3::Zero();  // m, of the body's origin in the axes of the files
  SecondOrder second_order = SecondOrder::none;
  bool excitation = true;  // waves act on it
  bool mirrored = false;   // wave forces from the other side are mirror images of those of the files
  bool gravity_in_stiffness = false;  // the hydrostatic stiffness has the part of its weight
  double volume = 0;                  // m³ that it displaces where `place` has it; 0: that of its mass
  std::optional<Vec3> place;          // m, of its origin where motion is counted from
  std::optional<double> heading;      // rad, there
  double follow = 100;                // s: waves and coefficients follow motion slower than this; 0: none
  Mat6 stiffness = Mat6::Zero(), damping = Mat6::Zero();  // added, about its origin: N/m ... N m s
  // Wave-drift damping by frequency, rad/s, growing: forces of surge and sway and moment of yaw over the
  // velocities and the square of the wave's amplitude; N s/m³, N s/m², N m s/m².
  std::vector<std::pair<double, Mat3>> drift_damping;
  Mat6 quadratic_damping = Mat6::Zero();  // times |v| v of the six velocities: N/(m/s)² ... N m/(rad/s)²
  std::shared_ptr<const HydrodynamicData> data;
  const char* key() const;  // that names the files
};

// Dynamic positioning (model/positioning.hpp): thrusters hold place and heading of a floating body by its
// slow motion.
struct DynamicPositioning {
  std::optional<Vec3> place;      // m, of the body's origin; z is not held
  std::optional<double> heading;  // rad
  // Of surge, sway and yaw: N/m, N m/rad; N s/m, N m s/rad; N/(m s), N m/(rad s).
  Vec3 proportional = Vec3::Zero(), derivative = Vec3::Zero(), integral = Vec3::Zero();
  double filter = 60;  // s: motion faster than this is left alone
  // N, of surge and sway alone; forces of both reach an ellipse of these half axes.
  Eigen::Vector2d max_force = Eigen::Vector2d::Constant(HUGE_VAL);
  double max_moment = HUGE_VAL;  // N m, of yaw
};

// Damping of the rates of a body's origin by wave drift in that sea, axes of its heading: the sum of the
// squares of the amplitudes times `drift_damping`, straight between its frequencies. N s/m, N s, N m s.
Mat6 wave_drift_damping(const BodyHydrodynamics& h, const std::vector<WaveComponent>& sea);

// A force on a floating body, constant or with a part by time.
struct BodyLoad {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  // N, N m
  std::vector<std::pair<double, Vec6>> table;        // s; N, N m, added to them: straight lines between rows
  Vec3 at = Vec3::Zero();                            // m, body frame
  bool body_fixed = false;                           // axes of the body; else of space
};

// Hydrostatics of the pressure alone, about the body's origin, with level 0: weight acts by itself. Files
// with gravity have -m g zG in C44 and C55, m g xG in C46 and m g yG in C56 (WAMIT manual 7, section 4.2). Of
// a body with hydrodynamics; density of the water [kg/m³], gravity [m/s²].
PlatformHydrostatics hydrostatics(const BodyMass& body, double density, double gravity);
// Stiffness of heave [N/m], roll and pitch [N m/rad] of that body with its weight, C - m g z_G of the
// rotations.
Vec3 restoring(const BodyMass& body, const PlatformHydrostatics& still, double gravity);

// Shares of a sea's energy that a table does not cover: at directions (seen from the bow) that it has no rows
// near, and at periods shorter and longer than its own. heading: rad, of the body.
struct Coverage {
  double uncovered = 0, shorter = 0, longer = 0;
  double direction = 0;  // rad, the first of those not covered
};
Coverage coverage(const WaveForceTable& table, const std::vector<WaveComponent>& sea, double heading);

// What `hawser check` says of a body with hydrodynamics, in lines.
std::string platform_text(const Case& c, const Body& b);

// Bodies of the case that radiate on each other: those with the same files, the first that is their body 1
// with the first that is their body 2, and so on. Files of one body: each by itself.
std::vector<std::vector<int>> radiating_groups(const Case& c);

}  // namespace hawser::model
