// Length paid out by a feeder with speed rows: the integral of a piecewise linear function.
#include "hawser/model/feeder.hpp"

#include <algorithm>

namespace hawser::model {

Fed fed_by(const Feed& feed, double t) {
  Fed out;
  if (feed.speed.empty()) return out;
  double from = 0;  // start of the piece
  const auto piece = [&](double to, double before, double after, double start, double end) {
    const double slope = end > start ? (after - before) / (end - start) : 0;
    const auto at = [&](double s) { return before + slope * (s - start); };
    const double until = std::min(to, t);
    if (until > from) {
      out.length += 0.5 * (until - from) * (at(from) + at(until));
      from = until;
    }
    if (t < to && t >= start) {
      out.speed = at(t);
      out.acceleration = slope;
    }
  };
  const auto& rows = feed.speed;
  piece(rows.front().first, rows.front().second, rows.front().second, 0, rows.front().first);
  for (std::size_t i = 1; i < rows.size(); ++i)
    piece(rows[i].first, rows[i - 1].second, rows[i].second, rows[i - 1].first, rows[i].first);
  if (t >= rows.back().first) {
    out.speed = rows.back().second;
    out.acceleration = 0;
    out.length += (t - from) * out.speed;
  }
  return out;
}

}  // namespace hawser::model
