// Raises the start shape of lines where they cross other lines near the bed, and over volumes on the bed.
#include "start_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "hawser/advice/start_shape.hpp"
#include "hawser/geometry/box_pairs.hpp"
#include "hawser/geometry/segment_distance.hpp"
#include "hawser/math/ordered.hpp"
#include "hawser/model/bed.hpp"

namespace hawser {
namespace {

// Clearance after a line was raised, in sums of the radii.
constexpr double kCrossingGap = 0.01;
// Length over height of the slope up to a place where a line is raised.
constexpr double kSlope = 20;
// Limit of the vertical component of the common unit normal of two lines. Below it neither line is over the
// other.
constexpr double kMinVertical = 0.1;
// Smallest horizontal component of the direction of a line that can lie over a volume or pass beside it.
constexpr double kMinHorizontal = 0.1;

// A given line as a polyline of its nodes.
struct Rope {
  const model::Line* line = nullptr;
  int number = 0;  // as in StartedLine, like the next
  bool counted = false;
  std::vector<Vec3*> x;
  std::vector<double> s;       // m, arc length
  std::vector<double> radius;  // m, contact radius of the segment after each node
  std::vector<double> raise;   // m, by which each node will be raised
  std::vector<Vec3*> tangent;

  size_t segments() const { return x.size() - 1; }
  Vec3 at(size_t segment, double t) const { return *x[segment] + t * (*x[segment + 1] - *x[segment]); }
};

std::vector<Rope> ropes_of(const model::Case& c, std::vector<StartedLine>& lines) {
  std::vector<Rope> ropes;
  for (StartedLine& started : lines) {
    if (!c.contact.takes_part(*started.line)) continue;
    Rope& rope = ropes.emplace_back();
    rope.line = started.line;
    rope.number = started.number;
    rope.counted = started.counted;
    for (int i = 0; i < started.span.nodes; ++i) {
      const int element = started.span.first_element + std::min(i, started.span.elements - 1);
      rope.x.push_back(&started.shape.x[i]);
      rope.tangent.push_back(&started.shape.tangent[i]);
      rope.s.push_back(started.mesh->node(started.span.first_node + i).arc);
      rope.radius.push_back(0.5 * c.line_types[started.mesh->element(element).type].contact_diameter);
    }
    rope.raise.assign(rope.x.size(), 0);
  }
  return ropes;
}

// Raises a line by `height` between the arc lengths `from` and `to`, with smooth slopes on both sides. The
// ends of the line are not raised.
void raise(Rope& rope, double from, double to, double height) {
  double longest = 0;
  for (size_t i = 0; i < rope.segments(); ++i)
    if (rope.s[i + 1] >= from && rope.s[i] <= to) longest = std::max(longest, rope.s[i + 1] - rope.s[i]);
  for (size_t i = 0; i < rope.x.size(); ++i) {
    const bool before = rope.s[i] < from;
    const double off = before ? from - rope.s[i] : rope.s[i] > to ? rope.s[i] - to : 0;
    const double room = before ? from - rope.s.front() : rope.s.back() - to;
    const double flat = std::min(longest, 0.5 * room);
    const double slope = std::min(kSlope * height, room - flat);
    double fraction = 1;
    if (off > flat) fraction = off < flat + slope ? 0.5 * (1 + std::cos(M_PI * (off - flat) / slope)) : 0;
    rope.raise[i] = std::max(rope.raise[i], fraction * height);
  }
}

// Moves the nodes by `raise`. Clears the tangents beside moved nodes, which repair() then computes. Returns
// whether any node was moved.
bool apply(std::vector<Rope>& ropes) {
  bool any = false;
  for (Rope& r : ropes)
    for (size_t i = 0; i < r.x.size(); ++i) {
      if (!(r.raise[i] > 0)) continue;
      any = true;
      r.x[i]->z() += r.raise[i];
      r.raise[i] = 0;
      for (size_t k = i > 0 ? i - 1 : 0; k < std::min(i + 2, r.x.size()); ++k) r.tangent[k]->setZero();
    }
  return any;
}

// One line at a place where it crosses another.
struct Crossing {
  Rope* rope = nullptr;
  size_t segment = 0;
  double t = 0;       // in the segment
  double radius = 0;  // m
  Vec3 x = Vec3::Zero();

  double arc() const { return rope->s[segment] + t * (rope->s[segment + 1] - rope->s[segment]); }
  Vec3 along() const { return rope->at(segment, 1) - rope->at(segment, 0); }
  const std::string& name() const { return rope->line->name; }
};

class Crossings {
 public:
  Crossings(const model::Case& c, std::vector<Rope>& ropes) : c_(c), ropes_(ropes) {
    for (const auto& [x, y] : c.contact.between_lines.exclude) excluded_.insert(ordered(x, y));
  }

  // Sentences by the pair of lines.
  using Done = std::map<std::pair<int, int>, std::string>;

  // Raises the upper line at each crossing. `done` gets a sentence for each pair of lines.
  void sweep(Done& done) {
    std::vector<Box> boxes;
    std::vector<std::pair<Rope*, size_t>> segments;
    for (Rope& r : ropes_)
      for (size_t i = 0; i < r.segments(); ++i) {
        Box b;
        b.add(*r.x[i]);
        b.add(*r.x[i + 1]);
        boxes.push_back(b.grown(r.radius[i]));
        segments.emplace_back(&r, i);
      }
    std::vector<std::pair<int, int>> pairs = overlapping_pairs(boxes);
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [i, j] : pairs) {
      const auto& [one, k] = segments[i];
      const auto& [other, l] = segments[j];
      if (one == other || excluded_.count(ordered(one->line->name, other->line->name))) continue;
      if (auto crossed = crossing(*one, k, *other, l)) settle(crossed->first, crossed->second, done);
    }
  }

 private:
  // The crossing of two segments in plan, if they are nearer than the sum of their radii and it is not at an
  // end of a line.
  static std::optional<std::pair<Crossing, Crossing>> crossing(Rope& one, size_t k, Rope& other, size_t l) {
    const Vec3 u = one.at(k, 1) - one.at(k, 0);
    const Vec3 v = other.at(l, 1) - other.at(l, 0);
    const Vec3 w = other.at(l, 0) - one.at(k, 0);
    const double area = u.x() * v.y() - u.y() * v.x();
    const double radii = one.radius[k] + other.radius[l];
    if (!(std::abs(area) > kMinVertical * u.norm() * v.norm())) return std::nullopt;
    const double s = (w.x() * v.y() - w.y() * v.x()) / area;
    const double t = (w.x() * u.y() - w.y() * u.x()) / area;
    if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return std::nullopt;
    const auto pair = closest_points_of_segments(*one.x[k], *one.x[k + 1], *other.x[l], *other.x[l + 1]);
    if (pair.distance >= radii) return std::nullopt;
    Crossing a{&one, k, s, one.radius[k], one.at(k, s)};
    Crossing b{&other, l, t, other.radius[l], other.at(l, t)};
    // A line that ends at the other one does not cross it.
    const auto at_end = [radii](const Crossing& q) {
      return (q.x - *q.rope->x.front()).norm() < radii || (q.x - *q.rope->x.back()).norm() < radii;
    };
    if (at_end(a) || at_end(b)) return std::nullopt;
    return std::pair(a, b);
  }

  double height(const Vec3& x) const {
    const model::Seabed& bed = c_.environment.seabed;
    return bed.present ? model::height_above_bed(bed, x) : HUGE_VAL;
  }
  bool is_on_bed(const Vec3& x, double radius) const { return height(x) < 2 * radius; }
  bool is_on_bed_from_end_to_end(const Rope& r) const {
    return is_on_bed(*r.x.front(), r.radius.front()) && is_on_bed(*r.x.back(), r.radius[r.segments() - 1]);
  }

  // Determines the upper one of two lines, in this order: by the case; the one that can be moved; by contact
  // of only one with the bed, at the crossing or from end to end; by the heights of the start shapes. Null:
  // neither is moved. Throws InputError if none of these applies.
  const Crossing* upper(const Crossing& a, const Crossing& b) const {
    for (const auto& [upper_name, lower_name] : c_.contact.between_lines.crossings) {
      if (upper_name == a.name() && lower_name == b.name()) return &a;
      if (upper_name == b.name() && lower_name == a.name()) return &b;
    }
    const bool a_moves = a.rope->line->starts_by_itself();
    const bool b_moves = b.rope->line->starts_by_itself();
    if (!a_moves && !b_moves) return nullptr;
    const bool a_on_bed = is_on_bed(a.x, a.radius);
    const bool b_on_bed = is_on_bed(b.x, b.radius);
    const double rise = a.x.z() - b.x.z();
    if (a_moves != b_moves) {
      const Crossing& moves = a_moves ? a : b;
      const Crossing& fixed = a_moves ? b : a;
      const bool room = height(fixed.x) - fixed.radius >= 2 * moves.radius;
      if (!room || moves.x.z() >= fixed.x.z()) return &moves;
      return nullptr;
    }
    if (a_on_bed != b_on_bed) return a_on_bed ? &b : &a;
    if (a_on_bed) {
      const bool a_all = is_on_bed_from_end_to_end(*a.rope);
      const bool b_all = is_on_bed_from_end_to_end(*b.rope);
      if (a_all != b_all) return a_all ? &b : &a;
    } else if (std::abs(rise) > kCrossingGap * (a.radius + b.radius)) {
      return nullptr;
    }
    c_.refuse("lines." + b.name(), advice::undecided_crossing(b.name(), a.name(), 0.5 * (a.x + b.x)));
  }

  void settle(const Crossing& a, const Crossing& b, Done& done) const {
    const Crossing* upper_line = upper(a, b);
    if (!upper_line) return;
    const Crossing& lower_line = upper_line == &a ? b : a;
    if (!upper_line->rope->line->starts_by_itself())
      c_.refuse("contact.between_lines.over",
                advice::cannot_be_over(upper_line->name(), lower_line.name(), upper_line->x));
    const Vec3 normal = upper_line->along().cross(lower_line.along()).normalized();
    const double radii = a.radius + b.radius;
    const double slant = std::abs(normal.z());
    if (slant < kMinVertical) return;
    const double to = lower_line.x.z() + (1 + kCrossingGap) * radii / slant;
    // The slopes of both lines at the crossing are those of their elements.
    raise(*upper_line->rope, upper_line->arc(), upper_line->arc(), to - upper_line->x.z());
    const Rope& one = *upper_line->rope;
    const Rope& other = *lower_line.rope;
    if (!(one.number < other.number ? one : other).counted) return;
    done.try_emplace(ordered(one.number, other.number),
                     advice::starts_over_line(upper_line->name(), lower_line.name(),
                                              Vec3(upper_line->x.x(), upper_line->x.y(), to)));
  }

  const model::Case& c_;
  std::vector<Rope>& ropes_;
  std::set<std::pair<std::string, std::string>> excluded_;
};

// A volume in its place at the start.
struct Obstacle {
  const Surface* surface = nullptr;
  RigidPose pose;
  const std::string* name = nullptr;
  double size = 0;  // m, of its bounds

  double distance(const Vec3& x) const {
    const auto p = surface->query(pose.to_body(x), size);
    return p ? p->distance : size;
  }
  // Distance [m] from x along the unit vector `direction` to where the distance to the volume is `radius`;
  // more than `limit` if it is farther.
  double distance_out(const Vec3& x, const Vec3& direction, double radius, double limit) const {
    double advanced = 0;
    while (advanced < limit) {
      const double missing = radius - distance(x + advanced * direction);
      if (missing <= 0) break;
      advanced += missing + kCrossingGap * radius;  // the distance changes by no more than the point moves
    }
    return advanced;
  }
};

// A part of a line that is in a volume, or nearer to it than its radius.
struct PartInVolume {
  double from = 0, to = 0, height = 0;  // m, arc lengths; necessary raise
  Vec3 deepest = Vec3::Zero(), along = Vec3::UnitX();
  double depth = 0, radius = 0;  // m
};

std::vector<PartInVolume> parts_in(const Rope& rope, const Obstacle& volume) {
  std::vector<PartInVolume> out;
  bool inside = false;
  for (size_t i = 0; i < rope.segments(); ++i) {
    const double length = (rope.at(i, 1) - rope.at(i, 0)).norm();
    const double radius = rope.radius[i];
    for (double advanced = 0; advanced < length;) {
      const Vec3 x = rope.at(i, advanced / length);
      const double gap = volume.distance(x) - radius;
      const double s = rope.s[i] + advanced / length * (rope.s[i + 1] - rope.s[i]);
      if (gap < 0) {
        if (!inside) out.push_back({s, s});
        PartInVolume& part = out.back();
        part.to = s;
        part.height = std::max(part.height, volume.distance_out(x, Vec3::UnitZ(), radius, 2 * volume.size));
        if (-gap > part.depth) {
          part.depth = -gap;
          part.deepest = x;
          part.radius = radius;
          part.along = rope.at(i, 1) - rope.at(i, 0);
        }
      }
      inside = gap < 0;
      advanced += std::max(std::abs(gap), radius);
    }
  }
  return out;
}

// True if a part must go over the volume: there is no room for it between the volume and the bed, and the
// path over the volume is shorter than the path round it.
bool must_pass_over(const model::Case& c, const PartInVolume& s, const Obstacle& volume) {
  const model::Seabed& bed = c.environment.seabed;
  if (!bed.present) return false;
  const double down = volume.distance_out(s.deepest, -Vec3::UnitZ(), s.radius, 2 * volume.size);
  if (model::height_above_bed(bed, s.deepest - down * Vec3::UnitZ()) > s.radius) return false;
  const Vec3 side = Vec3::UnitZ().cross(s.along);
  if (!(side.norm() > kMinHorizontal * s.along.norm())) return false;
  for (const double sign : {1.0, -1.0})
    if (volume.distance_out(s.deepest, sign * side.normalized(), s.radius, 2 * volume.size) <= s.height)
      return false;
  return true;
}

}  // namespace

std::vector<StartNote> lay_over_volumes(const model::Case& c, const Bodies& bodies,
                                        const std::vector<std::shared_ptr<const Surface>>& surfaces,
                                        std::vector<StartedLine>& lines) {
  std::vector<Rope> ropes = ropes_of(c, lines);
  std::vector<StartNote> notes;
  for (size_t v = 0; v < surfaces.size(); ++v) {
    const model::Volume& volume = c.volumes[v];
    const int body = c.body_index(volume.body);
    if (!c.contact.takes_part(volume) || volume.roller || c.off_at_start(volume) || c.rides(body)) continue;
    const Box bounds = surfaces[v]->bounds();
    if (!std::isfinite(bounds.diagonal())) continue;
    const Obstacle obstacle{surfaces[v].get(), bodies.pose(body, 0), &volume.name, bounds.diagonal()};
    const Vec3 centre = obstacle.pose.to_space(bounds.centre());
    for (Rope& rope : ropes) {
      const model::Line& line = *rope.line;
      const auto held_by_body = [&](const model::End& e) {
        return e.kind == model::EndKind::body && e.carrier == volume.body;
      };
      if (!line.starts_by_itself() || held_by_body(line.end_a) || held_by_body(line.end_b)) continue;
      const bool far = std::all_of(rope.x.begin(), rope.x.end(), [&](const Vec3* x) {
        return (*x - centre).norm() > obstacle.size + rope.s.back() / static_cast<double>(rope.segments());
      });
      if (far) continue;
      for (const PartInVolume& s : parts_in(rope, obstacle)) {
        if (!must_pass_over(c, s, obstacle)) continue;
        raise(rope, s.from, s.to, s.height);
        if (!rope.counted) continue;
        notes.push_back(
            {static_cast<int>(v), rope.number,
             advice::starts_over_volume(line.name, volume.name, s.deepest + s.height * Vec3::UnitZ())});
      }
    }
    apply(ropes);
  }
  return notes;
}

std::vector<StartNote> lay_over_each_other(const model::Case& c, std::vector<StartedLine>& lines) {
  if (!c.contact.between_lines.enabled) return {};
  std::vector<Rope> ropes = ropes_of(c, lines);
  Crossings::Done done;
  Crossings crossings(c, ropes);
  // A raised line may meet a third one.
  for (size_t i = 0; i < ropes.size(); ++i) {
    crossings.sweep(done);
    if (!apply(ropes)) break;
  }
  std::vector<StartNote> notes;
  for (auto& [pair, sentence] : done) notes.push_back({pair.first, pair.second, std::move(sentence)});
  return notes;
}

}  // namespace hawser
