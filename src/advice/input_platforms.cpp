// What a case with platforms has that their coefficients cannot take, inertia that no body has, wind without
// a body in it.
#include <fmt/format.h>

#include <algorithm>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/math/symmetric.hpp"

namespace hawser::advice {

using namespace model;

namespace {

void warn_of_inertia(const Body& b, std::vector<InputWarning>& out) {
  const Vec3 moments = eigenpairs(b.mass->tensor()).values;
  const double sum = moments[0] + moments[1];
  if (moments[2] > (1 + 1e-9) * sum)
    out.push_back(
        {"bodies." + b.name + ".floating.inertia",
         fmt::format(
             "the largest principal moment, {:.6g} kg m², is {:.2g} % above the sum of the other two, "
             "which no distribution of mass has: are the radii of gyration those of the ship?",
             moments[2], 100 * (moments[2] / sum - 1)),
         31});
}

void warn_of_sea_of_platform(const Case& c, const Body& b, std::vector<InputWarning>& out) {
  const Water& w = c.environment.water;
  const std::string key = "bodies." + b.name + ".floating.hydrodynamics";
  const auto flows = [](const CurrentRow& row) { return row.speed != 0; };
  if (!b.mass->current && std::any_of(w.current.profile.begin(), w.current.profile.end(), flows))
    out.push_back({key,
                   "the current acts on lines and not on this body, of which the coefficients are those of "
                   "waves: give its coefficients for it, 'floating.current'",
                   32});
  if (w.waves.kind == Waves::Kind::stokes && b.mass->hydrodynamics->excitation)
    out.push_back({key,
                   "its coefficients are those of linear waves: the wave of 'stokes' acts on it as a linear "
                   "one of the same height and period",
                   33});
}

}  // namespace

void warn_of_platforms(const Case& c, std::vector<InputWarning>& out) {
  const auto in_wind = [](const Body& b) { return b.mass && b.mass->wind; };
  if (c.environment.wind.speed > 0 && std::none_of(c.bodies.begin(), c.bodies.end(), in_wind))
    out.push_back({"environment.wind",
                   "acts on no body and never on lines: give a body coefficients, 'floating.wind'", 34});
  for (const Body& b : c.bodies) {
    if (!b.mass || !b.mass->hydrodynamics) continue;
    warn_of_inertia(b, out);
    warn_of_sea_of_platform(c, b, out);
  }
}

}  // namespace hawser::advice
