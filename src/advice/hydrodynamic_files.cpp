// Notes on the coefficients in files of diffraction programs.
#include "hawser/advice/hydrodynamic_files.hpp"

#include <fmt/format.h>

#include "hawser/math/freedoms.hpp"

namespace hawser::advice {
namespace {

std::string negative_damping(const std::string& file, double fraction, double period) {
  return fmt::format(
      "{}: radiation damping of {:.3g} % of its sum over the frequencies is negative, most at {:.4g} s", file,
      100 * fraction, period);
}

}  // namespace

std::string modes_text(int i, int j) {
  const auto name = [](int mode) {
    return mode < 6 ? std::string(kFreedomNames[mode])
                    : fmt::format("{} of body {}", kFreedomNames[mode % 6], mode / 6 + 1);
  };
  return i == j ? name(i) : name(i) + " and " + name(j);
}

std::string frequency_limits_swapped(const std::string& file) {
  return file +
         ": added mass at zero frequency (WAMIT's period -1) belongs to the shortest waves of the file and "
         "that at infinite frequency (period 0) to the longest: these rows are swapped, or the first column "
         "has frequencies in place of periods";
}

std::string damping_over_frequency(const std::string& file, bool multiplied, double times) {
  return fmt::format(
      "{}: with the damping {} the angular frequency, the added masses at infinite frequency that follow "
      "from each row by Ogilvie's relation scatter {:.0f} times less: is the damping stored over omega as "
      "its format requires (WAMIT's and BEMIO's is B/(rho omega), Capytaine's is B)?",
      file, multiplied ? "multiplied by" : "divided by", times);
}

std::string added_mass_not_of_damping(const std::string& file, double fraction) {
  return fmt::format(
      "{}: added mass and damping do not belong together: by Ogilvie's relation each frequency yields the "
      "added mass at infinite frequency, and these values differ by {:.0f} % of the range of the added mass",
      file, 100 * fraction);
}

std::string far_from_neighbours(const std::string& file, const IsolatedValue& v, int more) {
  return fmt::format(
      "{}: {} of {} at {:.5g} s, {:.4g}, is far from its neighbours, {:.4g} and {:.4g}{}: an error of the "
      "file, or an irregular frequency of its panels: remove that period, or suppress irregular frequencies "
      "in the diffraction run (WAMIT's IRR)",
      file, v.quantity, modes_text(v.i, v.j), v.period, v.value, v.at_shorter, v.at_longer,
      more > 0 ? fmt::format(" (and {} more)", more) : "");
}

std::string infinite_frequency_estimated(const std::string& file) {
  return file +
         ": has no added mass at infinite frequency (WAMIT's period 0); it is estimated from the other "
         "frequencies by Ogilvie's relation";
}

std::string mostly_negative_damping(const std::string& file, int mode) {
  return fmt::format(
      "{}: the radiation damping of {} is negative at most frequencies and is taken as zero there: waves "
      "that a body makes cannot drive it; does the file have the other sign?",
      file, modes_text(mode, mode));
}

std::string negative_damping_excluded(const std::string& file, double fraction, double period) {
  return negative_damping(file, fraction, period) + "; it is excluded";
}

std::string too_much_negative_damping(const std::string& file, double fraction, double period) {
  return negative_damping(file, fraction, period) +
         ": waves that a body makes cannot drive it; does the file have the other sign, or irregular "
         "frequencies of its panels?";
}

std::string asymmetric_stiffness(const std::string& file, int i, int j, double ij, double ji) {
  return fmt::format(
      "{}: the hydrostatic stiffness of {} has {:.4g} in row {} and {:.4g} in row {}, and is symmetric: the "
      "mean of both is used",
      file, modes_text(i, j), ij, i % 6 + 1, ji, j % 6 + 1);
}

std::string asymmetric_matrix(const std::string& file, const char* quantity, double fraction, double period) {
  return fmt::format(
      "{}: {} differs from its transpose by up to {:.2g} % of the diagonal, {}; the mean of both is used",
      file, quantity, 100 * fraction,
      period > 0 ? fmt::format("at {:.4g} s", period) : "at infinite frequency");
}

std::string other_water_depth(const std::string& file, double depth, double depth_of_case) {
  const auto text = [](double h) { return h > 0 ? fmt::format("{:g} m deep", h) : "infinitely deep"; };
  return fmt::format("{}: is made for water {}, and that of the case is {}: give them the same depth", file,
                     text(depth), text(depth_of_case));
}

std::string weight_elsewhere(const std::string& key, const Vec3& in_file, const Vec3& of_body) {
  return fmt::format(
      "{}: the stiffness of the file has the weight at ({:.3g}, {:.3g}, {:.3g}) m from the point that its "
      "moments are about, and 'centre_of_mass' is ({:.3g}, {:.3g}, {:.3g}): is that point the body's origin, "
      "at 'origin_in_file'?",
      key, in_file.x(), in_file.y(), in_file.z(), of_body.x(), of_body.y(), of_body.z());
}

std::string freedom_without_coefficients(const std::string& file, const char* freedom, int body) {
  return fmt::format("{}: has no freedom {} of body {}, whose coefficients are then zero", file, freedom,
                     body);
}

std::string frequencies_excluded(const std::string& file, const char* quantity,
                                 const std::vector<double>& omega) {
  const bool one = omega.size() == 1;
  return fmt::format(
      "{}: the {} of {} frequenc{}, {:g} to {:g} rad/s, {} entries that are no numbers and {} excluded", file,
      quantity, omega.size(), one ? "y" : "ies", omega.front(), omega.back(), one ? "has" : "have",
      one ? "is" : "are");
}

std::string other_gravity(const std::string& file, double gravity, double of_case) {
  return fmt::format("{}: is made with a gravity of {:g} m/s², the case has {:g}", file, gravity, of_case);
}

std::string no_vertical_drift(const std::string& file) {
  return file +
         ": has no rows of heave, roll and pitch, whose mean drift is then zero (the momentum of .8 shows "
         "only that of surge, sway and yaw)";
}

std::string periods_too_sparse(const std::string& file, double difference) {
  return fmt::format(
      "{}: its periods are too sparse for 'second_order: full': forces of neighbouring periods in surge and "
      "sway differ from the mean drift of the two by {:.0f} % of it: add periods between them, or take "
      "'second_order: newman'",
      file, 100 * difference);
}

}  // namespace hawser::advice
