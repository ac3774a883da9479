// Summaries of parts in contact with volumes and lines: of one turn, and of two joined parts.
#include "hawser/record/pressed_part.hpp"

namespace hawser::record {
namespace {

// Sums of b continue from those of a.
SumRange joined(const SumRange& a, const SumRange& b, double sum_of_a) {
  return {std::min(a.low, sum_of_a + b.low), std::max(a.high, sum_of_a + b.high)};
}

}  // namespace

PressedPart::PressedPart(const PressedTurn& turn)
    : pressed(true),
      first(turn),
      last(turn),
      worst(turn),
      sum(turn.tension_change),
      inside{turn.tension_change, turn.tension_change},
      transverse_transit_time(turn.transverse_transit_time),
      tension(turn.tension) {}

PressedPart joined(const PressedPart& a, const PressedPart& b) {
  const double tension = std::max(a.tension, b.tension);
  if (!a.pressed || !b.pressed) {
    PressedPart out = a.pressed ? a : b;
    out.tension = tension;
    return out;
  }
  const bool touch = b.first.node == a.last.node + 1;
  const bool larger = std::abs(b.worst.tension_change) > std::abs(a.worst.tension_change);
  PressedPart out = larger ? b : a;
  if (touch && larger && b.worst.node == b.first.node) out.before = a.last.angle;
  if (touch && !larger && a.worst.node == a.last.node) out.after = b.first.angle;
  out.first = a.first;
  out.last = b.last;
  out.sum = a.sum + b.sum;
  out.inside = joined(a.inside, b.inside, a.sum);
  out.outside = joined(a.outside, b.outside, a.sum);
  if (!touch) out.outside.add(a.sum);
  out.transverse_transit_time = std::max(a.transverse_transit_time, b.transverse_transit_time);
  out.tension = tension;
  return out;
}

}  // namespace hawser::record
