// Sea, wind and seabed of a case. Units are SI, angles rad. z up, origin at the still water level; directions
// are where a flow goes to, anticlockwise from +x.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hawser/kernels/contact_force_table.hpp"
#include "hawser/kernels/current.hpp"
#include "hawser/kernels/waves.hpp"
#include "hawser/kernels/wind.hpp"
#include "hawser/model/contact_properties.hpp"

namespace hawser {
class Surface;
}

namespace hawser::model {

struct CurrentRow {
  double depth = 0;      // m below the surface, positive
  double speed = 0;      // m/s
  double direction = 0;  // rad
};

// Linear between the rows, constant above the first and below the last; or, with an exponent, one row and the
// power law speed (1 - depth/water depth)^exponent.
struct Current {
  std::vector<CurrentRow> profile;  // empty: no current
  double exponent = 0;
  double ramp = 0;         // s, smooth start in dynamics; 0: acts from statics on
  TimeFactor time_factor;  // multiplies the speed as well
};

// Linear waves: a regular wave, components of a spectrum (by formula or table) or given components; or a
// Stokes wave of finite height.
struct WaveSystem {
  enum class Kind { regular, spectrum, components, stokes, table };
  Kind kind = Kind::components;
  std::string key;  // in the case file
  struct Row {
    double height = 0, period = 0;    // m, crest to trough; s
    double direction = 0, phase = 0;  // rad
  };
  std::vector<Row> rows;                          // regular or Stokes wave, or given components
  double height = 0, peak_period = 0, gamma = 1;  // of a spectrum: Hs [m], Tp [s]
  double direction = 0, spreading = 0;            // rad; exponent s of cos^2s, 0: long-crested
  std::vector<SpectrumRow> spectrum;              // rows of Kind::table
  double current = 0;                             // m/s, uniform, collinear with the Stokes wave
  bool transport =
      false;        // `current` is the depth-averaged transport velocity; else the mean Eulerian velocity
  int count = 200;  // number of components of a spectrum
  std::uint64_t seed = 1;

  bool irregular() const { return kind == Kind::spectrum || kind == Kind::table; }
};

// Systems such as wind sea and swell, whose linear waves are added; a Stokes wave is alone.
struct Waves {
  std::vector<WaveSystem> systems;  // empty: no waves
  Stretching stretching = Stretching::wheeler;
  double ramp = 0;  // s, smooth start in dynamics

  bool none() const { return systems.empty(); }
  bool stokes() const { return !none() && systems.front().kind == WaveSystem::Kind::stokes; }
};

struct Water {
  bool present = false;
  double density = 1025;  // kg/m³
  double depth = 0;       // m; 0: not given
  double surface = 0;     // m, z of the still water
  Current current;
  Waves waves;
};

// A plane through (0, 0, -depth) that descends with `slope` towards `direction`; or a surface.
struct Seabed {
  bool present = false;
  std::shared_ptr<const Surface> surface;  // grid or mesh, space axes; null: the plane
  std::string file;                        // of the surface
  double depth = 0;                        // m
  double slope = 0, direction = 0;         // rad
  StiffnessBasis basis = StiffnessBasis::per_area;
  double normal_stiffness = 0;  // N/m² or N/m³ by basis; with a table: its largest slope
  std::shared_ptr<const ContactForceTable> force_table;  // N/m or N/m² by basis; null: by stiffness
  double damping = 0;                                    // N s/m² or N s/m³ by basis
  std::optional<double> smoothing;                       // m, half width of the C1 ramp; none: default
  double suction = 0;         // N/m or N/m² by basis, largest uplift resistance; in dynamics
  double suction_length = 0;  // m above the deepest penetration at which suction ends
  Friction friction;
  bool as_laid = true;  // in statics friction opposes the displacement from the laid position,
  bool full = false;    // ... fully mobilised at the slightest slip
};

// Wind over the sea; acts on bodies with wind coefficients.
struct Wind {
  bool present = false;
  double speed = 0;           // m/s, hourly mean at `height`
  double direction = 0;       // rad
  double height = 10;         // m above the still water
  double exponent = 1.0 / 7;  // speed at z is multiplied by (z/height)^exponent
  double density = 1.225;     // kg/m³
  double ramp = 0;            // s, smooth start in dynamics; 0: acts from statics on
  TimeFactor time_factor;     // multiplies the speed as well
  GustSpectrum gusts = GustSpectrum::none;
  int components = 200;  // number of gust components
  std::uint64_t seed = 1;
  double gust_ramp = 60;  // s
};

struct Environment {
  double gravity = 9.80665;  // m/s², acts along -z
  Water water;
  Wind wind;
  Seabed seabed;
};

}  // namespace hawser::model
