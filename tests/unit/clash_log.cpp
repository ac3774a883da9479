// Contacts of successive steps are combined into clashes: duration, impulse, largest force and places,
// against hand calculations.
#include "hawser/record/clash_log.hpp"

#include <gtest/gtest.h>

#include "hawser/advice/clashes.hpp"

namespace hawser::record::clash_log_test {
namespace {

ActiveContact touch(int line, int volume, double from, double to, double force = 1, double depth = 0) {
  ActiveContact t;
  t.line = line;
  t.volume = volume;
  t.from = from;
  t.to = to;
  t.force = force;
  t.depth = depth;
  t.energy = 0.1 * force;
  return t;
}

ClashSettings settings(double gap = 0.1) { return {gap, {0.5, 0.5}}; }

void step(ClashLog& log, double time, const ActiveContacts& touches) {
  log.step(time, merge_contacts(touches, settings().merge_length));
}

TEST(ClashLog, PlacesNearerThanTheMergeLengthAreOne) {
  ActiveContact a = touch(0, 0, 1, 2, 3, 0.1);
  ActiveContact b = touch(0, 0, 2.4, 3, 4, 0.2);
  ActiveContact c = touch(0, 0, 3.6, 4);
  const ActiveContacts t = merge_contacts({c, b, touch(1, 0, 1, 2), touch(0, 1, 1.5, 2.5), a}, {0.5, 0.5});
  ASSERT_EQ(t.size(), 4u);
  EXPECT_EQ(t[0].from, 1);
  EXPECT_EQ(t[0].to, 3);
  EXPECT_EQ(t[0].force, 7);
  EXPECT_EQ(t[0].depth, 0.2);
  EXPECT_DOUBLE_EQ(t[0].energy, 0.7);
  EXPECT_EQ(t[1].from, 3.6);
  EXPECT_EQ(t[2].volume, 1);
  EXPECT_EQ(t[3].line, 1);
}

TEST(ClashLog, OneClash) {
  ClashLog log(settings());
  step(log, 0, {});
  step(log, 0.1, {touch(0, 0, 2, 2.2, 10, 0.01)});
  step(log, 0.3, {touch(0, 0, 2.1, 2.5, 30, 0.03)});
  step(log, 0.4, {touch(0, 0, 2.2, 2.4, 20, 0.02)});
  ASSERT_EQ(log.open().size(), 1u);
  EXPECT_TRUE(log.take().ended.empty());
  step(log, 0.6, {});
  EXPECT_TRUE(log.open().empty());
  const auto ended = log.take().ended;
  ASSERT_EQ(ended.size(), 1u);
  const io::ClashRow& r = ended[0];
  EXPECT_EQ(r.line, 0);
  EXPECT_EQ(r.other_line, -1);
  EXPECT_EQ(r.volume, 0);
  EXPECT_EQ(r.start, 0.1);
  EXPECT_EQ(r.end, 0.4);
  EXPECT_EQ(r.from, 2);
  EXPECT_EQ(r.to, 2.5);
  EXPECT_EQ(r.peak_force, 30);
  EXPECT_EQ(r.peak_time, 0.3);
  EXPECT_EQ(r.peak_from, 2.1);
  EXPECT_EQ(r.penetration, 0.03);
  EXPECT_DOUBLE_EQ(r.peak_energy, 3);
  // Trapezoids: 0 to 10 to 30 to 20 to 0.
  EXPECT_NEAR(r.impulse, 0.5 + 4 + 2.5 + 2, 1e-12);
  EXPECT_TRUE(log.take().ended.empty());
}

TEST(ClashLog, FlutterIsOneClashAndABounceAreTwo) {
  for (const double pause : {0.09, 0.2}) {
    ClashLog log(settings());
    step(log, 0, {touch(0, 0, 1, 1.1)});
    step(log, 0.01, {});
    step(log, pause, {touch(0, 0, 1, 1.1)});
    step(log, 1, {});
    EXPECT_EQ(log.count(), pause < 0.1 ? 1 : 2) << pause;
    EXPECT_TRUE(log.open().empty());
  }
}

TEST(ClashLog, PlacesOfAPairAreClashesOfTheirOwnUntilTheyMeet) {
  ClashLog log(settings());
  step(log, 0, {touch(0, 0, 1, 2, 5), touch(0, 1, 1, 2)});
  step(log, 1, {touch(0, 0, 1, 2, 5), touch(0, 0, 8, 9, 50), touch(0, 1, 1, 2)});
  EXPECT_EQ(log.count(), 3);
  // One contact moves along the line.
  for (int i = 0; i < 6; ++i) step(log, 1.1 + 0.1 * i, {touch(0, 0, 1 + i, 2 + i, 5), touch(0, 0, 8, 9, 50)});
  const auto open = log.open();
  ASSERT_EQ(open.size(), 2u);  // the clash of the other volume has ended
  EXPECT_EQ(open[0].from, 1);
  EXPECT_EQ(open[0].to, 7);
  EXPECT_EQ(open[1].from, 8);
  step(log, 2, {touch(0, 0, 6, 9, 60)});
  const auto joined = log.open();
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_EQ(joined[0].start, 0);
  EXPECT_EQ(joined[0].from, 1);
  EXPECT_EQ(joined[0].to, 9);
  EXPECT_EQ(joined[0].peak_force, 60);
  // Sum of both impulses: 5 N over the whole time, 50 N since 1 s (half in its first second), then 60 N.
  const double expected = 5 * 1.6 + 25 + 50 * 0.6 + 0.5 * (2 - 1.6) * (55 + 60);
  EXPECT_NEAR(joined[0].impulse, expected, 1e-12);
}

TEST(ClashLog, AClashThatPartsStaysOne) {
  ClashLog log(settings());
  step(log, 0, {touch(0, 0, 1, 9, 8)});
  for (const double t : {0.1, 1.0}) step(log, t, {touch(0, 0, 1, 2, 3), touch(0, 0, 8, 9, 4)});
  ASSERT_EQ(log.open().size(), 1u);
  EXPECT_NEAR(log.open()[0].impulse, 0.1 * 7.5 + 0.9 * 7, 1e-12);
}

std::vector<std::vector<double>> numbers(const ClashLog& log) {
  std::vector<std::vector<double>> out;
  for (const CheckpointRecord& r : log.save()) out.push_back(r.values);
  return out;
}

TEST(ClashLog, GoesOnFromItsRecords) {
  ClashLog whole(settings());
  ClashLog half(settings());
  const auto run = [](ClashLog& log, int from, int to) {
    for (int i = from; i < to; ++i) {
      ActiveContacts t;
      if (i % 7 < 4) t.push_back(touch(0, 0, 0.1 * i, 1 + 0.1 * i, i));
      if (i % 5 < 2) t.push_back(touch(1, 0, 3, 4, 2 * i));
      if (i > 20) t.push_back(touch(0, 1, 20, 21, 1));
      step(log, 0.07 * i, t);
    }
  };
  run(whole, 0, 60);
  run(half, 0, 23);
  ClashLog rest(settings());
  rest.restore(half.save());
  run(rest, 23, 60);
  EXPECT_EQ(numbers(rest), numbers(whole));
  EXPECT_GT(whole.count(), 10);
  std::vector<CheckpointRecord> damaged = whole.save();
  damaged.front().values.pop_back();
  EXPECT_THROW(rest.restore(damaged), std::invalid_argument);
  EXPECT_THROW(rest.restore({}), std::invalid_argument);
}

// The reported clashes are those of the last output in the file, even if the checkpoint is later.
TEST(ClashLog, KeepsWhatItHasReported) {
  ClashLog log(settings());
  step(log, 0, {touch(0, 0, 1, 2, 3), touch(1, 0, 1, 2, 3)});
  step(log, 1, {touch(0, 0, 1, 2, 3)});
  EXPECT_EQ(log.take().ended.size(), 1u);
  step(log, 2, {touch(0, 0, 1, 2, 9)});
  step(log, 3, {});
  ClashLog rest(settings());
  rest.restore(log.save());
  EXPECT_TRUE(rest.open().empty());
  EXPECT_EQ(rest.reported().ended, 1);
  ASSERT_EQ(rest.reported().open.size(), 1u);
  EXPECT_EQ(rest.reported().open[0].peak_force, 3);
  EXPECT_EQ(rest.take().ended.size(), 1u);
  EXPECT_EQ(rest.reported().ended, 2);
  rest.begin_file();
  EXPECT_EQ(rest.reported().ended, 0);
  EXPECT_TRUE(rest.reported().open.empty());
}

TEST(ClashLog, TheLargestAreKept) {
  ClashLog log(settings(0));
  for (int i = 0; i < 3000; ++i) {
    step(log, 2 * i, {touch(0, 0, 1, 2, (i * 7919) % 3000)});
    step(log, 2 * i + 1, {});
  }
  EXPECT_EQ(log.count(), 3000);
  const auto most = log.largest(5);
  ASSERT_EQ(most.size(), 5u);
  for (size_t i = 0; i < 5; ++i) EXPECT_EQ(most[i].peak_force, 2999 - static_cast<double>(i));
}

TEST(ClashLog, FirstLineOfTheTable) {
  EXPECT_EQ(advice::clashes(7, 2, 7), "clashes: 7, 2 of them still in contact:\n");
  EXPECT_EQ(advice::clashes(7, 2, 3),
            "clashes: 7, 2 of them still in contact; the 3 with the largest forces:\n");
}

}  // namespace
}  // namespace hawser::record::clash_log_test
