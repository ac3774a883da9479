// Hydrodynamic coefficients of floating bodies from a diffraction program, in SI units and one convention:
// motion and force = Re(X exp(i omega t)); phases are leads over the crest at the origin of the files;
// directions are where waves go to; moments are about the reference point of each body in the files.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "hawser/kernels/platform_waves.hpp"
#include "hawser/math/types.hpp"

namespace hawser::model {

// Forces of all difference frequencies on one body in waves of one direction.
struct DifferenceForces {
  std::vector<WaveForceTable> drift;  // of that direction, as in HydrodynamicData
  DifferenceForceTable pairs;
  double direction() const { return drift.front().directions().front(); }  // rad
};

struct HydrodynamicData {
  std::string radiation_file, excitation_file;       // for messages
  int bodies = 0;                                    // matrices have 6 rows and columns per body
  std::vector<double> omega;                         // rad/s, increasing, positive
  std::vector<Eigen::MatrixXd> added_mass, damping;  // per frequency: kg, kg m, kg m²; N s/m, N s, N m s
  Eigen::MatrixXd infinite;                          // added mass at infinite frequency
  bool infinite_estimated = false;                   // extrapolated from finite frequencies
  Eigen::MatrixXd hydrostatic;                       // N/m, N, N m/rad
  std::vector<WaveForceTable> excitation;            // per body: N/m, N per m amplitude; empty: not given
  std::vector<WaveForceTable> drift;         // per body: N/m², N/m per squared amplitude; empty: not given
  std::vector<DifferenceForces> difference;  // of one body, by direction; empty: not given
  std::string unread_drift_file;  // of mean drift or difference-frequency forces that `second_order` excludes
  // Per body, if the files contain them: the reference point of moments [m, axes of the files] and the moment
  // of weight m g (x, y, z) about it [N m] that is part of their hydrostatic stiffness.
  std::vector<std::optional<Vec3>> origin, weight;
};

}  // namespace hawser::model
