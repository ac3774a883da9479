// Start shape of a line with one free end that lies on the bed or floats: its direction, the hanging part,
// the bend at the touchdown point, and the part along the ground.
#include "start_free_end.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/geometry/surface.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/terms/lines_in_water.hpp"
#include "start_flexible.hpp"

namespace hawser {
namespace {

constexpr int kBisections = 50;
constexpr double kMaxBend = 0.5;  // largest radius of the bend, over the height above the ground

Vec3 level(const Vec3& v) { return {v.x(), v.y(), 0}; }

// The surface on which a line lies: the bed or the water's surface.
class Ground {
 public:
  Ground(const model::Environment& sea, bool floats) : sea_(sea), floats_(floats) {}

  // Moves x vertically to the ground; beyond the edge of the bed x is returned.
  Vec3 under(Vec3 x) const {
    if (floats_) return {x.x(), x.y(), sea_.water.surface};
    const model::Seabed& bed = sea_.seabed;
    if (!bed.surface) return {x.x(), x.y(), x.z() - model::height_above_bed(bed, x) / std::cos(bed.slope)};
    Vec3 y = x;
    for (int i = 0; i < kMaxDrops; ++i) {
      const double height = model::height_above_bed(bed, y);
      if (!std::isfinite(height)) return x;
      y.z() -= height;
      if (std::abs(height) < 1e-6 * std::abs(bed.depth)) break;
    }
    return y;
  }

  // The point on the ground at `length` from x on the ground, in this direction.
  Vec3 along_ground(const Vec3& x, const Vec3& direction, double length) const {
    const Vec3 ahead = under(x + length * direction);
    return under(x + length * (ahead - x).normalized());
  }

 private:
  static constexpr int kMaxDrops = 50;  // on a steep bed the nearest point is far from the one below
  const model::Environment& sea_;
  bool floats_;
};

std::vector<CatenarySection> first_of(const std::vector<CatenarySection>& sections, double length) {
  std::vector<CatenarySection> out;
  for (CatenarySection s : sections) {
    if (!(length > 0)) break;
    if (s.length > length) {
      s.length = length;
      s.end_load.setZero();
    }
    length -= s.length;
    out.push_back(s);
  }
  return out;
}

// Unit normal of a measured bed near x; vertical beyond its edge.
Vec3 normal_at(const Surface& bed, const Vec3& x) {
  const auto nearest = bed.query(x, HUGE_VAL);
  return nearest ? nearest->normal : Vec3(Vec3::UnitZ());
}

// Radius r of the bend where a hanging line begins to lie. The moment EI/r is that of the weight w r at an
// arm r, so r³ = EI/w.
double bend(const model::Case& c, const model::Line& line, const std::vector<CatenarySection>& sections) {
  double stiffest = 0, lightest = HUGE_VAL;
  for (const auto& s : line.sections)
    if (const auto& t = c.line_type(s.type); t.kind == model::LineKind::beam)
      stiffest = std::max({stiffest, t.EI2, t.EI3});
  for (const auto& k : sections) lightest = std::min(lightest, std::abs(k.load.z()));
  return std::cbrt(stiffest / lightest);
}

}  // namespace

Vec3 direction_of_free_end(const model::Case& c, const model::Line& line, const HeldEnd& end, bool floats) {
  const model::Water& water = c.environment.water;
  const model::Seabed& bed = c.environment.seabed;
  Vec3 pull = Vec3::Zero(), u = Vec3::Zero(), normal = Vec3::UnitZ(), by_depth;
  const Vec3 below = floats ? end.at : Ground(c.environment, false).under(end.at);
  if (const CurrentProfile current = acting_current(c); !current.none())
    current.at(floats ? 0.0 : water.surface - below.z(), u, by_depth);
  if (!floats && bed.present) normal = bed.surface ? normal_at(*bed.surface, below) : model::bed_normal(bed);
  for (const auto& s : line.sections) {
    const auto& t = c.line_type(s.type);
    pull += s.length * 0.5 * water.density * t.Cd_normal * t.dragged() * u.norm() * level(u);
    if (floats || !bed.present) continue;
    const double weight = t.mass_per_length * c.environment.gravity - buoyancy(c, t);
    pull += s.length * std::max(0.0, weight) * normal.z() * level(normal);
  }
  for (const Vec3& direction : {pull, level(end.direction), level(end.body)})
    if (direction.norm() > 1e-9) return direction.normalized();
  return Vec3::UnitX();
}

bool all_act(const std::vector<CatenarySection>& sections, double sign) {
  return std::all_of(sections.begin(), sections.end(), [sign](const CatenarySection& k) {
    return sign * k.load.z() > 0 && sign * k.end_load.z() >= 0;
  });
}

std::optional<std::vector<Vec3>> laid_free_end(const model::Case& c, const model::Line& line,
                                               const HeldEnd& end, std::vector<CatenarySection> sections,
                                               const std::vector<double>& arc) {
  const model::Water& water = c.environment.water;
  const bool floats = water.present && all_act(sections, 1);
  if (!floats && !(c.environment.seabed.present && all_act(sections, -1))) return {};
  const Ground ground(c.environment, floats);
  const Vec3 direction = direction_of_free_end(c, line, end, floats);
  const double height = end.at.z() - ground.under(end.at).z();
  const double up = height < 0 ? -1 : 1;
  if (floats && height > 0)  // the line hangs in the air; its weight matters only to its stretch
    for (CatenarySection& k : sections) {
      k.load.z() *= -1;
      k.end_load.z() *= -1;
    }
  const bool hangs = floats ? height != 0 : height > 0;
  const double radius = hangs ? std::min(bend(c, line, sections), kMaxBend * std::abs(height)) : 0;
  const double foot = ground.under(end.at + radius * direction).z();
  const auto above = [&](double length) {
    return up * (catenary_free_b(end.at, first_of(sections, length)).end_b().z() - foot) - radius;
  };
  double low = 0;
  double high = arc.back();
  if (hangs && above(high) > 0) return {};
  for (int i = 0; hangs && i < kBisections; ++i) {
    const double at = 0.5 * (low + high);
    (above(at) > 0 ? low : high) = at;
  }
  const double hanging = low;
  const double bent = hanging + 0.5 * M_PI * radius;
  std::optional<CatenaryShape> shape;
  if (hanging > 0) shape = catenary_free_b(end.at, first_of(sections, hanging));
  const Vec3 from = shape ? shape->end_b() : end.at;
  Vec3 last = ground.under(from + radius * direction);
  double so_far = bent;
  std::vector<Vec3> out;
  for (const double s : arc) {
    if (s <= hanging) {
      out.push_back(shape ? shape->position(s) : end.at);
    } else if (s <= bent) {
      const double turned = (s - hanging) / radius;
      out.push_back(from +
                    radius * ((1 - std::cos(turned)) * direction - up * std::sin(turned) * Vec3::UnitZ()));
    } else {
      last = ground.along_ground(last, direction, s - so_far);
      so_far = s;
      out.push_back(last);
    }
  }
  return out;
}

}  // namespace hawser
