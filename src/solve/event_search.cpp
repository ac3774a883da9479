// The class EventSearch: regula falsi with the modification of Anderson and Björck.
#include "hawser/solve/event_search.hpp"

#include <algorithm>

namespace hawser {
namespace {

// In tolerances: the search aims at the middle of the interval in which a step may end.
constexpr double kAim = 0.5;

// When the same end of the interval is replaced twice in a row, the function values at the other end are
// multiplied by 1 - now/before (Anderson & Björck); `before` and `now` are the values at the replaced end.
void weigh(std::vector<double>& stays, const std::vector<double>& before, const std::vector<double>& now) {
  for (size_t i = 0; i < stays.size(); ++i) {
    const double remaining = 1 - now[i] / before[i];
    stays[i] *= remaining > 0 && remaining < 1 ? remaining : 0.5;
  }
}

}  // namespace

double EventSearch::next(double h, double shortest, const std::vector<double>& end,
                         const std::vector<double>& at_start) {
  const bool beyond = std::any_of(end.begin(), end.end(), [](double g) { return g > 1; });
  const bool reached = std::any_of(end.begin(), end.end(), [](double g) { return g >= 0; });
  if (beyond ? h - before_ <= 2 * shortest : beyond_ == 0 || reached) return h;
  std::vector<double> now(end);
  for (double& g : now) g -= kAim;
  if (beyond) {
    if (beyond_ == 0) {
      left_ = at_start;
      for (double& g : left_) g -= kAim;
    }
    if (moved_ == 1) weigh(left_, right_, now);
    right_ = now;
    beyond_ = h;
    moved_ = 1;
  } else {
    if (moved_ == -1) weigh(right_, left_, now);
    left_ = now;
    before_ = h;
    moved_ = -1;
  }
  // Fraction of the interval at the first event. Functions above zero at the left end are not events.
  double fraction = 1;
  for (size_t i = 0; i < left_.size(); ++i)
    if (left_[i] < 0 && right_[i] > 0) fraction = std::min(fraction, left_[i] / (left_[i] - right_[i]));
  if (fraction == 1) return h;
  const double earliest = before_ + shortest;
  return std::min(std::max(before_ + fraction * (beyond_ - before_), earliest),
                  std::max(beyond_ - shortest, earliest));
}

}  // namespace hawser
