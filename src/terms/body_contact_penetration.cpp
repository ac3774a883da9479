// The class BodyContact: detection of overlap that contact of corners and edges does not resist. Two
// boxes with flush sides penetrate each other with all edges in the sides of the other box, where the
// distance is zero. A penetration far deeper than the features showed since the volumes were last apart ends
// the run with a message. The largest value of that period counts, because edges that slide over others may
// for a moment show little penetration.
#include <algorithm>
#include <cmath>

#include "hawser/advice/contact_stiffness.hpp"
#include "hawser/base/error.hpp"
#include "hawser/base/mpi.hpp"
#include "hawser/terms/body_contact.hpp"

namespace hawser {
namespace {

constexpr double kAllowed = 0.01;  // fraction of the size of the smaller volume
constexpr double kBeyond = 2;      // factor on the penetration of the features, which may be at another place
// Cosine between the normals of the two sides of a wall, which make an angle of at most 18 deg with each
// other. At a blunter edge, such as a bow, a point may slide from one side to the other.
constexpr double kOpposite = -0.95;
constexpr double kReserve = 2;  // factor on the stiffness that is proposed

}  // namespace

double BodyContact::overlap_depth(size_t volume, const BodyFrame& frame, size_t other,
                                  const BodyFrame& other_frame) const {
  const auto across = [&](const Vec3& y) { return other_frame.to_body(frame.to_space(y)); };
  double depth = 0;  // only deeper points are of interest
  volumes_[volume].skeleton.faces.walk(
      [&](const Vec3& y, double r) { return near(other, across(y), r, -depth); },
      [&](const SkeletonPart& p) {
        if (const auto s = volumes_[other].surface->query(across(p.from), 0))
          depth = std::max(depth, -s->distance);
      });
  return depth;
}

double BodyContact::overlap_depth(const Pair& pair, const PairFrames& at) const {
  return std::max(overlap_depth(pair.a, at.A, pair.b, at.B), overlap_depth(pair.b, at.B, pair.a, at.A));
}

double BodyContact::allowed_overlap(const Pair& pair) const {
  double size = HUGE_VAL;
  for (const size_t v : {pair.a, pair.b})
    if (const Vec3 e = boxes_[v].extent(); e.allFinite()) size = std::min(size, e.maxCoeff());
  return kAllowed * size;
}

// The force on a point is directed to the nearest place of the surface. Past the middle of a wall that is on
// its far side: there the normal reverses while the point is inside, and half the thickness is its depth.
void BodyContact::add_pressed(const Pair& pair, const Vec3& y, double r, const SurfacePoint& now,
                              PressedThrough& to) const {
  if (!(now.distance < r)) return;
  const Vec3 z = pair.frames.across(y);
  const auto before = volumes_[pair.b].surface->query(z, r);
  if (!before || !(before->distance < r) || before->normal.dot(now.normal) > kOpposite) return;
  const double thickness = before->normal.dot(before->point - now.point);
  // The two sides of a slot have opposite normals too, but then the space between them is outside.
  if (!(thickness > 0) || !(r - before->distance > to.depth)) return;
  const PairFrames& at = pair.frames;
  const Vec3 velocity = at.B.R.transpose() * (at.A.velocity(y) - at.B.velocity(z));
  to = {.depth = r - before->distance,
        .thickness = thickness,
        .speed = std::max(-velocity.dot(before->normal), 0.0)};
}

// With the stiffness times (P + E) / P the potential of the springs at this depth is that of now, P, and the
// energy E of the motion into the wall. At rest the stiffness times kReserve halves the depth.
std::optional<advice::BodyPressedThrough> BodyContact::pressed_through(const Pair& pair,
                                                                       const Kinematics& trial) const {
  if (!(pair.penetration > 0)) return std::nullopt;
  PressedThrough pressed;
  Slipping search;
  search.pressed = &pressed;
  contact(pair, frames_of(pair, trial), kSprings, search);
  if (!(pressed.depth > 0)) return std::nullopt;
  const double speed = trial.moves() ? pressed.speed : 0;
  const double potential = pair.potential + (pair.other < 0 ? 0 : pairs_[pair.other].potential);
  const double energy = 0.5 * pair.mass * speed * speed;
  return advice::BodyPressedThrough{.volume = names_[pair.a],
                                    .other = names_[pair.b],
                                    .depth = pressed.depth,
                                    .thickness = pressed.thickness,
                                    .basis = pair.basis,
                                    .stiffness = pair.law.stiffness,
                                    .required = kReserve * pair.law.stiffness * (1 + energy / potential),
                                    .table = pair.law.table != nullptr,
                                    .both = pair.lower_counts};
}

// Between two states without overlap a volume may pass through one that no corner or edge meets. A path that
// is longer than the largest approach, as in dynamic relaxation, is therefore divided into parts of at most
// that length, and the overlap is computed between them.
bool BodyContact::overlaps_within_step(const Pair& pair, const Kinematics& trial) const {
  const PairFrames& from = pair.frames;
  const PairFrames to = frames_of(pair, trial);
  const SkeletonParts& features = volumes_[pair.a].skeleton.features;
  const Vec3 start = from.across(features.centre());
  const Vec3 path = to.across(features.centre()) - start;
  const double length = path.norm();
  if (!(length > pair.max_approach)) return false;
  if (!near(pair.b, start + 0.5 * path, features.radius() + 0.5 * length, 0)) return false;
  const double allowed = std::max(overlap_depth(pair, from), overlap_depth(pair, to)) + allowed_overlap(pair);
  const int samples = static_cast<int>(std::ceil(length / pair.max_approach));
  for (int k = 1; k < samples; ++k) {
    PairFrames at = from;
    for (const auto& [body, end] : {std::pair(&at.A, &to.A), std::pair(&at.B, &to.B)}) {
      const double part = static_cast<double>(k) / samples;
      body->x += part * (end->x - body->x);
      body->R = Quat(body->R).slerp(part, Quat(end->R)).toRotationMatrix();
    }
    if (overlap_depth(pair, at) > allowed) return true;
  }
  return false;
}

// The springs push with the force F, other forces hold against them with F - m c, c the acceleration along F.
std::vector<DrivenApart> BodyContact::driven_apart(const Kinematics& start) const {
  std::vector<DrivenApart> out;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& p = pairs_[i];
    const bool again = p.other >= 0 && static_cast<size_t>(p.other) < i;  // the same two volumes
    if (!p.counted || again) continue;
    const PairFrames at = frames_of(p, start);
    const Sum s = contact(p, at, kSprings);
    double potential = s.potential;
    double depth = s.depth;
    Vec3 force = Vec3::Zero();
    if (s.active) force -= s.residual.f.head<3>();
    if (p.other >= 0) {
      const Sum other = contact(pairs_[p.other], {at.B, at.A}, kSprings);
      potential += other.potential;
      depth = std::max(depth, other.depth);
      if (other.active) force -= other.residual.f.segment<3>(6);
    }
    const double push = p.mass * at.relative_motion().second.head<3>().dot(force.normalized());
    const double way = p.law.smoothing + depth;
    const double taken_up = relative_energy(p, at) + std::max(force.norm() - push, 0.0) * way;
    if (push > 0 && potential > taken_up)
      out.push_back({static_cast<int>(p.a), static_cast<int>(p.b), potential, way});
  }
  return gather_all(comm_, out);
}

std::vector<TouchingVolumes> BodyContact::touching(const Kinematics& state) const {
  std::vector<TouchingVolumes> out;
  for (const Pair& p : pairs_)
    if (p.counted && contact(p, frames_of(p, state), kSprings).active)
      out.push_back({static_cast<int>(p.a), static_cast<int>(p.b)});
  return gather_all(comm_, out);
}

void BodyContact::check_at_rest(const Kinematics& equilibrium) {
  // Penetrations on the path to rest do not permit any in the motion.
  for (Pair& p : pairs_) p.penetration_since_clear = 0;
  prepare(equilibrium, 0);
  if (!friction_on_) check_overlap(equilibrium.time);
}

void BodyContact::check_overlap(double time) {
  struct {
    double depth;
    int pair;
  } worst{0, -1};
  bool watched = false;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    Pair& p = pairs_[i];
    watched = watched || p.needs_overlap_check;
    const bool again = p.other >= 0 && static_cast<size_t>(p.other) < i;  // the same two volumes
    if (!p.needs_overlap_check || !p.counted || again) continue;
    const double depth = overlap_depth(p, p.frames);
    // If each volume is the slave in a pair, the penetration may show in the other pair.
    const double penetration = std::max(p.penetration, p.other < 0 ? 0 : pairs_[p.other].penetration);
    p.penetration_since_clear = depth > 0 ? std::max(p.penetration_since_clear, penetration) : 0;
    if (depth > kBeyond * p.penetration_since_clear + allowed_overlap(p) && depth > worst.depth)
      worst = {depth, static_cast<int>(i)};
  }
  if (!watched) return;
  MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, comm_);
  if (worst.pair < 0) return;
  const Pair& p = pairs_[worst.pair];
  double since_clear = p.counted ? p.penetration_since_clear : 0;
  all_reduce(comm_, MPI_MAX, since_clear);
  const std::string slave = p.other < 0 ? names_[p.a] : "";
  throw SolveError(advice::bodies_overlap(names_[p.a], names_[p.b], worst.depth, since_clear, time, slave));
}

}  // namespace hawser
