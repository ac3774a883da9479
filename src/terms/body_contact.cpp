// The part of BodyContactTerm that acts: pairs of volumes, forces and tangent summed over points and edges,
// energies, history; steps are in body_contact_step_limits.cpp.
#include "hawser/terms/body_contact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "body_contact_points.hpp"
#include "hawser/model/body_pairs.hpp"
#include "hawser/terms/axis_distance.hpp"
#include "hawser/terms/contact_laws.hpp"

namespace hawser {
namespace {

constexpr double kSmoothing = 1e-3;      // of the size of what leads, m/m
constexpr double kMostSmoothing = 0.01;  // m
constexpr double kDeepestAtOnce = 0.05;  // of that size, m/m; less where it would get through something thin
constexpr int kEdgeLevels = 5;           // an edge is looked at in pieces of 1/32

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
    const auto owned = [&](const PairBody& s) { return s.node >= 0 && s.node < mesh_.owned; };
    p.here = owned(a) || owned(b);
    p.counted = a.global >= 0 ? owned(a) : owned(b);
  }
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
                                      const SkeletonPart& e, const AxisContactMode& mode, double* f,
                                      double* K, double* C, Sum& sum) const {
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
  const auto law = [&](const ContactPanel&) { return ContactLaw{pair.law, {}}; };
  const auto beyond = [&](const ContactPanel&, double xi) { return query(xi, contact_distance + 1e-9); };
  const auto start = [](const ContactPanel&, double, ContactRates*) { return ContactStart{}; };
  AxisContact contact(shape, pose, e.radius, weight, mode);
  std::vector<AxisContactPoint> points;
  contact.add(found, {law, beyond, start}, &points);
  if (points.empty()) return;
  Stencil stencil;
  stencil.blocks = 2;
  for (const Vec3& y : {e.from, e.to}) stencil.add({0, 1, y - at.A.centre, at.A.R, at.A.w});
  contact.to_blocks(stencil, f, K, C);
  sum.active = true;
  for (const AxisContactPoint& p : points) {
    const Vec3 x = shape.point(p.xi), speed = shape.velocity(p.xi) - pose.velocity_at(x);
    sum.potential += p.weight * p.potential;
    sum.damping_power -= p.weight * p.damping_force * (pose.rotation * p.normal).dot(speed);
    sum.depth = std::max(sum.depth, -p.gap);
  }
}

BodyContactTerm::Sum BodyContactTerm::contact(const Pair& pair, const Both& at,
                                              const AxisContactMode& mode) const {
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
  BodyContactPoints points(A, B, mode);
  const auto point = [&](const SkeletonPart& p) {
    const Vec3 z = points.place(p.from);
    if (const auto s = volumes_[pair.b].surface->query(z, p.radius + pair.law.smoothing))
      points.add(pair.law, *s, z, p.radius, pair.share * p.weight);
  };
  volumes_[pair.a].skeleton.features.walk(
      [&](const Vec3& y, double r) { return near(pair.b, at.across(y), r, pair.law.smoothing); },
      [&](const SkeletonPart& p) {
        if (p.from == p.to)
          point(p);
        else
          contact_of_edge(pair, at, pose, p, mode, f.data(), k, c, sum);
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
    const Sum s = contact(p, both(p, trial), {true, tangent, false});
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
  }
  if (h > 0) check_overlap(committed.time);
}

void BodyContactTerm::commit(const Kinematics& accepted) {
  for (Pair& p : pairs_) {
    if (!p.counted) continue;
    const Sum s = contact(p, both(p, accepted), {true});
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

// Kept with the node of the first floating body of a pair.
std::vector<HistoryKind> BodyContactTerm::history() const { return {history_kind<Pair>("sums of a pair")}; }

std::vector<HistoryRecord> BodyContactTerm::records(NodeRange of) const {
  std::vector<HistoryRecord> out;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& p = pairs_[i];
    const int node =
        bodies_of_volumes_[p.a].global >= 0 ? bodies_of_volumes_[p.a].global : bodies_of_volumes_[p.b].global;
    if (p.counted && of.has(node)) out.push_back(record_of(node, static_cast<int>(i), p));
  }
  return out;
}

void BodyContactTerm::restore(const std::vector<HistoryRecord>& records) {
  for (const HistoryRecord& r : records) {
    if (r.key < 0 || static_cast<size_t>(r.key) >= pairs_.size()) continue;
    Pair& p = pairs_[r.key];
    if (!p.counted) continue;
    const Pair kept = entry<Pair>(r);
    p.damping = kept.damping;
    p.work = kept.work;
    p.depth = kept.depth;
    p.met = kept.met;
  }
}

}  // namespace hawser
