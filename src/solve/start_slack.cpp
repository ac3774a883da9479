// The circular arc on the bed or on the water's surface that takes up the slack between two ends.
#include "hawser/solve/start_slack.hpp"

#include <algorithm>
#include <cmath>

namespace hawser {
namespace {

constexpr double kStraight = 1e-4;  // relative excess of length below which the arc is straight

double bed_height(const model::Seabed& bed, const Vec3& x) {
  return -bed.depth -
         std::tan(bed.slope) * (std::cos(bed.direction) * x.x() + std::sin(bed.direction) * x.y());
}

// Half the angle of the circular arc of this length over this chord: sin(t)/t = chord/length.
double half_angle(double chord, double length) {
  double low = 0, high = M_PI;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.5 * (low + high);
    (std::sin(t) * length > chord * t ? low : high) = t;
  }
  return 0.5 * (low + high);
}

// Unit vector normal to the chord, towards which the arc bulges.
Vec3 bulge(const model::Environment& sea, const Vec3& chord) {
  const Vec3 left(-chord.y(), chord.x(), 0);
  const model::Current& current = sea.water.current;
  if (sea.water.present && current.ramp == 0 && !current.profile.empty()) {
    const double b = current.profile.front().direction;
    const double speed = current.profile.front().speed * current.time_factor.at(0);
    if (speed * left.dot(Vec3(std::cos(b), std::sin(b), 0)) < 0) return -left;
  }
  return left;
}

}  // namespace

std::optional<LiesOn> comes_to_lie(const model::Case& c, const std::vector<CatenarySection>& sections) {
  const auto all = [&](double sign) {
    return std::all_of(sections.begin(), sections.end(), [sign](const CatenarySection& k) {
      return sign * k.load.z() > 0 && sign * k.end_load.z() >= 0;
    });
  };
  if (c.environment.water.present && all(1)) return LiesOn::water_surface;
  if (c.environment.seabed.present && all(-1)) return LiesOn::bed;
  return std::nullopt;
}

bool lay_slack(const model::Environment& sea, LiesOn ground, const std::vector<double>& arc,
               std::vector<Vec3>& points) {
  const bool floats = ground == LiesOn::water_surface;
  const auto off = [&](const Vec3& x) {
    return (sea.seabed.present && x.z() < bed_height(sea.seabed, x) - 1e-6 * sea.seabed.depth) ||
           (floats && x.z() > sea.water.surface);
  };
  size_t first = 0;
  size_t last = points.size() - 1;
  const bool any = std::any_of(points.begin() + 1, points.end() - 1, off);
  if (!any) return false;
  while (first + 1 < last && !off(points[first + 1])) ++first;
  while (last > first + 1 && !off(points[last - 1])) --last;
  const Vec3 from = points[first];
  const Vec3 to = points[last];
  Vec3 along = to - from;
  along.z() = 0;
  const double chord = along.norm();
  const double length = arc[last] - arc[first];
  along = chord > 1e-9 * length ? Vec3(along / chord) : Vec3::UnitX();
  const Vec3 across = bulge(sea, along);
  const bool straight = length < (1 + kStraight) * chord;
  const double half = straight ? 0 : half_angle(chord, length);
  // If an end is above or below the plane in which the line lies, the line rises to it over three times the
  // height, at most over half the length.
  const double end_z[2] = {from.z(), to.z()};
  for (size_t i = first + 1; i < last; ++i) {
    const double z = (arc[i] - arc[first]) / length;
    Vec3 x = from;
    if (straight) {
      x += z * chord * along;
    } else {
      const double radius = 0.5 * length / half;
      const double angle = half * (2 * z - 1);
      x +=
          radius * ((std::sin(angle) + std::sin(half)) * along + (std::cos(angle) - std::cos(half)) * across);
    }
    const double level = floats ? sea.water.surface : bed_height(sea.seabed, x);
    x.z() = level;
    for (int end = 0; end < 2; ++end) {
      const double height = end_z[end] - level;
      const double away = end ? arc[last] - arc[i] : arc[i] - arc[first];
      const double reach = std::min(3 * std::abs(height), 0.5 * length);
      if (away < reach) x.z() += height * (1 - away / reach);
    }
    points[i] = x;
  }
  return true;
}

}  // namespace hawser
