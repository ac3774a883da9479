// Common parts of the readers of diffraction programs: tables of wave forces built from entries, and
// completion and checks of coefficients.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hawser/io/hydrodynamic_files.hpp"
#include "hawser/math/degree.hpp"

namespace hawser::io {

inline bool rotates(int mode) { return mode % 6 >= 3; }  // modes from 0

// Force tables from entries by frequency, direction [rad, 0 to 2 pi] and mode. Modes without an entry are
// zero; the directions -180 and 180 degrees are the same.
class WaveForceRows {
 public:
  WaveForceRows(int bodies, bool mirrored) : bodies_(bodies), mirrored_(mirrored) {}
  void add(double omega, double direction_deg, int mode, Complex value);
  bool none() const { return values_.empty(); }
  // Tables of each body. Refuses directions in radians, and a pair of frequency and direction without rows or
  // without one of a significant mode.
  std::vector<WaveForceTable> tables(const std::string& path);

 private:
  void add_other_side(const std::string& path);
  void complete_modes(const std::string& path);
  void check_again(const std::string& path) const;
  void check_degrees(const std::string& path) const;

  // An entry given more than once: of the forces and of the moments that with the largest change.
  struct Again {
    double omega = 1, direction = 0;
    int mode = 0;
    Complex change = 0;
  };
  int bodies_;
  bool mirrored_;
  std::array<Again, 2> again_;
  std::map<long, double> directions_;
  std::map<std::pair<double, long>, std::vector<Complex>> values_;
};

// Symmetric matrices, damping without negative eigenvalues, and added mass at infinite frequency if the files
// have none (`has_infinite` false). zero_frequency: added mass at omega = 0, or empty. Refuses impossible
// coefficients and notes implausible ones (hydrodynamic_checks.cpp).
void finish_coefficients(model::HydrodynamicData& data, bool has_infinite,
                         const Eigen::MatrixXd& zero_frequency, std::vector<std::string>& notes);

// Refuses several bodies in files whose other side is to be mirrored.
void check_mirrored(const HydrodynamicForm& form, const model::HydrodynamicData& data);

// Notes files made for another depth of water [m; infinite: 0 or HUGE_VAL] than that of the case.
void note_depth(const HydrodynamicForm& form, double depth, const model::HydrodynamicData& data,
                std::vector<std::string>& notes);

// Checks symmetric added mass and damping individually and against each other.
void check_coefficients(const model::HydrodynamicData& data, bool has_infinite,
                        const Eigen::MatrixXd& zero_frequency, std::vector<std::string>& notes);

}  // namespace hawser::io
