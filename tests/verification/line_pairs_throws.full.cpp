// Ten thousand throws of line_pairs_throw.hpp.
#include "verification/line_pairs_throw.hpp"

namespace hawser::test {
namespace {

TEST(ThrownLinesFull, NeverPassThrough) { expect_none_passes_through(10000); }

}  // namespace
}  // namespace hawser::test
