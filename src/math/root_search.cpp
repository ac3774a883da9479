// The class RootSearch: outward search, and Chandrupatla's choice between interpolation and bisection.
#include "hawser/math/root_search.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

constexpr double kGrowth = 2;    // of steps outward
constexpr int kMaxFailures = 6;  // in one direction; each halves the step

}  // namespace

RootSearch::RootSearch(double start, double step, double low, double high) : next_(start) {
  direction_[0].step = step;
  direction_[1].step = -step;
  for (Direction& w : direction_) {
    w.limit = w.step > 0 ? high : low;
    w.x = start;
    w.tried = w.step;
  }
}

double RootSearch::width() const { return std::abs(x_[1] - x_[0]); }

void RootSearch::add(double value) {
  const std::pair<double, double> row(next_, value);
  values_.insert(std::upper_bound(values_.begin(), values_.end(), row), row);
  if (bracketed_) {
    const int same = (value > 0) == (f_[0] > 0) ? 0 : 1;
    x_[2] = x_[same];
    f_[2] = f_[same];
    if (same == 1) {
      x_[1] = x_[0];
      f_[1] = f_[0];
    }
    x_[0] = next_;
    f_[0] = value;
    failures_ = 0;
    return between();
  }
  if (count_++ == 0) {
    return begin(value);
  }
  Direction& w = direction_[side_];
  if ((value > 0) != (w.f > 0)) {
    bracketed_ = true;
    x_[0] = next_;
    f_[0] = value;
    x_[1] = w.x;
    f_[1] = w.f;
    fraction_ = f_[0] / (f_[0] - f_[1]);
    next_ = x_[0] + std::clamp(fraction_, 0.02, 0.98) * (x_[1] - x_[0]);
    x_[2] = x_[1];
    f_[2] = f_[1];
    return;
  }
  // Changes the direction if the function moves away_from_root from zero in this one.
  const bool away_from_root = count_ == 2 && std::abs(value) > std::abs(w.f) && !direction_[1 - side_].ended;
  w.x = next_;
  w.f = value;
  w.step *= w.failures > 0 ? 1 : kGrowth;
  if (w.x == w.limit) w.ended = true;
  if (away_from_root) side_ = 1 - side_;
  outward();
}

void RootSearch::fail() {
  if (bracketed_) {
    if (++failures_ > kMaxFailures) exhausted_ = true;
    fraction_ *= 0.5;
    next_ = x_[0] + fraction_ * (x_[1] - x_[0]);
    return;
  }
  if (count_ == 0) return extend_range();
  Direction& w = direction_[side_];
  w.limit = next_;
  w.step = 0.5 * (next_ - w.x);
  if (++w.failures > kMaxFailures) w.ended = true;
  outward();
}

// The search for a first value has already covered the side from which it came.
void RootSearch::begin(double value) {
  Direction& current = direction_[side_];
  Direction& opposite = direction_[1 - side_];
  if (failures_at_start_ > 0) {
    opposite.limit = current.x;
    opposite.failures = 1;
    opposite.ended = false;
  }
  current.ended = next_ == current.limit;
  for (Direction& w : direction_) {
    w.x = next_;
    w.f = value;
  }
  side_ = value > 0 ? 1 : 0;
  outward();
}

// The start has no value: search at increasing distances on both sides.
void RootSearch::extend_range() {
  if (failures_at_start_++ > 0) {
    direction_[side_].x = next_;
    direction_[side_].ended = next_ == direction_[side_].limit;
  }
  if (!direction_[1 - side_].ended) side_ = 1 - side_;
  Direction& w = direction_[side_];
  if (w.ended) {
    exhausted_ = true;
    return;
  }
  next_ = w.x + w.tried;
  w.tried *= kGrowth;
  if ((w.step > 0) != (next_ < w.limit)) next_ = w.limit;
}

void RootSearch::outward() {
  if (direction_[side_].ended) side_ = 1 - side_;
  const Direction& w = direction_[side_];
  if (w.ended) {
    exhausted_ = true;
    return;
  }
  const double x = w.x + w.step;
  next_ = (w.step > 0) == (x < w.limit) ? x : w.limit;
  // A point that failed is not requested again.
  if (w.failures > 0 && next_ == w.limit) next_ = 0.5 * (w.x + w.limit);
}

void RootSearch::between() {
  const double xi = (x_[0] - x_[1]) / (x_[2] - x_[1]);
  const double phi = (f_[0] - f_[1]) / (f_[2] - f_[1]);
  fraction_ = 0.5;
  if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi) {
    const double alpha = (x_[2] - x_[0]) / (x_[1] - x_[0]);
    fraction_ = f_[0] / (f_[1] - f_[0]) * f_[2] / (f_[1] - f_[2]) +
                alpha * f_[0] / (f_[2] - f_[0]) * f_[1] / (f_[2] - f_[1]);
  }
  next_ = x_[0] + fraction_ * (x_[1] - x_[0]);
}

}  // namespace hawser
