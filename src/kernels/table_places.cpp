// Search for frequencies and directions in tables, periodic in direction.
#include "hawser/kernels/table_places.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

constexpr double kSame = 1e-9;  // rad: equal directions

}  // namespace

double all_round(double direction) {
  const double d = std::fmod(direction, 2 * M_PI);
  const double r = d < 0 ? d + 2 * M_PI : d;
  return r < 2 * M_PI ? r : 0;
}

TablePlace frequency_place(const std::vector<double>& omega, double x) {
  const std::size_t last = omega.size() - 1;
  if (!(x > omega.front())) return {0, 0, 0};
  if (!(x < omega.back())) return {last, last, 0};
  const auto above = std::upper_bound(omega.begin(), omega.end(), x);
  const std::size_t next = above - omega.begin();
  return {next - 1, next, (x - omega[next - 1]) / (omega[next] - omega[next - 1])};
}

TablePlace direction_place(const std::vector<double>& directions, double x) {
  const std::size_t n = directions.size();
  const double within = all_round(x);
  const auto above = std::upper_bound(directions.begin(), directions.end(), within);
  const std::size_t after = above - directions.begin();
  const std::size_t a = (after + n - 1) % n;
  const std::size_t b = after % n;
  if (a == b) return {a, b, 0};
  // Counted from the direction below; rounding of x - directions[a] could add a full turn.
  const double angle = within - directions[a];
  return {a, b, (angle < 0 ? angle + 2 * M_PI : angle) / all_round(directions[b] - directions[a])};
}

DirectionGap direction_gap(const std::vector<double>& directions, double x) {
  const TablePlace place = direction_place(directions, x);
  const std::size_t a = place.low;
  const std::size_t b = place.high;
  for (const std::size_t i : {a, b})
    if (a == b || std::abs(std::remainder(x - directions[i], 2 * M_PI)) < kSame)
      return {directions[i], directions[i]};
  const double turn = a > b ? 2 * M_PI : 0;  // the circle closes between them
  if (all_round(x) < directions[a]) return {directions[a] - turn, directions[b]};
  return {directions[a], directions[b] + turn};
}

}  // namespace hawser
