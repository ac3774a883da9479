// Messages about events.
#include "hawser/advice/events.hpp"

#include <fmt/format.h>

#include <cmath>

namespace hawser::advice {

std::string happened(const model::Action& action, double time, const std::string& stage,
                     const Happened& how) {
  std::string text =
      fmt::format("note: {}: {} is {}", stage.empty() ? fmt::format("t = {:.6g} s", time) : "stage " + stage,
                  action.subject(), action.participle());
  if (how.tension >= 0) text += fmt::format(", with a tension of {:.6g} N", how.tension);
  if (how.from_place >= 0) text += fmt::format(", {:.3g} m from the place", how.from_place);
  if (how.from_origin >= 0) text += fmt::format(", {:.4g} m from its origin", how.from_origin);
  return text;
}

std::string released_inside(const model::Action& action, const std::string& volume, double without) {
  return fmt::format(
      "warning: {} that is released starts inside volume {}, and {:.3g} m of the line from that end on have "
      "no contact with it",
      action.subject(), volume, without);
}

std::string met_at_start(const model::Event& event, double value) {
  const model::Cause& c = event.cause;
  const char* unit = c.kind == model::Cause::Kind::tension ? "N" : "m";
  return fmt::format(
      "{} would be {} at once: {:.6g} {} at the start is already {} {:g} {}; give another limit, or 'time: "
      "0'",
      event.action.subject(), event.action.participle(), value, unit, c.below ? "below" : "above", c.limit,
      unit);
}

std::string did_not_happen(const model::Event& event) {
  return fmt::format("{} was not {}: the run ended before its condition was met ({})", event.action.subject(),
                     event.action.participle(), event.cause.text());
}

std::string cannot_happen(const model::Action& action, double time, const std::string& because) {
  return fmt::format("at t = {:.6g} s {} is to be {}, but {}", time, action.subject(), action.participle(),
                     because);
}

std::string nothing_holds() { return "nothing holds it"; }

std::string holds_already() { return "it is held already"; }

std::string too_far_from_place(double away, double within) {
  return fmt::format("it is {:.4g} m from 'at', and 'within' allows {:g} m", away, within);
}

std::string cannot_pay_out(const std::string& stage, double remaining, const std::string& feeder,
                           const std::string& why) {
  return fmt::format("stage {}, when {:.6g} m are left to be {} at {}: {}", stage, std::abs(remaining),
                     remaining < 0 ? "hauled in" : "paid out", feeder, why);
}

}  // namespace hawser::advice
