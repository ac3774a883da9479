// 10^7 cases each of triangle and point and of two segments, and 10^6 of the sign of the distance.
#include "support/geometry_fuzz.hpp"

namespace {
using hawser::test::GeometryFuzz;

TEST(GeometryFuzzLong, TriangleAndPoint) { GeometryFuzz(11).triangles(10000000); }
TEST(GeometryFuzzLong, TwoSegments) { GeometryFuzz(12).segments(10000000); }
TEST(GeometryFuzzLong, Sign) { GeometryFuzz(13).signs(1000, 1000); }
}  // namespace
