// Crossing lines thrown at each other never pass through, whatever the step.
#include "verification/line_pairs_throw.hpp"

namespace hawser::test::line_pairs_throw_test {
namespace {

TEST(ThrownLines, NeverPassThrough) { expect_none_passes_through(120); }

}  // namespace
}  // namespace hawser::test::line_pairs_throw_test
