#include "hawser/app/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::app {
namespace {
constexpr double kAmiss = 0.01;
}  // namespace

void Audit::update(const Energy& start, const Energy& e, double time, double h) {
  const double before = error;
  now = e;
  brought_in = e.work - start.work - (e.potential - start.potential);
  error = (e.kinetic - start.kinetic) + (e.strain - start.strain) + (e.friction - start.friction) +
          (e.damping - start.damping) - brought_in;
  moved = std::max({moved, std::abs(brought_in), e.kinetic + e.strain - std::max(error, 0.0)});
  if (std::abs(error) > std::abs(off.value)) off = {error, time, h};
  if (error - before > made.value) made = {error - before, time, h};
}

double Audit::percent() const {
  const double size = std::max(std::abs(brought_in), now.kinetic + now.strain);
  return size > 0 ? 100 * error / size : 0;
}

std::string Audit::warning(bool fixed) const {
  const double size = moved > 0 ? moved : 1, worst = std::abs(off.value) / size;
  if (std::abs(percent()) <= 100 * kAmiss && worst <= kAmiss) return "";
  std::string text = fmt::format(
      "{:.3g} % of the energy is not accounted for, and {:.3g} J ({:.3g} % of the most that moved) at t = "
      "{:.6g} s",
      percent(), off.value, 100 * worst, off.time);
  if (made.value > 0.1 * kAmiss * size)
    text += fmt::format("; the step of {:.3g} s that ended at t = {:.6g} s made {:.3g} J", made.step,
                        made.time, made.value);
  return text + ": the steps are too long for what happens (" +
         (fixed ? "dynamics.step" : "dynamics.max_step, dynamics.error_tolerance") +
         "), a line is caught inside a volume, or contact without springs was struck (with a rho_infinity "
         "below 0.8 more is booked as lost there than was)";
}

}  // namespace hawser::app
