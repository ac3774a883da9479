// Start shape of a line over its supports, as a string: a smooth curve over them, the point where it leaves
// them, and the rest of the line.
#include "start_on_supports.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/advice/start_shape.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/model/check.hpp"

namespace hawser {
namespace {

constexpr double kClear = 0.01;  // of the radius: clearance of the line above its rollers at the start
// of the length: by how much a line may be shorter than its path, which stretches it
constexpr double kStretched = 0.02;
constexpr int kPieces = 24;         // in a cubic between two supports; a catenary has ten times as many
constexpr double kSteepest = 1.55;  // rad, largest angle at which a line leaves its last support at the start

struct GuidePoint {
  Vec3 at, along;  // m; unit
};

double dip(const Vec3& along) { return -std::asin(std::clamp(along.z(), -1.0, 1.0)); }

// A chain of places with the length up to each.
struct Chain {
  std::vector<GuidePoint> places;
  std::vector<double> arc;  // m
  void add(const GuidePoint& p) {
    arc.push_back(places.empty() ? 0 : arc.back() + (p.at - places.back().at).norm());
    places.push_back(p);
  }
  double length() const { return arc.back(); }
};

// Adds the cubic through two places with their directions.
void add_cubic(Chain& chain, const GuidePoint from, const GuidePoint& to) {
  const double d = (to.at - from.at).norm();
  for (int i = 1; i <= kPieces; ++i) {
    const double t = static_cast<double>(i) / kPieces;
    const double u = 1 - t;
    const Vec3 x = u * u * (1 + 2 * t) * from.at + t * t * (3 - 2 * t) * to.at +
                   t * u * d * (u * from.along - t * to.along);
    const Vec3 v =
        6 * t * u * (to.at - from.at) + d * (u * (1 - 3 * t) * from.along + t * (3 * t - 2) * to.along);
    chain.add({x, v.normalized()});
  }
}

// What is beyond a place of the path.
struct Remainder {
  double deep = 0, wide = 0;  // m, vertical and horizontal distance to the other end
  double length = 0;          // m, of line that remains
};

// A catenary that leaves at the angle `down` and is tangent to the bed: its horizontal extent and its length.
struct Sag {
  double scale, wide, length;  // m; scale: horizontal force over weight per length
  Sag(double down, double deep)
      : scale(deep / (1 / std::cos(down) - 1)),
        wide(scale * std::asinh(std::tan(down))),
        length(scale * std::tan(down)) {}
};

// The length [m] that is missing if the line leaves at this angle in a catenary and then lies along the bed
// to the other end. It increases with the angle and with the position along the supports. At small angles the
// catenary does not reach the bed before the other end.
double lacking(double down, const Remainder& r) {
  if (!(down > 1e-4)) return -HUGE_VAL;
  const Sag sag(down, r.deep);
  return sag.wide > r.wide ? -HUGE_VAL : sag.length + r.wide - sag.wide - r.length;
}

class PathOverSupports {
 public:
  PathOverSupports(const model::Case& c, const model::Line& line, const Bodies& bodies, double length)
      : c_(c), line_(line), length_(length) {
    radius_ = 0.5 * model::contact_diameter_of(c, line);
    const model::SupportBox* first = nullptr;
    std::vector<GuidePoint> boxes;
    size_t closed = 0;
    for (const model::SupportBox& b : c.supports) {
      if (b.line != line.name) continue;
      if (!first) first = &b;
      const int body = c.body_index(b.body);
      const RigidPose pose = body < 0 ? RigidPose{} : bodies.pose(body, 0);
      boxes.push_back({pose.to_space(b.at + kClear * radius_ * b.up), pose.rotation * b.along});
      if (b.rollers.back() == "above") closed = boxes.size();
    }
    if (!first) return;
    const model::End* end = model::end_before(c, line, *first);
    if (!end) return;
    from_ = end == &line.end_a ? LineEnd::A : LineEnd::B;
    const RigidPose pose = start_pose(c, bodies, *end);
    GuidePoint from{pose.to_space(end->at), (boxes.front().at - pose.to_space(end->at)).normalized()};
    if (end->direction) from.along = pose.rotation * (from_a() ? *end->direction : Vec3(-*end->direction));
    path_.add(from);
    for (const GuidePoint& b : boxes) {
      add_cubic(path_, path_.places.back(), b);
      last_ = path_.places.size() - 1;
    }
    first_ = std::max<size_t>(1, closed * kPieces);
    const model::End& other = line.end(opposite(from_));
    if (other.kind != model::EndKind::free) to_ = start_pose(c, bodies, other).to_space(other.at);
    known_ = true;
  }

  bool known() const { return known_; }
  // The path from the tensioner on; its length is about that of the line.
  const Chain& find() {
    if (!to_)
      hang();
    else if (!to_bed())
      straight();
    return path_;
  }
  bool from_a() const { return from_ == LineEnd::A; }

 private:
  Remainder remainder(size_t i) const {
    const Vec3& p = path_.places[i].at;
    return {p.z() - to_->z(), std::hypot(to_->x() - p.x(), to_->y() - p.y()), length_ - path_.arc[i]};
  }
  // From place i down to the bed in a catenary, and along the bed. False if the other end is not on the bed.
  bool to_bed() {
    const model::Seabed& bed = c_.environment.seabed;
    if (!bed.present ||
        std::abs(model::height_above_bed(bed, *to_)) > 2 * radius_ + 1e-3 * std::abs(bed.depth))
      return false;
    size_t i = first_;
    while (i < last_ && !(lacking(dip(path_.places[i].along), remainder(i)) >= 0)) ++i;
    const Remainder r = remainder(i);
    double down = dip(path_.places[i].along);
    if (!(r.deep > 0) || i == 1 || lacking(down, r) > kStretched * length_) return false;
    if (!(lacking(down, r) >= 0)) {  // the line is longer than this path needs, so it leaves more steeply
      double low = std::max(down, 1e-3);
      double high = kSteepest;
      for (int k = 0; k < 100; ++k) (lacking(0.5 * (low + high), r) >= 0 ? high : low) = 0.5 * (low + high);
      down = high;
    }
    cut(i);
    const Sag sag(down, r.deep);
    const Vec3 p = path_.places.back().at;
    const Vec3 towards_end = Vec3(to_->x() - p.x(), to_->y() - p.y(), 0).normalized();
    const int pieces = 10 * kPieces;
    for (int k = 1; k <= pieces; ++k) {  // from the bed, where it is horizontal: x = a asinh(s / a)
      const double s = sag.length * (1 - static_cast<double>(k) / pieces);
      const double t = std::asinh(s / sag.scale);
      const Vec3 x = p + (sag.wide - sag.scale * t) * towards_end;
      path_.add({Vec3(x.x(), x.y(), to_->z() + sag.scale * (std::cosh(t) - 1)),
                 (towards_end - std::sinh(t) * Vec3::UnitZ()).normalized()});
    }
    path_.add({*to_, towards_end});
    return true;
  }
  // Straight from where it leaves the supports to the other end.
  void straight() {
    size_t i = first_;
    const auto to_end = [&](size_t k) { return Vec3((*to_ - path_.places[k].at).normalized()); };
    while (i < last_ && dip(path_.places[i].along) < dip(to_end(i))) ++i;
    cut(i);
    const Vec3 towards_end = to_end(i);
    path_.add({path_.places.back().at, towards_end});
    path_.add({*to_, towards_end});
    if (path_.length() > (1 + kStretched) * length_)
      c_.refuse("lines." + line_.name + ".sections", advice::too_short_for_supports(length_, path_.length()));
  }
  // With a free end: straight on from the last support, and along the bed.
  void hang() {
    if (path_.length() >= length_) return;
    const model::Seabed& bed = c_.environment.seabed;
    GuidePoint p = path_.places.back();
    double remaining = length_ - path_.length();
    const double high = bed.present ? model::height_above_bed(bed, p.at) - radius_ : HUGE_VAL;
    if (p.along.z() < 0 && high < -p.along.z() * remaining) {
      const double slope_length = std::max(high, 0.0) / -p.along.z();
      p.at += slope_length * p.along;
      path_.add(p);
      remaining -= slope_length;
      p.along = Vec3(p.along.x(), p.along.y(), 0).normalized();
      path_.add(p);
    }
    path_.add({p.at + remaining * p.along, p.along});
  }
  void cut(size_t last) {
    path_.places.resize(last + 1);
    path_.arc.resize(last + 1);
  }

  const model::Case& c_;
  const model::Line& line_;
  const double length_;
  double radius_ = 0;
  Chain path_;
  // Places from which the line may leave the supports: first_ is at the last box that is closed above, or at
  // the first place if there is none; last_ is at the last box.
  size_t first_ = 1, last_ = 0;
  std::optional<Vec3> to_;
  LineEnd from_ = LineEnd::A;
  bool known_ = false;
};

}  // namespace

std::optional<LineStart> line_over_supports(const model::Case& c, const model::Line& line,
                                            const Bodies& bodies, const Mesh& mesh, const LineSpan& span) {
  PathOverSupports supports(c, line, bodies, span.length);
  if (!supports.known()) return {};
  const Chain& path = supports.find();
  const double used_length =
      line.end_a.kind == model::EndKind::free || line.end_b.kind == model::EndKind::free
          ? std::max(path.length(), span.length)
          : path.length();
  LineStart out;
  for (int n = span.first_node; n < span.first_node + span.nodes; ++n) {
    const double fraction = mesh.node(n).arc / span.length;
    const double s = std::min((supports.from_a() ? fraction : 1 - fraction) * used_length, path.length());
    size_t i = 1;
    while (i + 1 < path.places.size() && s > path.arc[i]) ++i;
    const double d = path.arc[i] - path.arc[i - 1];
    const double t = d > 0 ? (s - path.arc[i - 1]) / d : 1;
    const Vec3 along = ((1 - t) * path.places[i - 1].along + t * path.places[i].along).normalized();
    out.x.push_back((1 - t) * path.places[i - 1].at + t * path.places[i].at);
    out.tangent.push_back(supports.from_a() ? along : Vec3(-along));
  }
  return out;
}

}  // namespace hawser
