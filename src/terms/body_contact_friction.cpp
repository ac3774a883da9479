// The class BodyContact: friction. Slip at the start of a step, work of friction over the step, and the
// history in a checkpoint.
#include <mpi.h>

#include <algorithm>
#include <cmath>

#include "hawser/base/mpi.hpp"
#include "hawser/terms/body_contact.hpp"
#include "hawser/terms/previous_slip.hpp"

namespace hawser {
namespace {

enum Kind { kSums, kSlip };

// Contact point of a feature in a checkpoint.
struct FeaturePoint {
  int feature = 0;
  BodyFrictionPoint point;

  template <class Self, class Each>
  static void quantities(Self& self, Each&& each) {
    each("feature", "", self.feature);
    BodyFrictionPoint::quantities(self.point, each);
  }
};

std::vector<double> values_of(const BodyFrictionPoints& points) {
  std::vector<double> values;
  points.each([&](int feature, std::span<const BodyFrictionPoint> group) {
    for (const BodyFrictionPoint& p : group) put(FeaturePoint{feature, p}, values);
  });
  return values;
}

BodyFrictionPoints points_of(const std::vector<double>& values) {
  CheckpointRecord record;
  record.values = values;
  BodyFrictionPoints points;
  std::vector<BodyFrictionPoint> group;
  const std::vector<FeaturePoint> all = entries<FeaturePoint>(record);
  for (size_t i = 0; i < all.size(); ++i) {
    group.push_back(all[i].point);
    if (i + 1 < all.size() && all[i + 1].feature == all[i].feature) continue;
    points.add(all[i].feature, group);
    group.clear();
  }
  return points;
}

}  // namespace

ContactStart BodyContact::start_of(const Pair& pair, const PairFrames& trial, const SkeletonPart& part,
                                   double xi, ContactRates* rates) const {
  const Vec3 y = part.place(xi);
  Vec3 slope = Vec3::Zero();
  ContactStart s;
  s.point = pair.frames.across(y);
  if (part.from != part.to) {
    slope = pair.frames.turn() * (part.to - part.from);
    s.tangent = slope.normalized();
  }
  if (rates) rates->start_point = slope;
  const auto previous_points = pair.touching.of(volumes_[pair.a].skeleton.features.index(part));
  if (previous_slip(previous_points, xi, s, rates)) return s;
  // Bound of the gap at the start for a point that touches in the trial, from its displacement.
  const double within =
      (trial.across(y) - s.point).norm() + part.radius + pair.law.smoothing + 1e-6 * pair.size;
  const auto q = volumes_[pair.b].surface->query(s.point, within);
  s.gap = q ? q->distance - part.radius : within;
  if (q && rates) rates->start_gap = q->normal.dot(slope);
  return s;
}

// Trapezoidal rule: friction times the displacement z1 - z0 of the point relative to the surface. The surface
// of a ball also moves by -r phi x n due to its rotation phi.
double BodyContact::half_dissipation(const Pair& pair, const PairFrames& trial,
                                     const BodyFrictionPoints& points) const {
  const SkeletonParts& parts = volumes_[pair.a].skeleton.features;
  const Vec3 turned = trial.turned_since(pair.frames);
  double sum = 0;
  points.each([&](int feature, std::span<const BodyFrictionPoint> touching) {
    const SkeletonPart& part = parts[feature];
    for (const BodyFrictionPoint& p : touching) {
      const Vec3 y = part.place(p.xi);
      const Vec3 moved = trial.across(y) - pair.frames.across(y) - part.radius * turned.cross(p.normal);
      sum -= 0.5 * p.weight * p.friction.dot(moved);
    }
  });
  return sum;
}

// k' = k_t + c_t/h, c_t = damping sqrt(k_t), of all points with the largest of their peaks: an upper
// bound.
double BodyContact::friction_stiffness(const Pair& pair, double h) const {
  const FrictionLaw law = slipping(pair, h).law;
  if (!law.active() || !(pair.points.weight > 0)) return 0;
  const Coulomb<double> mu{law.axial, law.lateral};
  const double N = pair.points.force / pair.points.weight;
  const double k = isotropic_stiffness(law, mu, N, std::max(N, pair.points.peak));
  const double damper = h > 0 ? law.damping * std::sqrt(k) / h : 0;
  return pair.points.weight * (k + damper);
}

// The forces F on A and -F on B act at z - r n. The power of a prescribed body is that of the force that
// holds it, which is opposite to the contact force.
double BodyContact::friction_power(const Pair& pair) const {
  const bool by_a = bodies_of_volumes_[pair.a].global < 0;
  const bool by_b = bodies_of_volumes_[pair.b].global < 0;
  if (!by_a && !by_b) return 0;
  const BodyFrame& A = pair.frames.A;
  const BodyFrame& B = pair.frames.B;
  const SkeletonParts& parts = volumes_[pair.a].skeleton.features;
  double sum = 0;
  pair.touching.each([&](int feature, std::span<const BodyFrictionPoint> touching) {
    const SkeletonPart& part = parts[feature];
    for (const BodyFrictionPoint& p : touching) {
      const Vec3 z = pair.frames.across(part.place(p.xi)) - part.radius * p.normal;
      Vec3 speed = Vec3::Zero();
      if (by_b) speed += B.velocity(z);
      if (by_a) speed -= A.velocity(A.to_body(B.to_space(z)));
      sum += p.weight * (B.R * p.friction).dot(speed);
    }
  });
  return sum;
}

// Both records are stored with the node of the first floating body of a pair.
std::vector<CheckpointKind> BodyContact::checkpoint_kinds() const {
  return {checkpoint_kind<Pair>("sums of a pair"), checkpoint_kind<FeaturePoint>("friction of a pair")};
}

std::vector<CheckpointRecord> BodyContact::checkpoint_records(NodeRange range) const {
  std::vector<CheckpointRecord> out;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    const Pair& p = pairs_[i];
    const PairBody& a = bodies_of_volumes_[p.a];
    const PairBody& b = bodies_of_volumes_[p.b];
    const int node = a.global >= 0 ? a.global : b.global;
    const int key = static_cast<int>(i);
    if (!p.counted || !range.has(node)) continue;
    out.push_back(record_of(node, key, p, kSums));
    if (!p.touching.empty()) out.push_back({node, key, values_of(p.touching), kSlip});
  }
  return out;
}

void BodyContact::restore(const std::vector<CheckpointRecord>& records) {
  for (Pair& p : pairs_) p.touching.clear();
  for (const CheckpointRecord& r : records) {
    if (r.key < 0 || static_cast<size_t>(r.key) >= pairs_.size()) continue;
    Pair& p = pairs_[r.key];
    if (r.kind == kSlip) {
      p.touching = points_of(r.values);
      continue;
    }
    if (!p.counted) continue;
    const Pair kept = entry<Pair>(r);
    p.damping = kept.damping;
    p.dissipated = kept.dissipated;
    p.work = kept.work;
    p.depth = kept.depth;
    p.penetration_since_clear = kept.penetration_since_clear;
  }
  send_slip();
}

// All ranks process the pairs in the same order, so that sends and receives match.
void BodyContact::send_slip() {
  const int rank = rank_of(comm_);
  for (Pair& p : pairs_) {
    const int a = bodies_of_volumes_[p.a].global;
    const int b = bodies_of_volumes_[p.b].global;
    if (a < 0 || b < 0) continue;
    const int from = mesh_.owner[a];
    const int to = mesh_.owner[b];
    if (from == to || (rank != from && rank != to)) continue;
    if (rank == from) {
      const std::vector<double> values = values_of(p.touching);
      MPI_Send(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, to, 0, comm_);
      continue;
    }
    MPI_Status status;
    int count = 0;
    MPI_Probe(from, 0, comm_, &status);
    MPI_Get_count(&status, MPI_DOUBLE, &count);
    std::vector<double> values(count);
    MPI_Recv(values.data(), count, MPI_DOUBLE, from, 0, comm_, MPI_STATUS_IGNORE);
    p.touching = points_of(values);
  }
}

}  // namespace hawser
