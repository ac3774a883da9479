// The class BodiesInFlow: forces of wind and current on floating bodies, and their work.
#include "hawser/terms/bodies_in_flow.hpp"

#include <cmath>

#include "hawser/math/so3.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser {

Wind wind_of(const model::Case& c) {
  const model::Wind& w = c.environment.wind;
  Wind out;
  out.mean = w.speed * Vec3(std::cos(w.direction), std::sin(w.direction), 0);
  out.height = w.height;
  out.exponent = w.exponent;
  out.density = w.density;
  out.ramp = w.ramp;
  out.factor = w.time_factor;
  const double at_ten = w.speed * std::pow(10 / w.height, w.exponent);
  out.gusts = gusts(w.gusts, w.speed, at_ten, w.height, w.components, w.seed);
  out.gust_ramp = w.gust_ramp;
  return out;
}

BodiesInFlow::BodiesInFlow(const model::Case& c, const LocalMesh& mesh) : sea_(sea_of(c)), wind_(wind_of(c)) {
  load_components_.resize(c.bodies.size());
  for (size_t b = 0; b < c.bodies.size(); ++b) {
    if (!c.bodies[b].mass) continue;
    if (c.bodies[b].mass->wind) load_components_[b].push_back("wind");
    if (c.bodies[b].mass->current) load_components_[b].push_back("current");
  }
  for (int n = 0; n < mesh.owned; ++n) {
    const int body = mesh.node(n).body;
    if (body < 0) continue;
    if (c.bodies[body].mass->wind) add(c, body, n, mesh, true);
    if (c.bodies[body].mass->current) add(c, body, n, mesh, false);
  }
}

void BodiesInFlow::add(const model::Case& c, int body, int node, const LocalMesh& mesh, bool air) {
  const model::BodyMass& m = *c.bodies[body].mass;
  const model::FlowOnBody& given = air ? *m.wind : *m.current;
  Flow& f = list_.emplace_back();
  f.data.coefficients = given.coefficients;
  f.data.density = air ? wind_.density : sea_.density;
  f.data.frontal = given.frontal;
  f.data.lateral = given.lateral;
  f.data.length = given.length;
  f.data.arm = given.at - m.centre;
  f.air = air;
  f.height = given.height;
  f.node = node;
  f.block = mesh.block[node];
  f.global = mesh.global[node];
  f.body = body;
}

// Gusts act in dynamics only.
FlowVelocity BodiesInFlow::velocity(const Flow& f, const Kinematics& state, const RigidBodyState& s) const {
  FlowVelocity out;
  if (f.air) {
    out.velocity = wind_.steady(f.height, state.time);
    if (state.moves()) out.velocity += wind_.gust(state.time);
    return out;
  }
  const Water without_waves = sea_.without_waves_at((s.x + s.q * f.data.arm).z(), state.time);
  out.velocity = without_waves.velocity;
  out.by_height = without_waves.by_height;
  return out;
}

BodiesInFlow::Push BodiesInFlow::push(const Flow& f, const Kinematics& state) const {
  const RigidBodyState s = floating_state(state, f.node);
  const Vec3 c = relative_flow(f.data, s, velocity(f, state, s).velocity);
  const Vec3 force = flow_force(f.data, c.x(), c.y()).force;
  return {s.q * Vec3(force.x(), force.y(), 0), s.x + s.q * f.data.arm, Vec3(0, 0, force.z()), s.q};
}

std::vector<std::string> BodiesInFlow::load_components(int body) const {
  return load_components_[static_cast<size_t>(body)];
}

std::vector<BodyForce> BodiesInFlow::forces_on(int body, const Kinematics& state) const {
  std::vector<BodyForce> out;
  for (const Flow& f : list_) {
    if (f.body != body) continue;
    const Push p = push(f, state);
    out.push_back({p.force, p.turned * (f.data.arm.cross(p.turned.conjugate() * p.force) + p.moment)});
  }
  return out;
}

double BodiesInFlow::work(const Push& from, const Push& to) {
  const Vec3 turn = log_so3(from.turned.conjugate() * to.turned);
  return 0.5 * ((from.force + to.force).dot(to.place - from.place) + (from.moment + to.moment).dot(turn));
}

void BodiesInFlow::prepare(const Kinematics& from, double) {
  for (Flow& f : list_)
    if (!from.ends_step() || !f.pushed) {
      f.push = push(f, from);
      f.pushed = true;
    }
}

void BodiesInFlow::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (const Flow& f : list_) {
    if (is_held(f.body)) continue;
    const RigidBodyState s = floating_state(trial, f.node);
    const BodyFlowResidual r = body_flow(f.data, s, velocity(f, trial, s));
    const int blocks[2] = {f.block, f.block + 1};
    assembler.add(blocks, r.f, r.K, r.C);
  }
}

void BodiesInFlow::commit(const Kinematics& accepted) {
  for (Flow& f : list_) {
    const Push now = push(f, accepted);
    if (accepted.moves() && f.pushed) f.work += work(f.push, now);
    f.push = now;
    f.pushed = true;
  }
}

// In statics, forces without a potential are given the work since the last iteration as potential.
Energy BodiesInFlow::energy(const Kinematics& state) const {
  Energy e;
  for (const Flow& f : list_) {
    e.work += f.work;
    e.by_water += f.work;
    if (!is_held(f.body) && !state.moves() && f.pushed) e.potential -= work(f.push, push(f, state));
  }
  return e;
}

std::vector<CheckpointKind> BodiesInFlow::checkpoint_kinds() const {
  return {checkpoint_kind<WorkDone>("wind on a body"), checkpoint_kind<WorkDone>("current on a body")};
}

std::vector<CheckpointRecord> BodiesInFlow::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> out;
  for (const Flow& f : list_)
    if (range.has(f.global)) out.push_back(record_of(f.global, 0, WorkDone{f.work}, f.air ? 0 : 1));
  return out;
}

// prepare() evaluates the forces of the restored state.
void BodiesInFlow::restore(const std::vector<CheckpointRecord>& records) {
  for (Flow& f : list_) {
    f.work = 0;
    f.pushed = false;
    const auto kept = find_entry<WorkDone>(records, f.global, 0, f.air ? 0 : 1);
    if (kept) f.work = kept->work;
  }
}

}  // namespace hawser
