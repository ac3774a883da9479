// The class BedContact: its construction from the case.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/model/bed.hpp"
#include "hawser/model/bed_touch.hpp"
#include "hawser/terms/bed_contact.hpp"
#include "hawser/terms/contact_laws.hpp"
#include "hawser/terms/soil_resistance.hpp"

namespace hawser {

BedContact::BedContact(const LocalMesh& mesh, const Plane& plane, PointLaws laws)
    : BedContact(mesh, std::shared_ptr<const Surface>(), std::move(laws)) {
  plane_ = plane;
}

BedContact::BedContact(const LocalMesh& mesh, std::shared_ptr<const Surface> surface, PointLaws laws)
    : mesh_(mesh), surface_(std::move(surface)), line_(mesh) {
  if (surface_) bounds_ = surface_->bounds();
  longest_element_.assign(mesh.nodes(), 0);
  for (const LocalElement& e : mesh.elements)
    for (const int n : {e.first, e.second}) {
      double& longest = longest_element_[n];
      longest = std::max(longest, mesh.element(e).length);
    }
  const size_t owned = mesh.owned;
  const size_t elements = mesh.elements.size();
  if (laws.nodes.size() != owned) throw std::invalid_argument("the seabed needs a law for each owned node");
  if (!laws.middles.empty() && laws.middles.size() != elements)
    throw std::invalid_argument("the seabed needs a law for each element, or none");
  const auto add = [this](const PointLaw& law) -> Point* {
    if (!(law.law.normal.stiffness > 0)) return nullptr;
    // Successive points of a line mostly have the same law, which is stored once.
    if (laws_.empty() || laws_.back() != law) laws_.push_back(law);
    Point& p = points_.emplace_back();
    p.law = static_cast<int>(laws_.size()) - 1;
    suction_ |= law.suction.limit > 0;
    return &p;
  };
  points_.reserve(owned + laws.middles.size());
  for (size_t n = 0; n < owned; ++n)
    if (Point* p = add(laws.nodes[n])) p->node = static_cast<int>(n);
  for (size_t i = 0; i < laws.middles.size(); ++i)
    if (Point* p = add(laws.middles[i])) {
      const LocalElement& e = mesh.elements[i];
      p->node = e.first;
      p->second = e.second;
      p->element = static_cast<int>(i);
      p->counted = e.counted;
    }
  starts_.resize(points_.size());
  if (surface_) cache_.resize(points_.size());
}

namespace {

BedContact::Plane plane_of(const model::Seabed& s) { return {Vec3(0, 0, -s.depth), model::bed_normal(s)}; }

// Share of the line that belongs to a point.
struct Tributary {
  double radius = 0, length = 0, area = 0, weight = 0;  // m, m, m², N under water
  double axial_stiffness = 0;                           // N/m
  double lowered = 0;                                   // m, lowering of the bed at the point

  void add(const model::LineType& t, double part, double w, double element) {
    radius = std::max(radius, 0.5 * t.contact_diameter);
    length += part;
    area += part * t.contact_diameter;
    weight += part * w;
    axial_stiffness = std::max(axial_stiffness, t.EA / element);
  }
};

BedContact::PointLaw law_of(const Tributary& s, const model::Seabed& bed) {
  BedContact::PointLaw o;
  if (!(s.length > 0)) return o;
  o.radius = s.radius - s.lowered;
  o.length = s.length;
  o.weight = s.weight;
  o.axial_stiffness = s.axial_stiffness;
  const double extent = bed.basis == model::StiffnessBasis::per_length ? s.length : s.area;
  const double k = bed.normal_stiffness * extent;
  NormalLaw& normal = o.law.normal;
  normal.stiffness = k;
  normal.damping = bed.damping * extent;
  o.suction = {bed.suction * extent, bed.suction_length};
  normal.table = bed.force_table.get();
  normal.table_factor = extent;
  normal.smoothing = model::bed_smoothing(bed, s.radius, s.weight, k);
  o.law.friction = friction_law(bed.friction, extent, 2 * s.radius);
  return o;
}

// True if a node is in the soil. A node where the line leaves the soil is not.
bool in_soil(const Mesh& mesh, const model::Case& c, int node) {
  const Node& n = mesh.node(node);
  if (n.body >= 0) return false;
  const double length = mesh.lines[n.line].length;
  const double near = 1e-9 * length;
  const auto& stretches = c.lines[n.line].buried;
  return std::any_of(stretches.begin(), stretches.end(), [&](const model::Buried& b) {
    return (b.from <= near || n.arc > b.from + near) && (b.to >= length - near || n.arc < b.to - near);
  });
}

// The bed beside both held ends of a line, where it may be lowered to them.
class BedAtEnds {
 public:
  BedAtEnds(const model::Case& c, const Mesh& mesh, size_t l) : length_(mesh.lines[l].length) {
    const LineSpan& span = mesh.lines[l];
    const Element& first = mesh.element(span.first_element);
    const Element& last = mesh.element(span.first_element + span.elements - 1);
    a_ = model::bed_at_end(c, c.lines[l], LineEnd::A, first.length);
    b_ = model::bed_at_end(c, c.lines[l], LineEnd::B, last.length);
  }
  double lowering(double arc) const {
    const double a = a_.lowering(arc);
    const double b = b_.lowering(length_ - arc);
    return std::abs(a) > std::abs(b) ? a : b;
  }

 private:
  double length_;
  model::BedAtEnd a_, b_;
};

// Beams have their share of the bed at nodes. Cables have it by Simpson's rule at nodes and middles, because
// without bending stiffness they do not bridge the distance between a node in contact and the next one
// (docs/theory/seabed.md). In a partly buried element, the node outside has the bare part of its half.
BedContact::PointLaws laws_of(const LocalMesh& mesh, const model::Case& c, const std::vector<int>& held) {
  std::vector<Tributary> nodes(static_cast<size_t>(mesh.owned));
  std::vector<Tributary> middles(mesh.elements.size());
  std::vector<BedAtEnds> ends;
  for (size_t l = 0; l < c.lines.size(); ++l) ends.emplace_back(c, *mesh.mesh, l);
  for (size_t i = 0; i < mesh.elements.size(); ++i) {
    const LocalElement& e = mesh.elements[i];
    const Element& g = mesh.element(e);
    const model::LineType& t = c.line_types[g.type];
    const double w = model::submerged_weight(c, t);
    const model::Line& line = c.lines[g.line];
    const double from = mesh.mesh->node(g.first).arc;
    const double half = 0.5 * g.length;
    const auto bare = [&](double a, double l) { return l - buried_length(line, a, a + l); };
    const bool cut = in_soil(*mesh.mesh, c, g.first) || in_soil(*mesh.mesh, c, g.second);
    for (const int node : {e.first, e.second}) {
      if (node >= mesh.owned || in_soil(*mesh.mesh, c, mesh.global[node])) continue;
      const double start = from + (node == e.first ? 0 : half);
      const double part = bare(start, half);
      if (!(part > 0)) continue;
      nodes[node].add(t, g.beam || cut ? part : part / 3, w, g.length);
      nodes[node].lowered = ends[g.line].lowering(from + (node == e.first ? 0 : g.length));
    }
    if (g.beam || cut) continue;
    middles[i].add(t, g.length / 1.5, w, g.length);
    middles[i].lowered = ends[g.line].lowering(from + half);
  }
  for (const int node : held)
    if (node < mesh.owned) nodes[node] = {};
  BedContact::PointLaws laws;
  for (const Tributary& s : nodes) laws.nodes.push_back(law_of(s, c.environment.seabed));
  for (const Tributary& s : middles) laws.middles.push_back(law_of(s, c.environment.seabed));
  return laws;
}

}  // namespace

BedContact::BedContact(const LocalMesh& mesh, const model::Case& c, const std::vector<int>& held)
    : BedContact(mesh, plane_of(c.environment.seabed), laws_of(mesh, c, held)) {
  surface_ = c.environment.seabed.surface;
  table_ = c.environment.seabed.force_table;
  if (surface_) {
    bounds_ = surface_->bounds();
    cache_.resize(points_.size());
  }
}

}  // namespace hawser
