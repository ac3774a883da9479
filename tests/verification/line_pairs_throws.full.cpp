// Ten thousand throws of what line_pairs_throw does with a few.
#include "verification/line_pairs_throw.hpp"

namespace hawser::test {
namespace {

TEST(ThrownLinesFull, NeverPassThrough) { expect_none_passes_through(10000); }

}  // namespace
}  // namespace hawser::test
