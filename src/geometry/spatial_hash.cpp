// Construction of a spatial hash: size of the cubes, and items in each.
#include "hawser/geometry/spatial_hash.hpp"

#include <bit>
#include <numeric>
#include <utility>

namespace hawser {

SpatialHash::SpatialHash(std::span<const Box> boxes, const std::vector<bool>& chosen) {
  constexpr double kMaxCells = 1 << 20, kCubesOfItem = 6;
  std::vector<int> which;
  std::vector<double> sizes;
  Box all;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (!chosen.empty() && !chosen[i]) continue;
    which.push_back(static_cast<int>(i));
    sizes.push_back(boxes[i].extent().maxCoeff());
    all.add(boxes[i]);
  }
  if (which.empty()) return;
  const double extent = all.extent().maxCoeff();
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
  origin_ = all.lo;
  side_ = std::max({1.5 * sizes[sizes.size() / 2], extent / kMaxCells, std::numeric_limits<double>::min()});
  const auto fit = [&] {
    for (int a = 0; a < 3; ++a) last_[a] = static_cast<int>(all.extent()[a] / side_);
  };
  const auto cells = [&](int item) {
    const Box& b = boxes[static_cast<std::size_t>(item)];
    return std::pair{cell_of(b.lo), cell_of(b.hi)};
  };
  // Enlarge the cubes until there are not too many per item.
  for (fit();; side_ *= 1.5, fit()) {
    double sum = 0;
    for (const int i : which) {
      const auto [lo, hi] = cells(i);
      sum += (hi - lo + Cell::Ones()).cast<double>().prod();
    }
    if (sum <= kCubesOfItem * static_cast<double>(which.size())) break;
  }
  places_ = std::bit_ceil(2 * which.size());
  // Count the items, then store them contiguously.
  std::vector<std::uint32_t> first(places_ + 1, 0);
  const auto each = [&](auto&& visit) {
    for (const int i : which) {
      const auto [lo, hi] = cells(i);
      for (int x = lo[0]; x <= hi[0]; ++x)
        for (int y = lo[1]; y <= hi[1]; ++y)
          for (int z = lo[2]; z <= hi[2]; ++z) visit(i, place({x, y, z}));
    }
  };
  each([&](int, std::size_t k) { ++first[k]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> items(first.back());
  each([&](int i, std::size_t k) { items[--first[k]] = i; });
  first_ = std::move(first);
  items_ = std::move(items);
}

}  // namespace hawser
