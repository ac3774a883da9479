// Messages about length searches and exhausted feeders.
#include "hawser/advice/lengths.hpp"

#include <fmt/format.h>

#include "hawser/base/count_of.hpp"
#include "hawser/math/declination.hpp"

namespace hawser::advice {
namespace {

using Kind = model::LengthTarget::Kind;

std::string end_of(const model::LengthTarget& t) { return fmt::format("end {}", end_letter(t.line_end)); }

std::string value_text(const model::LengthTarget& t, double value) {
  switch (t.kind) {
    case Kind::tension:
      return fmt::format("{:.6g} N", value);
    case Kind::declination:
      return fmt::format("{:.6g} deg", degrees(value));
    default:
      return fmt::format("{:.6g} m", value);
  }
}

std::string name_of(const model::LengthTarget& t) {
  switch (t.kind) {
    case Kind::tension:
      return fmt::format("tension at {}", end_of(t));
    case Kind::declination:
      return fmt::format("declination at {}", end_of(t));
    case Kind::touchdown:
      return fmt::format("arc length of the first touchdown point from {}", end_of(t));
    default:
      return "laid length";
  }
}

std::string text_of(const LengthsTried& tried, const model::LengthTarget& t) {
  const auto at = [&](const LengthsTried::Trial& s) {
    return fmt::format("{} at {:.6g} m", value_text(t, s.second), s.first);
  };
  std::string text;
  if (tried.range && tried.jumps)
    text = fmt::format("; at {:.9g} m it jumps past the target", *tried.jumps);
  else if (tried.range)
    text = fmt::format("; of the lengths tried, {:.6g} to {:.6g} m, it was between {} and {}",
                       tried.range->first.first, tried.range->last.first, at(tried.range->shortest),
                       at(tried.range->longest));
  if (!tried.why.empty()) text += (tried.range ? "; beyond these: " : "; as it is given: ") + tried.why;
  return text;
}

}  // namespace

std::string length_tried(const LengthSearched& at) {
  const model::LengthTarget& t = at.target;
  const std::string where = at.in_feeder ? fmt::format("inside the feeder at {}", end_of(t))
                                         : fmt::format("of section {}", t.section + 1);
  return fmt::format("line {}: with {:.6g} m {} the {} is {}, the target {}", at.line, at.length, where,
                     name_of(t), value_text(t, at.value), value_text(t, t.value));
}

std::string length_solved(const LengthSearched& at, int trials) {
  const model::LengthTarget& t = at.target;
  if (at.in_feeder)
    return fmt::format(
        "line {}: {:.6f} m are inside the feeder at {} at the start ({:g} m in the case), which gives the "
        "line its tension of {} at rest (after {})",
        at.line, at.length, end_of(t), at.given, value_text(t, t.value), count_of(trials, "static solution"));
  return fmt::format(
      "line {}: section {} is {:.6f} m long ({:g} m in the case), so that the {} is {} (after {})", at.line,
      t.section + 1, at.length, at.given, name_of(t), value_text(t, at.value),
      count_of(trials, "static solution"));
}

std::string length_not_solved(const LengthSearched& at, const LengthsTried& tried) {
  const model::LengthTarget& t = at.target;
  return fmt::format("no length of section {} between {:g} and {:g} m was found that makes {} the {}{}",
                     t.section + 1, t.min_length, t.max_length, value_text(t, t.value), name_of(t),
                     text_of(tried, t));
}

std::string feeder_not_at_rest(const LengthSearched& at, const LengthsTried& tried) {
  const model::LengthTarget& t = at.target;
  return fmt::format(
      "line {}: the feeder at {} begins with {:g} m inside as given and not with its tension of {}: no "
      "length was found that gives that tension at rest{}",
      at.line, end_of(t), at.given, value_text(t, t.value), text_of(tried, t));
}

std::string targets_do_not_settle() {
  return "statics: the targets of the lines cannot be met together: the length that one line needs depends "
         "on those of the others; give fewer lines a target";
}

std::string length_of_other_run(const std::string& line, int section, double length) {
  return fmt::format("line {}: section {} is {:.6f} m long, as found by the run that this one continues",
                     line, section + 1, length);
}

std::string stock_runs_out(const std::string& feeder, double time) {
  return fmt::format(
      "the stock at {} runs out at t = {:.6g} s: make the line and the 'stock' of the feeder longer by the "
      "same length, or end the run before that time",
      feeder, time);
}

std::string all_hauled_in(const std::string& feeder, double time, bool up_to_cut) {
  return fmt::format(
      "at t = {:.6g} s all of the line{} is hauled in at {}: haul in less, or end the run before that time",
      time, up_to_cut ? " up to the place of its cut, which cannot be hauled in," : "", feeder);
}

}  // namespace hawser::advice
