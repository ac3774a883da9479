// What SeabedTerm is made from, how lines are laid, what it shows and keeps.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "hawser/model/case.hpp"
#include "hawser/terms/seabed.hpp"

namespace hawser {

SeabedTerm::SeabedTerm(const LocalMesh& mesh, const Plane& plane, PointLaws laws)
    : SeabedTerm(mesh, std::shared_ptr<const Surface>(), std::move(laws)) {
  plane_ = plane;
  for (Point& p : points_) p.history.normal = p.start.normal = plane.normal;
}

SeabedTerm::SeabedTerm(const LocalMesh& mesh, std::shared_ptr<const Surface> surface, PointLaws laws)
    : mesh_(mesh), surface_(std::move(surface)), line_(mesh) {
  if (surface_) bounds_ = surface_->bounds();
  element_.assign(static_cast<size_t>(mesh.nodes()), 0);
  for (const LocalElement& e : mesh.elements)
    for (const int n : {e.first, e.second}) {
      double& longest = element_[static_cast<size_t>(n)];
      longest = std::max(longest, mesh.mesh->elements[static_cast<size_t>(e.global)].length);
    }
  const size_t owned = static_cast<size_t>(mesh.owned), elements = mesh.elements.size();
  if (laws.nodes.size() != owned) throw std::invalid_argument("the seabed needs a law for each owned node");
  if (!laws.middles.empty() && laws.middles.size() != elements)
    throw std::invalid_argument("the seabed needs a law for each element, or none");
  const auto add = [this](const PointLaw& law) -> Point* {
    if (law.radius < 0 || !(law.law.normal.stiffness > 0)) return nullptr;
    Point& p = points_.emplace_back();
    p.radius = law.radius, p.law = law.law, p.suction = law.suction;
    has_friction_ |= p.law.friction.active();
    return &p;
  };
  for (size_t n = 0; n < owned; ++n)
    if (Point* p = add(laws.nodes[n])) p->node = static_cast<int>(n);
  for (size_t i = 0; i < laws.middles.size(); ++i)
    if (Point* p = add(laws.middles[i])) {
      const LocalElement& e = mesh.elements[i];
      p->node = e.first, p->second = e.second, p->element = static_cast<int>(i), p->counted = e.counted;
    }
}

namespace {

SeabedTerm::Plane plane_of(const model::Seabed& s) {
  const double down = std::tan(s.slope);
  return {Vec3(0, 0, -s.depth),
          Vec3(down * std::cos(s.direction), down * std::sin(s.direction), 1).normalized()};
}

// What belongs to a point.
struct Share {
  double radius = -1, length = 0, area = 0, weight = 0;  // m, m, m², N under water

  void add(const model::LineType& t, double part, double w) {
    radius = std::max(radius, 0.5 * t.contact_diameter);
    length += part, area += part * t.contact_diameter, weight += part * w;
  }
};

SeabedTerm::PointLaw law_of(const Share& s, const model::Seabed& bed) {
  SeabedTerm::PointLaw o;
  o.radius = s.radius;
  if (s.radius < 0) return o;
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
  return o;
}

// A beam has its share of the bed at its nodes; a cable by Simpson's rule, for it has nothing to bridge the
// way from one node that touches to the next (docs/theory/seabed.md).
SeabedTerm::PointLaws laws_of(const LocalMesh& mesh, const model::Case& c, const std::vector<int>& held) {
  const model::Water& water = c.environment.water;
  std::vector<Share> nodes(static_cast<size_t>(mesh.owned)), middles(mesh.elements.size());
  for (size_t i = 0; i < mesh.elements.size(); ++i) {
    const LocalElement& e = mesh.elements[i];
    const Element& g = mesh.mesh->elements[static_cast<size_t>(e.global)];
    const model::LineType& t = c.line_types[static_cast<size_t>(g.type)];
    const double A = M_PI / 4 * t.displaced() * t.displaced();
    const double w = c.environment.gravity * (t.mass_per_length - (water.present ? water.density * A : 0));
    for (const int node : {e.first, e.second})
      if (node < mesh.owned) nodes[static_cast<size_t>(node)].add(t, g.length / (g.beam ? 2 : 6), w);
    if (!g.beam) middles[i].add(t, g.length / 1.5, w);
  }
  for (const int node : held)
    if (node < mesh.owned) nodes[static_cast<size_t>(node)].radius = -1;
  SeabedTerm::PointLaws laws;
  for (const Share& s : nodes) laws.nodes.push_back(law_of(s, c.environment.seabed));
  for (const Share& s : middles) laws.middles.push_back(law_of(s, c.environment.seabed));
  return laws;
}

}  // namespace

SeabedTerm::SeabedTerm(const LocalMesh& mesh, const model::Case& c, const std::vector<int>& held)
    : SeabedTerm(mesh, plane_of(c.environment.seabed), laws_of(mesh, c, held)) {
  surface_ = c.environment.seabed.surface, table_ = c.environment.seabed.force_table;
  if (surface_) bounds_ = surface_->bounds();
}

// The whole line's positions on every rank: once in a run, and 24 bytes a node.
void SeabedTerm::lay(MPI_Comm comm, const Kinematics& at, const std::vector<int>& held) {
  const Mesh& mesh = *mesh_.mesh;
  std::vector<double> x(3 * mesh.nodes.size(), 0), reach(mesh.nodes.size(), -1);
  for (int n = 0; n < mesh_.owned; ++n)
    for (int c = 0; c < 3; ++c)
      x[static_cast<size_t>(3 * mesh_.global[static_cast<size_t>(n)] + c)] = at.x[static_cast<size_t>(n)][c];
  for (const Point& p : points_)
    if (p.second < 0)
      reach[static_cast<size_t>(mesh_.global[static_cast<size_t>(p.node)])] =
          p.radius + p.law.normal.smoothing;
  MPI_Allreduce(MPI_IN_PLACE, x.data(), static_cast<int>(x.size()), MPI_DOUBLE, MPI_SUM, comm);
  MPI_Allreduce(MPI_IN_PLACE, reach.data(), static_cast<int>(reach.size()), MPI_DOUBLE, MPI_MAX, comm);
  const auto place = [&](int node) { return Vec3(Eigen::Map<const Vec3>(x.data() + 3 * node)); };

  // By node and by element of the mesh: m, away from the end, signed from A to B.
  std::unordered_map<int, double> pulled, pulled_between;
  for (const LineSpan& line : mesh.lines)
    for (const bool from_a : {true, false}) {
      const int first = from_a ? line.first_node : line.first_node + line.nodes - 1, way = from_a ? 1 : -1;
      if (!std::binary_search(held.begin(), held.end(), first)) continue;
      const int next = first + way;
      const double near = 2 * std::abs(reach[static_cast<size_t>(next)]);
      if (gap(place(first), near) > near) continue;
      double sum = 0;
      std::vector<std::pair<int, double>> walked, walked_between;
      int node = first;
      for (int i = 1; i < line.nodes; ++i) {
        const int to = first + i * way;
        const int element = line.first_element + (from_a ? i - 1 : line.elements - i);
        const double stretch = std::max(
            0.0, (place(to) - place(node)).norm() - mesh.elements[static_cast<size_t>(element)].length);
        walked_between.emplace_back(element, way * (sum + 0.5 * stretch));
        const double most = reach[static_cast<size_t>(to)];
        if (most < 0 || gap(place(to), most) >= most) break;
        sum += stretch;
        walked.emplace_back(to, way * sum);
        node = to;
      }
      // On the bed from end to end: nothing says where it was pulled from.
      if (static_cast<int>(walked.size()) >= line.nodes - 2) continue;
      for (const auto& [n, s] : walked) pulled[n] = s;
      for (const auto& [e, s] : walked_between) pulled_between[e] = s;
    }
  for (Point& p : points_) {
    const Vec3 here = of_nodes(p, at.x);
    ContactTrial seen;
    locate(p, here, 0, seen);
    p.start.point = here;
    p.start.gap = seen.gap;
    p.start.normal = seen.normal;
    p.start.slip.setZero();
    const bool between = p.second >= 0;
    const auto& from = between ? pulled_between : pulled;
    const auto found = from.find(between ? mesh_.elements[static_cast<size_t>(p.element)].global
                                         : mesh_.global[static_cast<size_t>(p.node)]);
    if (found == from.end()) continue;
    const Vec3 t = tangent(p, at);
    p.start.slip = found->second * (t - seen.normal * seen.normal.dot(t));
  }
  laid_ = true;
}

}  // namespace hawser
