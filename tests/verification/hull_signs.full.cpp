// 10^6 points at each real hull are classified as inside or outside as by the winding number of all
// triangles.
#include "verification/hull_signs.hpp"

namespace hawser {
namespace {

TEST(HullSignsFull, Kvlcc2Flat) { test::expect_signs("kvlcc2.obj", 58, false, 10000); }
TEST(HullSignsFull, Kvlcc2Curved) { test::expect_signs("kvlcc2.obj", 58, true, 10000); }
TEST(HullSignsFull, DtcFlat) { test::expect_signs("dtc.stl", 1, false, 10000); }
TEST(HullSignsFull, DtcCurved) { test::expect_signs("dtc.stl", 1, true, 10000); }

}  // namespace
}  // namespace hawser
