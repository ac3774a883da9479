// Limits of wave forces in long waves. A wave that is long against the body accelerates all of the water by
// i k g a along its direction, so that to first order in the wave number k, about any point of the body and
// at the phase of the wave there,
//   surge   X1 =  i k g ((rho V + A11) cos beta + A12 sin beta)
//   sway    X2 =  i k g ((rho V + A22) sin beta + A21 cos beta)
//   heave   X3 =  C33 - omega² (rho V + A33)
//   roll    X4 =  C34 - i k ((C44 - g A42) sin beta - (C45 + g A41) cos beta)
//   pitch   X5 =  C35 + i k ((C55 + g A51) cos beta - (C45 - g A52) sin beta)
// with C44, C45 and C55 by the pressure alone: the pressure of the wave on the volume and on the waterplane,
// by the theorem of Gauss, and the added mass times the acceleration. V, C33, C44 and C55 of two frequencies
// differ from their limits by terms of order omega² and are extrapolated to omega = 0.
#include "hawser/model/check_long_waves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "hawser/kernels/table_places.hpp"
#include "hawser/kernels/waves.hpp"
#include "hawser/math/degree.hpp"
#include "hawser/math/freedoms.hpp"
#include "hawser/model/waterplane.hpp"

namespace hawser::model {
namespace {

// A quantity by the wave forces and by the case.
struct Compared {
  int freedom = 0;
  double by_waves = 0, given = 0, allowed = 0;
  double off() const { return std::abs(by_waves - given) / allowed; }
};

class LongWaves {
 public:
  LongWaves(const Case& c, const Body& b)
      : mass_(*b.mass),
        h_(*mass_.hydrodynamics),
        table_(*h_.wave_forces()),
        density_(c.environment.water.density),
        depth_(c.environment.water.depth),
        g_(c.environment.gravity),
        hydrostatics_(hydrostatics(mass_, density_, g_)),
        volume_(hydrostatics_.buoyancy / (density_ * g_)) {}

  // omega²/g times the side of a cube of the volume; small for waves that are long against the body.
  double length_ratio(double omega) const { return omega * omega / g_ * std::cbrt(volume_); }

  void check(const Issues& issue) const;
  std::optional<LongWaveDifference> difference() const;

 private:
  // Direction of the table closest to the axis of surge (freedom 0) or sway (1).
  double direction(int freedom) const {
    const auto along = [freedom](double beta) {
      return std::abs(freedom == 0 ? std::cos(beta) : std::sin(beta));
    };
    const std::vector<double>& all = table_.directions();
    return *std::max_element(all.begin(), all.end(), [&](double a, double b) { return along(a) < along(b); });
  }
  // Component of the direction along the axis; 0 if the table has none within 60 deg.
  double component(int freedom) const {
    constexpr double kLeast = 0.5;
    const double beta = direction(freedom);
    const double along = freedom == 0 ? std::cos(beta) : std::sin(beta);
    return std::abs(along) < kLeast ? 0 : along;
  }
  // Component of the same direction along the other axis.
  double across(int freedom) const {
    const double beta = direction(freedom);
    return freedom == 0 ? std::sin(beta) : std::cos(beta);
  }
  // Wave force in the direction of `direction(freedom)`, at the phase of the wave at a horizontal distance
  // from the body's origin.
  ComplexVec6 force(int freedom, double omega, double number,
                    const Eigen::Vector2d& point = Eigen::Vector2d::Zero()) const {
    return force_to(direction(freedom), omega, number, point);
  }
  // The same of a wave to any direction [rad].
  ComplexVec6 force_to(double beta, double omega, double number, const Eigen::Vector2d& point) const {
    const Eigen::Vector2d from_phases = h_.in_file.head<2>() + point;
    const double lead = number * (from_phases.x() * std::cos(beta) + from_phases.y() * std::sin(beta));
    return table_.at(omega, beta) * std::polar(1.0, lead);
  }
  // At the centre of the waterplane, about which the wave is symmetric to first order: forces, not moments.
  ComplexVec6 central_force(int freedom, double omega, double number) const {
    return force(freedom, omega, number, waterplane_centre(hydrostatics_.stiffness));
  }
  Mat6 added_mass(double omega) const { return added_mass(omega, h_.first_row()); }
  // Of the body that has the rows from `first` on: its acceleration pushes this body.
  Mat6 added_mass(double omega, Eigen::Index first) const {
    const Eigen::Index row = h_.first_row();
    const auto [low, high, fraction] = frequency_place(h_.data->omega, omega);
    const std::vector<Eigen::MatrixXd>& A = h_.data->added_mass;
    return (1 - fraction) * A[low].block<6, 6>(row, first) + fraction * A[high].block<6, 6>(row, first);
  }
  // In the depth of the case, or infinitely deep.
  double number(double omega, bool deep) const {
    return deep ? omega * omega / g_ : wave_number(omega, depth_, g_);
  }
  // Mass that waves along x and y accelerate with the water, kg: rho V and the added mass, with that of all
  // bodies that radiate on this one, since the water accelerates past all of them.
  Eigen::Matrix2d accelerated_mass() const;
  void check_directions(const Issues& issue) const;
  void check_phase(int freedom, const Issues& issue) const;
  // V by the force of surge (0) or sway (1), m³; C44 (1) or C55 (0) by the moment across it, N m.
  double volume_by_waves(int freedom, double omega, bool deep) const;
  double stiffness_by_waves(int freedom, double omega, bool deep) const;
  // Limit of a function of the frequency at omega = 0, with an error of order omega^4.
  template <class Function>
  double limit(const Function& f) const {
    const double first = f(omega_);
    const double second = f(second_);
    return first - (second - first) * omega_ * omega_ / (second_ * second_ - omega_ * omega_);
  }
  bool moves(int freedom) const {
    return component(freedom) != 0 && added_mass(omega_)(freedom, freedom) > 0 &&
           force(freedom, omega_, 0)[freedom] != Complex(0);
  }

  const BodyMass& mass_;
  const BodyHydrodynamics& h_;
  const WaveForceTable& table_;
  double density_, depth_, g_;
  PlatformHydrostatics hydrostatics_;
  double volume_;
  double omega_ = table_.lowest();
  double second_ = 0;
};

Eigen::Matrix2d LongWaves::accelerated_mass() const {
  Eigen::Matrix2d mass = density_ * volume_ * Eigen::Matrix2d::Identity();
  for (int other = 0; other < h_.data->bodies; ++other)
    mass += added_mass(omega_, 6 * other).topLeftCorner<2, 2>();
  return mass;
}

// Directions of another convention: true directions are `turn` times those of the file.
struct Convention {
  Eigen::Matrix2d turn;
  const char* forces;
  const char* cause;
};

std::array<Convention, 6> other_conventions() {
  const auto turn = [](double xx, double xy, double yx, double yy) {
    Eigen::Matrix2d m;
    m << xx, xy, yx, yy;
    return m;
  };
  constexpr const char* kExchanged = "surge and sway are exchanged";
  constexpr const char* kOpposite = "surge and sway are exchanged and against the waves";
  constexpr const char* kTurned = "surge and sway are turned by 90 deg from its directions";
  return {{{turn(1, 0, 0, -1), "the sway force alone is against the waves",
            "its directions were clockwise, or y were to starboard"},
           {turn(-1, 0, 0, 1), "the surge force alone is against the waves",
            "its directions were clockwise and those that waves come from, or x were astern"},
           {turn(0, 1, 1, 0), kExchanged,
            "its directions were clockwise from y, as on a compass, or modes 1 and 2 were exchanged"},
           {turn(0, -1, -1, 0), kOpposite, "its directions were those of a compass from which waves come"},
           {turn(0, -1, 1, 0), kTurned, "its directions were from y"},
           {turn(0, 1, -1, 0), kTurned, "its directions were from -y"}}};
}

// The forces over i k g of waves to all directions n, q, are those of the mass M times n. Of directions by
// another convention they are those of M T n, with T as in `Convention`. The fit is
//   sum q . M T n / sqrt(sum q² sum (M T n)²)
// which is 1 for the right convention, and does not depend on the units of the forces.
void LongWaves::check_directions(const Issues& issue) const {
  constexpr double kCounts = 1e-3, kClear = 0.02;  // of heave
  constexpr double kInPhase = 0.9;                 // of the square of the forces; else the phases are wrong
  constexpr double kFits = 0.95, kDiffers = 0.02, kBetter = 0.1, kUnlike = 0.5;
  const double k = number(omega_, false);
  const Eigen::Vector2d centre = waterplane_centre(hydrostatics_.stiffness);
  std::vector<Eigen::Vector2d> along, forces;
  double all = 0;
  double in_phase = 0;
  double heave = 0;
  for (const double beta : table_.directions()) {
    const ComplexVec6 X = force_to(beta, omega_, k, centre);
    along.emplace_back(std::cos(beta), std::sin(beta));
    forces.emplace_back(X.head<2>().imag() / (k * g_));
    all += X.head<2>().squaredNorm();
    in_phase += X.head<2>().imag().squaredNorm();
    heave += std::norm(X[2]);
  }
  if (!(all > kCounts * kCounts * heave) || in_phase < kInPhase * all) return;
  const Eigen::Matrix2d mass = accelerated_mass();
  const auto fit = [&](const Eigen::Matrix2d& turn) {
    double product = 0;
    double expected = 0;
    double found = 0;
    for (size_t d = 0; d < along.size(); ++d) {
      const Eigen::Vector2d one = mass * turn * along[d];
      product += one.dot(forces[d]);
      expected += one.squaredNorm();
      found += forces[d].squaredNorm();
    }
    return product / std::sqrt(expected * found);
  };
  const double as_given = fit(Eigen::Matrix2d::Identity());
  const std::array<Convention, 6> others = other_conventions();
  const Convention* best = &others.front();
  for (const Convention& other : others)
    if (fit(other.turn) > fit(best->turn)) best = &other;
  // The opposite directions, with fit -as_given, are those that waves come from, which check_phase() names.
  const double as_best = fit(best->turn);
  const double off = 1 - std::abs(as_given);
  if (as_best > kFits && off > kDiffers && 1 - as_best < kBetter * off)
    issue(
        h_.key(),
        "in the longest waves, {:.4g} s, by the wave forces of {} {}, as if {}: directions are anticlockwise "
        "from x to where the waves go, and y is to port",
        2 * M_PI / omega_, h_.data->excitation_file, best->forces, best->cause);
  else if (all > kClear * kClear * heave && std::max(std::abs(as_given), as_best) < kUnlike)
    issue(h_.key(),
          "in the longest waves, {:.4g} s, surge and sway of {} are not those of waves to its directions, "
          "{:.4g} to {:.4g} deg: are these in degrees from x, anticlockwise?",
          2 * M_PI / omega_, h_.data->excitation_file, table_.directions().front() / kDegree,
          table_.directions().back() / kDegree);
}

// The force of long waves along their direction leads the crest by a quarter of a period.
void LongWaves::check_phase(int freedom, const Issues& issue) const {
  constexpr double kPhase = 30 * kDegree;
  if (!moves(freedom)) return;
  const double k = number(omega_, false);
  const ComplexVec6 X = central_force(freedom, omega_, k);
  constexpr double kCounts = 0.02;  // of heave
  if (std::abs(X[freedom]) < kCounts * std::abs(X[2])) return;
  const double phase = std::arg(X[freedom] * component(freedom));
  if (std::abs(phase - M_PI / 2) < kPhase) return;
  const bool conjugated = std::abs(phase + M_PI / 2) < kPhase;
  issue(
      h_.key(),
      "in the longest waves, {:.4g} s, the {} force {} the crest by {:.3g} deg, but the acceleration of the "
      "water leads it by 90 deg: the phases of {} are {}",
      2 * M_PI / omega_, kFreedomNames[freedom], phase < 0 ? "lags" : "leads", std::abs(phase) / kDegree,
      h_.data->excitation_file,
      conjugated ? "conjugated (WAMIT's and BEMIO's are leads with exp(+i omega t), Capytaine's lags with "
                   "exp(-i omega t)), or its directions are those that waves come from"
                 : "not leads on the crest at the origin of the files, with exp(+i omega t)");
}

void LongWaves::check(const Issues& issue) const {
  const std::size_t before = issue.count();
  check_directions(issue);
  for (const int freedom : {0, 1})
    if (issue.count() == before) check_phase(freedom, issue);
  const double C33 = hydrostatics_.stiffness(0, 0);
  const double expected = C33 - omega_ * omega_ * (density_ * volume_ + added_mass(omega_)(2, 2));
  constexpr double kClear = 0.5;  // the stiffness has most of the force
  if (issue.count() > before || !(expected > kClear * C33)) return;
  const Complex heave = central_force(0, omega_, number(omega_, false))[2];
  constexpr double kFar = 1.5, kPhase = 30 * kDegree;
  const double ratio = std::abs(heave) / expected;
  if (ratio > kFar || ratio < 1 / kFar)
    issue(
        h_.key(),
        "in the longest waves, {:.4g} s, the heave force of {} is {:.3g} times the hydrostatic stiffness "
        "C33, and should be about 1: {}",
        2 * M_PI / omega_, h_.data->excitation_file, std::abs(heave) / C33,
        h_.format == BodyHydrodynamics::Format::wamit
            ? fmt::format("is 'length_scale' (ULEN, {:g} m here) that of the files, and are they in metres?",
                          h_.length)
            : "do both belong to the same body, with the density and gravity stated in the file?");
  else if (std::abs(std::arg(heave)) > kPhase)
    issue(h_.key(),
          "in the longest waves, {:.4g} s, the heave force leads the crest by {:.3g} deg, but a body goes up "
          "and down with the water: the phases of {} are not leads on the crest at the origin of the files, "
          "with exp(+i omega t)",
          2 * M_PI / omega_, std::arg(heave) / kDegree, h_.data->excitation_file);
}

double LongWaves::volume_by_waves(int freedom, double omega, bool deep) const {
  const double k = number(omega, deep);
  const Mat6 A = added_mass(omega);
  const double push = central_force(freedom, omega, k)[freedom].imag() / (k * g_);
  const double by_others = across(freedom) * A(freedom, 1 - freedom);
  return ((push - by_others) / component(freedom) - A(freedom, freedom)) / density_;
}

double LongWaves::stiffness_by_waves(int freedom, double omega, bool deep) const {
  const double k = number(omega, deep);
  const double sign = freedom == 0 ? 1 : -1;
  const int turn = 4 - freedom;
  const Mat6 A = added_mass(omega);
  const double moment = sign * force(freedom, omega, k)[turn].imag() / k;
  const double by_others =
      across(freedom) * (-hydrostatics_.stiffness(1, 2) + sign * g_ * A(turn, 1 - freedom));
  return (moment - by_others) / component(freedom) - sign * g_ * A(turn, freedom);
}

std::optional<LongWaveDifference> LongWaves::difference() const {
  constexpr double kHigher = 1.4, kLongest = 0.35;
  const std::vector<double>& omega = h_.data->omega;
  const auto second =
      std::find_if(omega.begin(), omega.end(), [&](double w) { return w > kHigher * omega_; });
  if (second == omega.end() || length_ratio(*second) > kLongest) return {};
  LongWaves at = *this;
  at.second_ = *second;
  const double ratio = length_ratio(*second);
  const auto volume = [&](int freedom, bool deep) {
    Compared out{freedom, 0, volume_, 0};
    out.by_waves = at.limit([&](double w) { return volume_by_waves(freedom, w, deep); });
    out.allowed = (0.02 + 0.1 * ratio) * (volume_ + added_mass(omega_)(freedom, freedom) / density_);
    return out;
  };
  // Files made for deep water fit a case of finite depth too, but for its longest waves.
  const auto largest_difference = [&](bool deep) {
    Compared worst{0, 0, 0, 1};
    for (const int freedom : {0, 1})
      if (moves(freedom))
        if (const Compared compared = volume(freedom, deep); compared.off() > worst.off()) worst = compared;
    return worst;
  };
  const Compared as_given = largest_difference(false);
  const Compared in_deep = largest_difference(true);
  const bool deep = in_deep.off() < as_given.off();
  const double heave = at.limit([&](double w) {
    return central_force(0, w, number(w, deep))[2].real() +
           w * w * (density_ * volume_ + added_mass(w)(2, 2));
  });
  const double C33 = hydrostatics_.stiffness(0, 0);
  // Of the waterplane of a cube, a hundredth is negligible: a submerged body has none.
  const double allowed = (0.03 + 0.1 * ratio) * std::max(std::abs(C33), std::abs(heave)) +
                         0.01 * hydrostatics_.buoyancy / std::cbrt(volume_);
  using Quantity = LongWaveDifference::Quantity;
  if (std::abs(heave - C33) > allowed) return LongWaveDifference{Quantity::heave_stiffness, 2, heave, C33};
  if (const Compared& worst = deep ? in_deep : as_given; worst.off() > 1)
    return LongWaveDifference{Quantity::volume, worst.freedom, worst.by_waves, worst.given};
  const double size = hydrostatics_.buoyancy * std::cbrt(volume_);
  Compared worst{0, 0, 0, 1};
  for (const int freedom : {0, 1}) {
    if (!moves(freedom)) continue;
    Compared one{4 - freedom, 0, hydrostatics_.stiffness(2 - freedom, 2 - freedom), 0};
    one.by_waves = at.limit([&](double w) { return stiffness_by_waves(freedom, w, deep); });
    one.allowed = (0.005 + 0.02 * ratio) * size +
                  (0.01 + 0.1 * ratio) * std::max(std::abs(one.given), std::abs(one.by_waves));
    if (one.off() > worst.off()) worst = one;
  }
  if (!(worst.off() > 1)) return {};
  const double of_weight = -mass_.mass * g_ * mass_.centre.z();
  const bool counts = std::abs(of_weight) > worst.allowed;
  return LongWaveDifference{Quantity::turning_stiffness, worst.freedom, worst.by_waves, worst.given,
                            counts ? (worst.given - worst.by_waves) / of_weight : 0};
}

bool long_enough(const Case& c, const Body& b, const LongWaves& waves) {
  constexpr double kLongWaves = 0.1;
  const double omega = b.mass->hydrodynamics->wave_forces()->lowest();
  return c.environment.gravity > 0 && waves.length_ratio(omega) <= kLongWaves;
}

}  // namespace

void check_long_waves(const Case& c, const Body& b, const Issues& issue) {
  const LongWaves waves(c, b);
  if (long_enough(c, b, waves)) waves.check(issue);
}

std::optional<LongWaveDifference> long_wave_difference(const Case& c, const Body& b) {
  // Bodies side by side accelerate the water between them, and a hull has separate hydrostatics.
  if (b.mass->hydrodynamics->data->bodies > 1 || b.mass->hull) return {};
  const LongWaves waves(c, b);
  if (!long_enough(c, b, waves)) return {};
  return waves.difference();
}

}  // namespace hawser::model
