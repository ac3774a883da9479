// A list of names in one text.
#include "hawser/base/names.hpp"

#include <gtest/gtest.h>

namespace hawser::names_test {
namespace {

TEST(Names, InOneText) {
  Names names;
  for (const char* name : {"a", "", "a longer name than the others"}) names.push_back(name);
  names.shrink_to_fit();
  EXPECT_EQ(names.size(), 3u);
  EXPECT_EQ(names[0], "a");
  EXPECT_EQ(names[1], "");
  EXPECT_EQ(names[2], "a longer name than the others");
  EXPECT_EQ(names[3], "");
}

}  // namespace
}  // namespace hawser::names_test
