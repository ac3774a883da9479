// Look-up by name finds the first of equal names, also after objects are added, renamed or exchanged.
#include "hawser/model/name_index.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace hawser::name_index_test {
namespace {

struct Thing {
  std::string name;
};

TEST(NameIndex, FindsTheFirstOfTheName) {
  std::vector<Thing> things;
  for (int k = 0; k < 200; ++k) things.push_back({"line " + std::to_string(k * 7919 % 200)});
  things[150].name = things[20].name;
  const model::NameIndex index;
  for (size_t i = 0; i < things.size(); ++i)
    EXPECT_EQ(index.find(things, things[i].name), static_cast<int>(i == 150 ? 20 : i));
  EXPECT_EQ(index.find(things, "line"), -1);
  EXPECT_EQ(index.find(things, "zebra"), -1);
  std::swap(things[3], things[180]);
  things[7].name = "renamed";
  EXPECT_EQ(index.find(things, things[3].name), 3);
  EXPECT_EQ(index.find(things, things[180].name), 180);
  EXPECT_EQ(index.find(things, "renamed"), 7);
  things.push_back({"added"});
  EXPECT_EQ(index.find(things, "added"), 200);
  EXPECT_EQ(index.find(std::vector<Thing>(), "added"), -1);
}

}  // namespace
}  // namespace hawser::name_index_test
