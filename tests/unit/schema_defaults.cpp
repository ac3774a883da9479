// Defaults of the schema must equal the initial values of the structs that its keys fill.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "hawser/model/case.hpp"
#include "hawser/model/schema.hpp"

namespace hawser::model::schema_defaults_test {
namespace {

// True if the default of the only key of `root` leaves a new T unchanged; empty if the key belongs to another
// struct.
template <class T>
std::optional<bool> keeps(const Value& root) {
  T object{};
  std::array<unsigned char, sizeof(T)> before;
  std::memcpy(before.data(), &object, sizeof(T));
  try {
    take(root, object);
  } catch (const std::logic_error&) {
    return std::nullopt;
  }
  return std::memcmp(before.data(), &object, sizeof(T)) == 0;
}

template <class... T>
std::optional<bool> keeps_any(const Value& root) {
  std::optional<bool> out;
  (void)((out = keeps<T>(root)).has_value() || ...);
  return out;
}

std::optional<bool> keeps_initial(const Value& root) {
  return keeps_any<Case, Environment, Water, Wind, FlowOnBody, Current, CurrentRow, Waves, WaveSystem,
                   WaveSystem::Row, Seabed, Friction, LineType, Body, Drift, BodyMass, BodyInWater,
                   BodyHydrodynamics, BodyHull, MassMatrix, DynamicPositioning, BodyMember, BodyLoad,
                   HarmonicMotion, ConstantMotion, TableMotion, Ride, Volume, Line, Section, End, Joint,
                   PointMass, BendStiffener, Buried, LengthTarget, Feed, Link, LinkLaw, Contact, BetweenLines,
                   BetweenLines::Tuned, LinePairSettings, Statics, Dynamics, Output, ClashOutput, Clearance,
                   HistoryPoint, BoxShape, Event, Action, Cause>(root);
}

bool has_fields(const Key& k) {
  bool any = !k.fields.empty();
  for (const Key& inner : k.keys) any = any || has_fields(inner);
  return any;
}

// Only JONSWAP has a peakedness, and the keys of a Stokes wave create its row.
const std::set<std::string> kFallback = {
    ".environment.waves.jonswap.gamma",        ".environment.waves.sum.jonswap.gamma",
    ".environment.waves.stokes.direction_deg", ".environment.waves.sum.stokes.direction_deg",
    ".environment.waves.stokes.phase_deg",     ".environment.waves.sum.stokes.phase_deg"};

int compare(const Key& key, const std::string& path) {
  int compared = 0;
  for (const Key& k : key.keys) {
    const std::string here = k.name.empty() ? path : path + "." + k.name;
    if (k.fallback && has_fields(k)) {
      Key only;
      only.keys = {k};
      Value root;
      root.kind = Value::Kind::map;
      check_structure(root, only, "test");
      const std::optional<bool> same = keeps_initial(root);
      EXPECT_TRUE(same.has_value()) << here << " is for a struct that this test does not know";
      EXPECT_EQ(same.value_or(true), kFallback.count(here) == 0)
          << here << ": default " << *k.fallback << ", but the field is made with another value";
      ++compared;
    }
    compared += compare(k, here);
  }
  return compared;
}

TEST(SchemaDefaults, AreTheInitialValuesOfTheFields) { EXPECT_GT(compare(case_schema(), ""), 100); }

}  // namespace
}  // namespace hawser::model::schema_defaults_test
