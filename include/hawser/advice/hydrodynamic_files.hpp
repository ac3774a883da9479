// Notes on the coefficients in files of diffraction programs, and refusals that have a part in common with a
// note. file: its path; modes count from 0, six for each body.
#pragma once

#include <string>
#include <vector>

#include "hawser/math/types.hpp"

namespace hawser::advice {

// Names such as "surge and pitch", "heave of body 2".
std::string modes_text(int i, int j);

// A refusal if the file has both limits, a note if it has one.
std::string frequency_limits_swapped(const std::string& file);
// With the damping multiplied (or divided) by the angular frequency, the added masses at infinite frequency
// by Ogilvie's relation scatter `times` less.
std::string damping_over_frequency(const std::string& file, bool multiplied, double times);
// The same values differ by `fraction` of the range of the added mass.
std::string added_mass_not_of_damping(const std::string& file, double fraction);

// A value far from those at the neighbouring periods.
struct IsolatedValue {
  const char* quantity = "";  // "added mass", "damping"
  int i = 0, j = 0;           // modes
  double period = 0;          // s
  double value = 0, at_shorter = 0, at_longer = 0;
};
// more: number of others.
std::string far_from_neighbours(const std::string& file, const IsolatedValue& v, int more);

std::string infinite_frequency_estimated(const std::string& file);
std::string mostly_negative_damping(const std::string& file, int mode);
// Negative eigenvalues of the damping, as a fraction of its sum over the frequencies, most at a period [s]:
// the note, and the refusal of a large part.
std::string negative_damping_excluded(const std::string& file, double fraction, double period);
std::string too_much_negative_damping(const std::string& file, double fraction, double period);
// Entries (i, j) and (j, i) of the hydrostatic stiffness; i, j: modes.
std::string asymmetric_stiffness(const std::string& file, int i, int j, double ij, double ji);
// Largest difference from the transpose, as a fraction of the diagonal. period: s; 0: infinite frequency.
std::string asymmetric_matrix(const std::string& file, const char* quantity, double fraction, double period);
// Depths in m; 0: infinite.
std::string other_water_depth(const std::string& file, double depth, double depth_of_case);
// Centres of mass [m] by the stiffness of the file, and of the body.
std::string weight_elsewhere(const std::string& key, const Vec3& in_file, const Vec3& of_body);

// Capytaine. freedom: its name in the file; body: from 1.
std::string freedom_without_coefficients(const std::string& file, const char* freedom, int body);
// omega: rad/s, ascending, not empty.
std::string frequencies_excluded(const std::string& file, const char* quantity,
                                 const std::vector<double>& omega);
std::string other_gravity(const std::string& file, double gravity, double of_case);  // m/s²

// WAMIT.
std::string no_vertical_drift(const std::string& file);
// difference: of the forces from the mean drift, as a fraction of it.
std::string periods_too_sparse(const std::string& file, double difference);

}  // namespace hawser::advice
