// Hydrodynamic coefficients of floating bodies as a diffraction program computes them, in SI units and one
// convention: motion and force = Re(X exp(i omega t)), phases lead the crest at the origin of the files,
// directions are where waves go to, moments about the point that the files have for each body.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "hawser/kernels/platform_waves.hpp"
#include "hawser/math/types.hpp"

namespace hawser::model {

struct HydrodynamicData {
  std::string radiation_file, excitation_file;       // for messages
  int bodies = 0;                                    // matrices have 6 rows and columns for each
  std::vector<double> omega;                         // rad/s, growing, above 0
  std::vector<Eigen::MatrixXd> added_mass, damping;  // by frequency: kg, kg m, kg m²; N s/m, N s, N m s
  Eigen::MatrixXd infinite;                          // added mass at infinite frequency
  bool infinite_estimated = false;                   // from the other rows: the files have none
  Eigen::MatrixXd hydrostatic;                       // N/m, N, N m/rad
  std::vector<WaveForceTable> excitation;            // by body: N/m, N; empty: not given
  std::vector<WaveForceTable> drift;  // by body: N/m², N/m of the amplitude squared; empty: not given
  DifferenceForceTable difference;    // of one body, at one direction
  // By body, where the files tell it: the point that moments are about, m, axes of the files; and the moment
  // m g (x, y, z) of its weight about that point, N m, that is in their hydrostatic stiffness.
  std::vector<std::optional<Vec3>> origin, weight;
};

}  // namespace hawser::model
