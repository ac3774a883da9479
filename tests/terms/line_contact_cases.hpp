// Models of contact along elements: a line of three beams and one of three cables beside each other over a
// moving surface, each element in its own state, with one step of history.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hawser/geometry/mesh_surface.hpp"
#include "hawser/terms/line_volume_contact.hpp"
#include "support/shapes.hpp"
#include "support/taylor_model.hpp"

namespace hawser::test {

enum class Under { plane, roller, drum, edge, vertex, corner };

struct LineCase {
  std::string name;
  Under on;
  double axial = 0, lateral = 0;
  bool far = false;  // slides in the step (does not stick)
  bool rolling = false;
};

inline std::vector<LineCase> line_cases() {
  std::vector<LineCase> out;
  for (const auto& [on, name] : {std::pair{Under::plane, "plane"},
                                 {Under::roller, "roller"},
                                 {Under::drum, "drum"},
                                 {Under::edge, "edge"},
                                 {Under::vertex, "vertex"},
                                 {Under::corner, "corner"}}) {
    out.push_back({std::string(name) + ", smooth", on});
    for (const bool far : {false, true}) {
      out.push_back({std::string(name) + (far ? ", slides" : ", sticks"), on, 0.3, 0.3, far});
      out.push_back(
          {std::string(name) + (far ? ", slides" : ", sticks") + ", anisotropic", on, 0.2, 0.5, far});
      out.push_back(
          {std::string(name) + (far ? ", slides" : ", sticks") + ", rolls", on, 0.3, 0.3, far, true});
    }
  }
  return out;
}

inline constexpr double kLineRadius = 0.1, kLineStiffness = 1e5;  // m, N/m²

// Position of node g in body axes at a gap [m] from the surface, moved along by `slip`, and its rotation.
inline void place_node(Under on, int g, double gap, double slip, Vec3& x, Quat& q) {
  const double k = g % 4;
  const double side = g < 4 ? 0 : 1.5;
  x = {1.2 * k + slip, side + 0.7 * slip, kLineRadius + gap};
  q = exp_so3(Vec3(0.2, 2e-3 * noise(g, 0, 1), 3e-3 * noise(g, 1, 1)));
  // A larger distance from the floor is a smaller distance from the wall beside it: at y = -0.1 and 1.6.
  if (on == Under::corner) x.y() = g < 4 ? -gap - 4.5e-3 : 1.5 + gap + 2.4e-3;
  if (on == Under::drum) {  // about y, radius 5
    const double r = 5 + x.z();
    const double angle = x.x() / 5.1;
    x = {r * std::sin(angle), x.y(), r * std::cos(angle)};
    q = exp_so3(Vec3(0, angle, 0)) * q;
  }
}

// Gaps of the nodes of a line at the start of the step and in the trial, mm. On the plane the first element
// separates, the second stays in contact, the third comes into contact; the ramp is 1 mm on either side.
struct Gaps {
  double before[4], trial[4];
};
inline Gaps gaps(Under on) {
  switch (on) {
    case Under::plane:
    case Under::drum:
    case Under::corner:
      return {{-2, -5, -5, 8}, {3, -6, -4, -3}};
    case Under::roller:  // below the middle of the second element, which penetrates by 5 mm
    case Under::vertex:
      return {{-5, -5.5, -4.5, -5}, {-6, -6.2, -5.4, -3}};
    case Under::edge:  // the box ends at x = 1.8
      return {{4, -4, -6, -30}, {6, -4.6, -7, -35}};
  }
  return {};
}

// One mesh of a channel along x: a floor at z = 0 between walls at y = left and y = right.
inline TriangleMesh channel_mesh(double left, double right) {
  TriangleMesh m =
      test::prism_mesh({{left - 1, -1},
                        {left, -1},
                        {right, -1},
                        {right + 1, -1},
                        {right + 1, 0},
                        {right + 1, 1},
                        {right, 1},
                        {right, 0},
                        {left, 0},
                        {left, 1},
                        {left - 1, 1},
                        {left - 1, 0}},
                       {{0, 1, 8, 11}, {1, 2, 7, 8}, {2, 3, 4, 7}, {11, 8, 9, 10}, {7, 4, 5, 6}}, 9);
  for (Vec3& v : m.vertices) v = Vec3(v.z() - 3, v.x(), v.y());
  return m;
}

// One mesh of two pyramids side by side, their apexes below the lines at z = 0.
inline TriangleMesh pyramids_mesh() {
  TriangleMesh m;
  for (const double y : {-1.0, 0.75, 2.5})
    for (const double x : {0.8, 2.8}) m.vertices.push_back({x, y, -1});
  const Vec3 first(1.83, 0.01, 0), second(1.81, 1.52, 0), below(1.8, 0.75, -3);
  for (const Vec3& v : {first, second, below}) m.vertices.push_back(v);
  m.triangles = {{0, 1, 6}, {1, 3, 6}, {3, 2, 6}, {2, 0, 6}, {2, 3, 7}, {3, 5, 7}, {5, 4, 7},
                 {4, 2, 7}, {1, 0, 8}, {3, 1, 8}, {5, 3, 8}, {4, 5, 8}, {2, 4, 8}, {0, 2, 8}};
  return m;
}

inline std::shared_ptr<const Surface> surface_of(Under on) {
  switch (on) {
    case Under::plane:
      return std::make_shared<PlaneSurface>(Vec3::Zero(), Vec3::UnitZ());
    case Under::roller:
      return std::make_shared<CylinderSurface>(Vec3(1.83, -5, -0.25), Vec3(1.83, 5, -0.25), 0.25);
    case Under::drum:
      return std::make_shared<CylinderSurface>(Vec3(0, -8, 0), Vec3(0, 8, 0), 5);
    case Under::edge:
      return std::make_shared<MeshSurface>(test::box_mesh(Vec3(-3, -4, -2), Vec3(1.8, 4, 0)));
    case Under::vertex:
      return std::make_shared<MeshSurface>(pyramids_mesh());
    case Under::corner:
      return std::make_shared<MeshSurface>(channel_mesh(-kLineRadius, 1.5 + kLineRadius));
  }
  return {};
}

struct LineModel : SuiteModel {
  LineVolumeContact* contact = nullptr;
  std::shared_ptr<const Bodies> bodies;

  explicit LineModel(const LineCase& what, MPI_Comm comm = PETSC_COMM_SELF, const Placement& at = {})
      : SuiteModel(comm, at) {
    const LocalMesh& l = system->mesh();
    const SteadyLaw turning{at.rotation * Vec3(0.2, -0.1, 0.3), at.rotation * Vec3(1, 2, -2), 0.4};
    bodies = std::make_shared<const Bodies>(std::vector<RigidMotion>{
        {at.point({1, 2, 3}), log_so3(at.rotation * exp_so3({0.3, -0.2, 0.5})),
         what.on == Under::plane || what.on == Under::corner ? MotionLaw() : MotionLaw(turning)}});
    ContactVolume v;
    v.surface = surface_of(what.on);
    v.body = 0;
    v.settings.name = "volume";
    v.settings.basis = model::StiffnessBasis::per_length;
    v.settings.normal_stiffness = kLineStiffness;
    v.settings.smoothing = 1e-3;
    v.settings.relative_damping = 0.1;
    v.settings.friction = {what.axial, what.lateral, 0, what.axial == what.lateral ? 4e4 : 0.0};
    if (what.axial != what.lateral) v.settings.friction.mobilisation_length = 2e-3;
    LineContactElement element{kLineRadius, 50};
    element.rolling = what.rolling;
    auto term = std::make_unique<LineVolumeContact>(
        l, bodies, std::vector{v}, std::vector<LineContactElement>(l.elements.size(), element));
    contact = term.get();
    system->add(std::move(term));

    const double t0 = trial.from.time;
    const double h = trial.h;
    const RigidPose p0 = bodies->pose(0, t0 - h);
    const RigidPose p1 = bodies->pose(0, t0);
    const RigidPose p2 = bodies->pose(0, t0 + h);
    const Gaps g = gaps(what.on);
    State before = trial.from;
    before.time = t0 - h;
    for (int n = 0; n < l.nodes(); ++n) {
      const size_t i = static_cast<size_t>(n);
      const int id = l.global[i];
      const double b = 1e-3 * g.before[id % 4];
      const double e = 1e-3 * g.trial[id % 4];
      const double slip = what.far ? 0.02 + 2e-3 * noise(id, 0, 2) : 5e-4 + 2e-4 * noise(id, 0, 2);
      Vec3 x0, x1, x2;
      Quat q0, q1, q2;
      place_node(what.on, id, b + 2e-4, -5e-4, x0, q0);
      place_node(what.on, id, b, 0, x1, q1);
      place_node(what.on, id, e, slip, x2, q2);
      // Both the trial's poses in space; the trial's rotation differs a little from the start's.
      before.x[i] = p0.to_space(x0);
      before.v[i] = p0.velocity_at(before.x[i]);
      put(n, p1.to_space(x1), p2.to_space(x2),
          p2.velocity_at(p2.to_space(x2)) + 0.05 * (at.rotation * noise3(id, 9)));
      trial.from.v[i] = p1.velocity_at(trial.from.x[i]);
      if (!l.rotates(n)) continue;
      before.q[i] = p0.rotation * q0;
      trial.from.q[i] = p1.rotation * q1;
      const Quat end = p2.rotation * q2 * exp_so3(2e-3 * noise3(id, 10));
      Eigen::Map<Vec3>(trial.u.data() + 3 * l.block[i] + 3, 3) = log_so3(trial.from.q[i].conjugate() * end);
      trial.rates.w[i] = end.conjugate() * p2.angular_velocity + 0.05 * noise3(id, 11);
      before.w[i] = trial.from.w[i] = Vec3::Zero();
    }
    system->prepare(before.after_step(h), h);
    system->commit(trial.from.after_step(h));
    system->prepare(trial.from.after_step(h), h);
    trial.length = 2e-4;
    trial.angle = 2e-4;
  }
};

}  // namespace hawser::test
