// Positions where the nodes of lines were laid on the bed, starting from the ends of lines, and the choice of
// the end from which a line was laid.
#include "hawser/solve/laid_places.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "hawser/geometry/surface.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"
#include "hawser/terms/soil_resistance.hpp"

namespace hawser {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();
// Weight of the distance along the lines: it decides between equally low ends only.
constexpr double kAway = 1e-3;

// An end of a line.
struct Side {
  size_t line = 0;
  LineEnd end = LineEnd::A;
};

// The held end on one side of a line, found through joints: the lowest one there, and of equally low ends the
// nearest.
struct Holder {
  // m above the bed, plus kAway times its distance; infinite: no end holds the line
  double height = kNowhere;
  bool joint = false;
  Side next;  // with a joint: the side of the next line there
};

class Laying {
 public:
  Laying(const model::Case& c, const Mesh& mesh, const std::vector<std::vector<Vec3>>& starts)
      : c_(c), bed_(c.environment.seabed), mesh_(mesh), starts_(starts) {
    for (size_t l = 0; l < c.lines.size(); ++l)
      for (const LineEnd end : kLineEnds)
        if (const model::End& e = c.lines[l].end(end); e.kind == model::EndKind::joint)
          joints_[e.carrier].push_back({l, end});
  }

  std::vector<Vec3> line(size_t l) const {
    const std::vector<Vec3>& start = starts_[l];
    if (given(l)) return start;
    const double a = holder({l, LineEnd::A}).height;
    const double b = holder({l, LineEnd::B}).height;
    if (!std::isfinite(a) || !std::isfinite(b)) return beside_free_end(start, std::min(a, b));
    // Between two held ends a line was laid from the lower one, or from both if they are equally high: x =
    // (h_b⁴ x_a + h_a⁴ x_b)/(h_a⁴ + h_b⁴). This is continuous in the heights h, and for a leg with a padeye
    // it is practically the place laid from its anchor.
    const double tiny = 1e-40 * std::pow(mesh_.lines[l].length, 4);
    const double weight = (std::pow(a, 4) + tiny) / (std::pow(a, 4) + std::pow(b, 4) + 2 * tiny);
    std::vector<Vec3> out = places({l, LineEnd::A});
    const std::vector<Vec3> other = places({l, LineEnd::B});
    for (size_t i = 0; i < out.size(); ++i) out[i] += weight * (other[i] - out[i]);
    return out;
  }

 private:
  const model::End& end(const Side& s) const { return c_.lines[s.line].end(s.end); }
  const Vec3& start_of(const Side& s) const {
    return s.end == LineEnd::B ? starts_[s.line].back() : starts_[s.line].front();
  }

  // A line with a free end is assumed to have been laid in its start shape if its other end is near the bed.
  // If it hangs down onto the bed, the place where it was laid is unknown (NaN).
  std::vector<Vec3> beside_free_end(const std::vector<Vec3>& start, double height) const {
    constexpr double kNear = 0.1;  // of the length of the start shape
    double length = 0;
    for (size_t i = 1; i < start.size(); ++i) length += (start[i] - start[i - 1]).norm();
    if (height < kNear * length) return start;
    return std::vector<Vec3>(start.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  }

  // True if the case prescribes the start shape and the line lies on the bed from end to end in it.
  bool given(size_t l) const {
    const model::Line& line = c_.lines[l];
    if (line.start != model::Start::straight && line.start != model::Start::points &&
        line.start != model::Start::other_run)
      return false;
    const double largest_height = model::laying_reach(c_, line) + 0.5 * model::contact_diameter_of(c_, line);
    return std::all_of(starts_[l].begin(), starts_[l].end(),
                       [&](const Vec3& x) { return model::height_above_bed(bed_, x) < largest_height; });
  }

  // A frame of many lines has too many paths through its joints to follow them all, so the shortest are
  // followed first (Dijkstra 1959).
  Holder holder(const Side& s) const {
    if (end(s).kind == model::EndKind::free) return {};
    if (end(s).kind != model::EndKind::joint) return {height_of(s), false, {}};
    struct Path {
      Side first;  // side of the line at the joint of s with which the path begins
      Side to;     // end that the path has reached
    };
    std::multimap<double, Path> open;  // by path length
    std::set<std::string> reached;
    const auto go_on = [&](const std::string& joint, double length, const Side* first) {
      if (!reached.insert(joint).second) return;
      for (const Side& side : joints_.at(joint)) {
        const Side far{side.line, opposite(side.end)};
        if (side.line == s.line || end(far).kind == model::EndKind::free) continue;
        const double height = end(far).kind == model::EndKind::joint ? 0 : height_of(far);
        open.insert({length + kAway * mesh_.lines[side.line].length + height, {first ? *first : side, far}});
      }
    };
    go_on(end(s).carrier, 0, nullptr);
    while (!open.empty()) {
      const auto [length, path] = *open.begin();
      open.erase(open.begin());
      if (end(path.to).kind != model::EndKind::joint) return {length, true, path.first};
      go_on(end(path.to).carrier, length, &path.first);
    }
    return {};
  }

  // Height of a held end above the bed [m].
  double height_of(const Side& s) const { return std::max(0.0, model::height_above_bed(bed_, start_of(s))); }

  // Normal of the bed at its point nearest to x.
  Vec3 nearest_normal(const Vec3& x) const {
    if (!bed_.surface) return model::bed_normal(bed_);
    const auto nearest = bed_.surface->query(x, kNowhere);
    return nearest ? nearest->normal : Vec3::Zero();
  }

  // Unit vector along the bed in the direction of a chord; zero if the chord is vertical.
  Vec3 along_bed(const Vec3& from, const Vec3& to) const {
    constexpr double kUpright = 1e-3;
    Vec3 direction(to.x() - from.x(), to.y() - from.y(), 0);
    if (!(direction.norm() > kUpright * (to - from).norm())) return Vec3::Zero();
    const Vec3 n = nearest_normal(from);
    if (n.z() > kUpright) direction.z() = -n.dot(direction) / n.z();
    return direction.normalized();
  }

  // The place on the bed from which a line of this radius is laid if its end is at x, and how far the line
  // hangs down to this place [m]. An end above the bed hangs straight down; one below it is moved to the bed
  // by the shortest way. Beyond the edge of a mesh there is no bed.
  struct Foot {
    Vec3 at = Vec3::Zero();
    double drop = 0;
  };
  Foot foot(const Vec3& x, double radius) const {
    const double height = model::height_above_bed(bed_, x);
    if (!std::isfinite(height)) return {x, 0};
    if (height <= radius) return {x - height * nearest_normal(x), 0};
    const Vec3 below = model::below_on_bed(bed_, x);
    const Vec3 n = nearest_normal(below);
    if (!(n.z() > 0)) return {below, 0};
    const Vec3 axis = below + radius / n.z() * Vec3::UnitZ();
    return {axis - radius * n, std::max(0.0, x.z() - axis.z())};
  }

  // Slopes of a line that was laid from a held end: along the bed, which is lowered or raised to the end, and
  // from an end above the bed down to it. Each has a constant slope over a length from the end.
  struct Descent {
    double sine[2] = {0, 0};    // of the angle to the bed
    double length[2] = {0, 0};  // m
    // Distance along the bed that a piece of line covers if it begins at `from_end` from the end [m].
    double reach(double from_end, double piece) const {
      double out = piece;
      for (int i = 0; i < 2; ++i) {
        const double sloping = std::clamp(length[i] - from_end, 0.0, piece);
        out -= sloping * (1 - std::sqrt(std::max(0.0, 1 - sine[i] * sine[i])));
      }
      return std::max(0.0, out);
    }
  };
  Descent descent(const Side& s, double element) const {
    const model::Line& line = c_.lines[s.line];
    Descent out;
    if (!model::is_held(end(s))) return out;
    const model::LineType& type = c_.line_type(line.end_section(s.end).type);
    const model::BedAtEnd bed = model::bed_at_end(c_, line, s.end, element);
    out.length[0] = bed.length;
    if (bed.length > 0) out.sine[0] = bed.depth / bed.length;
    const double height = foot(start_of(s), 0.5 * type.contact_diameter).drop;
    if (height <= 0) return out;
    // A cable without tension hangs straight down. A beam of the weight w whose end is lifted by h from the
    // bed is lifted over the length (72 EI h/w)^(1/4).
    out.length[1] = height;
    const double weight = model::submerged_weight(c_, type);
    if (weight > 0)
      out.length[1] =
          std::max(height, std::pow(72 * type.smallest_bending_stiffness() * height / weight, 0.25));
    out.sine[1] = height / out.length[1];
    return out;
  }

  // Laid places of all nodes of a line, laid from this side on, in the order of the line.
  std::vector<Vec3> places(const Side& s) const {
    const LineSpan& span = mesh_.lines[s.line];
    const model::Line& line = c_.lines[s.line];
    const std::vector<Vec3>& start = starts_[s.line];
    const int last = span.nodes - 1;
    const auto node = [&](int i) { return s.end == LineEnd::B ? last - i : i; };
    const auto element = [&](int i) {
      return mesh_.element(span.first_element + (s.end == LineEnd::B ? span.elements - 1 - i : i));
    };
    const auto in_soil = [&](const Element& e) {
      const double from = mesh_.node(e.first).arc;
      return buried_length(line, from, from + e.length) > 0;
    };
    const Descent down = descent(s, element(0).length);
    // The start position of a joint is only an estimate, so a line at a joint is assumed to have been laid
    // straight.
    const bool straight = line.starts_by_itself() && (line.end_a.kind == model::EndKind::joint ||
                                                      line.end_b.kind == model::EndKind::joint);
    Vec3 direction = along_bed(start[node(0)], start[node(last)]);
    if (!straight) direction.setZero();
    for (int i = 0; direction.isZero() && i < last; ++i)
      direction = along_bed(start[node(i)], start[node(i + 1)]);
    std::vector<Vec3> out(start.size());
    Vec3 x = start_of(s);
    const std::string& type = line.end_section(s.end).type;
    if (!in_soil(element(0))) x = foot(x, 0.5 * c_.line_type(type).contact_diameter).at;
    if (const Holder h = holder(s); h.joint) {
      const std::vector<Vec3> before = places({h.next.line, opposite(h.next.end)});
      x = h.next.end == LineEnd::B ? before.back() : before.front();
    }
    out[node(0)] = x;
    double laid = 0;
    for (int i = 0; i < last; ++i) {
      const Element& e = element(i);
      const double natural = (1 + e.free_strain) * e.length;
      const Vec3& from = start[node(i)];
      const Vec3& to = start[node(i + 1)];
      if (in_soil(e)) {
        const double chord = (to - from).norm();
        if (chord > 0) x += natural / chord * (to - from);
      } else {
        if (const Vec3 along = along_bed(from, to); !straight && !along.isZero()) direction = along;
        x += natural / e.length * down.reach(laid, e.length) * direction;
      }
      laid += e.length;
      out[node(i + 1)] = x;
    }
    return out;
  }

  const model::Case& c_;
  const model::Seabed& bed_;
  const Mesh& mesh_;
  const std::vector<std::vector<Vec3>>& starts_;
  std::map<std::string, std::vector<Side>> joints_;
};

}  // namespace

std::vector<std::vector<Vec3>> laid_places(const model::Case& c, const Mesh& mesh,
                                           const std::vector<std::vector<Vec3>>& starts) {
  const Laying laying(c, mesh, starts);
  std::vector<std::vector<Vec3>> out;
  for (size_t l = 0; l < c.lines.size(); ++l)
    out.push_back(starts[l].empty() ? std::vector<Vec3>() : laying.line(l));
  return out;
}

}  // namespace hawser
