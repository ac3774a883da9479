// Start shape of a line by minimisation of its energy: pieces, loads, bed and water from the case, the drag
// of a current, which depends on the shape, and the removal of folds.
#include "start_flexible.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/kernels/flexible_shape.hpp"
#include "hawser/kernels/line_water.hpp"
#include "hawser/model/bed.hpp"
#include "hawser/terms/lines_in_water.hpp"

namespace hawser {
namespace {

constexpr int kMaxPieces = 300;   // sufficient for a start shape, however fine the mesh is
constexpr double kStreams = 0.1;  // ratio of drag to weight above which a catenary is not used
constexpr int kDragRounds = 8;
constexpr double kSettled = 5e-3;  // of the length: change of the shape below which it is accepted
// cosine of the angle between neighbouring pieces below which the line is folded
constexpr double kFold = 0.2;
constexpr double kPressed = 0.05;  // compressive strain by which a fold is laid straight
constexpr double kPull = 0.01;     // of the weight: load that straightens a slack line

// Elements [first, last) of the mesh as one piece, with its length without tension.
FlexibleLine::Segment piece(const model::Case& c, const model::Line& line, const Mesh& mesh, int first,
                            int last) {
  FlexibleLine::Segment p;
  double compliance = 0;
  for (int e = first; e < last; ++e) {
    const Element& g = mesh.element(e);
    const auto& t = c.line_types[g.type];
    p.length += (1 + g.free_strain) * g.length;
    p.load.z() -= g.length * t.mass_per_length * c.environment.gravity;
    p.buoyancy += g.length * buoyancy(c, t);
    p.radius = std::max(p.radius, 0.5 * t.contact_diameter);
    compliance += g.length / t.EA;
    const double from = mesh.node(g.first).arc;
    for (const auto& l : line.loads) {
      if (l.ramp > 0) continue;  // the load is zero at t = 0
      const double end = l.to < 0 ? HUGE_VAL : l.to;
      const double overlap = std::min(from + g.length, end) - std::max(from, l.from);
      if (overlap > 0) p.load += overlap * l.per_length;
    }
  }
  p.load /= p.length;
  p.buoyancy /= p.length;
  p.EA = p.length / compliance;
  return p;
}

// Computes drag and shape in turns, each with the other held. Drag is under-relaxed by a half.
std::vector<Vec3> in_current(const model::Water& water, const CurrentProfile& current, FlexibleLine line,
                             const std::vector<WaterSection>& sections,
                             const std::vector<Vec3>& without_current) {
  std::vector<Vec3> x = without_current;
  std::vector<Vec3> pull(sections.size(), Vec3::Zero());
  std::vector<Vec3> dead;
  double length = 0;
  for (const auto& p : line.pieces) {
    dead.push_back(p.load);
    length += p.length;
  }
  for (int round = 0; round < kDragRounds; ++round) {
    for (size_t i = 0; i < sections.size(); ++i) {
      const double depth = water.surface - 0.5 * (x[i].z() + x[i + 1].z());
      Vec3 u, by_depth;
      current.at(depth, u, by_depth);
      const Vec3 t = (x[i + 1] - x[i]).normalized();
      const Vec3 now = depth > 0 ? line_drag(sections[i], u, t) : Vec3(0, 0, 0);
      pull[i] = round > 0 ? Vec3(0.5 * (pull[i] + now)) : now;
      line.pieces[i].load = dead[i] + pull[i];
    }
    const std::vector<Vec3> next = flexible_shape(line, x);
    double change = 0;
    for (size_t i = 0; i < x.size(); ++i) change = std::max(change, (next[i] - x[i]).norm());
    x = next;
    if (change < kSettled * length) break;
  }
  // A line that is pushed together on the bed: statics starts better from the shape in still water than from
  // a fold.
  return folded(x) ? without_current : x;
}

}  // namespace

double buoyancy(const model::Case& c, const model::LineType& t) {
  const model::Water& w = c.environment.water;
  return w.present ? w.density * c.environment.gravity * M_PI / 4 * t.displaced() * t.displaced() : 0;
}

CurrentProfile acting_current(const model::Case& c) {
  const model::Water& w = c.environment.water;
  if (!w.present || w.current.ramp > 0) return {};
  const double factor = w.current.time_factor.at(0);
  return factor == 0 ? CurrentProfile() : current_profile(w, factor);
}

namespace {

bool folded_at(const std::vector<Vec3>& x, size_t i) {
  return (x[i + 1] - x[i]).normalized().dot((x[i] - x[i - 1]).normalized()) < kFold;
}

// Between two elements of a folded beam there is a rotation of half a turn, where the tangent gives no
// descent direction. The line around a fold is laid straight over a length that takes the excess with the
// small strain kPressed; statics relaxes this strain into the rest of the line.
void unfold(const Mesh& mesh, const LineSpan& span, std::vector<Vec3>& x) {
  const size_t last = x.size() - 1;
  std::vector<double> arc;
  for (int n = 0; n < span.nodes; ++n) arc.push_back(mesh.node(span.first_node + n).arc);
  for (size_t i = 1; i < last; ++i) {
    if (!folded_at(x, i)) continue;
    size_t a = i;
    size_t b = i;
    do {
      a -= a > 0;
      b += b < last;
    } while ((x[b] - x[a]).norm() < (1 - kPressed) * (arc[b] - arc[a]) && (a > 0 || b < last));
    const Vec3 from = x[a];
    const Vec3 chord = x[b] - x[a];
    for (size_t k = a + 1; k < b; ++k) x[k] = from + (arc[k] - arc[a]) / (arc[b] - arc[a]) * chord;
    i = b;
  }
}

}  // namespace

bool folded(const std::vector<Vec3>& x) {
  for (size_t i = 1; i + 1 < x.size(); ++i)
    if (folded_at(x, i)) return true;
  return false;
}

bool streams(const model::Case& c, const model::Line& line) {
  const CurrentProfile current = acting_current(c);
  if (current.none()) return false;
  const model::Water& w = c.environment.water;
  double speed = 0;
  for (const model::CurrentRow& r : w.current.profile) speed = std::max(speed, r.speed);
  speed *= w.current.time_factor.at(0);
  double pull = 0, weight = 0;
  for (const auto& s : line.sections) {
    const auto& t = c.line_type(s.type);
    pull += s.length * 0.5 * w.density * t.Cd_normal * t.dragged() * speed * speed;
    weight += s.length * std::abs(buoyancy(c, t) - t.mass_per_length * c.environment.gravity);
  }
  return pull > kStreams * weight;
}

bool crosses_bed_or_surface(const model::Case& c, const model::Line& line, const std::vector<Vec3>& x) {
  const model::Seabed& bed = c.environment.seabed;
  const model::Water& water = c.environment.water;
  double thick = 0;
  for (const auto& s : line.sections) thick = std::max(thick, c.line_type(s.type).outer_diameter);
  const auto through = [&](const Vec3& p) {
    return (bed.present && model::height_above_bed(bed, p) < -thick) ||
           (water.present && p.z() > water.surface + thick);
  };
  // End nodes are excluded because they are held.
  return x.size() > 2 && std::any_of(x.begin() + 1, x.end() - 1, through);
}

namespace {

// The line in pieces of elements, and what belongs to its points or pieces.
struct LineInPieces {
  FlexibleLine line;
  std::vector<double> arc{0};       // m, of the points
  std::vector<Vec3> places;         // m, of the points before
  std::vector<WaterSection> drags;  // of the pieces
};

// Ends, bed and water. With a measured bed the shape is lifted onto it afterwards. A grounded line needs a
// plane at about the correct height here, along which it can be laid.
FlexibleLine without_pieces(const model::Case& c, const model::Line& line, const std::vector<Vec3>& x,
                            const Vec3& direction) {
  const model::Seabed& bed = c.environment.seabed;
  FlexibleLine f;
  f.held_a = line.end_a.kind != model::EndKind::free;
  f.held_b = line.end_b.kind != model::EndKind::free;
  const Vec3& held = f.held_a ? x.front() : x.back();
  const double height = bed.present && bed.surface ? model::height_above_bed(bed, held) : 0;
  f.bed = bed.present && (!bed.surface || (!direction.isZero(0) && std::isfinite(height)));
  f.bed_point = Vec3(0, 0, bed.surface ? held.z() - height : -bed.depth);
  f.bed_normal = model::bed_normal(bed);
  f.water = c.environment.water.present;
  f.surface = c.environment.water.surface;
  return f;
}

int elements_of_piece(const LineSpan& span) { return (span.elements + kMaxPieces - 1) / kMaxPieces; }

LineInPieces in_pieces(const model::Case& c, const model::Line& line, const Mesh& mesh, const LineSpan& span,
                       const std::vector<Vec3>& x, const Vec3& direction) {
  const model::Seabed& bed = c.environment.seabed;
  LineInPieces out;
  FlexibleLine& f = out.line;
  f = without_pieces(c, line, x, direction);
  out.places = {x.front()};
  const int stride = elements_of_piece(span);
  double thick = 0;
  for (int e = 0; e < span.elements; e += stride) {
    const int last = std::min(e + stride, span.elements);
    f.pieces.push_back(piece(c, line, mesh, span.first_element + e, span.first_element + last));
    thick = std::max(thick, 2 * f.pieces.back().radius);
    const auto& t = c.line_types[mesh.element(span.first_element + e).type];
    std::vector<double>& s = out.arc;
    s.push_back(mesh.node(span.first_node + last).arc);
    // Per length of the piece, like its weight.
    const double per = 0.5 * c.environment.water.density * t.dragged() * (s.back() - s[s.size() - 2]) /
                       f.pieces.back().length;
    WaterSection& drag = out.drags.emplace_back();
    drag.drag_normal = per * t.Cd_normal;
    drag.drag_axial = per * t.Cd_axial * M_PI;
    out.places.push_back(x[last]);
  }
  f.bed_stiffness =
      bed.basis == model::StiffnessBasis::per_length ? bed.normal_stiffness : bed.normal_stiffness * thick;
  f.points.resize(out.arc.size());
  return out;
}

// Adds masses and point loads at the nearest points.
void add_point_loads(const model::Case& c, const model::Line& line, LineInPieces& to) {
  const model::Water& water = c.environment.water;
  const std::vector<double>& s = to.arc;
  const auto nearest = [&](double at) -> FlexibleLine::Point& {
    const auto next = std::lower_bound(s.begin(), s.end() - 1, at);
    const bool back = next != s.begin() && at - *(next - 1) < *next - at;
    return to.line.points[next - s.begin() - (back ? 1 : 0)];
  };
  for (const auto& m : line.masses) {
    FlexibleLine::Point& p = nearest(m.at);
    p.load.z() -= m.mass * c.environment.gravity;
    if (water.present) p.buoyancy += water.density * m.volume * c.environment.gravity;
  }
  for (const auto& p : line.point_loads)
    if (p.ramp == 0) nearest(p.at).load += p.force;
}

}  // namespace

std::vector<Vec3> flexible_start(const model::Case& c, const model::Line& line, const Mesh& mesh,
                                 const LineSpan& span, const std::vector<Vec3>& x, const Vec3& direction) {
  LineInPieces parts = in_pieces(c, line, mesh, span, x, direction);
  add_point_loads(c, line, parts);
  const FlexibleLine& f = parts.line;
  FlexibleLine pulled = f;
  double weight = 0;
  for (const auto& p : f.pieces) weight += p.length * std::abs(p.load.z() + p.buoyancy);
  for (auto& p : pulled.pieces) p.load += kPull * weight / span.length * direction;
  std::vector<Vec3> shape = flexible_shape(pulled, std::move(parts.places));
  if (const CurrentProfile current = acting_current(c); !current.none())
    shape = in_current(c.environment.water, current, f, parts.drags, shape);
  std::vector<Vec3> out;
  for (int n = 0; n < span.nodes; ++n)
    out.push_back(elements_of_piece(span) == 1
                      ? shape[n]
                      : interpolated(parts.arc, shape, mesh.node(span.first_node + n).arc));
  out.front() = x.front();
  out.back() = f.held_b ? x.back() : out.back();
  if (!f.held_a) out.front() = shape.front();
  if (f.held_a && f.held_b && mesh.node(span.first_node).rotates) unfold(mesh, span, out);
  return out;
}

}  // namespace hawser
