// Energy audit of a run: energy created and lost by the steps, its time and place, and the warnings about it.
#include "hawser/record/audit.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "hawser/record/audit_checkpoint.hpp"

namespace hawser::test::audit_test {
namespace {

Energy moving(double kinetic, double work = 0) {
  Energy e;
  e.kinetic = kinetic;
  e.work = work;
  return e;
}

// A checkpoint without one of the numbers is incomplete: none is taken as zero.
TEST(Audit, IsRestoredCompletely) {
  record::Audit a;
  a.update(moving(100), moving(100), 0, 0);
  a.update(moving(100), moving(103, 1), 0.3, 0.1);
  a.located(7, record::Audit::Step::ContactWith::volume);
  io::Checkpoint complete;
  record::save_audit(moving(100), a, complete);
  ASSERT_TRUE(record::has_audit(complete));
  record::Audit b;
  Energy start;
  record::restore_audit(complete, start, b);
  EXPECT_EQ(start.kinetic, 100);
  EXPECT_EQ(b.absolute_work, a.absolute_work);
  EXPECT_EQ(b.largest_step_gain.value, a.largest_step_gain.value);
  EXPECT_EQ(b.worst.node, a.worst.node);
  EXPECT_EQ(b.warning(advice::StepChoice::given, "here"), a.warning(advice::StepChoice::given, "here"));
  for (const auto& [name, value] : complete.scalars) {
    io::Checkpoint part = complete;
    part.scalars.erase(name);
    EXPECT_FALSE(record::has_audit(part)) << name;
    EXPECT_THROW(record::restore_audit(part, start, b), std::out_of_range) << name;
  }
}

// The work enters in some steps and leaves in the last: the absolute work increases, but there is no error
// and no warning.
TEST(Audit, IsSilentOfWhatIsBroughtIn) {
  record::Audit a;
  a.update(moving(0), moving(0), 0, 0);
  a.update(moving(0), moving(500, 500), 0.1, 0.1);
  a.update(moving(0), moving(995, 1000), 0.2, 0.1);
  a.update(moving(0), moving(0, 0), 0.3, 0.1);
  EXPECT_EQ(a.brought_in, 0);
  EXPECT_EQ(a.absolute_work, 2000);
  EXPECT_EQ(a.error, 0);
  EXPECT_EQ(a.warning(advice::StepChoice::given, "here"), "");
  EXPECT_FALSE(a.wrong());
}

TEST(Audit, ReportsWhatAStepMadeWhereAndWhatHelps) {
  record::Audit a;
  a.update(moving(100), moving(100), 0, 0);
  EXPECT_TRUE(a.update(moving(100), moving(103), 0.3, 0.1));
  a.worst.with = record::Audit::Step::ContactWith::volume;
  EXPECT_FALSE(a.update(moving(100), moving(102), 0.35, 0.05));
  EXPECT_NEAR(a.size(), 100, 1e-5);  // without created energy
  EXPECT_EQ(
      a.warning(advice::StepChoice::given, "line chain, arc length 3 m"),
      "the steps created 3 J of energy by t = 0.3 s, 3 % of the work done; the one of 0.1 s that ended at "
      "t = 0.3 s created most of it, 3 J, at line chain, arc length 3 m: it touches a volume there; give "
      "dynamics.step: 0.025 s");
  EXPECT_FALSE(a.wrong());
  a.worst.with = record::Audit::Step::ContactWith::nothing;
  const std::string w = a.warning(advice::StepChoice::automatic, "here");
  EXPECT_NE(
      w.find("its velocity changes faster than the time steps resolve; give dynamics.max_step: 0.025 s"),
      std::string::npos)
      << w;
}

// An impact at the start is not reduced by shorter steps.
TEST(Audit, ReportsAnImpactAtTheStart) {
  record::Audit a;
  a.update(moving(100), moving(100), 0, 0);
  a.update(moving(100), moving(103), 0.3, 0.1);
  EXPECT_EQ(
      a.warning(advice::StepChoice::given, "line chain, arc length 3 m", "bodies.vessel.motion"),
      "the steps created 3 J of energy by t = 0.3 s, 3 % of the work done; the one of 0.1 s that ended at "
      "t = 0.3 s created most of it, 3 J, at line chain, arc length 3 m: bodies.vessel.motion begins with a "
      "non-zero velocity, which is an impact on the lines at rest; add a 'ramp' to it (a shorter step does "
      "not help)");
  a.update(moving(100), moving(110), 0.7, 0.1);  // a larger error later, for another reason
  EXPECT_NE(a.warning(advice::StepChoice::given, "here", "bodies.vessel.motion")
                .find("give dynamics.step: 0.025 s"),
            std::string::npos);
}

// Energy created first and lost later: the final sum is right, but the run is still wrong.
TEST(Audit, KeepsTheLargestErrorOfTheRun) {
  record::Audit a;
  a.update(moving(100), moving(100), 0, 0);
  a.update(moving(100), moving(130), 1, 0.1);
  a.update(moving(100), moving(100), 2, 0.1);
  EXPECT_EQ(a.percent(), 0);
  EXPECT_TRUE(a.wrong());
  const std::string w = a.warning(advice::StepChoice::given, "here");
  EXPECT_NE(w.find("created 30 J of energy by t = 1 s"), std::string::npos) << w;
  EXPECT_NE(w.find("Do not use the results"), std::string::npos) << w;
}

// Energy lost first and created later: a gain after a loss is created energy as well.
TEST(Audit, AGainAfterALossCounts) {
  record::Audit a;
  a.update(moving(100), moving(100), 0, 0);
  a.update(moving(100), moving(85), 1, 0.1);
  EXPECT_FALSE(a.wrong());
  EXPECT_NE(a.warning(advice::StepChoice::given, "here")
                .find("the steps lost 15 J by t = 1 s, 15 % of the work done"),
            std::string::npos);
  a.update(moving(100), moving(100), 2, 0.1);
  EXPECT_TRUE(a.wrong());
}

// A loss of 0.1 % of each wave's work over a thousand waves gives no warning, although it is ten times the
// energy present at any time.
TEST(Audit, ASlowLossInALongRunIsNoAlarm) {
  record::Audit a;
  double in = 0;
  const Energy start = moving(1000);
  a.update(start, start, 0, 0);
  for (int wave = 1; wave <= 10000; ++wave) {
    in += 100;
    a.update(start, moving(1100.05 - 0.1 * wave, in), wave, 1);
    in -= 100;
    a.update(start, moving(1000 - 0.1 * wave, in), wave + 0.5, 1);
  }
  EXPECT_NEAR(a.error, -1000, 1);
  EXPECT_EQ(a.warning(advice::StepChoice::automatic, "here"), "");
}

// Created energy of a fifth of the energy present at a time is an error, for any absolute work in hours of
// waves.
TEST(Audit, AFifthOfWhatWasThereIsAnAlarmInALongRun) {
  record::Audit a;
  a.update(moving(0), moving(0), 0, 0);
  double in = 0;
  for (int wave = 1; wave <= 10000; ++wave) {
    in += 100;
    a.update(moving(0), moving(100, in), wave, 1);
    in -= 100;
    a.update(moving(0), moving(0, in), wave + 0.5, 1);
  }
  a.update(moving(0), moving(19, 0), 10001, 0.1);
  EXPECT_FALSE(a.wrong());
  a.update(moving(0), moving(30, 0), 10002, 0.1);
  EXPECT_TRUE(a.wrong());
  EXPECT_NE(a.warning(advice::StepChoice::automatic, "here").find("created 30 J"), std::string::npos);
}

// In each wave an end brings in 50 J more than it takes out, and drag dissipates them. The created energy,
// half a per cent of the absolute work, is dissipated as well: no warning, although its sum is ten times the
// energy present. Without drag the created energy remains, which is an error.
TEST(Audit, WhatDissipationTakesAlongIsNoAlarm) {
  for (const double drag : {50.0, 0.0}) {
    record::Audit a;
    a.update(moving(0), moving(0), 0, 0);
    for (int wave = 1; wave <= 1000; ++wave) {
      const double made_before = wave - 1;
      const double through = drag * wave;
      Energy in = moving(100, 100 - made_before);
      in.by_water = -through + drag;
      a.update(moving(0), in, wave, 1);
      Energy out = moving(0, -made_before - 1);
      out.by_water = -through;
      a.update(moving(0), out, wave + 0.5, 1);
    }
    EXPECT_NEAR(a.error, 1000, 1e-9);
    EXPECT_NEAR(a.largest_energy, 100, 2);
    EXPECT_EQ(a.wrong(), drag == 0);
  }
}

// A taut line on which hardly any work is done: created energy that as axial vibration would change its
// tension by at most 5 % gives a warning only.
TEST(Audit, SmallVibrationOfATautLineIsAWarning) {
  for (const double created : {0.0024, 0.0026}) {
    record::Audit a;
    Energy e;
    e.strain = 1;
    const Energy start = e;
    a.update(start, start, 0, 0);
    e.work = 0.005;
    e.strain += e.work;
    a.update(start, e, 1, 0.1);
    e.kinetic = created;
    a.update(start, e, 2, 0.1);
    EXPECT_NE(a.warning(advice::StepChoice::automatic, "here"), "");
    EXPECT_EQ(a.wrong(), created > 0.0025 * e.strain) << created;
  }
}

// Rounding of a line at rest, before any work, gives no warning.
TEST(Audit, RestIsNoAlarm) {
  record::Audit a;
  Energy e;
  e.strain = 434;
  const Energy start = e;
  a.update(start, start, 0, 0);
  e.strain += 3e-10;
  e.kinetic = 1e-12;
  a.update(start, e, 0.1, 0.1);
  e.strain -= 6e-10;
  a.update(start, e, 0.2, 0.1);
  EXPECT_EQ(a.warning(advice::StepChoice::automatic, "here"), "");
  EXPECT_FALSE(a.wrong());
}

TEST(Audit, NoNumberIsWrong) {
  record::Audit a;
  a.update(moving(0), moving(0), 0, 0);
  a.update(moving(0), moving(NAN), 0.1, 0.1);
  EXPECT_TRUE(a.wrong());
  EXPECT_NE(a.warning(advice::StepChoice::automatic, "here"), "");
}

TEST(Audit, WhatStepsDoNotResolveIsANote) {
  record::Audit a;
  Energy e = moving(90, 0);
  e.unresolved = 10;
  a.update(moving(100), moving(100), 0, 0);
  a.update(moving(100), e, 1, 0.1);
  EXPECT_EQ(a.error, 0);
  EXPECT_EQ(a.warning(advice::StepChoice::automatic, "here"), "");
  EXPECT_NE(a.note().find("10 J of axial vibration faster than the time steps resolve were dissipated (10 %"),
            std::string::npos)
      << a.note();
}

}  // namespace
}  // namespace hawser::test::audit_test
