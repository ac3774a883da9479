// Displacements of bodies in statics along the volumes on which they rest, and contacts that drive bodies
// apart.
#include "hawser/run/bodies_in_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "hawser/advice/start_contact.hpp"
#include "hawser/advice/statics.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/model/body_motion.hpp"
#include "hawser/model/body_pairs.hpp"
#include "hawser/record/subject.hpp"
#include "hawser/terms/body_contact.hpp"

namespace hawser::run {
namespace {

// Contact of a body at rest with the volumes of others.
struct RestsOn {
  Vec3 force = Vec3::Zero();  // N, on the body
  int volume = -1;            // with the largest force
  double largest = 0;         // N, of that volume
  double friction = 0;        // coefficient there
};

// Coefficients of the pairs of volumes with friction, by the lower and the higher index.
using PairFriction = std::map<std::pair<int, int>, double>;

PairFriction pairs_with_friction(const std::vector<model::BodyPair>& pairs) {
  PairFriction out;
  for (const model::BodyPair& p : pairs)
    if (p.friction.axial > 0)
      out[{static_cast<int>(std::min(p.a, p.b)), static_cast<int>(std::max(p.a, p.b))}] = p.friction.axial;
  return out;
}

// By body with mass. Pairs without friction are excluded.
std::map<int, RestsOn> contacts_with_friction(const model::Case& c, const PairFriction& friction,
                                              const ContactResultants& contacts) {
  std::map<int, RestsOn> out;
  for (const ContactResultant& r : contacts) {
    const auto pair = friction.find({r.volume, r.other_volume});
    if (pair == friction.end()) continue;
    for (const bool first : {true, false}) {
      const int own = first ? r.volume : r.other_volume;
      const int other = first ? r.other_volume : r.volume;
      const int body = c.body_index(c.volumes[own].body);
      if (!c.floats(body)) continue;
      RestsOn& on = out[body];
      on.force += first ? r.force : Vec3(-r.force);
      if (!(r.force.norm() > on.largest)) continue;
      on.largest = r.force.norm();
      on.volume = other;
      on.friction = pair->second;
    }
  }
  return out;
}

// Smallest displacement that is reported, m: a part of the radius of gyration.
double significant(const model::BodyMass& m) {
  constexpr double kMost = 0.1;  // m
  constexpr double kOfGyration = 0.05;
  return std::min(kMost, kOfGyration * std::sqrt(0.5 * m.inertia.sum() / m.mass));
}

// The bodies of two volumes in contact, each as the one that rests on the other.
std::array<RestsOnBody, 2> both_ways(const model::Case& c, const TouchingVolumes& t) {
  const int a = c.body_index(c.volumes[t.volume].body);
  const int b = c.body_index(c.volumes[t.other_volume].body);
  return {{{a, b}, {b, a}}};
}

// Position [m] of the centre of mass and rotation of a body in the frame of another one (-1: in space).
struct RelativePose {
  Vec3 place = Vec3::Zero();
  Quat turned = Quat::Identity();
};

RelativePose relative_pose(const model::Case& c, const RestsOnBody& on, const std::vector<RigidPose>& poses) {
  const RigidPose& body = poses[on.body];
  const Vec3 centre = body.to_space(c.bodies[on.body].mass->centre);
  if (on.other < 0) return {centre, body.rotation};
  const RigidPose& other = poses[on.other];
  return {other.to_body(centre), other.rotation.conjugate() * body.rotation};
}

// Displacement of a body relative to the one that it rests on: m, without its part along `force` [N, on the
// body], which is normal to the surface; and the angle by which this normal has turned with the body, rad.
struct MovedOnSurface {
  double along = 0, tilted = 0;
};

MovedOnSurface moved_on_surface(const model::Case& c, const RestsOnBody& on, const Vec3& force,
                                const std::vector<RigidPose>& start,
                                const std::vector<RigidPose>& equilibrium) {
  const RelativePose from = relative_pose(c, on, start);
  const RelativePose to = relative_pose(c, on, equilibrium);
  const Vec3 moved = to.place - from.place;
  const Vec3 out = on.other < 0 ? force : Vec3(equilibrium[on.other].rotation.conjugate() * force);
  const Vec3 normal = out.normalized();
  const Vec3 turned = to.turned * (from.turned.conjugate() * normal);
  return {(moved - normal.dot(moved) * normal).norm(), std::acos(std::clamp(normal.dot(turned), -1.0, 1.0))};
}

}  // namespace

std::vector<RigidPose> poses_of(const System& system, const Bodies& bodies, const Kinematics& state) {
  std::vector<RigidPose> out;
  for (const io::BodyPose& p : record::body_poses(bodies, system, state)) {
    RigidPose pose;
    pose.position = p.position;
    pose.rotation = p.rotation;
    out.push_back(pose);
  }
  return out;
}

std::vector<RestsOnBody> bodies_starting_in_contact(const model::Case& c,
                                                    const std::vector<StaticRest>& support,
                                                    const System& system, const Kinematics& start) {
  std::vector<RestsOnBody> out;
  const LocalMesh& mesh = system.mesh();
  for (const TouchingVolumes& t : touching_volumes(system, start)) {
    for (const RestsOnBody& on : both_ways(c, t)) {
      if (!c.floats(on.body) || !mesh.owns_node(mesh.mesh->body_node(on.body))) continue;
      const model::BodyMass& m = *c.bodies[on.body].mass;
      if ((m.weight || !m.loads.empty()) && !support[static_cast<size_t>(on.body)].supported)
        out.push_back(on);
    }
  }
  return gather_all(system.comm(), out);
}

bool have_stayed(const model::Case& c, const std::vector<RestsOnBody>& resting,
                 const std::vector<TouchingVolumes>& touching, const std::vector<RigidPose>& start,
                 const std::vector<RigidPose>& equilibrium) {
  constexpr double kTurn = 0.01;  // rad; more is the settlement of a body that does not stand upright
  std::set<RestsOnBody> in_contact;
  for (const TouchingVolumes& t : touching)
    for (const RestsOnBody& on : both_ways(c, t)) in_contact.insert(on);
  std::set<int> all;
  std::set<int> at_rest;
  for (const RestsOnBody& on : resting) {
    all.insert(on.body);
    if (!in_contact.contains(on)) continue;
    at_rest.insert(on.body);
    const RelativePose from = relative_pose(c, on, start);
    const RelativePose to = relative_pose(c, on, equilibrium);
    if ((to.place - from.place).norm() > significant(*c.bodies[on.body].mass)) return false;
    if (from.turned.angularDistance(to.turned) > kTurn) return false;
  }
  return at_rest == all;
}

std::vector<TouchingVolumes> touching_volumes(const System& system, const Kinematics& state) {
  const auto* contact = system.find<BodyContact>();
  if (!contact) return {};
  return contact->touching(state);
}

namespace {

// Bodies whose weight nothing but lines and contact carries and that have left a volume with friction.
std::vector<std::string> bodies_off_volumes(const model::Case& c, const PairFriction& friction,
                                            const std::map<int, RestsOn>& rests,
                                            const std::vector<TouchingVolumes>& at_start) {
  std::set<std::string> out;  // two volumes may touch each other in two pairs
  for (const TouchingVolumes& t : at_start) {
    const auto pair = friction.find(std::minmax(t.volume, t.other_volume));
    if (pair == friction.end()) continue;
    for (const auto& [own, other] :
         {std::pair(t.volume, t.other_volume), std::pair(t.other_volume, t.volume)}) {
      const int body = c.body_index(c.volumes[own].body);
      if (!c.floats(body) || rests.contains(body)) continue;
      const model::BodyMass& m = *c.bodies[body].mass;
      if (m.weight && !m.hull && !m.hydrodynamics && !(m.spring_stiffness().z() > 0))
        out.insert(advice::left_without_friction(c.bodies[body].name, c.volumes[other].name, pair->second));
    }
  }
  return {out.begin(), out.end()};
}

}  // namespace

std::vector<std::string> bodies_moved_by_statics(const model::Case& c, const System& system,
                                                 const Bodies& bodies, const Kinematics& equilibrium,
                                                 const std::vector<TouchingVolumes>& at_start,
                                                 bool friction_in_statics) {
  constexpr double kRests = 0.1;    // part of the weight that contact carries; less is that of a fender
  constexpr double kTopples = 0.5;  // rad; less is the settlement of a body that does not start at rest
  const PairFriction friction = pairs_with_friction(model::body_pairs(c));
  if (friction.empty()) return {};
  ContactResultants local;
  if (const auto* contact = system.find<BodyContact>()) contact->resultants(local);
  const ContactResultants all = gather_all(system.comm(), local);
  const std::vector<RigidPose> poses = poses_of(system, bodies, equilibrium);
  const std::map<int, RestsOn> rests = contacts_with_friction(c, friction, all);
  std::vector<std::string> out;
  if (!friction_in_statics) out = bodies_off_volumes(c, friction, rests, at_start);
  std::vector<RigidPose> start(c.bodies.size());
  for (size_t b = 0; b < start.size(); ++b)
    if (c.bodies.has(b)) start[b] = model::pose_at_start(c.bodies[b]);  // all bodies with volumes are kept
  for (const auto& [body, on] : rests) {
    const model::BodyMass& m = *c.bodies[body].mass;
    if (!m.weight || !(on.force.z() > kRests * m.mass * c.environment.gravity)) continue;
    const model::Volume& volume = c.volumes[on.volume];
    const MovedOnSurface moved =
        moved_on_surface(c, {body, c.body_index(volume.body)}, on.force, start, poses);
    if (moved.tilted > kTopples)
      out.push_back(advice::toppled_in_statics(c.bodies[body].name, moved.tilted, volume.name));
    if (moved.along > significant(m) && !friction_in_statics)
      out.push_back(
          advice::moved_without_friction(c.bodies[body].name, moved.along, volume.name, on.friction));
  }
  return out;
}

std::vector<std::string> bodies_driven_apart(const model::Case& c, const System& system,
                                             const Kinematics& start) {
  std::vector<std::string> out;
  const auto* contact = system.find<BodyContact>();
  if (!contact) return out;
  for (const DrivenApart& d : contact->driven_apart(start)) {
    const model::Volume& one = c.volumes[d.volume];
    const model::Volume& other = c.volumes[d.other_volume];
    const std::string& body = c.floats(c.body_index(one.body)) ? one.body : other.body;
    out.push_back(advice::driven_apart(one.name, other.name, body, d.energy, d.out));
  }
  return out;
}

}  // namespace hawser::run
