// Displacements of bodies in statics along the volumes on which they rest, and contacts that drive bodies
// apart.
#include "hawser/run/bodies_in_contact.hpp"

#include <algorithm>
#include <cmath>
#include <map>
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

// By body with mass. Pairs without friction are excluded.
std::map<int, RestsOn> contacts_with_friction(const model::Case& c, const std::vector<model::BodyPair>& pairs,
                                              const ContactResultants& contacts) {
  std::map<std::pair<int, int>, double> friction;  // by volumes in ascending order
  for (const model::BodyPair& p : pairs)
    if (p.friction.axial > 0)
      friction[{static_cast<int>(std::min(p.a, p.b)), static_cast<int>(std::max(p.a, p.b))}] =
          p.friction.axial;
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

// Displacement [m] of the body's centre of mass relative to `other` (-1: fixed in space), without its part
// along the force of contact, which is normal to the surface.
double along_surface(const model::Case& c, int body, int other, const Vec3& force,
                     const std::vector<RigidPose>& poses) {
  const Vec3& centre = c.bodies[body].mass->centre;
  Vec3 from = model::pose_at_start(c.bodies[body]).to_space(centre);
  if (other >= 0) from = poses[other].to_space(model::pose_at_start(c.bodies[other]).to_body(from));
  const Vec3 moved = poses[body].to_space(centre) - from;
  const Vec3 normal = force.normalized();
  return (moved - normal.dot(moved) * normal).norm();
}

// Smallest displacement that is reported, m: a part of the radius of gyration.
double significant(const model::BodyMass& m) {
  constexpr double kMost = 0.1;  // m
  constexpr double kOfGyration = 0.05;
  return std::min(kMost, kOfGyration * std::sqrt(0.5 * m.inertia.sum() / m.mass));
}

}  // namespace

std::vector<std::string> bodies_moved_by_statics(const model::Case& c, const System& system,
                                                 const Bodies& bodies, const Kinematics& equilibrium) {
  constexpr double kRests = 0.1;  // part of the weight that contact carries; less is that of a fender
  std::vector<std::string> out;
  const std::vector<model::BodyPair> pairs = model::body_pairs(c);
  if (std::none_of(pairs.begin(), pairs.end(), [](const model::BodyPair& p) { return p.friction.axial > 0; }))
    return out;
  ContactResultants local;
  if (const auto* contact = system.find<BodyContact>()) contact->resultants(local);
  const ContactResultants all = gather_all(system.comm(), local);
  std::vector<RigidPose> poses;
  for (const io::BodyPose& p : record::body_poses(bodies, system, equilibrium))
    poses.push_back({p.position, p.rotation});
  for (const auto& [body, on] : contacts_with_friction(c, pairs, all)) {
    const model::BodyMass& m = *c.bodies[body].mass;
    if (!m.weight || !(on.force.z() > kRests * m.mass * c.environment.gravity)) continue;
    const model::Volume& volume = c.volumes[on.volume];
    const double moved = along_surface(c, body, c.body_index(volume.body), on.force, poses);
    if (moved > significant(m))
      out.push_back(advice::moved_without_friction(c.bodies[body].name, moved, volume.name, on.friction));
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
