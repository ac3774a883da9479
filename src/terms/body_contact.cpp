// The part of BodyContactTerm that acts: pairs of volumes, forces and tangent summed over points and edges,
// energies, history; steps are in body_contact_step_limits.cpp.
#include "hawser/terms/body_contact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "body_contact_points.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/model/body_pairs.hpp"
#include "hawser/terms/axis_distance.hpp"
#include "hawser/terms/contact_laws.hpp"
#include "hawser/terms/previous_slip.hpp"

namespace hawser {
namespace {

constexpr double kSmoothing = 1e-3;      // of the size of what leads, m/m
constexpr double kMostSmoothing = 0.01;  // m
constexpr double kDeepestAtOnce = 0.05;  // of that size, m/m; less where it would get through something thin
constexpr int kEdgeLevels = 5;           // an edge is looked at in pieces of 1/32

// A contact point of a feature, in a checkpoint.
struct FeaturePoint {
  int feature = 0;
  AxisContactPoint point;

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("feature", "", self.feature);
    AxisContactPoint::quantities(self.point, each);
  }
};

Vec3 place(const SkeletonPart& part, double xi) { return part.from + xi * (part.to - part.from); }

AxisShape chord(const BodyFrame& body, const Vec3& from, const Vec3& to) {
  AxisEnds e;
  e.beam = false;
  e.x1 = body.to_space(from);
  e.x2 = body.to_space(to);
  e.v1 = body.velocity(from);
  e.v2 = body.velocity(to);
  return AxisShape(e);
}

}  // namespace

BodyContactTerm::BodyContactTerm(MPI_Comm comm, const model::Case& c, const LocalMesh& mesh,
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
    pair.share = p.share;
    pair.hides = p.hides;
    pair.mass = 1 / (1 / bodies_of_volumes_[p.a].mass + 1 / bodies_of_volumes_[p.b].mass);
    pair.size = boxes_[p.a].extent().maxCoeff();  // no plane leads
    pair.most_depth = kDeepestAtOnce * pair.size;
    for (const auto& [i, first] : {std::pair(p.a, 0), std::pair(p.b, 6)}) {
      const Vec3 e = boxes_[i].extent();
      if (e.allFinite() && e.minCoeff() > 0) pair.most_depth = std::min(pair.most_depth, 0.5 * e.minCoeff());
      const PairBody& body = bodies_of_volumes_[i];
      if (body.global < 0) continue;
      pair.root.block<3, 3>(first, first) = Mat3::Identity() / std::sqrt(body.mass);
      pair.root.block<3, 3>(first + 3, first + 3) = Mat3(body.inertia.inverse()).llt().matrixL();
    }
    // The mass that belongs to a unit of length or area is that over the whole of it.
    const double units = v.basis == model::StiffnessBasis::per_point    ? 1
                         : v.basis == model::StiffnessBasis::per_length ? pair.size
                                                                        : pair.size * pair.size;
    // Where the other volume is softer the stiffness of the two is that one's.
    pair.law = normal_law(v, p.stiffness / v.normal_stiffness,
                          std::min(kSmoothing * pair.size, kMostSmoothing), pair.mass / units);
    pair.friction = friction_law(p.friction, 1, pair.size);
    if (p.friction.mobilisation_length == 0 && p.friction.shear_stiffness == 0)
      pair.friction.stiffness = pair.law.stiffness;
    if (!pairs_.empty() && pairs_.back().a == pair.b && pairs_.back().b == pair.a) {
      pair.other = static_cast<int>(pairs_.size()) - 1;
      pairs_.back().other = static_cast<int>(pairs_.size());
    }
    pairs_.push_back(pair);
  }
  update_ghosts();
}

bool BodyContactTerm::recouple(const Kinematics&, double) {
  const bool first = !coupled_;
  coupled_ = true;
  return first;
}

void BodyContactTerm::couple(Couplings& to) const {
  for (const Pair& p : pairs_) {
    const int a = bodies_of_volumes_[p.a].global, b = bodies_of_volumes_[p.b].global;
    const auto here = [&](int n) {
      const int local = n < 0 ? -1 : mesh_.find(n);
      return mesh_.owns(local);
    };
    if (a >= 0 && b >= 0 && (here(a) || here(b))) to.add({a, a}, {b, b});
  }
}

void BodyContactTerm::update_ghosts() {
  for (PairBody& s : bodies_of_volumes_) {
    s.node = s.global < 0 ? -1 : mesh_.find(s.global);
    s.block = s.node < 0 ? -1 : mesh_.block[s.node];
  }
  for (Pair& p : pairs_) {
    const PairBody &a = bodies_of_volumes_[p.a], &b = bodies_of_volumes_[p.b];
    p.here = owned(a) || owned(b);
    p.counted = a.global >= 0 ? owned(a) : owned(b);
  }
}

Vec3 BodyContactTerm::Both::turned_since(const Both& start) const {
  return log_so3(Quat(Mat3(turn() * start.turn().transpose())));
}

BodyFrame BodyContactTerm::frame(size_t volume, const Kinematics& at) const {
  const PairBody& s = bodies_of_volumes_[volume];
  if (s.global < 0) {
    const RigidPose p = bodies_->pose(s.body, at.time);
    const Mat3 R = p.rotation.toRotationMatrix(), back = R.transpose();
    return {s.centre,
            p.position,
            R,
            p.velocity,
            p.acceleration,
            back * p.angular_velocity,
            back * p.angular_acceleration};
  }
  const size_t n = s.node;
  return {s.centre, at.x[n], at.q[n].toRotationMatrix(), at.v[n], at.a[n], at.w[n], at.alpha[n]};
}

BodyContactTerm::Both BodyContactTerm::both(const Pair& pair, const Kinematics& at) const {
  return {frame(pair.a, at), frame(pair.b, at)};
}

bool BodyContactTerm::near(size_t volume, const Vec3& centre, double radius, double gap) const {
  const double reach = radius + gap, within = std::max(reach, 0.0);
  if (squared_distance(boxes_[volume], centre) > within * within) return false;
  const auto s = volumes_[volume].surface->query(centre, within);
  return s && s->distance <= reach;
}

void BodyContactTerm::contact_of_edge(const Pair& pair, const Both& at, const RigidPose& pose,
                                      const SkeletonPart& e, const AxisContactMode& mode,
                                      const FrictionLaw& friction, double* f, double* K, double* C, Sum& sum,
                                      TouchingPoints* touching) const {
  const Surface& surface = *volumes_[pair.b].surface;
  const double contact_distance = e.radius + pair.law.smoothing, length = (e.to - e.from).norm(),
               weight = pair.share * length;
  const AxisShape shape = chord(at.A, e.from, e.to);
  const auto query = [&](double xi, double within) {
    return surface.query(pose.to_body(shape.point(xi)), within);
  };
  ContactQuadrature found;
  auto gap = axis_distance(surface, pose, shape, contact_distance);
  found.add_panels(split_intervals(contact_intervals(gap, {length}, kEdgeLevels), kEdgeLevels), 0, weight,
                   [&](double xi) { return query(xi, contact_distance); });
  if (found.quadrature.empty()) return;
  const auto law = [&](const ContactPanel&) { return ContactLaw{pair.law, friction}; };
  const auto beyond = [&](const ContactPanel&, double xi) { return query(xi, contact_distance + 1e-9); };
  const auto start = [&](const ContactPanel&, double xi, ContactRates* rates) {
    return start_of(pair, at, e, xi, rates);
  };
  AxisContact contact(shape, pose, e.radius, weight, mode);
  std::vector<AxisContactPoint> points;
  contact.add(found, {law, beyond, start}, &points);
  if (points.empty()) return;
  Stencil stencil;
  stencil.blocks = 2;
  for (const Vec3& y : {e.from, e.to}) stencil.add({0, 1, {y - at.A.centre, at.A.R, at.A.w}});
  contact.to_blocks(stencil, f, K, C);
  sum.active = true;
  for (const AxisContactPoint& p : points) {
    const Vec3 x = shape.point(p.xi), speed = shape.velocity(p.xi) - pose.velocity_at(x);
    sum.potential += p.weight * p.potential;
    sum.damping_power -= p.weight * p.damping_force * (pose.rotation * p.normal).dot(speed);
    sum.depth = std::max(sum.depth, -p.gap);
  }
  if (touching) (*touching)[volumes_[pair.a].skeleton.features.index(e)] = std::move(points);
}

bool BodyContactTerm::driven(const Pair& pair, const Both& at) const {
  const auto moves = [&](size_t volume, const BodyFrame& f) {
    return bodies_of_volumes_[volume].global < 0 && !(f.v.isZero(0) && f.w.isZero(0));
  };
  return moves(pair.a, at.A) || moves(pair.b, at.B);
}

ContactStart BodyContactTerm::start_of(const Pair& pair, const Both& trial, const SkeletonPart& part,
                                       double xi, ContactRates* rates) const {
  const Vec3 y = place(part, xi), slope = pair.at.turn() * (part.to - part.from);
  ContactStart s;
  s.point = pair.at.across(y);
  if (part.from != part.to) s.tangent = slope.normalized();
  if (rates) rates->start_point = slope;
  const auto known = pair.touching.find(volumes_[pair.a].skeleton.features.index(part));
  if (known != pair.touching.end() && previous_slip(known->second, xi, s, rates)) return s;
  // What touches now was no farther away than it has moved since.
  const double within =
      (trial.across(y) - s.point).norm() + part.radius + pair.law.smoothing + 1e-6 * pair.size;
  const auto q = volumes_[pair.b].surface->query(s.point, within);
  s.gap = q ? q->distance - part.radius : within;
  if (q && rates) rates->start_gap = q->normal.dot(slope);
  return s;
}

// Of the trapezoidal rule: friction on the displacement z1 - z0 of the point against the surface, with that
// of the surface of a ball by its rotation phi, -r phi x n.
double BodyContactTerm::half_dissipation(const Pair& pair, const Both& trial,
                                         const TouchingPoints& points) const {
  const SkeletonParts& parts = volumes_[pair.a].skeleton.features;
  const Vec3 turned = trial.turned_since(pair.at);
  double sum = 0;
  for (const auto& [feature, touching] : points) {
    const SkeletonPart& part = parts[feature];
    for (const AxisContactPoint& p : touching) {
      const Vec3 y = place(part, p.xi);
      const Vec3 moved = trial.across(y) - pair.at.across(y) - part.radius * turned.cross(p.normal);
      sum -= 0.5 * p.weight * p.friction.dot(moved);
    }
  }
  return sum;
}

BodyContactTerm::Sum BodyContactTerm::contact(const Pair& pair, const Both& at, const AxisContactMode& mode,
                                              const FrictionLaw& friction, TouchingPoints* touching) const {
  const BodyFrame &A = at.A, &B = at.B;
  RigidPose pose;  // of the surface
  pose.position = B.to_space(Vec3::Zero());
  pose.rotation = Quat(B.R);
  pose.velocity = B.velocity(Vec3::Zero());
  pose.angular_velocity = B.R * B.w;
  Sum sum;
  sum.on.f = Vec12::Zero();
  std::array<double, 6> f{};
  std::array<double, 36> K{}, C{};
  double *k = mode.tangent ? K.data() : nullptr, *c = mode.tangent ? C.data() : nullptr;
  BodyContactPoints points(A, B, friction.active() ? at.turned_since(pair.at) : Vec3(Vec3::Zero()), mode);
  const auto point = [&](const SkeletonPart& p) {
    const Vec3 z = points.place(p.from);
    const auto s = volumes_[pair.b].surface->query(z, p.radius + pair.law.smoothing);
    if (!s) return;
    const ContactStart start = friction.active() ? start_of(pair, at, p, 0, nullptr) : ContactStart();
    const AxisContactPoint at_point =
        points.add({pair.law, friction}, start, *s, z, p.radius, pair.share * p.weight);
    if (touching && at_point.normal_force > 0)
      (*touching)[volumes_[pair.a].skeleton.features.index(p)] = {at_point};
  };
  volumes_[pair.a].skeleton.features.walk(
      [&](const Vec3& y, double r) { return near(pair.b, at.across(y), r, pair.law.smoothing); },
      [&](const SkeletonPart& p) {
        if (p.from == p.to)
          point(p);
        else
          contact_of_edge(pair, at, pose, p, mode, friction, f.data(), k, c, sum, touching);
      });
  if (points.active()) {
    points.to_body(f.data(), k, c);
    sum.active = true;
    sum.potential += points.potential();
    sum.damping_power += points.damping_power();
    sum.depth = std::max(sum.depth, points.depth());
  }
  if (!sum.active) return sum;
  const std::array<LineBlock, 2> blocks{LineBlock{0, false, A.x, A.v, A.R}, {1, true, A.x, A.v, A.R}};
  sum.on = against_body(blocks, {2, B.x, B.v, B.R}, !mode.convex, f.data(), k, c);
  const Vec12 rates = at.rates();
  for (const auto& [volume, first] : {std::pair(pair.a, 0), std::pair(pair.b, 6)})
    if (bodies_of_volumes_[volume].global < 0)
      sum.work_power += sum.on.f.segment<6>(first).dot(rates.segment<6>(first));
  return sum;
}

void BodyContactTerm::evaluate(const Kinematics& trial, Assembler& assembler) {
  for (const Pair& p : pairs_) {
    if (!p.here) continue;
    const PairBody &a = bodies_of_volumes_[p.a], &b = bodies_of_volumes_[p.b];
    const bool tangent = assembler.needs_tangent();
    const Sum s = contact(p, both(p, trial), {true, tangent, false}, friction_in(p, trial.step));
    if (!s.active) continue;
    // Rows and columns of bodies with unknowns.
    const Eigen::Index first = a.global < 0 ? 6 : 0, count = a.global < 0 || b.global < 0 ? 6 : 12;
    const std::array<int, 4> blocks{a.block, a.block + 1, b.block, b.block + 1};
    const Eigen::VectorXd f = s.on.f.segment(first, count);
    AgainstBody::Matrix K, C;
    if (tangent) {
      K = s.on.K.block(first, first, count, count);
      C = s.on.C.block(first, first, count, count);
    }
    assembler.add({&blocks[first / 3], static_cast<size_t>(count / 3)}, f.data(),
                  tangent ? K.data() : nullptr, tangent ? C.data() : nullptr, nullptr);
  }
}

void BodyContactTerm::prepare(const Kinematics& committed, double h) {
  for (Pair& p : pairs_) {
    if (!p.here) continue;
    p.at = both(p, committed);
    const Sum s = contact(p, p.at, kStiffness);
    p.potential = s.potential;
    p.penetration = s.depth;
    p.elastic = s.active ? Vec12(contact(p, p.at, kSprings).on.f) : Vec12(Vec12::Zero());
    p.frequency = h > 0 ? frequency(p, s) : 0;
    p.energy = relative_energy(p, p.at) + s.potential;
    p.damping_power = s.damping_power;
    p.work_power = s.work_power;
    const FrictionLaw friction = friction_in(p, h);
    if (s.active && friction.active() && driven(p, p.at))
      p.work_power = contact(p, p.at, {true}, friction).work_power;
  }
  if (h > 0) check_overlap(committed.time);
}

void BodyContactTerm::commit(const Kinematics& accepted) {
  for (Pair& p : pairs_) {
    const FrictionLaw friction = friction_in(p, accepted.step);
    // The slip is kept on the ranks of both bodies.
    if (!p.here || !(p.counted || friction.active())) continue;
    const Both now = both(p, accepted);
    TouchingPoints touching;
    const Sum s = contact(p, now, {true}, friction, friction.active() ? &touching : nullptr);
    if (accepted.step > 0) {
      p.dissipated += half_dissipation(p, now, p.touching) + half_dissipation(p, now, touching);
      p.touching = std::move(touching);
    }
    if (!p.counted) continue;
    p.depth = std::max(p.depth, s.depth);
    p.potential = s.potential;
    p.now.force = s.on.f.segment<3>(0).norm();
    p.now.energy = s.potential;
    p.now.depth = s.depth;
    if (!(accepted.step > 0)) continue;
    p.damping += 0.5 * accepted.step * (s.damping_power + p.damping_power);
    p.work += 0.5 * accepted.step * (s.work_power + p.work_power);
  }
}

// In dynamics of the committed state, in statics of trials.
Energy BodyContactTerm::energy(const Kinematics& at) const {
  Energy e;
  for (const Pair& p : pairs_) {
    if (!p.counted) continue;
    e.strain += at.step > 0 ? p.potential : contact(p, both(p, at), kSprings).potential;
    e.damping += p.damping;
    e.friction += p.dissipated;
    e.work += p.work;
  }
  return e;
}

// Of a pair of which both lead it is one contact, reported by two.
void BodyContactTerm::active_contacts(ActiveContacts& out) const {
  for (const Pair& p : pairs_) {
    if (!p.counted || !(p.now.force > 0)) continue;
    ActiveContact t = p.now;
    t.volume = static_cast<int>(std::min(p.a, p.b));
    t.other_volume = static_cast<int>(std::max(p.a, p.b));
    out.push_back(t);
  }
}

double BodyContactTerm::largest_penetration() const {
  double depth = 0;
  for (const Pair& p : pairs_) depth = std::max(depth, p.depth);
  return depth;
}

// The sums are kept with the node of the first floating body of a pair; what touches with those of both,
// since either may be on another rank.
std::vector<CheckpointKind> BodyContactTerm::checkpoint_kinds() const {
  return {checkpoint_kind<Pair>("sums of a pair"), checkpoint_kind<FeaturePoint>("friction of a pair")};
}

std::vector<CheckpointRecord> BodyContactTerm::records(NodeRange of) const {
  std::vector<CheckpointRecord> out;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& p = pairs_[i];
    const PairBody &a = bodies_of_volumes_[p.a], &b = bodies_of_volumes_[p.b];
    const int node = a.global >= 0 ? a.global : b.global, key = static_cast<int>(i);
    if (p.counted && of.has(node)) out.push_back(record_of(node, key, p));
    for (const PairBody* body : {&a, &b}) {
      if (p.touching.empty() || !owned(*body) || !of.has(body->global)) continue;
      CheckpointRecord r;
      r.node = body->global;
      r.key = key;
      r.kind = 1;
      for (const auto& [feature, points] : p.touching)
        for (const AxisContactPoint& c : points) put(FeaturePoint{feature, c}, r.values);
      out.push_back(std::move(r));
    }
  }
  return out;
}

void BodyContactTerm::restore(const std::vector<CheckpointRecord>& records) {
  for (Pair& p : pairs_) p.touching.clear();
  for (const CheckpointRecord& r : records) {
    if (r.key < 0 || static_cast<size_t>(r.key) >= pairs_.size()) continue;
    Pair& p = pairs_[r.key];
    if (r.kind == 1) {
      p.touching.clear();  // a rank that owns both bodies has the record twice
      for (const FeaturePoint& f : entries<FeaturePoint>(r)) p.touching[f.feature].push_back(f.point);
      continue;
    }
    if (!p.counted) continue;
    const Pair kept = entry<Pair>(r);
    p.damping = kept.damping;
    p.dissipated = kept.dissipated;
    p.work = kept.work;
    p.depth = kept.depth;
    p.met = kept.met;
  }
}

}  // namespace hawser
