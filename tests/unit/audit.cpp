// The energy audit of a run says what the steps have made, and when.
#include "hawser/app/audit.hpp"

#include <gtest/gtest.h>

namespace hawser::test::audit_test {
namespace {

Energy moving(double kinetic, double work = 0) {
  Energy e;
  e.kinetic = kinetic, e.work = work;
  return e;
}

TEST(Audit, IsSilentOfWhatIsBroughtIn) {
  app::Audit a;
  a.update(moving(0), moving(0), 0, 0);
  a.update(moving(0), moving(500, 500), 0.1, 0.1);
  a.update(moving(0), moving(995, 1000), 0.2, 0.1);
  EXPECT_EQ(a.brought_in, 1000);
  EXPECT_EQ(a.error, -5);
  EXPECT_EQ(a.percent(), -0.5);
  EXPECT_EQ(a.warning(true), "");
}

TEST(Audit, TellsWhatAStepMade) {
  app::Audit a;
  a.update(moving(100), moving(100), 0, 0);
  a.update(moving(100), moving(2600), 0.3, 0.1);
  a.update(moving(100), moving(2500), 0.35, 0.05);
  EXPECT_EQ(a.moved, 100);  // without what was made
  const std::string w = a.warning(true);
  EXPECT_NE(w.find("2.5e+03 J (2.5e+03 % of the most that moved) at t = 0.3 s"), std::string::npos) << w;
  EXPECT_NE(w.find("the step of 0.1 s that ended at t = 0.3 s made 2.5e+03 J"), std::string::npos) << w;
  EXPECT_NE(w.find("(dynamics.step)"), std::string::npos) << w;
  EXPECT_NE(a.warning(false).find("dynamics.max_step"), std::string::npos);
}

// Made first and lost later: at the end the sum is right.
TEST(Audit, RemembersWhatWasAmissOnTheWay) {
  app::Audit a;
  a.update(moving(100), moving(100), 0, 0);
  a.update(moving(100), moving(130), 1, 0.1);
  a.update(moving(100), moving(100), 2, 0.1);
  EXPECT_EQ(a.percent(), 0);
  EXPECT_NE(a.warning(true).find("30 J (30 % of the most that moved) at t = 1 s"), std::string::npos);
}

}  // namespace
}  // namespace hawser::test::audit_test
