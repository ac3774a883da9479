// The class RigidBodies: inertia, weight, springs and dampers of floating bodies as a force term, their
// energy and work, and conversion between centre of mass and body frame. The equations of one body are in
// kernels/rigid_body.cpp. Ends of lines tied to a body are in system/tied_nodes.hpp.
#include "hawser/terms/rigid_bodies.hpp"

#include "hawser/kernels/spring_matrices.hpp"
#include "hawser/math/broken_line.hpp"
#include "hawser/terms/force_round_off.hpp"

namespace hawser {

RigidBodyData RigidBodies::data(const Floating& f) const {
  RigidBodyData d = f.data;
  if (!is_held(f.body)) return d;
  for (int i = 0; i < 3; ++i) {
    // The buoyancy of a hull carries the body and keeps it upright.
    const bool carried = f.has_hull && i == 2;
    const bool upright = f.has_hull && i < 2;
    if (!(d.stiffness[i] > 0) && !carried) {
      d.stiffness[i] = d.mass;
      d.weight[i] = 0;
    }
    if (!(d.turning_stiffness[i] > 0) && !upright) d.turning_stiffness[i] = d.inertia(i, i);
  }
  return d;
}

RigidBodyState floating_start(const model::BodyMass& mass, const RigidPose& pose) {
  RigidBodyState s;
  s.x = pose.to_space(mass.centre);
  s.q = pose.rotation;
  s.v = mass.velocity;
  s.w = mass.angular_velocity;
  return s;
}

RigidPose floating_pose(const RigidBodyState& s, const Vec3& centre) {
  RigidPose p;
  p.rotation = s.q;
  p.position = s.x - s.q * centre;
  p.angular_velocity = s.q * s.w;
  p.angular_acceleration = s.q * s.alpha;
  p.velocity = s.v + p.angular_velocity.cross(p.position - s.x);
  p.acceleration = s.a + p.angular_acceleration.cross(p.position - s.x) +
                   p.angular_velocity.cross(p.angular_velocity.cross(p.position - s.x));
  return p;
}

RigidBodyState floating_state(const Kinematics& state, int node) {
  return {state.x[node], state.q[node], state.v[node], state.a[node], state.w[node], state.alpha[node]};
}

namespace {

// Natural frequency [rad/s] of the spring that prevents drift of a body in statics in directions without
// resistance. Its force is zero at the start of each Newton iteration, so it does not affect the equilibrium.
constexpr double kDrift = 0.01;

// True if inertia is the change of the momenta over the step.
bool by_momenta(const Kinematics& state) { return state.moves() && state.mean.over_step(); }

}  // namespace

RigidBodies::RigidBodies(const model::Case& c, const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies)
    : bodies_(std::move(bodies)), scheme_(AlphaCoefficients(c.dynamics.rho_infinity)) {
  for (int n = 0; n < mesh.owned; ++n) {
    const int global = mesh.global[n];
    const int body = mesh.mesh->node(global).body;
    if (body < 0) continue;
    const model::BodyMass& m = *c.bodies[body].mass;
    Floating f;
    f.data.mass = m.mass;
    f.data.inertia = m.tensor();
    f.data.coupled = m.coupled;
    if (m.weight) f.data.weight = -m.mass * c.environment.gravity * Vec3::UnitZ();
    f.data.stiffness = m.stiffness;
    f.data.damping = m.damping;
    f.data.turning_stiffness = m.turning_stiffness;
    f.data.turning_damping = m.turning_damping;
    f.data.matrices = {m.stiffness_matrix, m.damping_matrix, -m.centre};
    for (const model::BodyLoad& l : m.loads)
      f.loads.push_back({{l.force, l.moment, l.at - m.centre, l.body_fixed, l.table.empty()}, l.table});
    f.has_hull = static_cast<bool>(m.hull);
    f.centre = m.centre;
    f.body = body;
    f.node = n;
    f.global = global;
    f.block = mesh.block[n];
    list_.push_back(f);
  }
}

RigidBodyLoad RigidBodies::Load::at(double time) const {
  RigidBodyLoad out = constant;
  if (table.empty()) return out;
  const Vec6 more = on_broken_line(table, time);
  out.force += more.head<3>();
  out.moment += more.tail<3>();
  return out;
}

// Pose and velocity of the centre of mass for the prescribed motion of the body.
RigidPose RigidBodies::spring_rest(const Floating& f, double time) const {
  RigidPose p = bodies_->pose(f.body, time);
  const Vec3 x = p.to_space(f.centre);
  p.velocity = p.velocity_at(x);
  p.position = x;
  return p;
}

void RigidBodies::powers(const Floating& f, const Kinematics& state, double& damping, double& work) const {
  const RigidBodyState s = floating_state(state, f.node);
  const RigidPose r = spring_rest(f, state.time);
  const Vec3 dv = s.v - r.velocity;
  const Vec3 dw = s.w - s.q.conjugate() * r.angular_velocity;
  const SpringMatrixForces full = spring_matrix_forces(f.data.matrices, s, r);
  damping = dv.dot(f.data.damping.cwiseProduct(dv)) + dw.dot(f.data.turning_damping.cwiseProduct(dw)) +
            full.dissipated;
  // The support supplies the power of its force on the springs and dampers at their far end.
  const Vec6 force = rigid_body(f.data, s, r).springs - full.f;
  work = full.supplied - force.head<3>().dot(r.velocity) - (s.q * force.tail<3>()).dot(r.angular_velocity);
  for (const Load& l : f.loads) work += load_power(l.at(state.time), s);
}

// At the start or restart of motion the momenta change by the accelerations.
void RigidBodies::prepare(const Kinematics& from, double) {
  for (Floating& f : list_) {
    powers(f, from, f.damping_power, f.work_power);
    f.start = floating_state(from, f.node);
    if (!from.ends_step()) f.momenta.q = f.momenta.f = momentum_rate(f.data, f.start);
  }
}

RigidBodyResidual RigidBodies::residual(const Floating& f, const RigidBodyState& s, const Kinematics& trial,
                                        bool step) const {
  if (!step) return rigid_body(data(f), s, spring_rest(f, trial.time));
  RigidBodyResidual r = rigid_body(without_momentum(f.data), s, spring_rest(f, trial.time));
  add_momentum(momentum_matrix(f.data), scheme_, trial.step, f.start, f.momenta, s, r);
  return r;
}

void RigidBodies::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (const Floating& f : list_) {
    const RigidBodyState s = floating_state(trial, f.node);
    RigidBodyResidual r = residual(f, s, trial, by_momenta(trial));
    if (!is_held(f.body))
      for (const Load& l : f.loads) add_load(l.at(trial.time), s, r);
    const int blocks[2] = {f.block, f.block + 1};
    assembler.add(blocks, r.inertia, r.K, r.C, r.M);
    if (in_statics() && !is_held(f.body) && assembler.needs_tangent()) {
      Mat6 K = Mat6::Zero();
      K.topLeftCorner<3, 3>() = kDrift * kDrift * f.data.mass * Mat3::Identity();
      K.bottomRightCorner<3, 3>() = kDrift * kDrift * f.data.inertia;
      assembler.add(blocks, {}, K);
    }
    if (!assembler.needs_force()) continue;
    assembler.add(blocks, r.applied);
    assembler.add(blocks, r.springs);
  }
}

std::array<Vec3, 2> RigidBodies::force_on(int body, const Kinematics& state) const {
  for (const Floating& f : list_) {
    if (f.body != body) continue;
    const RigidBodyState s = floating_state(state, f.node);
    const bool step = by_momenta(state);
    RigidBodyResidual r = rigid_body(step ? without_momentum(f.data) : f.data, s, spring_rest(f, state.time));
    for (const Load& l : f.loads) add_load(l.at(state.time), s, r);
    const Vec6 inertia = r.f();
    const Vec6 momenta = step ? f.momenta.f : Vec6(Vec6::Zero());
    return {inertia.head<3>() + momenta.head<3>(), s.q * inertia.tail<3>() + momenta.tail<3>()};
  }
  return {Vec3::Zero(), Vec3::Zero()};
}

void RigidBodies::commit(const Kinematics& accepted) {
  if (!accepted.moves()) return;
  for (Floating& f : list_) {
    double damping = 0, work = 0;
    powers(f, accepted, damping, work);
    advance_momentum(momentum_matrix(f.data), scheme_, accepted.step, f.start,
                     floating_state(accepted, f.node), f.momenta);
    f.damping += 0.5 * accepted.step * (damping + f.damping_power);
    f.work += 0.5 * accepted.step * (work + f.work_power);
  }
}

Energy RigidBodies::energy(const Kinematics& state) const {
  Energy e;
  for (const Floating& f : list_) {
    const RigidBodyState s = floating_state(state, f.node);
    e.kinetic += rigid_body_kinetic(f.data, s);
    const RigidBodyData d = data(f);
    e.strain += rigid_body_strain(d, s, spring_rest(f, state.time));
    e.potential -= d.weight.dot(s.x);
    for (const Load& load : f.loads) {
      const RigidBodyLoad l = load.at(state.time);
      if (l.constant) e.potential += load_potential(l, s);
      // Statics needs a potential: that of the forces at the last iteration. In motion they do work.
      if (in_statics()) e.potential -= load_work(l, f.start, s);
    }
    e.damping += f.damping;
    e.work += f.work;
  }
  return e;
}

double RigidBodies::dead_load() const {
  double sum = 0;
  for (const Floating& f : list_) {
    sum += f.data.weight.norm();
    for (const Load& l : f.loads) sum += l.at(0).force.norm();
  }
  return sum;
}

// As for lines: accelerations have the round-off of v h divided by h², springs that of positions.
double RigidBodies::round_off(const Kinematics& state, double h) const {
  double sum = 0;
  for (const Floating& f : list_) {
    const size_t n = f.node;
    const RigidBodyData d = data(f);
    const Vec6 full = d.matrices.stiffness.diagonal();
    sum += spring_round_off((d.stiffness + full.head<3>()).maxCoeff(), state.x[n].norm());
    sum += spring_round_off((d.turning_stiffness + full.tail<3>()).maxCoeff(), 1);
    if (!(h > 0)) continue;
    const double coupled = f.data.coupled.topLeftCorner<3, 3>().cwiseAbs().maxCoeff();
    sum += inertia_round_off(f.data.mass + coupled, state.v[n].norm(), h);
    sum += inertia_round_off(f.data.inertia.diagonal().maxCoeff(), state.w[n].norm(), h);
  }
  return sum;
}

std::vector<CheckpointKind> RigidBodies::checkpoint_kinds() const {
  return {checkpoint_kind<Floating>("sums of a body")};
}

std::vector<CheckpointRecord> RigidBodies::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> out;
  for (const Floating& f : list_)
    if (range.has(f.global)) out.push_back(record_of(f.global, 0, f));
  return out;
}

void RigidBodies::restore(const std::vector<CheckpointRecord>& records) {
  for (Floating& f : list_) {
    const auto kept = find_entry<Floating>(records, f.global);
    if (!kept) continue;
    f.damping = kept->damping;
    f.work = kept->work;
    f.momenta = kept->momenta;
  }
}

}  // namespace hawser
