#include "hawser/app/audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::app {
namespace {
// Shares of Audit::size(). Energy that is made feeds on itself; what is lost damps, and a run that is damped
// a little is as good as one in thicker water.
constexpr double kMadeTold = 0.01, kMadeWrong = 0.05, kLostTold = 0.05, kLostWrong = 0.20,
                 kUnresolvedTold = 0.02;

double share(double value, double size) { return size > 0 ? value / size : value > 0 ? HUGE_VAL : 0.0; }
double share(const Audit::Largest& l) { return share(l.value, l.size); }

const char* words(Audit::Step::Touch touch) {
  switch (touch) {
    case Audit::Step::Touch::volume:
      return "it touches a volume there";
    case Audit::Step::Touch::line:
      return "it touches a line there";
    case Audit::Step::Touch::seabed:
      return "it touches the seabed there";
    case Audit::Step::Touch::nothing:
      break;
  }
  return "its motion changes faster than the steps follow";
}

// One that is surely short: a quarter of what was too long.
std::string remedy(bool fixed, double step) {
  return fmt::format("give dynamics.{}: {:.2g} s", fixed ? "step" : "max_step", step / 4);
}

}  // namespace

bool Audit::update(const Energy& start, const Energy& e, double time, double h) {
  const double before = error, brought_before = brought_in;
  now = e;
  brought_in = e.work - start.work - (e.potential - start.potential);
  error = (e.kinetic - start.kinetic) + (e.strain - start.strain) + (e.friction - start.friction) +
          (e.damping - start.damping) + (e.unresolved - start.unresolved) - brought_in;
  at_start = start.kinetic;
  worked += std::abs(brought_in - brought_before);
  set_free = std::max(set_free, start.strain - e.strain);
  least_error = std::min(least_error, error);
  const double rise = error - least_error;
  if (share(rise, size()) > share(made)) made = {rise, time, h, size()};
  if (share(-error, size()) > share(lost)) lost = {-error, time, h, size()};
  if (error - before <= worst.value) return false;
  worst = {error - before, time, h, -1, Step::Touch::nothing};
  return true;
}

double Audit::percent() const { return size() > 0 ? 100 * error / size() : 0; }

bool Audit::wrong() const { return share(made) > kMadeWrong || share(lost) > kLostWrong; }

std::string Audit::warning(bool fixed, const std::string& where) const {
  const double making = share(made) / kMadeTold, losing = share(lost) / kLostTold;
  if (std::max(making, losing) <= 1) return "";
  std::string text;
  if (making > losing)
    text = fmt::format(
        "the steps made {:.3g} J out of nothing by t = {:.6g} s, {:.3g} % of the work done; the one of "
        "{:.3g} s "
        "that ended at t = {:.6g} s made most of it, {:.3g} J, at {}: {}; {}",
        made.value, made.time, 100 * share(made), worst.length, worst.time, worst.value, where,
        words(worst.touch), remedy(fixed, worst.length));
  else
    text = fmt::format(
        "the steps lost {:.3g} J by t = {:.6g} s, {:.3g} % of the work done: they are too long for what "
        "moves; {}",
        lost.value, lost.time, 100 * share(lost), remedy(fixed, lost.step));
  return wrong() ? text + ". The results are not to be used" : text;
}

std::string Audit::note() const {
  const double part = share(now.unresolved, size());
  if (part < kUnresolvedTold) return "";
  return fmt::format(
      "{:.3g} J, {:.2g} % of the work done, went into axial vibration too fast for the steps, which take it "
      "out; "
      "what is tightened at a blow may peak higher for less than a step",
      now.unresolved, 100 * part);
}

}  // namespace hawser::app
