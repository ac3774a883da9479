// What SeabedTerm is made from, what it shows and keeps.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "hawser/model/case.hpp"
#include "hawser/terms/buried.hpp"
#include "hawser/terms/seabed.hpp"

namespace hawser {

SeabedTerm::SeabedTerm(const LocalMesh& mesh, const Plane& plane, std::vector<NodeLaw> nodes)
    : SeabedTerm(mesh, std::shared_ptr<const Surface>(), std::move(nodes)) {
  plane_ = plane;
  for (Point& p : points_) p.history.normal = p.start.normal = plane.normal;
}

SeabedTerm::SeabedTerm(const LocalMesh& mesh, std::shared_ptr<const Surface> surface,
                       std::vector<NodeLaw> nodes)
    : mesh_(mesh), surface_(std::move(surface)), buried_(mesh.mesh->nodes.size(), false), line_(mesh) {
  if (surface_) bounds_ = surface_->bounds();
  element_.assign(static_cast<size_t>(mesh.nodes()), 0);
  for (const LocalElement& e : mesh.elements)
    for (const int n : {e.first, e.second}) {
      double& longest = element_[static_cast<size_t>(n)];
      longest = std::max(longest, mesh.mesh->elements[static_cast<size_t>(e.global)].length);
    }
  const size_t owned = static_cast<size_t>(mesh.owned);
  if (nodes.size() != owned) throw std::invalid_argument("the seabed needs a law for each owned node");
  for (size_t n = 0; n < owned; ++n) {
    if (nodes[n].radius < 0 || !(nodes[n].law.normal.stiffness > 0)) continue;
    Point& p = points_.emplace_back();
    p.node = static_cast<int>(n), p.block = mesh.block[n];
    p.radius = nodes[n].radius, p.law = nodes[n].law, p.suction = nodes[n].suction;
    has_friction_ |= p.law.friction.active();
  }
}

namespace {

SeabedTerm::Plane plane_of(const model::Seabed& s) {
  const double down = std::tan(s.slope);
  return {Vec3(0, 0, -s.depth),
          Vec3(down * std::cos(s.direction), down * std::sin(s.direction), 1).normalized()};
}

// Of all the elements at an owned node.
struct Share {
  double radius = -1, length = 0, area = 0, weight = 0;  // m, m, m², N under water
};

// Whether a node is in the soil, and not where the line comes out of it.
bool in_soil(const Mesh& mesh, const model::Case& c, int node) {
  const Node& n = mesh.nodes[static_cast<size_t>(node)];
  if (n.body >= 0) return false;
  const double length = mesh.lines[static_cast<size_t>(n.line)].length, near = 1e-9 * length;
  const auto& stretches = c.lines[static_cast<size_t>(n.line)].buried;
  return std::any_of(stretches.begin(), stretches.end(), [&](const model::Buried& b) {
    return (b.from <= near || n.arc > b.from + near) && (b.to >= length - near || n.arc < b.to - near);
  });
}

std::vector<SeabedTerm::NodeLaw> laws_of(const LocalMesh& mesh, const model::Case& c,
                                         const std::vector<int>& held) {
  const model::Seabed& bed = c.environment.seabed;
  const model::Water& water = c.environment.water;
  std::vector<Share> shares(static_cast<size_t>(mesh.owned));
  for (const LocalElement& e : mesh.elements) {
    const Element& g = mesh.mesh->elements[static_cast<size_t>(e.global)];
    const model::LineType& t = c.line_types[static_cast<size_t>(g.type)];
    const double A = M_PI / 4 * t.displaced() * t.displaced();
    const double w = c.environment.gravity * (t.mass_per_length - (water.present ? water.density * A : 0));
    const model::Line& line = c.lines[static_cast<size_t>(g.line)];
    for (const int node : {e.first, e.second}) {
      if (node >= mesh.owned) continue;
      // Of its half of the element, what the soil does not hold.
      const double from = mesh.mesh->nodes[static_cast<size_t>(g.first)].arc, half = 0.5 * g.length,
                   start = from + (node == e.first ? 0 : half);
      const double bare = half - buried_length(line, start, start + half);
      if (!(bare > 0) || in_soil(*mesh.mesh, c, mesh.global[static_cast<size_t>(node)])) continue;
      Share& s = shares[static_cast<size_t>(node)];
      s.radius = std::max(s.radius, 0.5 * t.contact_diameter);
      s.length += bare, s.area += bare * t.contact_diameter;
      s.weight += bare * w;
    }
  }
  for (const int node : held)
    if (node < mesh.owned) shares[static_cast<size_t>(node)].radius = -1;
  std::vector<SeabedTerm::NodeLaw> laws;
  for (const Share& s : shares) {
    SeabedTerm::NodeLaw& o = laws.emplace_back();
    o.radius = s.radius;
    if (s.radius < 0) continue;
    const double share = bed.basis == model::StiffnessBasis::per_length ? s.length : s.area;
    const double k = bed.normal_stiffness * share;
    NormalLaw& normal = o.law.normal;
    normal.stiffness = k;
    normal.damping = bed.damping * share;
    o.suction = {bed.suction * share, bed.suction_length};
    normal.table = bed.force_table.get(), normal.table_factor = share;
    // A fifth of what the line at rest sinks in: what rests lies beyond the ramp, what touches down is soft.
    if (!normal.table)
      normal.smoothing =
          bed.smoothing >= 0 ? bed.smoothing : std::max(0.002 * s.radius, 0.2 * std::max(s.weight, 0.0) / k);
    const model::Friction& f = bed.friction;
    FrictionLaw& friction = o.law.friction;
    friction.axial = f.axial, friction.lateral = f.lateral;
    friction.stiffness = f.shear_stiffness * share;
    friction.axial_length = f.mobilisation_length > 0 ? f.mobilisation_length : 0.02 * s.radius;
    friction.lateral_length =
        f.lateral_mobilisation_length > 0 ? f.lateral_mobilisation_length : friction.axial_length;
    friction.back = f.back, friction.spring = f.spring;
    friction.axial_kinetic = f.axial_kinetic, friction.lateral_kinetic = f.lateral_kinetic;
    friction.blend_speed = f.blend_speed;
  }
  return laws;
}

}  // namespace

SeabedTerm::SeabedTerm(const LocalMesh& mesh, const model::Case& c, const std::vector<int>& held)
    : SeabedTerm(mesh, plane_of(c.environment.seabed), laws_of(mesh, c, held)) {
  surface_ = c.environment.seabed.surface, table_ = c.environment.seabed.force_table;
  if (surface_) bounds_ = surface_->bounds();
  for (size_t n = 0; n < buried_.size(); ++n) buried_[n] = in_soil(*mesh.mesh, c, static_cast<int>(n));
}

void SeabedTerm::fields(FieldRegistry& registry) const {
  const auto vector = [this](auto value) {
    return [this, value](const Kinematics&, std::span<double> out) {
      std::fill(out.begin(), out.end(), 0.0);
      for (const Point& p : points_)
        for (int c = 0; c < 3; ++c) out[static_cast<size_t>(3 * p.node + c)] = value(p.history)[c];
    };
  };
  registry.add({"seabed_force", "N", 3, vector([](const History& h) { return h.force; })});
  registry.add({"seabed_friction", "N", 3, vector([](const History& h) { return h.friction; })});
}

std::vector<HistoryRecord> SeabedTerm::save() const {
  std::vector<HistoryRecord> records;
  for (const Point& p : points_) {
    const History& h = p.history;
    if (!h.touches && h.deepest == 0 && h.friction_work == 0 && h.damping_work == 0) continue;
    HistoryRecord r{mesh_.global[static_cast<size_t>(p.node)], 0, {h.touches ? 1.0 : 0}};
    for (const Vec3* v : {&h.slip, &h.normal, &h.force, &h.friction})
      r.values.insert(r.values.end(), v->begin(), v->end());
    r.values.insert(r.values.end(),
                    {h.normal_force, h.damping_force, h.potential, h.friction_work, h.damping_work});
    if (p.suction.limit > 0) r.values.insert(r.values.end(), {h.deepest, h.held ? 1.0 : 0});
    records.push_back(std::move(r));
  }
  return records;
}

void SeabedTerm::restore(const std::vector<HistoryRecord>& records) {
  std::unordered_map<int, size_t> at;
  for (size_t i = 0; i < points_.size(); ++i)
    points_[i].history = {}, at[mesh_.global[static_cast<size_t>(points_[i].node)]] = i;
  for (const HistoryRecord& r : records) {
    const auto found = at.find(r.node);
    if (found == at.end()) continue;
    const std::vector<double>& v = r.values;
    if (v.size() != 18 && v.size() != 20)
      throw std::invalid_argument("a seabed record of the checkpoint has the wrong size");
    History& h = points_[found->second].history;
    h.touches = v[0] != 0;
    size_t i = 1;
    for (Vec3* part : {&h.slip, &h.normal, &h.force, &h.friction})
      for (int c = 0; c < 3; ++c) (*part)[c] = v[i++];
    h.normal_force = v[13], h.damping_force = v[14], h.potential = v[15];
    h.friction_work = v[16], h.damping_work = v[17];
    if (v.size() == 20) h.deepest = v[18], h.held = v[19] != 0;
  }
}

}  // namespace hawser
