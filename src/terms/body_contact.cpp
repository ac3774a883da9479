// The class BodyContact: pairs of volumes, contact forces and tangent summed over points and edges,
// energies. Slip and history are in body_contact_friction.cpp, step limits in body_contact_step_limits.cpp.
#include "hawser/terms/body_contact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "body_contact_points.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/body_pairs.hpp"
#include "hawser/terms/axis_distance.hpp"
#include "hawser/terms/contact_laws.hpp"
#include "hawser/terms/force_round_off.hpp"

namespace hawser {
namespace {

constexpr double kSmoothing = 1e-3;      // fraction of the size of the slave volume
constexpr double kMostSmoothing = 0.01;  // m
constexpr double kDeepestAtOnce = 0.05;  // fraction of that size; further limited by thin volumes
constexpr int kEdgeLevels = 5;           // resolution of an edge: 1/32 of its length

AxisShape chord(const BodyFrame& body, const Vec3& from, const Vec3& to) {
  AxisEnds e;
  e.beam = false;
  e.x1 = body.to_space(from);
  e.x2 = body.to_space(to);
  return AxisShape(e);
}

}  // namespace

BodyContact::BodyContact(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
                         std::shared_ptr<const Bodies> bodies, std::vector<BodyVolume> volumes)
    : comm_(comm), mesh_(mesh), bodies_(std::move(bodies)), volumes_(std::move(volumes)) {
  if (volumes_.size() != c.volumes.size()) throw std::invalid_argument("body contact needs all volumes");
  for (const model::Volume& v : c.volumes) {
    PairBody s;
    s.body = c.body_index(v.body);
    if (s.body >= 0 && c.bodies[s.body].mass) {
      const model::BodyMass& m = *c.bodies[s.body].mass;
      s.centre = m.centre;
      s.mass = m.mass;
      s.inertia = m.tensor();
      s.global = mesh.mesh->body_node(s.body);
    }
    bodies_of_volumes_.push_back(s);
    names_.push_back("volume " + v.name + (v.body.empty() ? "" : " of body " + v.body));
  }
  for (const BodyVolume& v : volumes_) boxes_.push_back(v.surface->bounds());
  for (const model::BodyPair& p : model::body_pairs(c)) {
    const model::Volume& v = c.volumes[p.a];
    Pair pair;
    pair.a = p.a;
    pair.b = p.b;
    pair.force_factor = p.force_factor;
    pair.needs_overlap_check = p.needs_overlap_check;
    pair.basis = v.basis;
    pair.lower_counts = v.basis == c.volumes[p.b].basis;
    pair.mass = 1 / (1 / bodies_of_volumes_[p.a].mass + 1 / bodies_of_volumes_[p.b].mass);
    pair.size = boxes_[p.a].extent().maxCoeff();  // a plane is never the slave
    pair.round = std::min(kSmoothing * pair.size, kMostSmoothing);
    pair.max_approach = kDeepestAtOnce * pair.size;
    for (const auto& [i, first] : {std::pair(p.a, 0), std::pair(p.b, 6)}) {
      const Vec3 e = boxes_[i].extent();
      if (e.allFinite() && e.minCoeff() > 0)
        pair.max_approach = std::min(pair.max_approach, 0.5 * e.minCoeff());
      const PairBody& body = bodies_of_volumes_[i];
      if (body.global < 0) continue;
      pair.root.block<3, 3>(first, first) = Mat3::Identity() / std::sqrt(body.mass);
      pair.root.block<3, 3>(first + 3, first + 3) = Mat3(body.inertia.inverse()).llt().matrixL();
    }
    // Effective mass per point, per length or per area: the whole mass divided by the size or its square.
    const double units = v.basis == model::StiffnessBasis::per_point    ? 1
                         : v.basis == model::StiffnessBasis::per_length ? pair.size
                                                                        : pair.size * pair.size;
    // If the other volume is softer, the stiffness of the pair is that of the other volume.
    pair.law = normal_law(v, p.stiffness / v.normal_stiffness, pair.round, pair.mass / units);
    pair.friction = friction_law(p.friction, 1, pair.size);
    if (p.friction.mobilisation_length == 0 && p.friction.shear_stiffness == 0)
      pair.friction.stiffness = pair.law.stiffness;
    // Tangential damping c = 2 zeta sqrt(k m), like the normal damping.
    pair.friction.damping = pair.law.damping / std::sqrt(pair.law.stiffness);
    if (!pairs_.empty() && pairs_.back().a == pair.b && pairs_.back().b == pair.a) {
      pair.other = static_cast<int>(pairs_.size()) - 1;
      pairs_.back().other = static_cast<int>(pairs_.size());
    }
    pairs_.push_back(pair);
  }
  renumber();
}

void BodyContact::list_couplings(Couplings& to) const {
  for (const Pair& p : pairs_) {
    const int a = bodies_of_volumes_[p.a].global;
    const int b = bodies_of_volumes_[p.b].global;
    if (a >= 0 && b >= 0 && (mesh_.owns_node(a) || mesh_.owns_node(b))) to.add({a, a}, {b, b});
  }
}

void BodyContact::renumber() {
  for (PairBody& s : bodies_of_volumes_) {
    s.node = s.global < 0 ? -1 : mesh_.find(s.global);
    s.block = s.node < 0 ? -1 : mesh_.block[s.node];
  }
  for (Pair& p : pairs_) {
    const PairBody& a = bodies_of_volumes_[p.a];
    const PairBody& b = bodies_of_volumes_[p.b];
    p.owns_body = owned(a) || owned(b);
    p.counted = a.global >= 0 ? owned(a) : owned(b);
  }
}

Vec3 BodyContact::PairFrames::turned_since(const PairFrames& start) const {
  return log_so3(Quat(Mat3(turn() * start.turn().transpose())));
}

BodyFrame BodyContact::frame(size_t volume, const Kinematics& state) const {
  const PairBody& s = bodies_of_volumes_[volume];
  if (s.global < 0) {
    const RigidPose p = bodies_->pose(s.body, state.time);
    const Mat3 R = p.rotation.toRotationMatrix();
    const Mat3 back = R.transpose();
    return {s.centre,
            p.position,
            R,
            p.velocity,
            p.acceleration,
            back * p.angular_velocity,
            back * p.angular_acceleration};
  }
  const size_t n = s.node;
  return {s.centre,   state.x[n],    state.q[n].toRotationMatrix(), state.v[n], state.a[n],
          state.w[n], state.alpha[n]};
}

BodyContact::PairFrames BodyContact::frames_of(const Pair& pair, const Kinematics& state) const {
  return {frame(pair.a, state), frame(pair.b, state)};
}

bool BodyContact::near(size_t volume, const Vec3& centre, double radius, double gap) const {
  const double reach = radius + gap;
  const double within = std::max(reach, 0.0);
  if (squared_distance(boxes_[volume], centre) > within * within) return false;
  const auto s = volumes_[volume].surface->query(centre, within);
  return s && s->distance <= reach;
}

void BodyContact::contact_of_edge(const Pair& pair, const PairFrames& at, const RigidPose& pose,
                                  const SkeletonPart& e, const AxisContactMode& mode,
                                  const Slipping& friction, BodyContactPoints& points) const {
  const Surface& surface = *volumes_[pair.b].surface;
  const double contact_distance = e.radius + pair.law.smoothing;
  const double length = (e.to - e.from).norm();
  const double weight = pair.force_factor * length;
  const AxisShape shape = chord(at.A, e.from, e.to);
  const auto place = [&](double xi) { return points.place(e.place(xi)); };
  ContactQuadrature contact;
  auto gap = axis_distance(surface, pose, shape, contact_distance);
  contact.add_panels(split_intervals(contact_intervals(gap, {length}, kEdgeLevels), kEdgeLevels), 0, weight,
                     [&](double xi) { return surface.query(place(xi), contact_distance); });
  const Vec3 slope = place(1) - place(0);
  // Derivative of a panel's end by the bodies' motion; nullopt if the edge is parallel to the surface.
  const auto moving_end = [&](double xi) -> std::optional<Vec6> {
    const Vec3 z = place(xi);
    const auto p = surface.query(z, contact_distance + 1e-9);
    if (!p || std::abs(p->normal.dot(slope)) < 1e-9 * length) return std::nullopt;
    return points.end_by_motion(z, p->normal, slope);
  };
  const ContactLaw law{pair.law, friction.law};
  const bool with_ends = mode.tangent && !mode.convex;
  std::vector<BodyFrictionPoint> touching;
  std::array<std::optional<Vec6>, 2> ends;
  for (size_t i = 0; i < contact.quadrature.size(); ++i) {
    const QuadraturePoint& q = contact.quadrature[i];
    const ContactPanel& panel = contact.panels[q.panel];
    if (with_ends && (i == 0 || contact.quadrature[i - 1].panel != q.panel))
      ends = {panel.from_moves ? moving_end(panel.from) : std::nullopt,
              panel.to_moves ? moving_end(panel.to) : std::nullopt};
    std::array<BodyContactPoints::MovingEnd, 2> moving;
    size_t n = 0;
    const double span = panel.to - panel.from;
    for (size_t k = 0; k < 2; ++k)
      if (ends[k])
        moving[n++] = {*ends[k], weight * q.in_panel.length_by_end(k == 1),
                       weight * span * q.in_panel.weight * q.in_panel.xi_by_end(k == 1)};
    ContactRates rates;
    const ContactStart start =
        friction.law.active() ? start_of(pair, at, e, q.xi, n > 0 ? &rates : nullptr) : ContactStart();
    const Vec3 z = place(q.xi);
    const AxisContactPoint point = points.add(law, start, q.surface, z, e.radius, q.weight);
    if (friction.eighths) add_resultant(pair, e.place(q.xi), z, e.radius, point, *friction.eighths);
    if (friction.damping) add_damping_work(pair, e.place(q.xi), z, point, *friction.damping);
    if (friction.pressed) add_pressed(pair, e.place(q.xi), e.radius, q.surface, *friction.pressed);
    if (n > 0)
      points.add_moving_ends(law, start, q.surface, z, e.radius, point, slope, rates,
                             std::span(moving).first(n));
    if (friction.points && point.elastic_force() > 0)
      touching.push_back(
          {q.xi, panel.from, panel.to, point.weight, point.slip, point.normal, point.friction, point.peak});
  }
  if (friction.points) friction.points->add(volumes_[pair.a].skeleton.features.index(e), touching);
}

BodyContact::Sum BodyContact::contact(const Pair& pair, const PairFrames& at, const AxisContactMode& mode,
                                      const Slipping& friction) const {
  const BodyFrame& A = at.A;
  const BodyFrame& B = at.B;
  RigidPose pose;  // of the surface
  pose.position = B.to_space(Vec3::Zero());
  pose.rotation = Quat(B.R);
  Sum sum;
  sum.residual.f = Vec12::Zero();
  const bool slips = friction.law.active();
  BodyContactPoints points(A, B, slips ? at.turned_since(pair.frames) : Vec3(Vec3::Zero()), friction.step,
                           mode);
  const auto point = [&](const SkeletonPart& p) {
    const Vec3 z = points.place(p.from);
    const auto s = volumes_[pair.b].surface->query(z, p.radius + pair.law.smoothing);
    if (!s) return;
    const ContactStart start = slips ? start_of(pair, at, p, 0, nullptr) : ContactStart();
    const AxisContactPoint at_point =
        points.add({pair.law, friction.law}, start, *s, z, p.radius, pair.force_factor * p.weight);
    if (friction.eighths) add_resultant(pair, p.from, z, p.radius, at_point, *friction.eighths);
    if (friction.damping) add_damping_work(pair, p.from, z, at_point, *friction.damping);
    if (friction.pressed) add_pressed(pair, p.from, p.radius, *s, *friction.pressed);
    if (!friction.points || !(at_point.normal_force > 0)) return;
    const BodyFrictionPoint touching_point{
        0, 0, 0, at_point.weight, at_point.slip, at_point.normal, at_point.friction, at_point.peak};
    friction.points->add(volumes_[pair.a].skeleton.features.index(p), {&touching_point, 1});
  };
  volumes_[pair.a].skeleton.features.walk(
      [&](const Vec3& y, double r) { return near(pair.b, at.across(y), r, pair.law.smoothing); },
      [&](const SkeletonPart& p) {
        if (p.from == p.to)
          point(p);
        else
          contact_of_edge(pair, at, pose, p, mode, friction, points);
      });
  sum.active = points.active();
  sum.potential = points.potential();
  sum.depth = points.depth();
  sum.touching = points.touching();
  if (!sum.active) return sum;
  BlockVector f = BlockVector::Zero(6);
  BlockMatrix K, C;
  if (mode.tangent) {
    K.setZero(6, 6);
    C.setZero(6, 6);
  }
  BlockMatrix* by_place = mode.tangent ? &K : nullptr;
  BlockMatrix* by_rate = mode.tangent ? &C : nullptr;
  points.to_body(f, by_place, by_rate);
  const std::array<LineBlock, 2> blocks{LineBlock{0, false, A.x, A.v, A.R}, {1, true, A.x, A.v, A.R}};
  sum.residual = against_body(LineBlocks(blocks), {2, B.x, B.v, B.R}, !mode.convex, f, by_place, by_rate);
  const Vec12 rates = at.rates();
  for (const auto& [volume, first] : {std::pair(pair.a, 0), std::pair(pair.b, 6)})
    if (bodies_of_volumes_[volume].global < 0)
      sum.work_power += sum.residual.f.segment<6>(first).dot(rates.segment<6>(first));
  return sum;
}

void BodyContact::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (const Pair& p : pairs_) {
    if (!p.owns_body) continue;
    const PairBody& a = bodies_of_volumes_[p.a];
    const PairBody& b = bodies_of_volumes_[p.b];
    const bool tangent = assembler.needs_tangent();
    const Sum s = contact(p, frames_of(p, trial), {trial.moves(), tangent, false}, slipping(p, trial.step));
    if (!s.active) continue;
    // Only bodies with unknowns have rows and columns.
    const Eigen::Index first = a.global < 0 ? 6 : 0;
    const Eigen::Index count = a.global < 0 || b.global < 0 ? 6 : 12;
    const std::array<int, 4> blocks{a.block, a.block + 1, b.block, b.block + 1};
    const Eigen::VectorXd f = s.residual.f.segment(first, count);
    AgainstBody::Matrix K, C;
    if (tangent) {
      K = s.residual.K.block(first, first, count, count);
      C = s.residual.C.block(first, first, count, count);
    }
    assembler.add({&blocks[first / 3], static_cast<size_t>(count / 3)}, f, K, C);
  }
}

void BodyContact::prepare(const Kinematics& from, double h) {
  for (Pair& p : pairs_) {
    if (!p.owns_body) continue;
    p.frames = frames_of(p, from);
    const Sum s = contact(p, p.frames, kStiffness);
    p.potential = s.potential;
    p.stiffness = s.active ? s.residual.K.topLeftCorner<3, 3>().norm() : 0;
    p.points = s.touching;
    p.penetration = s.depth;
    p.elastic = s.active ? Vec12(contact(p, p.frames, kSprings).residual.f) : Vec12(Vec12::Zero());
    p.energy = relative_energy(p, p.frames) + s.potential;
    p.frequencies = h > 0 ? frequencies(p, p.frames, s) : Frequencies();
    p.work_power = s.work_power + friction_power(p);
    if (!p.has_accepted_state) store_first_forces(p, h);
  }
  if (h > 0 || friction_on_) check_overlap(from.time);
}

// Forces of a state that no step has led to: the start without statics, or that of a checkpoint.
void BodyContact::store_first_forces(Pair& p, double h) const {
  Slipping friction = slipping(p, 0);
  Eighths eighths;
  if (p.counted) friction.eighths = &eighths;
  const Sum s = contact(p, p.frames, {h > 0}, friction);
  p.residual = s.active ? Vec12(s.residual.f) : Vec12(Vec12::Zero());
  if (p.counted) p.resultants = resultants_of(p, p.frames, eighths);
}

void BodyContact::commit(const Kinematics& accepted) {
  for (Pair& p : pairs_) {
    Slipping friction = slipping(p, accepted.step);
    const bool slips = friction.law.active();
    // Slip and forces are kept on the ranks of both bodies.
    if (!p.owns_body) continue;
    const PairFrames now = frames_of(p, accepted);
    BodyFrictionPoints touching;
    Eighths eighths;
    if (slips) friction.points = &touching;
    if (p.counted) friction.eighths = &eighths;
    DampingWork damping;
    if (p.counted && p.law.damping > 0 && accepted.moves()) {
      damping.end = &now;
      contact(p, p.frames, {true}, {FrictionLaw(), accepted.step, nullptr, nullptr, &damping});
      damping.end = nullptr;
      friction.damping = &damping;
    }
    const Sum s = contact(p, now, {accepted.moves()}, friction);
    if (slips && accepted.moves())
      p.dissipated += half_dissipation(p, now, p.touching) + half_dissipation(p, now, touching);
    p.touching = std::move(touching);
    p.residual = s.active ? Vec12(s.residual.f) : Vec12(Vec12::Zero());
    p.has_accepted_state = true;
    if (!p.counted) continue;
    p.depth = std::max(p.depth, s.depth);
    p.potential = s.potential;
    p.now.force = s.residual.f.segment<3>(0).norm();
    p.now.energy = s.potential;
    p.now.depth = s.depth;
    p.resultants = resultants_of(p, now, eighths);
    if (!accepted.moves()) continue;
    p.damping += damping.sum;
    p.work += 0.5 * accepted.step * (s.work_power + p.work_power);
  }
}

// After a step the energy of the committed state, in statics that of the trial.
Energy BodyContact::energy(const Kinematics& state) const {
  Energy e;
  for (const Pair& p : pairs_) {
    if (!p.counted) continue;
    e.strain += state.ends_step() ? p.potential : contact(p, frames_of(p, state), kSprings).potential;
    e.damping += p.damping;
    e.friction += p.dissipated;
    e.work += p.work;
  }
  return e;
}

std::vector<std::string> BodyContact::load_components(int body) const {
  for (const Pair& p : pairs_)
    if (bodies_of_volumes_[p.a].body == body || bodies_of_volumes_[p.b].body == body) return {"contact"};
  return {};
}

std::vector<BodyForce> BodyContact::forces_on(int body, const Kinematics& state) const {
  if (load_components(body).empty()) return {};
  BodyForce sum;
  for (const Pair& p : pairs_)
    for (const auto& [volume, first] : {std::pair(p.a, 0), std::pair(p.b, 6)}) {
      const PairBody& carrier = bodies_of_volumes_[volume];
      if (carrier.body != body || carrier.node < 0) continue;
      sum.force -= p.residual.segment<3>(first);
      sum.moment -= state.q[carrier.node] * p.residual.segment<3>(first + 3);
    }
  return {sum};
}

// Positions of contact points are rounded, which changes the forces on the springs by k times the error, and
// their moments by that times the lever.
double BodyContact::round_off(const Kinematics&, double h) const {
  double sum = 0;
  for (const Pair& p : pairs_) {
    if (!p.counted) continue;
    const double position = p.frames.A.x.norm() + p.frames.B.x.norm() + p.points.lever_a;
    const double stiffness = p.stiffness + friction_stiffness(p, h);
    sum += spring_round_off(stiffness, position);
    if (bodies_of_volumes_[p.a].global >= 0) sum += spring_round_off(stiffness * p.points.lever_a, position);
    if (bodies_of_volumes_[p.b].global >= 0) sum += spring_round_off(stiffness * p.points.lever_b, position);
  }
  return sum;
}

// If each volume is the slave in a pair, their contact is reported as two entries.
void BodyContact::active_contacts(ActiveContacts& out) const {
  for (const Pair& p : pairs_) {
    if (!p.counted || !(p.now.force > 0)) continue;
    ActiveContact t = p.now;
    t.volume = static_cast<int>(std::min(p.a, p.b));
    t.other_volume = static_cast<int>(std::max(p.a, p.b));
    out.push_back(t);
  }
}

// Trapezoidal rule: -½ F·Δz with the damping force at either end of the step and the displacement Δz of the
// point. The force at the start acts until the point has left contact. That at the end counts over the whole
// displacement, as the step applies it.
void BodyContact::add_damping_work(const Pair& pair, const Vec3& y, const Vec3& z,
                                   const AxisContactPoint& point, DampingWork& to) const {
  const double depth = pair.law.smoothing - point.gap;
  const double path = to.end ? std::min(point.normal.dot(to.end->across(y) - z), depth)
                             : point.normal.dot(z - pair.frames.across(y));
  to.sum -= 0.5 * point.weight * point.damping_force * path;
}

void BodyContact::add_resultant(const Pair& pair, const Vec3& y, const Vec3& z, double r,
                                const AxisContactPoint& point, Eighths& to) const {
  const Vec3 from_middle = y - boxes_[pair.a].centre();
  const size_t eighth = 4 * (from_middle.x() > 0) + 2 * (from_middle.y() > 0) + (from_middle.z() > 0);
  to[eighth].add(z - (r + point.gap) * point.normal, point, Mat3::Identity());
}

ContactResultants BodyContact::resultants_of(const Pair& pair, const PairFrames& at,
                                             const Eighths& sums) const {
  ContactResultants out;
  const double sign = pair.a < pair.b ? 1 : -1;  // the force on the first of the two
  for (const ResultantSum& sum : sums)
    if (sum.any())
      out.push_back({-1, -1, static_cast<int>(std::min(pair.a, pair.b)),
                     static_cast<int>(std::max(pair.a, pair.b)), at.B.to_space(sum.place()),
                     sign * (at.B.R * sum.force())});
  return out;
}

void BodyContact::resultants(ContactResultants& out) const {
  for (const Pair& p : pairs_)
    if (p.counted) out.insert(out.end(), p.resultants.begin(), p.resultants.end());
}

double BodyContact::largest_penetration() const {
  double depth = 0;
  for (const Pair& p : pairs_) depth = std::max(depth, p.depth);
  return depth;
}

}  // namespace hawser
