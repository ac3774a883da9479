// Memory of large vectors: whole pages, and what is in it stays while they grow, shrink and are copied.
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

#include "hawser/geometry/large_vector.hpp"

namespace hawser::geometry_large_vector_test {
namespace {

TEST(GeometryLargeVector, KeepsWhatIsInIt) {
  LargeVector<std::uint32_t> v;
  for (std::uint32_t i = 0; i < 3000000; ++i) v.push_back(i);  // 64 bytes to 16 MB, past 2 MB
  LargeVector<std::uint32_t> copy = v;
  v.resize(100000);
  v.shrink_to_fit();  // less than a page again
  for (std::uint32_t i = 0; i < v.size(); ++i) ASSERT_EQ(v[i], i);
  for (std::uint32_t i = 0; i < copy.size(); ++i) ASSERT_EQ(copy[i], i);
}

TEST(GeometryLargeVector, WholePages) {
  constexpr std::size_t kPage = std::size_t{2} << 20;
  for (const std::size_t bytes : {kPage, kPage + 1, 3 * kPage - 1, 5 * kPage}) {
    LargeVector<std::uint8_t> a(bytes, std::uint8_t{1}), b(bytes, std::uint8_t{2});
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(a.data()) % kPage, 0u);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(b.data()) % kPage, 0u);
    EXPECT_EQ(std::accumulate(a.begin(), a.end(), std::size_t{0}), bytes);
    EXPECT_EQ(std::accumulate(b.begin(), b.end(), std::size_t{0}), 2 * bytes);
  }
  const LargeVector<std::uint8_t> small(1000);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(small.data()) % 64, 0u);
}

TEST(GeometryLargeVector, MoreThanThereIsIsRefused) {
  LargeVector<std::uint8_t> v;
  EXPECT_THROW(v.reserve(std::size_t{1} << 60), std::bad_alloc);
}

}  // namespace
}  // namespace hawser::geometry_large_vector_test
