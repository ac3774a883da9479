// The class BodiesInWater: Morison forces on floating bodies and their work, the potential of buoyancy,
// checkpoint records.
#include "hawser/terms/bodies_in_water.hpp"

#include <algorithm>
#include <cmath>

#include "hawser/math/so3.hpp"
#include "hawser/model/case.hpp"
#include "hawser/terms/force_round_off.hpp"
#include "hawser/terms/rigid_bodies.hpp"

namespace hawser {

BodiesInWater::BodiesInWater(const model::Case& c, const LocalMesh& mesh) : sea_(sea_of(c)) {
  for (const model::Body& b : c.bodies)
    has_.push_back(b.mass && (b.mass->in_water || !b.mass->members.empty()));
  for (int n = 0; n < mesh.owned; ++n) {
    Wet b;
    b.node = n;
    b.block = mesh.block[n];
    b.global = mesh.global[n];
    b.body = mesh.mesh->node(b.global).body;
    if (b.body < 0) continue;
    const model::Body& body = c.bodies[b.body];
    const model::BodyMass& m = *body.mass;
    if (!m.in_water && m.members.empty()) continue;
    const size_t first = list_.size();
    if (m.in_water) {
      const model::BodyInWater& w = *m.in_water;
      Wet& wet = list_.emplace_back(b);
      wet.data.centre = w.centre - m.centre;
      wet.data.drag_centre = w.drag_centre - m.centre;
      wet.data.height = w.height;
      wet.data.displaced_mass = sea_.density * w.volume;
      wet.data.buoyancy = sea_.gravity * wet.data.displaced_mass;
      wet.data.added = w.added_mass;
      wet.data.drag = 0.5 * sea_.density * w.drag_area;
    }
    for (const model::BodyMember& member : m.members) add_member(body, member, b);
    for (size_t i = first; i < list_.size(); ++i) list_[i].key = static_cast<int>(i - first);
  }
}

// Divides a member into pieces of half a diameter, at least 4 and at most 50. Each piece becomes wet over its
// height in the upright body, and has its share of the forces of the member:
//   rho/2 Cd D L across, rho/2 Cd pi D²/4 along;   rho Ca pi D²/4 L across, rho Ca pi D³/12 along
void BodiesInWater::add_member(const model::Body& body, const model::BodyMember& m, Wet piece) {
  const Vec3 along = m.to - m.from;
  const double length = along.norm();
  const int pieces = std::clamp(static_cast<int>(std::ceil(2 * length / m.diameter)), 4, 50);
  const double each = length / pieces;
  const double area = 0.25 * M_PI * m.diameter * m.diameter;
  const double rise = std::abs((exp_so3(body.rotation) * along).z()) / length;
  const double drag = 0.5 * sea_.density * m.drag * m.diameter * each;
  const double added = sea_.density * m.added * area * each;
  BodyInWater& data = piece.data;
  data.height = each * rise + m.diameter * std::sqrt(std::max(1 - rise * rise, 0.0));
  data.drag = Vec3(drag, drag, 0.5 * sea_.density * m.axial_drag * area / pieces);
  data.added = Vec3(added, added, sea_.density * m.axial_added * area * m.diameter / (3 * pieces));
  data.cross_flow = true;
  piece.axes = Quat::FromTwoVectors(Vec3::UnitZ(), along);
  for (int i = 0; i < pieces; ++i) {
    const Vec3 centre = m.from + (i + 0.5) / pieces * along - body.mass->centre;
    data.centre = data.drag_centre = piece.axes.conjugate() * centre;
    list_.push_back(piece);
  }
}

RigidBodyState BodiesInWater::body_state(const Wet& b, const Kinematics& state) {
  RigidBodyState s = floating_state(state, b.node);
  s.q = s.q * b.axes;
  s.w = b.axes.conjugate() * s.w;
  s.alpha = b.axes.conjugate() * s.alpha;
  return s;
}

BodiesInWater::Places BodiesInWater::places(const Wet& b, const RigidBodyState& s) {
  return {s.x + s.q * b.data.centre, s.x + s.q * b.data.drag_centre};
}

BodiesInWater::Places BodiesInWater::wave_places(const Wet& b, const Kinematics& state) const {
  const double since = state.time - start_time_;
  if (!(since > 0)) return b.wave_place;
  return {b.start.centre + since * b.speed.centre, b.start.drag + since * b.speed.drag};
}

Water BodiesInWater::water(const Wet& b, const Kinematics& state, const Vec3& x,
                           WaveMotion Wet::*wave) const {
  const Water without_waves = sea_.without_waves_at(x.z(), state.time);
  if (sea_.waves.none() || !state.moves()) return without_waves;
  if (!b.known || b.time != state.time) {
    const Places places = wave_places(b, state);
    b.centre = sea_.waves_at(places.centre, state.time);
    b.drag = places.drag == places.centre ? b.centre : sea_.waves_at(places.drag, state.time);
    b.time = state.time;
    b.known = true;
  }
  return without_waves + b.*wave;
}

BodiesInWater::Flow BodiesInWater::all_forces(const Wet& b, const RigidBodyState& s,
                                              const Kinematics& state) const {
  Flow out;
  out.at = places(b, s);
  out.force = body_water_force(b.data, s, water(b, state, out.at.centre, &Wet::centre),
                               water(b, state, out.at.drag, &Wet::drag));
  return out;
}

BodiesInWater::Flow BodiesInWater::flow(const Wet& b, const Kinematics& state) const {
  const RigidBodyState s = body_state(b, state);
  Flow out = all_forces(b, s, state);
  BodyInWater floating;
  floating.centre = b.data.centre;
  floating.height = b.data.height;
  floating.buoyancy = b.data.buoyancy;
  Water still_water;
  still_water.surface = sea_.surface;
  out.force.at_centre -= body_water_force(floating, s, still_water, still_water).at_centre;
  return out;
}

std::vector<int> BodiesInWater::in_surface(const Kinematics& state) const {
  std::vector<int> out;
  for (const Wet& b : list_) {
    const double z = places(b, body_state(b, state)).centre.z();
    if (!(b.data.buoyancy > 0)) continue;
    if (std::abs(sea_.surface - z) < 0.5 * b.data.height) out.push_back(b.body);
  }
  return out;
}

namespace {

template <class Flow>
double work(const Flow& from, const Flow& to) {
  return 0.5 * ((to.force.at_centre + from.force.at_centre).dot(to.at.centre - from.at.centre) +
                (to.force.at_drag + from.force.at_drag).dot(to.at.drag - from.at.drag));
}

}  // namespace

void BodiesInWater::prepare(const Kinematics& from, double) {
  for (Wet& b : list_) {
    const RigidBodyState s = body_state(b, from);
    b.start = places(b, s);
    if (!from.ends_step() || !b.has_wave_place) {
      b.wave_place = b.start;
      b.has_wave_place = true;
    }
    b.speed = {s.v + s.q * s.w.cross(b.data.centre), s.v + s.q * s.w.cross(b.data.drag_centre)};
    b.known = false;
  }
  start_time_ = from.time;
  // At the start of the motion waves start to act, and accelerations jump.
  for (Wet& b : list_)
    if (!from.ends_step() || !b.flowed) {
      b.flow = flow(b, from);
      b.flowed = true;
    }
}

void BodiesInWater::evaluate(const Kinematics& trial, Assembler& assembler) {
  const bool tangent = assembler.needs_tangent();
  BodyWaterResidual r;
  for (const Wet& b : list_) {
    if (is_held(b.body)) continue;
    const RigidBodyState s = body_state(b, trial);
    const Places at = places(b, s);
    body_water(b.data, s, water(b, trial, at.centre, &Wet::centre), water(b, trial, at.drag, &Wet::drag),
               tangent, assembler.convex(), r);
    // To the axes of the body.
    const Mat3 turn = b.axes.toRotationMatrix();
    r.f.tail<3>() = turn * r.f.tail<3>().eval();
    for (Mat6* m : {&r.K, &r.C, &r.M}) {
      m->bottomRows<3>() = turn * m->bottomRows<3>().eval();
      m->rightCols<3>() = m->rightCols<3>().eval() * turn.transpose();
    }
    const int blocks[2] = {b.block, b.block + 1};
    assembler.add(blocks, r.f, r.K, r.C, r.M);
  }
}

void BodiesInWater::commit(const Kinematics& accepted) {
  for (Wet& b : list_) {
    const Flow now = flow(b, accepted);
    if (accepted.moves() && b.flowed) b.work += work(b.flow, now);
    b.flow = now;
    b.flowed = true;
    b.wave_place = wave_places(b, accepted);
    b.has_wave_place = true;
  }
  start_time_ = accepted.time;
}

// As for lines: in statics, forces without a potential are given the work since the last iteration as
// potential. The force of waves does work.
Energy BodiesInWater::energy(const Kinematics& state) const {
  Energy e;
  for (const Wet& b : list_) {
    e.work += b.work;
    e.by_water += b.work;
    if (is_held(b.body)) continue;
    e.potential += body_water_potential(b.data, body_state(b, state), sea_.surface);
    if (!state.moves() && b.flowed) e.potential -= work(b.flow, flow(b, state));
  }
  return e;
}

double BodiesInWater::dead_load() const {
  double sum = 0;
  for (const Wet& b : list_) sum += b.data.buoyancy;
  return sum;
}

double BodiesInWater::round_off(const Kinematics& state, double h) const {
  if (!(h > 0)) return 0;
  double sum = 0;
  for (const Wet& b : list_) sum += inertia_round_off(b.data.added.maxCoeff(), state.v[b.node].norm(), h);
  return sum;
}

std::vector<std::string> BodiesInWater::load_components(int body) const {
  if (!has_[static_cast<size_t>(body)]) return {};
  return {"morison"};
}

std::vector<BodyForce> BodiesInWater::forces_on(int body, const Kinematics& state) const {
  BodyForce sum;
  bool in_water = false;
  for (const Wet& b : list_) {
    if (b.body != body) continue;
    in_water = true;
    const RigidBodyState s = body_state(b, state);
    const Flow f = all_forces(b, s, state);
    sum.force += f.force.at_centre + f.force.at_drag;
    sum.moment += (f.at.centre - s.x).cross(f.force.at_centre) + (f.at.drag - s.x).cross(f.force.at_drag);
  }
  return in_water ? std::vector<BodyForce>{sum} : std::vector<BodyForce>{};
}

namespace {

struct Kept {
  double work = 0;
  Vec3 centre = Vec3::Zero(), drag = Vec3::Zero();
  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("work", "J", self.work);
    each("waves at the centre of buoyancy", "m", self.centre);
    each("waves at the centre of drag", "m", self.drag);
  }
};

}  // namespace

std::vector<CheckpointKind> BodiesInWater::checkpoint_kinds() const {
  return {checkpoint_kind<Kept>("body in water")};
}

std::vector<CheckpointRecord> BodiesInWater::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> out;
  for (const Wet& b : list_)
    if (range.has(b.global))
      out.push_back(record_of(b.global, b.key, Kept{b.work, b.wave_place.centre, b.wave_place.drag}));
  return out;
}

// The waves of a restored state are those at the stored positions.
void BodiesInWater::restore(const std::vector<CheckpointRecord>& records) {
  for (Wet& b : list_) {
    b.work = 0;
    b.known = b.flowed = b.has_wave_place = false;
    const auto kept = find_entry<Kept>(records, b.global, b.key);
    if (!kept) continue;
    b.work = kept->work;
    b.wave_place = {kept->centre, kept->drag};
    b.has_wave_place = true;
  }
}

}  // namespace hawser
