// Values that copies share until one of them changes its own.
#include "hawser/base/shared.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace hawser::shared_test {
namespace {

TEST(Shared, CopiesHaveOneValueUntilOneIsChanged) {
  Shared<std::string> a(std::string("long enough to be on the heap"));
  Shared<std::string> b = a;
  EXPECT_EQ(&*std::as_const(a), &*std::as_const(b));
  b->append(", and longer");
  EXPECT_NE(&*std::as_const(a), &*std::as_const(b));
  EXPECT_EQ(*std::as_const(a), "long enough to be on the heap");
  EXPECT_EQ(*std::as_const(b), "long enough to be on the heap, and longer");
  const std::string* own = &*std::as_const(b);
  *b = "other";
  EXPECT_EQ(&*std::as_const(b), own) << "nothing shares it any more";
  b = a;
  b.emplace("new");
  EXPECT_EQ(*std::as_const(a), "long enough to be on the heap");
  b = a;
  b.reset();
  EXPECT_FALSE(b);
  EXPECT_TRUE(a.has_value());
}

TEST(Shared, NoneIsSmall) {
  struct Large {
    double of[100];
  };
  const Shared<Large> none;
  EXPECT_FALSE(none.has_value());
  EXPECT_LE(sizeof none, 2 * sizeof(void*));
}

}  // namespace
}  // namespace hawser::shared_test
