// The class HeldBodies: bodies held in given poses with attached lines in equilibrium.
#include "hawser/run/held_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/advice/hulls.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/farm.hpp"
#include "hawser/model/platform_periods.hpp"
#include "hawser/record/end_forces.hpp"
#include "hawser/terms/dynamic_positioning.hpp"
#include "hawser/terms/run_roles.hpp"

namespace hawser::run {
namespace {

// Largest displacement of an end per increment, relative to the shortest line.
constexpr double kStep = 0.005;

// Ties of the nodes of these bodies of the case.
std::vector<TiedNode> with_bodies(const Simulation& sim, std::vector<TiedNode> all,
                                  const std::vector<int>& bodies) {
  for (const int b : bodies) {
    const int n = sim.local().find(sim.mesh().body_node(b));
    if (n < 0) continue;
    TiedNode held;
    held.node = n;
    held.body = b;
    held.at = sim.model().bodies[static_cast<size_t>(b)].mass->centre;
    held.rotation_mask = 7;
    all.push_back(held);
  }
  return all;
}

// Ties without those of bodies with mass, on the current ghost nodes.
std::vector<TiedNode> without_bodies(Simulation& sim) {
  std::vector<TiedNode> out;
  for (const TiedNode& tied : sim.system().tied_nodes().nodes())
    if (sim.local().node(tied.node).body < 0) out.push_back(tied);
  return out;
}

std::vector<int> with_mass(const model::Case& c) {
  std::vector<int> out;
  for (size_t b = 0; b < c.bodies.size(); ++b)
    if (c.bodies[b].mass) out.push_back(static_cast<int>(b));
  return out;
}

// Position and rotation of a body with mass, the same on all ranks.
RigidPose pose_at_rest(Simulation& sim, int body) {
  std::vector<double> pose(7, 0);
  if (const auto own = sim.body_pose(body, sim.state().at_rest())) {
    Eigen::Map<Vec3>(pose.data()) = own->position;
    Eigen::Map<Eigen::Vector4d>(pose.data() + 3) = own->rotation.coeffs();
  }
  all_reduce(sim.system().comm(), MPI_SUM, pose);
  RigidPose p;
  p.position = Vec3(pose.data());
  p.rotation = Quat(Eigen::Vector4d(pose.data() + 3)).normalized();
  return p;
}

}  // namespace

void hold_body(Simulation& sim, int body) {
  System& system = sim.system();
  const RigidPose start = sim.bodies().pose(body, 0);
  const BodyMotion before = system.tied_nodes().motion();
  system.tie(with_bodies(sim, system.tied_nodes().nodes(), {body}),
             [=](int b, double time) { return b == body ? start : before(b, time); });
}

std::vector<std::string> periods_on_lines(Simulation& sim) {
  System& system = sim.system();
  const model::Case& c = sim.model();
  const Kinematics at = sim.state().at_rest();
  const std::vector<TiedNode> free = system.tied_nodes().nodes();
  const BodyMotion motion = system.tied_nodes().motion();
  auto* thrusters = system.find<DynamicPositioning>();
  if (thrusters) thrusters->integrate_at_rest(false);
  const std::vector<int> bodies = with_mass(c);
  const std::vector<TiedNode> held = with_bodies(sim, free, bodies);
  std::vector<std::string> out;
  for (const int b : bodies) {
    const model::Body& body = c.bodies[static_cast<size_t>(b)];
    if (!body.mass->hydrodynamics || model::line_ends_at(c, body).empty()) continue;
    if (model::is_repeated(c, body.name)) continue;
    Mat6 axes = Mat6::Identity();
    axes.topLeftCorner<3, 3>() = pose_at_rest(sim, b).rotation.toRotationMatrix();
    try {
      const Mat6 K = body_stiffness(system, at, sim.mesh().body_node(b), free, held).K;
      out.push_back(
          advice::periods_on_lines(body.name, model::platform_modes(body, axes.transpose() * K * axes)));
    } catch (const SolveError& no_stiffness) {
      out.push_back(advice::no_periods_on_lines(body.name, no_stiffness.what()));
    }
  }
  if (thrusters) thrusters->integrate_at_rest(true);
  system.tie(free, motion);
  return out;
}

HeldBodies::HeldBodies(Simulation& sim)
    : sim_(sim), poses_(std::make_shared<std::vector<RigidPose>>(sim.model().bodies.size())) {
  System& system = sim_.system();
  const model::Case& c = sim_.model();
  for (size_t b = 0; b < c.bodies.size(); ++b) {
    if (!c.bodies[b].mass) continue;
    (*poses_)[b] = pose_at_rest(sim_, static_cast<int>(b));
  }
  for (AppliesExternalLoad* term : system.with<AppliesExternalLoad>())
    system.remove(dynamic_cast<const ForceTerm*>(term));
  motion_ = [poses = poses_, before = BodyMotion(system.tied_nodes().motion()), &c](int body, double time) {
    return c.bodies[static_cast<size_t>(body)].mass ? (*poses)[static_cast<size_t>(body)]
                                                    : before(body, time);
  };
  system.tie(with_bodies(sim_, without_bodies(sim_), with_mass(c)), motion_);
}

void HeldBodies::solve() { sim_.solve_statics(); }

// Number of increments such that no line end on the body moves by more than kStep of the shortest of these
// lines.
int HeldBodies::steps_to(int body, const RigidPose& target) const {
  const model::Case& c = sim_.model();
  const RigidPose& from = pose(body);
  double shortest = HUGE_VAL, distance = 0;
  for (const auto& [line, end] : model::line_ends_at(c, c.bodies[static_cast<size_t>(body)])) {
    shortest = std::min(shortest, model::length_of(line));
    distance = std::max(distance, (target.to_space(end.at) - from.to_space(end.at)).norm());
  }
  return std::max(1, static_cast<int>(std::ceil(distance / (kStep * shortest))));
}

// Moves line nodes with their ends, in proportion to arc length.
void HeldBodies::move(int body, const RigidPose& target) {
  const model::Case& c = sim_.model();
  const LocalMesh& local = sim_.local();
  RigidPose& pose_now = (*poses_)[static_cast<size_t>(body)];
  const auto displacement = [&](const model::End& e) {
    const bool moves = e.kind == model::EndKind::body && c.body_index(e.carrier) == body;
    return moves ? Vec3(target.to_space(e.at) - pose_now.to_space(e.at)) : Vec3(Vec3::Zero());
  };
  State& state = sim_.state();
  for (int n = 0; n < local.nodes(); ++n) {
    const Node& node = local.node(n);
    const auto i = static_cast<size_t>(n);
    if (node.body == body) {
      state.x[i] = target.to_space(c.bodies[static_cast<size_t>(body)].mass->centre);
      state.q[i] = target.rotation;
    }
    if (node.body >= 0) continue;
    const model::Line& line = c.lines[static_cast<size_t>(node.line)];
    const double fraction =
        std::clamp(node.arc / sim_.mesh().lines[static_cast<size_t>(node.line)].length, 0.0, 1.0);
    state.x[i] += (1 - fraction) * displacement(line.end_a) + fraction * displacement(line.end_b);
  }
  pose_now = target;
  sim_.system().tied_nodes().move_with_frames(state);
}

void HeldBodies::put(int body, const RigidPose& target) {
  const RigidPose from = pose(body);
  const Vec3 turn = log_so3(from.rotation.conjugate() * target.rotation);
  const int steps = steps_to(body, target);
  for (int k = 1; k <= steps; ++k) {
    const double fraction = static_cast<double>(k) / steps;
    RigidPose next = target;
    if (k < steps) {
      next.position = from.position + fraction * (target.position - from.position);
      next.rotation = from.rotation * exp_so3(fraction * turn);
    }
    move(body, next);
    solve();
  }
}

BodyStiffness HeldBodies::stiffness(int body) {
  System& system = sim_.system();
  system.update_couplings(sim_.state().at_rest(), 0);
  system.update_ghosts(sim_.state());
  const std::vector<TiedNode> free = without_bodies(sim_);
  return body_stiffness(system, sim_.state().at_rest(), sim_.mesh().body_node(body), free,
                        with_bodies(sim_, free, with_mass(sim_.model())));
}

// Tensions at the middle of elements, and at the ends, which carry half an element's weight more.
std::vector<double> HeldBodies::tensions() const {
  const Kinematics at = sim_.state().at_rest();
  std::vector<double> out;
  for (const LineTension& t : sim_.system().line_tensions(at)) out.push_back(t.tension);
  record::EndForces ends(sim_.system());
  const std::vector<Vec3> nothing(static_cast<size_t>(sim_.local().nodes()), Vec3::Zero());
  ends.evaluate(at, nothing);
  for (const record::EndForces::SectionNode& p : ends.places())
    if (p.line_end) {
      double& largest = out[static_cast<size_t>(p.line)];
      largest = std::max(largest, p.at_line_end().tension());
    }
  all_reduce(sim_.system().comm(), MPI_MAX, out);
  return out;
}

}  // namespace hawser::run
