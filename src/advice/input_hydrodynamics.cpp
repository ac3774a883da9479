// A platform's coefficients against each other, its size and long-wave limits: other conventions and units.
#include <algorithm>
#include <cmath>
#include <complex>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/kernels/waves.hpp"
#include "hawser/math/angle_gap.hpp"
#include "hawser/math/freedoms.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/check_drift.hpp"
#include "hawser/model/check_freedoms.hpp"
#include "hawser/model/check_long_waves.hpp"
#include "hawser/model/waterplane.hpp"

namespace hawser::advice {

using namespace model;

namespace {

// Key of the files of a body.
std::string key_of_files(const Body& b) {
  return "bodies." + b.name + ".floating.hydrodynamics." + b.mass->hydrodynamics->key();
}

// True if the table has directions all round.
bool all_round(const WaveForceTable& table) {
  constexpr double kGap = M_PI / 3 * (1 + 1e-6);
  return table.directions().size() >= 3 && widest_gap(table.directions(), 2 * M_PI).width() <= kGap;
}

// Weights of the directions [rad] of a table for the mean over the circle: the constant of the Fourier series
//   c + sum_m (a_m cos m beta + b_m sin m beta),   m = 1 ... harmonics
// that fits the values best, each direction counted by its part of the circle. It is exact for such a series.
// The fit is well conditioned if no gap exceeds pi/harmonics (Groechenig 1992, Reconstruction algorithms in
// irregular sampling).
Eigen::RowVectorXd mean_weights(const std::vector<double>& directions, int harmonics) {
  const Eigen::Index rows = std::ssize(directions);
  const Eigen::Index columns = 1 + 2 * Eigen::Index{harmonics};
  Eigen::MatrixXd series(rows, columns);
  Eigen::VectorXd part(rows);
  for (Eigen::Index d = 0; d < rows; ++d) {
    const auto at = [&](Eigen::Index k) { return directions[static_cast<size_t>((k + rows) % rows)]; };
    const double turn = 2 * M_PI;
    const double around = at(d + 1) - at(d - 1);
    part[d] = 0.5 * (d == 0 || d + 1 == rows ? around + turn : around);
    series(d, 0) = 1;
    for (int m = 1; m <= harmonics; ++m) {
      series(d, 2 * m - 1) = std::cos(m * at(d));
      series(d, 2 * m) = std::sin(m * at(d));
    }
  }
  const Eigen::MatrixXd weighted = series.transpose() * part.asDiagonal();
  return Eigen::MatrixXd(weighted * series).ldlt().solve(weighted).row(0);
}

// Harmonics that the widest gap of the directions resolves; of waves longer than the body those above the
// sixth are negligible.
int resolved_harmonics(const std::vector<double>& directions) {
  constexpr int kMost = 6;
  constexpr double kRounding = 1e-6;
  const double resolved = M_PI / widest_gap(directions, 2 * M_PI).width();
  return std::min(kMost, static_cast<int>(std::ceil(resolved - kRounding)) - 1);
}

// Heave force at the phase of the wave at the centre of the waterplane: its mean over all directions or, of
// files without directions all round, its value in the first one.
class HeaveForce {
 public:
  HeaveForce(const WaveForceTable& table, const Eigen::Vector2d& centre) : table_(table), centre_(centre) {
    if (!all_round(table)) return;
    const int harmonics = resolved_harmonics(table.directions());
    weights_ = mean_weights(table.directions(), harmonics);
    coarse_ = mean_weights(table.directions(), harmonics - 1);
  }
  bool has_mean() const { return weights_.size() > 0; }
  // number: of the wave, 1/m.
  Complex at(double omega, double number) const {
    return has_mean() ? mean(weights_, omega, number) : at(omega, number, table_.directions().front());
  }
  // Estimated error of the mean: its change by the last harmonic.
  double error(double omega, double number) const {
    return has_mean() ? std::abs(mean(weights_, omega, number) - mean(coarse_, omega, number)) : 0;
  }

 private:
  Complex at(double omega, double number, double beta) const {
    const double lead = number * (centre_.x() * std::cos(beta) + centre_.y() * std::sin(beta));
    return table_.at(omega, beta)[2] * std::polar(1.0, lead);
  }
  Complex mean(const Eigen::RowVectorXd& weights, double omega, double number) const {
    Complex sum = 0;
    for (Eigen::Index d = 0; d < weights.size(); ++d)
      sum += weights[d] * at(omega, number, table_.directions()[static_cast<size_t>(d)]);
    return sum;
  }

  const WaveForceTable& table_;
  Eigen::Vector2d centre_;
  Eigen::RowVectorXd weights_, coarse_;
};

// In moderately long waves the heave force is that of the stiffness plus, a quarter of a period ahead of the
// crest, that of damping by the velocity of the water: Im X3 = omega B33 at the centre of the waterplane. The
// pressure on a wide waterplane has another imaginary part, which the mean over all directions does not have:
// with the distance r from the centre, the mean of exp(-i k r cos beta) is J0(k r).
void warn_of_heave_phase(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  constexpr double kLong = 0.6, kOpposite = -0.4;
  constexpr double kWide = 0.015;    // of |X3|: the damping is above the part by the waterplane
  constexpr double kRounded = 2e-4;  // rad: it is above the rounding of phases to 0.01 deg
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const HydrodynamicData& data = *h.data;
  if (data.bodies > 1) return;
  const Water& water = c.environment.water;
  const double g = c.environment.gravity;
  const WaveForceTable& table = data.excitation.front();
  const Mat3 C = hydrostatics(*b.mass, water.density, g).stiffness;
  const HeaveForce force(table, h.in_file.head<2>() + waterplane_centre(C));
  const double counts = force.has_mean() ? kRounded : kWide;
  const double size = std::cbrt(b.mass->mass / water.density);
  double imaginary = 0, damped = 0, all = 0, error = 0;
  for (size_t k = 0; k < data.omega.size(); ++k) {
    const double omega = data.omega[k];
    if (omega < table.lowest() || omega * omega / g * size > kLong) continue;
    const double number = wave_number(omega, water.depth, g);
    const Complex X = force.at(omega, number);
    imaginary += X.imag();
    error += force.error(omega, number);
    damped += omega * data.damping[k](2, 2);
    all += std::abs(X);
  }
  if (damped > counts * all && imaginary + error < kOpposite * damped)
    add_warning(
        out, key_of_files(b), Effect::all,
        "in waves longer than {:.3g} s the heave force lags the crest, but the damping of {} requires that "
        "it leads it: its phases in {} are conjugated (they are leads with exp(+i omega t))",
        2 * M_PI / std::sqrt(kLong * g / size), data.radiation_file, data.excitation_file);
}

// Haskind's relation between radiation damping and wave excitation,
//   B_ii = k/(8 pi rho g c_g) int |X_i(beta)|² dbeta
// (Newman 1977, Marine Hydrodynamics, 6.173). Takes the median of the ratios over the frequencies with
// significant damping; wrong units of either make it differ greatly from 1.
void warn_by_haskind(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  constexpr double kCounts = 0.1, kFar = 1.5;
  constexpr double kNone = 1e-9;  // of omega A: damping that was removed
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const HydrodynamicData& data = *h.data;
  const WaveForceTable& table = *h.wave_forces();
  if (!all_round(table)) return;
  const Eigen::RowVectorXd weights = mean_weights(table.directions(), resolved_harmonics(table.directions()));
  const double g = c.environment.gravity;
  const double density = c.environment.water.density;
  double worst = 1;
  const char* name = nullptr;
  for (Eigen::Index mode = 0; mode < 3; ++mode) {
    const Eigen::Index row = h.first_row() + mode;
    double largest = 0;
    for (const Eigen::MatrixXd& B : data.damping) largest = std::max(largest, B(row, row));
    std::vector<double> ratios;
    for (size_t k = 0; k < data.omega.size(); ++k) {
      const double omega = data.omega[k];
      const double B = data.damping[k](row, row);
      if (omega < table.lowest() || omega > table.highest() || !(B > kCounts * largest) ||
          !(B > kNone * omega * std::abs(data.added_mass[k](row, row))))
        continue;
      const double number = wave_number(omega, c.environment.water.depth, g);
      const double steep = number * c.environment.water.depth;
      const double group =
          0.5 * omega / number * (steep > 0 && steep < 20 ? 1 + 2 * steep / std::sinh(2 * steep) : 1);
      double sum = 0;
      for (Eigen::Index d = 0; d < weights.size(); ++d)
        sum += 2 * M_PI * weights[d] *
               std::norm(table.at(omega, table.directions()[static_cast<size_t>(d)])[mode]);
      ratios.push_back(number * sum / (8 * M_PI * density * g * group * B));
    }
    if (ratios.size() < 3) continue;
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    if (std::abs(std::log(*middle)) > std::abs(std::log(worst))) {
      worst = *middle;
      name = kFreedomNames[mode];
    }
  }
  if (worst > kFar || worst < 1 / kFar)
    add_warning(
        out, key_of_files(b), Effect::all,
        "by Haskind's relation the wave forces of {} mean {:.3g} times the radiation damping in {} of {}: "
        "is one of them in other units (divided by density, or for another length scale)?",
        data.excitation_file, worst, name, data.radiation_file);
}

// The damping is taken as zero beyond the last frequency; a truncated file has significant damping there.
void warn_of_end_of_damping(const Body& b, std::vector<InputWarning>& out) {
  constexpr double kLarge = 0.2, kFurther = 1.25;
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const HydrodynamicData& data = *h.data;
  const double beyond = h.wave_forces()->highest();
  const double end = data.omega.back();
  if (beyond < kFurther * end) return;
  const Eigen::Index row = h.first_row();
  Vec6 largest = Vec6::Zero();
  for (const Eigen::MatrixXd& B : data.damping) largest = largest.cwiseMax(B.diagonal().segment<6>(row));
  const Vec6 last = data.damping.back().diagonal().segment<6>(row).cwiseQuotient(largest.cwiseMax(1e-300));
  Eigen::Index mode = 0;
  if (last.maxCoeff(&mode) > kLarge)
    add_warning(
        out, key_of_files(b), Effect::all,
        "the radiation damping of {} ends at {:.4g} s, where that of {} is still {:.0f} % of its largest, "
        "and is taken as zero in shorter waves, though the wave forces of {} go on to {:.4g} s: is the file "
        "cut off?",
        data.radiation_file, 2 * M_PI / end, kFreedomNames[mode], 100 * last[mode], data.excitation_file,
        2 * M_PI / beyond);
}

// Bounds of added mass over displaced mass and of waterplane area over size that no hull approaches; values
// divided by density or with another length scale exceed them.
void warn_of_size(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const HydrodynamicData& data = *h.data;
  const double density = c.environment.water.density;
  const double g = c.environment.gravity;
  const double volume = displaced_volume(*b.mass, density);
  double added = 0;
  for (const Eigen::MatrixXd& A : data.added_mass)
    added = std::max(added, A.diagonal().segment<3>(h.first_row()).maxCoeff() / (density * volume));
  // A body held down by lines displaces more than its mass, and a hinged body may have no translational rows.
  constexpr double kLeast = 0.02, kMost = 50;
  if ((added > 0 && added < kLeast) || (h.volume > 0 && added > kMost))
    add_warning(
        out, key_of_files(b), Effect::all,
        "the largest added mass of {} is {:.3g} times the mass of the displaced water, and hulls have 0.1 "
        "to 10: are its values divided by density, or for another length scale, or is 'mass' that of "
        "another body?",
        data.radiation_file, added);
  const double C33 = hydrostatics(*b.mass, density, g).stiffness(0, 0);
  const double plane = C33 / (density * g) / std::pow(volume, 2.0 / 3);
  constexpr double kLargest = 100;
  if (g > 0 && plane > kLargest)
    add_warning(out, key_of_files(b), Effect::all,
                "the hydrostatic stiffness C33, {:.3g} N/m, means a waterplane of {:.3g} m², and the body "
                "displaces {:.3g} m³: is the stiffness multiplied by density, or for another length scale?",
                C33, C33 / (density * g), volume);
}

// The contribution of the weight to a turning stiffness that the files include, against the statement of the
// case.
std::string hint_on_weight(const LongWaveDifference& d, bool stated) {
  constexpr double kNear = 0.35;
  const auto near = [&d](double times) { return std::abs(d.weight_contributions - times) < kNear; };
  if (near(1) && !stated)
    return "this is the part of the body's weight: set 'gravity_in_stiffness: true', since it acts by itself";
  if (near(-1) && stated)
    return "this is the part of the body's weight, which the files do not have: remove "
           "'gravity_in_stiffness'";
  if (near(stated ? 1 : 2)) return "this is twice the part of the body's weight: the files have it doubled";
  return "are the moments, the added mass and the stiffness of one length scale, about one point and in one "
         "system of axes?";
}

void warn_of_long_waves(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  const std::optional<LongWaveDifference> d = long_wave_difference(c, b);
  if (!d) return;
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const std::string& file = h.data->excitation_file;
  switch (d->quantity) {
    case LongWaveDifference::Quantity::heave_stiffness:
      return add_warning(
          out, key_of_files(b), Effect::all,
          "in the longest waves the heave force of {} means a hydrostatic stiffness C33 of {:.4g} N/m, and "
          "that of the files is {:.4g} N/m: do they belong to the same body, draught and density, and is "
          "'length_scale' that of the files?",
          file, d->by_waves, d->given);
    case LongWaveDifference::Quantity::volume:
      return add_warning(
          out, key_of_files(b), Effect::all,
          "in the longest waves the {} force of {} is that of a displaced volume of {:.5g} m³, and the body "
          "displaces {:.5g} m³{}: are depth of the water and 'length_scale' those of the files, and is "
          "'displaced_volume' that of the body?",
          kFreedomNames[d->freedom], file, d->by_waves, d->given, h.volume > 0 ? "" : " (that of its mass)");
    case LongWaveDifference::Quantity::turning_stiffness:
      return add_warning(
          out, key_of_files(b), Effect::all,
          "in the longest waves the {0} moment of {1} means a hydrostatic stiffness C{2}{2} by the pressure "
          "of {3:.4g} N m, and by the files it is {4:.4g} N m: {5}",
          kFreedomNames[d->freedom], file, d->freedom + 1, d->by_waves, d->given,
          hint_on_weight(*d, h.gravity_in_stiffness));
  }
}

void warn_of_drift(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const DriftSize size = drift_size(c, b);
  if (size.is_noted()) out.push_back({key_of_files(b), text_of(size, h), "drift size", Effect::all});
  if (const std::optional<int> freedom = drift_against_waves(h); freedom && size.has_direction())
    add_warning(
        out, key_of_files(b), Effect::all,
        "the mean drift force of the files in {} is against the waves at most frequencies: does it have "
        "the other sign, or are its directions those that waves come from?",
        kFreedomNames[*freedom]);
}

// True if anything but radiation and the lines damps surge or sway of a body.
bool has_viscous_damping(const BodyMass& m) {
  const BodyHydrodynamics& h = *m.hydrodynamics;
  const auto damps = [](const Mat6& B) { return !B.topRows<2>().isZero(0); };
  return damps(h.damping) || damps(h.quadratic_damping) || damps(m.damping_matrix) || !m.damping.isZero(0) ||
         !h.drift_damping.empty() || !m.members.empty() || m.current || m.positioning;
}

// A mooring makes the natural periods of surge and sway those of slow drift.
void warn_of_slow_drift(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  const bool unread = h.excitation && !h.second_order_given && !h.data->unread_drift_file.empty();
  const bool slow = h.second_order == SecondOrder::newman || h.second_order == SecondOrder::full;
  const bool undamped = slow && !has_viscous_damping(*b.mass);
  if (!unread && !undamped) return;
  if (c.environment.water.waves.none() || line_ends_at(c, b).empty()) return;
  const std::string key = "bodies." + b.name + ".floating.hydrodynamics";
  if (unread)
    add_warning(
        out, key, Effect::all,
        "mean and slow drift do not act on this moored body, although {} has their coefficients: give "
        "'second_order: newman', or 'none' without drift",
        h.data->unread_drift_file);
  if (undamped)
    add_warning(
        out, key, Effect::all,
        "slow drift excites surge and sway on the mooring at their natural periods, where radiation has "
        "no damping, and the body has no other: give its viscous damping, 'quadratic_damping'");
}

}  // namespace

void warn_of_hydrodynamics(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  const BodyHydrodynamics& h = *b.mass->hydrodynamics;
  if (h.wave_forces()) {
    // The other checks of a degree of freedom without values would name other causes.
    if (const std::optional<MissingFreedom> missing = missing_freedom(c, b)) {
      out.push_back({key_of_files(b), text_of(*missing, h), "missing freedom", Effect::all});
    } else {
      warn_of_long_waves(c, b, out);
      warn_of_heave_phase(c, b, out);
      warn_by_haskind(c, b, out);
    }
    warn_of_end_of_damping(b, out);
  }
  warn_of_drift(c, b, out);
  warn_of_slow_drift(c, b, out);
  warn_of_size(c, b, out);
}

}  // namespace hawser::advice
