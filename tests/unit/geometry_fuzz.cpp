// Short random tests of the geometry; geometry_fuzz_long.full.cpp has the long ones.
#include "support/geometry_fuzz.hpp"

namespace {
using hawser::test::GeometryFuzz;

TEST(GeometryFuzz, TriangleAndPoint) { GeometryFuzz(1).triangles(50000); }
TEST(GeometryFuzz, TwoSegments) { GeometryFuzz(2).segments(50000); }
TEST(GeometryFuzz, Sign) { GeometryFuzz(3).signs(40, 500); }
}  // namespace
