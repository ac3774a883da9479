// Poses of single bodies on their ranks, and of all bodies on every rank.
#include "hawser/record/subject.hpp"

#include "hawser/base/mpi.hpp"

namespace hawser::record {

std::optional<RigidPose> body_pose(const Bodies& bodies, const LocalMesh& mesh, int body,
                                   const Kinematics& state) {
  if (bodies.floats(body) && !mesh.owns(bodies.local_node(body))) return std::nullopt;
  return bodies.pose(body, state);
}

std::vector<io::BodyPose> body_poses(const Bodies& bodies, const System& system, const Kinematics& state) {
  std::vector<double> packed;
  for (int b = 0; b < bodies.size(); ++b) {
    if (!bodies.floats(b)) continue;
    const auto p = body_pose(bodies, system.mesh(), b, state);
    const Quat q = p ? p->rotation : Quat(0, 0, 0, 0);
    const Vec3 x = p ? p->position : Vec3(Vec3::Zero());
    packed.insert(packed.end(), {x.x(), x.y(), x.z(), q.w(), q.x(), q.y(), q.z()});
  }
  if (!packed.empty()) all_reduce(system.comm(), MPI_SUM, packed);
  std::vector<io::BodyPose> out;
  const double* t = packed.data();
  for (int b = 0; b < bodies.size(); ++b) {
    if (bodies.floats(b)) {
      out.push_back({{t[0], t[1], t[2]}, {t[3], t[4], t[5], t[6]}});
      t += 7;
    } else {
      const RigidPose p = bodies.pose(b, state.time);
      out.push_back({p.position, p.rotation});
    }
  }
  return out;
}

}  // namespace hawser::record
