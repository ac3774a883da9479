// The grid of coarse distances over a mesh: how large its cells are, and what a cell tells of a point in it.
#include "coarse_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hawser::detail {

CoarseDistance::CoarseDistance(const Box& box, std::size_t triangles,
                               const std::function<Sample(const Vec3&, int hint)>& sample)
    : box_(box) {
  // About as many cells as triangles, no fewer than 512 and no more than 32^3, as near cubes as they get.
  const double wanted = std::clamp(static_cast<double>(triangles), 512.0, 32768.0);
  const Vec3 e = box.extent().cwiseMax(1e-3 * box.extent().maxCoeff());
  side_ = std::cbrt(e.prod() / wanted);
  rounding_ = 1e-6 * box.extent().maxCoeff();
  if (!(side_ > 0)) side_ = 1;
  for (int a = 0; a < 3; ++a) n_[a] = std::max(1, static_cast<int>(std::ceil(e[a] / side_)));
  std::vector<Cell> cells;
  cells.reserve(static_cast<std::size_t>(n_[0]) * static_cast<std::size_t>(n_[1]) *
                static_cast<std::size_t>(n_[2]));
  int hint = -1;
  std::vector<float> closed;
  bool open = false;
  for (int k = 0; k < n_[2]; ++k)
    for (int j = 0; j < n_[1]; ++j)
      for (int i = 0; i < n_[0]; ++i) {
        const Sample s = sample(box.lo + side_ * Vec3(i + 0.5, j + 0.5, k + 0.5), hint);
        hint = s.triangle;
        cells.push_back({static_cast<float>(s.active), static_cast<float>(s.whole)});
        closed.push_back(static_cast<float>(s.closed));
        open = open || std::isfinite(s.closed);
      }
  cells_ = std::move(cells);
  if (open) closed_ = std::move(closed);
}

CoarseDistance::About CoarseDistance::about(const Vec3& y) const {
  if (!box_.contains(y)) return {true, 0, std::numeric_limits<double>::infinity()};
  double way = 0;
  const Cell& c = cells_[cell(y, way)];
  return {c.whole > way, c.active - way, c.active + way};
}

double CoarseDistance::closed_within(const Vec3& y) const {
  if (closed_.empty()) return std::numeric_limits<double>::infinity();
  if (!y.allFinite()) return 0;
  double way = 0;
  const std::size_t c = cell(y, way);
  return closed_[c] - way;
}

std::size_t CoarseDistance::cell(const Vec3& y, double& way) const {
  std::size_t at[3];
  Vec3 centre;
  for (int a = 0; a < 3; ++a) {
    const double i = std::clamp(std::floor((y[a] - box_.lo[a]) / side_), 0.0, n_[a] - 1.0);
    at[a] = static_cast<std::size_t>(i);
    centre[a] = box_.lo[a] + side_ * (i + 0.5);
  }
  way = (y - centre).norm() + rounding_;
  return (at[2] * static_cast<std::size_t>(n_[1]) + at[1]) * static_cast<std::size_t>(n_[0]) + at[0];
}

}  // namespace hawser::detail
