// The models that show every force term in all its situations, for the term suite.
#pragma once

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "hawser/geometry/height_grid.hpp"
#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/terms/buried.hpp"
#include "hawser/terms/end_springs.hpp"
#include "hawser/terms/hydrodynamics.hpp"
#include "hawser/terms/line_mass.hpp"
#include "hawser/terms/point_loads.hpp"
#include "hawser/terms/seabed.hpp"
#include "hawser/terms/structure.hpp"
#include "hawser/terms/volume_contact.hpp"
#include "support/shapes.hpp"
#include "support/taylor_model.hpp"

namespace hawser::test {

struct SuiteCase {
  std::string name;
  std::function<std::unique_ptr<SuiteModel>(MPI_Comm, const Placement&)> build;
};

// Places of contact. Nodes are put on the surface, each in a state of its own (kStory), and one step of
// history is laid down.
enum class ContactOn { plane, cylinder, face, edge, vertex, corner };
inline constexpr double kContactRadius = 0.1, kNormalStiffness = 1e5;

inline const Vec3 kTurn(0.3, -0.4, 0.5);  // of element axes in node axes
inline Mat3 suite_axes(bool turned) { return turned ? exp_so3(kTurn).toRotationMatrix() : Mat3::Identity(); }

inline std::unique_ptr<SuiteModel> held_model(MPI_Comm comm, const Placement& at) {
  auto m = std::make_unique<SuiteModel>(comm, at);
  // One position held by components, one rotation by a component: an end as dynamics has it.
  std::vector<Support> s;
  const LocalMesh& l = m->system->mesh();
  for (int n = 0; n < l.nodes(); ++n)
    if (l.global[static_cast<size_t>(n)] == 3) {
      Support held;
      held.node = n, held.position_mask = 7, held.rotation_mask = 1;
      s.push_back(held);
    }
  m->system->support(s, {});
  return m;
}

// Stiffnesses of one size, so that no part hides behind another.
inline void add_structure(SuiteModel& m, double beta, double GA, bool turned, bool tables = false) {
  // Bent and stretched into their steep and their flat parts.
  static const StiffnessTable tension(std::vector<StiffnessTable::Row>{{0.05, 15}, {0.2, 90}, {0.4, 120}},
                                      false);
  static const StiffnessTable moment(std::vector<StiffnessTable::Row>{{0.1, 5}, {0.3, 11}, {0.6, 13}}, true);
  const LocalMesh& l = m.system->mesh();
  std::vector<StructureTerm::Beam> beams;
  std::vector<StructureTerm::Cable> cables;
  for (const LocalElement& e : l.elements) {
    const Element& g = m.mesh.elements[static_cast<size_t>(e.global)];
    if (!g.beam) {
      cables.push_back({e, {}, {g.length, 300, beta, tables ? &tension : nullptr}});
      continue;
    }
    StructureTerm::Beam b{e, {}, {g.length, 300, 50, 80, 40, GA, beta}, {}};
    if (tables) b.section.tension = &tension, b.section.moment = &moment, b.section.EI3 = b.section.EI2 = 60;
    if (turned) {
      b.reference.axes = suite_axes(true), b.reference.aligned = false;
      b.reference.psi = Vec3(0.1, -0.05, 0.08), b.reference.strain = 0.02;
    }
    beams.push_back(b);
  }
  m.system->add(std::make_unique<StructureTerm>(l, std::move(beams), std::move(cables)));
}

inline void add_mass(SuiteModel& m, const Placement& at, bool turned) {
  const LocalMesh& l = m.system->mesh();
  std::vector<LineMassTerm::Piece> pieces;
  for (const LocalElement& e : l.elements) {
    const Element& g = m.mesh.elements[static_cast<size_t>(e.global)];
    LineMassTerm::Piece p;
    p.at = e, p.beam = g.beam;
    p.section = {g.length, 2, Vec3(0.5, 0.2, 0.4), suite_axes(turned)};
    p.load = at.rotation * Vec3(1, -2, -15);
    p.first_ramped = 0, p.ramped = 2;
    pieces.push_back(p);
  }
  m.system->add(std::make_unique<LineMassTerm>(
      l, pieces,
      std::vector<LineMassTerm::Load>{{at.rotation * Vec3(3, 0, 1), 2}, {at.rotation * Vec3(0, 5, 1), 0.5}}));
}

// The directors' accelerations as a step has them: near those of w and alpha, but not the same.
inline void add_directors(SuiteModel& m, const Placement& at) {
  const LocalMesh& l = m.system->mesh();
  State& r = m.trial.rates;
  r.director_weight = 23;
  r.directors.assign(r.x.size(), Mat3::Zero());
  const State s = state_of(l, m.trial);
  for (size_t i = 0; i < r.x.size(); ++i) {
    const int g = l.global[i];
    r.directors[i] = director_acceleration(s.q[i], r.w[i], r.alpha[i]);
    for (int c = 0; c < 3; ++c) r.directors[i].col(c) += at.rotation * (0.4 * noise3(g, 20 + c));
  }
}

inline void add_loads(SuiteModel& m, const Placement& at, bool gravity) {
  const LocalMesh& l = m.system->mesh();
  std::vector<NodeLoad> loads;
  std::vector<NodeMass> masses;
  for (int n = 0; n < l.nodes(); ++n) {
    const int g = l.global[static_cast<size_t>(n)];
    if (g == 1 || g == 2)
      loads.push_back({n, at.rotation * Vec3(4, -3, 2), at.rotation * Vec3(5, 7, -6), g == 1 ? 0.0 : 1.5});
    if (g == 1) loads.push_back({n, Vec3::Zero(), at.rotation * Vec3(-2, 1, 3), 2});
    if (g == 5) loads.push_back({n, at.rotation * Vec3(0, 9, 2), Vec3::Zero(), 3});
    if (g == 0 || g == 6) masses.push_back({n, 4.0 + g});
  }
  m.system->add(std::make_unique<PointLoads>(l, loads));
  m.system->add(std::make_unique<PointMasses>(l, masses, gravity ? 9.81 : 0));
}

// Of one piece, the floor z = 0 and the wall y = 0 beside it.
inline TriangleMesh floor_and_wall() {
  TriangleMesh m = testing::prism_mesh({{-1, -1}, {0, -1}, {3, -1}, {3, 0}, {0, 0}, {0, 1}, {-1, 1}, {-1, 0}},
                                       {{0, 1, 4, 7}, {1, 2, 3, 4}, {7, 4, 5, 6}}, 9);
  for (Vec3& v : m.vertices) v = Vec3(v.z() - 3, v.x(), v.y());
  return m;
}

// A place over the surface, body axes: `gap` from it, moved by `slip` along it from where node g begins.
inline Vec3 place(ContactOn on, int g, double gap, double slip) {
  const double d = kContactRadius + gap, k = g;
  const double way = slip / d;  // rad, over an edge or a vertex
  switch (on) {
    case ContactOn::plane:
      return {0.4 * k + 0.8 * slip, -0.6 * slip, d};
    case ContactOn::cylinder: {  // about y, radius 2, from y = -5 to 5
      const double angle = 0.3 + 0.2 * k + 0.6 * slip / 2;
      return (2 + d) * Vec3(std::cos(angle), 0, std::sin(angle)) + Vec3(0, 0.5 * k - 2 + 0.8 * slip, 0);
    }
    case ContactOn::face:
      return {0.3 + 0.3 * k + 0.8 * slip, 1.7 - 0.6 * slip, 2 + d};
    case ContactOn::edge: {  // along y at x = 3, z = 2, from y = 0 to 3
      const double angle = 0.7 + 0.03 * k + 0.6 * way;
      return Vec3(3, 0.3 + 0.3 * k + 0.8 * slip, 2) + d * Vec3(std::sin(angle), 0, std::cos(angle));
    }
    // Floor z = 0 and wall y = 0 of one mesh: the farther from the one, the nearer to the other.
    case ContactOn::corner:
      return {0.4 * k + 0.8 * slip, kContactRadius - gap - 4.3e-3, d};
    case ContactOn::vertex:
      return Vec3(3, 3, 2) +
             d * (Vec3(1, 0.8 + 0.02 * k, 1.1).normalized() + way * Vec3(0.6, -0.8, 0)).normalized();
  }
  return {};
}

struct NodeStory {
  double before, gap;  // m, at the start of the step and in the trial
  double slip;         // m, in the step
  double speed;        // m/s, relative, of each component
};
inline constexpr double mm = 1e-3;
// By node: open, ramp and stick, full and stick, full and slip, ramp and slip, first touch and stick, first
// touch and slip, leaves. The ramp is 1 mm wide on either side.
inline constexpr NodeStory kStory[8] = {
    {50 * mm, 30 * mm, 5 * mm, 0.1},  {-0.2 * mm, 0.3 * mm, 0.02 * mm, 0.02}, {-5 * mm, -6 * mm, 1 * mm, 0.1},
    {-5 * mm, -4 * mm, 20 * mm, 0.1}, {-0.3 * mm, 0.2 * mm, 5 * mm, 0.02},    {10 * mm, -4 * mm, 1 * mm, 0.1},
    {10 * mm, -5 * mm, 40 * mm, 0.1}, {-3 * mm, 5 * mm, 1 * mm, 0.1}};

// How a node is kept out; with multipliers or held, those of the start of the step. The last: by multipliers
// alone, as the exact statics does it.
enum class Kept { elastic, augmented, rigid, gap, exact };

inline VolumeContact& add_contact(SuiteModel& m, const Placement& at, ContactOn on, double axial,
                                  double lateral, Kept kept = Kept::elastic) {
  const LocalMesh& l = m.system->mesh();
  const Quat start = exp_so3({0.3, -0.2, 0.5});
  const bool moves = on != ContactOn::plane && on != ContactOn::corner;
  const SteadyLaw turning{at.rotation * Vec3(0.2, -0.1, 0.3), at.rotation * Vec3(1, 2, -2), 0.4};
  const auto bodies = std::make_shared<const Bodies>(std::vector<RigidMotion>{
      {at.point({1, 2, 3}), log_so3(at.rotation * start), moves ? MotionLaw(turning) : MotionLaw()}});
  ContactVolume v;
  v.body = 0;
  v.settings.name = "volume";
  v.settings.basis = model::StiffnessBasis::per_point;
  v.settings.normal_stiffness = kNormalStiffness;
  v.settings.smoothing = 1 * mm;
  v.settings.relative_damping = 0.1;
  v.settings.friction = {axial, lateral, 0, axial == lateral ? 4e4 : 0.0};
  if (axial != lateral) v.settings.friction.mobilisation_length = 2 * mm;
  if (on == ContactOn::plane)
    v.surface = std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ());
  else if (on == ContactOn::cylinder)
    v.surface = std::make_shared<CylinderSurface>(Vec3(0, -5, 0), Vec3(0, 5, 0), 2);
  else if (on == ContactOn::corner)
    v.surface = std::make_shared<MeshSurface>(floor_and_wall());
  else
    v.surface = std::make_shared<MeshSurface>(testing::box_mesh(Vec3(0, 0, -1), Vec3(3, 3, 2)));
  // What holds a node in motion goes by its mass: one that asks for no more than the spring.
  const double mass = kept == Kept::elastic || kept == Kept::gap ? 50 : 0.02;
  v.settings.relative_damping *= std::sqrt(50 / mass);
  const NodeContact model = kept == Kept::gap       ? NodeContact::gap
                            : kept == Kept::rigid   ? NodeContact::rigid
                            : kept == Kept::elastic ? NodeContact::elastic
                                                    : NodeContact::augmented;
  auto term = std::make_unique<VolumeContact>(
      l, bodies, std::vector<ContactVolume>{v},
      std::vector<ContactNode>(static_cast<size_t>(l.owned), {kContactRadius, mass}), model);
  VolumeContact& contact = *term;
  m.system->add(std::move(term));

  // One step that ends where the trial's begins lays down history, then the trial's step is prepared.
  Trial& t = m.trial;
  const double t0 = t.from.time;
  const RigidPose p0 = bodies->pose(0, t0 - t.h), p1 = bodies->pose(0, t0), p2 = bodies->pose(0, t0 + t.h);
  State before = t.from;
  before.time = t0 - t.h;
  for (int n = 0; n < l.nodes(); ++n) {
    const int g = l.global[static_cast<size_t>(n)];
    const NodeStory& s = kStory[g];
    const double old = g == 1 ? 0.02 * mm : 0.5 * mm;
    before.x[static_cast<size_t>(n)] = p0.to_space(place(on, g, s.before, -old));
    const Vec3 from = p1.to_space(place(on, g, s.before, 0)), to = p2.to_space(place(on, g, s.gap, s.slip));
    m.put(n, from, to, p2.velocity_at(to) + s.speed * (at.rotation * noise3(g, 9)));
    t.from.v[static_cast<size_t>(n)] = p1.velocity_at(from);
    before.v[static_cast<size_t>(n)] = p0.velocity_at(before.x[static_cast<size_t>(n)]);
  }
  m.system->prepare(before.view(t.h), t.h);
  m.system->commit(t.from.view(t.h));
  m.system->prepare(t.from.view(t.h), t.h);
  t.length = 0.2 * mm;
  if (kept == Kept::augmented) contact.augment(t.from.view(t.h));
  if (kept == Kept::rigid) {  // held where it is deep at the start, then with its force, or deep in the trial
    for (int i = 0; i < 2; ++i) contact.augment(t.from.view(t.h));
    contact.augment(state_of(l, t).view(t.h));
  }
  if (kept == Kept::exact) {
    std::vector<double> forces;
    for (int n = 0; n < l.owned; ++n) {
      const NodeStory& s = kStory[l.global[static_cast<size_t>(n)]];
      forces.push_back(std::max(0.0, -kNormalStiffness * s.before));
    }
    contact.set_multipliers(forces);
  }
  return contact;
}

// A seabed turned and moved with the model: curved in space, so that slope and curvature count. Distances are
// those of the bed it is made of.
class PlacedSurface final : public Surface {
 public:
  PlacedSurface(std::shared_ptr<const Surface> bed, const Vec3& origin, const Quat& turn)
      : bed_(std::move(bed)), origin_(origin), turn_(turn) {}
  using Surface::query;
  std::optional<SurfacePoint> query(const Vec3& y, double most, int hint) const override {
    auto s = bed_->query(turn_.conjugate() * (y - origin_), most, hint);
    if (!s) return s;
    const Mat3 R = turn_.toRotationMatrix();
    s->normal = R * s->normal, s->point = origin_ + R * s->point;
    s->curvature = R * s->curvature * R.transpose();
    return s;
  }
  Box bounds() const override { return Box::everything(); }

 private:
  std::shared_ptr<const Surface> bed_;
  Vec3 origin_;
  Quat turn_;
};

// Hills and hollows of some metres: radii of curvature down to a few times the contact radius.
inline std::shared_ptr<const HeightGrid> hilly() {
  std::vector<double> x, z;
  for (int i = 0; i <= 24; ++i) x.push_back(i - 8);
  for (const double b : x)
    for (const double a : x)
      z.push_back(0.2 * std::sin(0.9 * a + 0.5) * std::cos(0.7 * b) + 0.1 * a - 0.05 * b);
  return std::make_shared<const HeightGrid>(x, x, z);
}

// A seabed under the nodes, sloping or of a grid, each node in its own situation (kStory): with a spring or a
// A seabed under the nodes, sloping or of a grid, each node in its own situation (kStory): with a spring or a
// table, through whose bends and steep parts they go, or with suction, which holds those that rise; or in the
// first stage of statics, in which springs keep them where they were laid; with points half way along the
// elements as well, which come to be between their nodes' situations.
enum class Soil { spring, table, sticky, laid };
inline SeabedTerm& add_seabed(SuiteModel& m, const Placement& at, double axial, double lateral,
                              bool curved = false, Soil soil = Soil::spring, bool between = false) {
  static const std::vector<ForceTable::Row> rows{{2 * mm, 60}, {4.5 * mm, 500}, {20 * mm, 1000}};
  static const ForceTable table(rows);
  const LocalMesh& l = m.system->mesh();
  const Quat slope = at.rotation * exp_so3({0.2, -0.1, 0.4});
  const Vec3 origin = at.point({1, 2, 3});
  const SeabedTerm::Plane plane{origin, slope * Vec3::UnitZ()};
  const auto bed = hilly();
  SeabedTerm::PointLaw law;
  law.radius = kContactRadius;
  law.law.normal.stiffness = kNormalStiffness, law.law.normal.smoothing = 1 * mm,
  law.law.normal.damping = 500;
  if (soil == Soil::sticky) law.suction = {300, 10 * mm};
  if (soil == Soil::table) law.law.normal = {0.7 * table.largest_slope(), 0, 500, &table, 0.7};
  FrictionLaw& friction = law.law.friction;
  friction.axial = axial, friction.lateral = lateral;
  friction.axial_length = 2 * mm, friction.lateral_length = 3 * mm;
  const SeabedTerm::PointLaws laws{std::vector<SeabedTerm::PointLaw>(static_cast<size_t>(l.owned), law),
                                   std::vector<SeabedTerm::PointLaw>(between ? l.elements.size() : 0, law)};
  auto term = curved ? std::make_unique<SeabedTerm>(
                           l, std::make_shared<const PlacedSurface>(bed, origin, slope), laws)
                     : std::make_unique<SeabedTerm>(l, plane, laws);
  SeabedTerm& seabed = *term;
  m.system->add(std::move(term));
  Trial& t = m.trial;
  State before = t.from;
  before.time = t.from.time - t.h;
  for (int n = 0; n < l.nodes(); ++n) {
    const int g = l.global[static_cast<size_t>(n)];
    const NodeStory& s = kStory[g];
    const auto where = [&](double gap, double slip) -> Vec3 {
      const Vec3 flat = place(ContactOn::plane, g, gap, slip);
      if (!curved) return origin + slope * flat;
      const auto h = bed->at(flat.x(), flat.y());
      const Vec3 normal = Vec3(-h.slope.x(), -h.slope.y(), 1).normalized();
      return origin + slope * (Vec3(flat.x(), flat.y(), h.z) + flat.z() * normal);
    };
    before.x[static_cast<size_t>(n)] = where(s.before, g == 1 ? -0.02 * mm : -0.5 * mm);
    m.put(n, where(s.before, 0), where(s.gap, s.slip), s.speed * (at.rotation * noise3(g, 9)));
  }
  m.system->prepare(before.view(t.h), t.h);
  m.system->commit(t.from.view(t.h));
  if (soil == Soil::laid) {
    t.h = 0;
    seabed.enable_friction(false);
    seabed.lay_at_start(m.system->comm(), t.from.view(0), std::vector<double>(l.mesh->lines.size(), 100.0));
  }
  m.system->prepare(t.from.view(t.h), t.h);
  t.length = 0.2 * mm;
  return seabed;
}

inline std::vector<SuiteCase> seabed_cases() {
  std::vector<SuiteCase> out;
  for (const bool curved : {false, true})
    for (const auto& [axial, lateral, friction] :
         {std::tuple{0.0, 0.0, "smooth"}, {0.3, 0.3, "isotropic"}, {0.2, 0.5, "anisotropic"}})
      for (const auto& [soil, kind] : {std::pair{Soil::spring, ""},
                                       {Soil::table, "table, "},
                                       {Soil::sticky, "suction, "},
                                       {Soil::laid, "laid, "}})
        out.push_back(
            {std::string("seabed, ") + (curved ? "grid, " : "") + kind + friction,
             [axial = axial, lateral = lateral, curved, soil = soil](MPI_Comm comm, const Placement& at) {
               auto m = std::make_unique<SuiteModel>(comm, at);
               add_seabed(*m, at, axial, lateral, curved, soil);
               return m;
             }});
  // Some come to lie just where a table begins and suction lets go, which has no tangent: springs only.
  for (const auto& [axial, lateral, friction] :
       {std::tuple{0.0, 0.0, "smooth"}, {0.3, 0.3, "isotropic"}, {0.2, 0.5, "anisotropic"}})
    out.push_back({std::string("seabed, half way along too, ") + friction,
                   [axial = axial, lateral = lateral](MPI_Comm comm, const Placement& at) {
                     auto m = std::make_unique<SuiteModel>(comm, at);
                     add_seabed(*m, at, axial, lateral, false, Soil::spring, true);
                     return m;
                   }});
  // Nodes that the soil holds, yields along, yields across, and yields to both ways, after a step that left
  // some slip.
  out.push_back({"buried", [](MPI_Comm comm, const Placement& at) {
                   auto m = std::make_unique<SuiteModel>(comm, at);
                   const LocalMesh& l = m->system->mesh();
                   Trial& t = m->trial;
                   State laid = t.from;
                   laid.time = t.from.time - t.h;
                   std::vector<BuriedTerm::Place> places;
                   for (int n = 0; n < l.nodes(); ++n) {
                     const size_t i = static_cast<size_t>(n);
                     const int g = l.global[i];
                     laid.x[i] -= 1 * mm * (at.rotation * noise3(g, 11));
                     if (n < l.owned)
                       places.push_back({n, {200, 300, g % 2 ? 0.01 : 1.0, g % 4 < 2 ? 0.02 : 1.0}});
                   }
                   m->system->add(std::make_unique<BuriedTerm>(l, laid.view(t.h), places));
                   m->system->prepare(laid.view(t.h), t.h);
                   m->system->commit(t.from.view(t.h));
                   m->system->prepare(t.from.view(t.h), t.h);
                   return m;
                 }});
  return out;
}

inline std::vector<SuiteCase> structure_cases() {
  std::vector<SuiteCase> out;
  const auto structure = [&](const char* name, double beta, double GA, bool turned, bool tables = false) {
    out.push_back({name, [=](MPI_Comm comm, const Placement& at) {
                     auto m = held_model(comm, at);
                     add_structure(*m, beta, GA, turned, tables);
                     m->system->prepare(m->trial.from.view(m->trial.h), m->trial.h);
                     return m;
                   }});
  };
  structure("structure", 0, 0, false);
  structure("structure, shear", 0, 200, false);
  structure("structure, damped", 0.3, 200, false);
  structure("structure, curved, damped", 0.3, 200, true);
  structure("structure, tables", 0, 0, false, true);
  structure("structure, tables, curved, damped", 0.3, 0, true, true);
  out.push_back(
      {"end springs", [](MPI_Comm comm, const Placement& at) {
         auto m = std::make_unique<SuiteModel>(comm, at);
         const LocalMesh& l = m->system->mesh();
         // One to a body that turns, one nearly along its direction, one far from it.
         const auto bodies = std::make_shared<const Bodies>(
             std::vector<RigidMotion>{{at.point({1, 2, 3}), log_so3(at.rotation * exp_so3({0.1, 0.2, 0.3})),
                                       SteadyLaw{Vec3::Zero(), at.rotation * Vec3(1, 2, -2), 0.4}}});
         const State s = state_of(l, m->trial);
         std::vector<EndSpring> springs;
         for (int n = 0; n < l.owned; ++n) {
           const int g = l.global[static_cast<size_t>(n)];
           const Vec3 t = s.q[static_cast<size_t>(n)] * Vec3::UnitX();
           if (g == 0) springs.push_back({n, 0, Vec3(0.8, 0.6, 0), 70});
           if (g == 1)
             springs.push_back({n, -1, (t + 0.01 * (at.rotation * Vec3(1, 2, 3))).normalized(), 90});
           if (g == 3) springs.push_back({n, -1, at.rotation * Vec3(-0.6, 0, 0.8), 50});
         }
         m->system->add(std::make_unique<EndSprings>(l, bodies, springs));
         m->system->prepare(m->trial.from.view(m->trial.h), m->trial.h);
         return m;
       }});
  return out;
}

inline std::vector<SuiteCase> mass_and_load_cases() {
  std::vector<SuiteCase> out;
  for (const bool turned : {false, true})
    for (const bool step : {false, true})
      out.push_back({std::string("mass") + (turned ? ", turned axes" : "") + (step ? ", in a step" : ""),
                     [=](MPI_Comm comm, const Placement& at) {
                       auto m = held_model(comm, at);
                       add_mass(*m, at, turned);
                       if (step) add_directors(*m, at);
                       m->system->prepare(m->trial.from.view(m->trial.h), m->trial.h);
                       return m;
                     }});
  out.push_back({"point loads and masses", [](MPI_Comm comm, const Placement& at) {
                   auto m = held_model(comm, at);
                   // Weight does not turn with the model.
                   add_loads(*m, at, at.rotation.isApprox(Quat::Identity()));
                   m->system->prepare(m->trial.from.view(m->trial.h), m->trial.h);
                   return m;
                 }});
  return out;
}

// A sea with its surface where the lines are (or far above them), a current that turns with the depth, and a
// buoy. The sea is level: `at` may turn it about z only. Sections so thick that none comes to the edges of
// what is half wet, where the second derivative is infinite.
inline void add_water(SuiteModel& m, const Placement& at, double surface, bool turned, bool waves = false) {
  constexpr double radius = 2;
  const LocalMesh& l = m.system->mesh();
  std::vector<Hydrodynamics::Piece> pieces;
  for (const LocalElement& e : l.elements) {
    const Element& g = m.mesh.elements[static_cast<size_t>(e.global)];
    Hydrodynamics::Piece p;
    p.at = e, p.beam = g.beam;
    p.section = {g.length, radius, 40, 4, 3, 1, 2, 0.7, suite_axes(turned).col(0)};
    pieces.push_back(p);
  }
  std::vector<Hydrodynamics::Ball> balls;
  for (int n = 0; n < l.owned; ++n)
    if (const int g = l.global[static_cast<size_t>(n)]; g == 2 || g == 6)
      balls.push_back({n, {20, 2, 1, 3, 0.6}});
  Sea sea;
  sea.surface = surface;
  sea.current = CurrentProfile(
      {{surface - 20, at.rotation * Vec3(0.5, 1, 0)}, {surface + 20, at.rotation * Vec3(-1.5, 3, 0)}});
  sea.current_ramp = 1.5, sea.current_factor = TimeFactor({{0, 0.4}, {2, 1.6}});
  if (waves) {
    std::vector<WaveComponent> components;
    for (const Vec3& omega_and_way : {Vec3(0.9, 0.6, 0.8), Vec3(1.4, -1, 0)}) {
      WaveComponent w;
      const Vec3 way = at.rotation * Vec3(omega_and_way.y(), omega_and_way.z(), 0);
      w.amplitude = 0.3, w.omega = omega_and_way.x(), w.x = way.x(), w.y = way.y();
      w.phase = 0.4 - wave_number(w.omega, 0, sea.gravity) * way.dot(at.shift);
      components.push_back(w);
    }
    sea.waves = WaveField(std::move(components), 0, sea.gravity, Stretching::wheeler);
    sea.wave_ramp = 3;
  }
  m.system->add(std::make_unique<Hydrodynamics>(l, sea, std::move(pieces), std::move(balls)));
}

inline std::vector<SuiteCase> water_cases() {
  std::vector<SuiteCase> out;
  for (const auto& [name, surface, turned, step, waves] :
       {std::tuple{"water, deep", 10.0, false, false, false},
        {"water, waves", 0.2, true, true, true},
        {"water, at the surface", 0.1, false, true, false},
        {"water, turned axes", 0.3, true, true, false},
        {"water, turned axes, deep", 10.0, true, false, false}})
    out.push_back({name, [surface = surface, turned = turned, step = step, waves = waves](
                             MPI_Comm comm, const Placement& at) {
                     auto m = held_model(comm, at);
                     add_water(*m, at, surface, turned, waves);
                     if (step) add_directors(*m, at);
                     m->system->prepare(m->trial.from.view(m->trial.h), m->trial.h);
                     return m;
                   }});
  return out;
}

inline std::vector<SuiteCase> contact_cases() {
  std::vector<SuiteCase> out;
  constexpr std::pair<ContactOn, const char*> kinds[] = {
      {ContactOn::plane, "plane"}, {ContactOn::cylinder, "cylinder"}, {ContactOn::face, "face"},
      {ContactOn::edge, "edge"},   {ContactOn::vertex, "vertex"},     {ContactOn::corner, "corner"}};
  for (const auto& [on, name] : kinds)
    for (const auto& [axial, lateral, friction] :
         {std::tuple{0.0, 0.0, "smooth"}, {0.3, 0.3, "isotropic"}, {0.2, 0.5, "anisotropic"}})
      out.push_back({std::string("contact, ") + name + ", " + friction,
                     [on = on, axial = axial, lateral = lateral](MPI_Comm comm, const Placement& at) {
                       auto m = std::make_unique<SuiteModel>(comm, at);
                       add_contact(*m, at, on, axial, lateral);
                       return m;
                     }});
  for (const auto& [kept, how] : {std::pair(Kept::augmented, "augmented"),
                                  {Kept::rigid, "rigid"},
                                  {Kept::gap, "gap"},
                                  {Kept::exact, "exact"}})
    for (const auto& [on, name] : kinds)
      for (const double friction : {0.0, 0.3}) {
        if (kept == Kept::exact && friction == 0) continue;  // on a plane there is no tangent
        out.push_back({std::string("contact, ") + how + ", " + name + (friction > 0 ? "" : ", smooth"),
                       [on = on, kept = kept, friction](MPI_Comm comm, const Placement& at) {
                         auto m = std::make_unique<SuiteModel>(comm, at);
                         add_contact(*m, at, on, friction, friction, kept);
                         return m;
                       }});
      }
  return out;
}

inline std::vector<SuiteCase> all_cases() {
  std::vector<SuiteCase> out = structure_cases();
  for (auto list : {mass_and_load_cases(), water_cases(), seabed_cases(), contact_cases()})
    out.insert(out.end(), list.begin(), list.end());
  out.push_back({"everything", [](MPI_Comm comm, const Placement& at) {
                   auto m = held_model(comm, at);
                   add_structure(*m, 0.01, 200, true);
                   add_mass(*m, at, true);
                   add_loads(*m, at, at.rotation.isApprox(Quat::Identity()));
                   add_contact(*m, at, ContactOn::cylinder, 0.3, 0.3);
                   add_directors(*m, at);
                   return m;
                 }});
  return out;
}

}  // namespace hawser::test
