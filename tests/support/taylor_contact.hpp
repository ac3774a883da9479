// A model in all states of contact: its nodes are on a surface, each in a different state.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/terms/line_volume_contact.hpp"
#include "support/shapes.hpp"
#include "support/taylor_model.hpp"

namespace hawser::test {

struct SuiteCase {
  std::string name;
  std::function<std::unique_ptr<SuiteModel>(MPI_Comm, const Placement&)> build;
};

// Surfaces of contact. Each node is placed on the surface in its own state (kHistory), after one step of
// history.
enum class ContactOn { plane, cylinder, face, edge, vertex, corner };
inline constexpr double kContactRadius = 0.1, kNormalStiffness = 1e5;

inline std::unique_ptr<SuiteModel> held_model(MPI_Comm comm, const Placement& at) {
  auto m = std::make_unique<SuiteModel>(comm, at);
  // One position held by components and one rotation held by a component, as dynamics has them at an end.
  std::vector<TiedNode> s;
  const LocalMesh& l = m->system->mesh();
  for (int n = 0; n < l.nodes(); ++n)
    if (l.global[static_cast<size_t>(n)] == 3) {
      TiedNode held;
      held.node = n;
      held.position_mask = 7;
      held.rotation_mask = 1;
      s.push_back(held);
    }
  m->system->tie(s, {});
  return m;
}

// One mesh of the floor z = 0 and the wall y = 0 beside it.
inline TriangleMesh floor_and_wall() {
  TriangleMesh m = test::prism_mesh({{-1, -1}, {0, -1}, {3, -1}, {3, 0}, {0, 0}, {0, 1}, {-1, 1}, {-1, 0}},
                                    {{0, 1, 4, 7}, {1, 2, 3, 4}, {7, 4, 5, 6}}, 9);
  for (Vec3& v : m.vertices) v = Vec3(v.z() - 3, v.x(), v.y());
  return m;
}

// A point above the surface, body axes: at the distance `gap`, moved by `slip` along the surface from the
// start of node g.
inline Vec3 place(ContactOn on, int g, double gap, double slip) {
  const double d = kContactRadius + gap;
  const double k = g;
  const double way = slip / d;  // rad, around an edge or a vertex
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
    // Floor z = 0 and wall y = 0 of one mesh: a larger distance from the one is a smaller distance from the
    // other.
    case ContactOn::corner:
      return {0.4 * k + 0.8 * slip, kContactRadius - gap - 4.3e-3, d};
    case ContactOn::vertex:
      return Vec3(3, 3, 2) +
             d * (Vec3(1, 0.8 + 0.02 * k, 1.1).normalized() + way * Vec3(0.6, -0.8, 0)).normalized();
  }
  return {};
}

struct NodeHistory {
  double before, gap;  // m, at the start of the step and in the trial
  double slip;         // m, in the step
  double speed;        // m/s, relative velocity, each component
};
inline constexpr double mm = 1e-3;
// Per node: open; ramp and stick; full and stick; full and slip; ramp and slip; first touch and stick; first
// touch and slip; separation. The ramp is 1 mm wide on either side.
inline constexpr NodeHistory kHistory[8] = {
    {50 * mm, 30 * mm, 5 * mm, 0.1},  {-0.2 * mm, 0.3 * mm, 0.02 * mm, 0.02}, {-5 * mm, -6 * mm, 1 * mm, 0.1},
    {-5 * mm, -4 * mm, 20 * mm, 0.1}, {-0.3 * mm, 0.2 * mm, 5 * mm, 0.02},    {10 * mm, -4 * mm, 1 * mm, 0.1},
    {10 * mm, -5 * mm, 40 * mm, 0.1}, {-3 * mm, 5 * mm, 1 * mm, 0.1}};

inline LineVolumeContact& add_contact(SuiteModel& m, const Placement& at, ContactOn on, double axial,
                                      double lateral,
                                      model::ContactMethod method = model::ContactMethod::nodes) {
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
  if (axial != lateral) v.settings.friction.mobilisation_length = 2.2 * mm;
  if (on == ContactOn::plane)
    v.surface = std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ());
  else if (on == ContactOn::cylinder)
    v.surface = std::make_shared<CylinderSurface>(Vec3(0, -5, 0), Vec3(0, 5, 0), 2);
  else if (on == ContactOn::corner)
    v.surface = std::make_shared<MeshSurface>(floor_and_wall());
  else
    v.surface = std::make_shared<MeshSurface>(test::box_mesh(Vec3(0, 0, -1), Vec3(3, 3, 2)));
  auto term = std::make_unique<LineVolumeContact>(
      l, bodies, std::vector<ContactVolume>{v},
      std::vector<LineContactElement>(l.elements.size(), {kContactRadius, 50}), PETSC_COMM_SELF, method);
  LineVolumeContact& contact = *term;
  m.system->add(std::move(term));

  // One step to the start of the trial makes the history; then the system is prepared for the trial.
  Trial& t = m.trial;
  const double t0 = t.from.time;
  const RigidPose p0 = bodies->pose(0, t0 - t.h);
  const RigidPose p1 = bodies->pose(0, t0);
  const RigidPose p2 = bodies->pose(0, t0 + t.h);
  State before = t.from;
  before.time = t0 - t.h;
  for (int n = 0; n < l.nodes(); ++n) {
    const int g = l.global[static_cast<size_t>(n)];
    const NodeHistory s = kHistory[g];
    const double old = g == 1 ? 0.02 * mm : 0.5 * mm;
    before.x[static_cast<size_t>(n)] = p0.to_space(place(on, g, s.before, -old));
    const Vec3 from = p1.to_space(place(on, g, s.before, 0));
    const Vec3 to = p2.to_space(place(on, g, s.gap, s.slip));
    m.put(n, from, to, p2.velocity_at(to) + s.speed * (at.rotation * noise3(g, 9)));
    t.from.v[static_cast<size_t>(n)] = p1.velocity_at(from);
    before.v[static_cast<size_t>(n)] = p0.velocity_at(before.x[static_cast<size_t>(n)]);
  }
  m.system->prepare(before.after_step(t.h), t.h);
  m.system->commit(t.from.after_step(t.h));
  m.system->prepare(t.from.after_step(t.h), t.h);
  t.length = 0.2 * mm;
  return contact;
}

}  // namespace hawser::test
