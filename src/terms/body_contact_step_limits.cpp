// How long a step may be where bodies meet, touch and part; and what a step that was taken made of energy.
// Bodies have few contacts with few, large masses: the motion on their springs is known exactly, and what is
// ahead is found by moving the bodies on. See docs/theory/body-contact.md, "Steps".
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "hawser/kernels/axis_sweep.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/terms/axis_distance.hpp"
#include "hawser/terms/body_contact.hpp"

namespace hawser {
namespace {

constexpr double kStepsAPeriod = 20;
constexpr double kShortest = 200;      // no more steps a period are asked for
constexpr double kEnergyError = 3e-4;  // of the energy of the motion against each other, in a step
constexpr int kLevels = 3;             // of an edge: in each eighth the gap has one minimum
constexpr int kHalvings = 12;

// G, the gap of the material y of A to B's surface by the motion of the two bodies.
Vec12 gap_gradient(const BodyFrame& A, const Vec3& y, const BodyFrame& B, const SurfacePoint& s) {
  const Vec3 z = B.to_body(A.to_space(y)), n = B.R * s.normal;
  Vec12 G;
  G << n, y.cross(A.R.transpose() * n), -n, s.normal.cross(z);
  return G;
}

}  // namespace

void BodyContactTerm::Both::move(double time) {
  const Vec3 surface = B.to_body(Bs.x);
  for (BodyFrame* f : {&A, &B}) {
    f->x += time * f->v;
    f->R = f->R * exp_so3(time * f->w).toRotationMatrix();
  }
  Bs.x = B.to_space(surface), Bs.R = B.R;
}

double BodyContactTerm::frequency(const Pair& pair, const Sum& s) const {
  if (!s.active) return 0;
  Mat12 W = Mat12::Zero();  // inverse of the root of the mass
  for (const auto& [body, first] :
       {std::pair(&bodies_of_volumes_[pair.a], 0), std::pair(&bodies_of_volumes_[pair.b], 6)}) {
    if (body->global < 0) continue;
    W.block<3, 3>(first, first) = Mat3::Identity() / std::sqrt(body->mass);
    W.block<3, 3>(first + 3, first + 3) = body->inverse_inertia.llt().matrixL();
  }
  const Mat12 K = W.transpose() * s.on.K * W;
  const Eigen::SelfAdjointEigenSolver<Mat12> solver(K, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues()[11], 0.0));
}

double BodyContactTerm::relative_energy(const Pair& pair, const Both& at) const {
  const Vec3 there = at.B.v + at.B.R * at.B.w.cross(at.B.to_body(at.A.x));
  double e = 0.5 * pair.mass * (at.A.v - there).squaredNorm();
  for (const auto& [body, f] :
       {std::pair(&bodies_of_volumes_[pair.a], &at.A), std::pair(&bodies_of_volumes_[pair.b], &at.B)})
    if (body->global >= 0) e += 0.5 * f->w.dot(body->inertia * f->w);
  return e;
}

double BodyContactTerm::fastest(const Pair& pair, const Both& at) const {
  const double arm = pair.middle.norm() + pair.radius;
  return (at.A.v - at.B.v).norm() + at.A.w.norm() * arm + at.B.w.norm() * (arm + (at.A.x - at.B.x).norm());
}

std::optional<BodyContactTerm::Nearest> BodyContactTerm::nearest(const Pair& pair, const Both& at,
                                                                 double within) const {
  const Vec3& ca = bodies_of_volumes_[pair.a].centre;
  const Surface& surface = *volumes_[pair.b].surface;
  const DistanceField field = distance_to(surface);
  const auto there = [&](const Vec3& y) { return at.Bs.to_body(at.A.to_space(y - ca)); };
  const SkeletonPart* best = nullptr;
  AxisToSurface found;
  double gap = within;
  for (const SkeletonBundle& b : volumes_[pair.a].skeleton.features) {
    const Vec3 z = there(b.centre);
    const double reach = b.radius + std::max(gap, 0.0);
    if (squared_distance(boxes_[pair.b], z) > reach * reach) continue;
    if (const auto s = surface.query(z, reach); !s || !(s->distance - b.radius < gap)) continue;
    for (const SkeletonPart& p : b.parts) {
      const auto near = nearest_to(field, BezierAxis::straight(there(p.from), there(p.to)), gap + p.radius,
                                   p.from == p.to ? 0 : kLevels);
      if (near) best = &p, found = *near, gap = near->distance - p.radius;
    }
  }
  if (!best) return std::nullopt;
  const Vec3 y = best->from + found.xi * (best->to - best->from);
  const auto s = surface.query(there(y), std::max(found.distance, 0.0) * (1 + 1e-9) + 1e-9);
  if (!s) return std::nullopt;
  return Nearest{gap, gap_gradient(at.A, y - ca, at.B, *s)};
}

// The stiffness grows with what gets into touch on the way: a twentieth of the period that the springs have
// at the end of the step.
double BodyContactTerm::followed(const Pair& pair, const Both& at, double most) const {
  const auto follows = [&](double h) {
    Both there = at;
    there.move(h);
    const double w = frequency(pair, contact(pair, there, kStiffness));
    return h * w <= 2 * M_PI / kStepsAPeriod;
  };
  if (follows(most)) return most;
  double good = 1e-4 * most, bad = most;
  for (int k = 0; k < kHalvings && bad > 1.1 * good; ++k) {
    const double h = std::sqrt(good * bad);
    (follows(h) ? good : bad) = h;
  }
  return good;
}

void BodyContactTerm::limit_by(const Pair& p, const Kinematics& committed, ImpactEvents& to) const {
  const Surface& surface = *volumes_[p.b].surface;
  const double speed = fastest(p, p.at), reach = std::isfinite(to.most) ? speed * to.most : HUGE_VAL;
  const Vec3 middle = p.at.Bs.to_body(p.at.A.to_space(p.middle));
  const double far = p.radius + p.law.smoothing + reach;
  if (squared_distance(boxes_[p.b], middle) > far * far || !surface.query(middle, far)) return;
  const double time_to_depth = speed > 0 ? std::max(p.most_depth / speed, 1e-6) : HUGE_VAL;
  to.limit(time_to_depth);  // it must not go deeper at once than a first touch would
  const double most = std::min(to.most, time_to_depth);
  if (p.frequency > 0) {
    const double period = 2 * M_PI / p.frequency;
    to.limit(followed(p, p.at, std::min(most, period / kStepsAPeriod)));
  }

  const auto place = nearest(p, p.at, p.law.smoothing + speed * std::min(most, 1e6));
  if (!place) return;
  Vec12 rates = Vec12::Zero(), accelerations = Vec12::Zero();
  double slowness_of_mass = 0;  // 1/kg
  for (const auto& [body, f, first] :
       {std::tuple(&bodies_of_volumes_[p.a], &p.at.A, 0), std::tuple(&bodies_of_volumes_[p.b], &p.at.B, 6)}) {
    rates.segment<3>(first) = f->v, rates.segment<3>(first + 3) = f->w;
    if (body->global < 0) {
      const RigidPose pose = bodies_->pose(body->body, committed.time);
      accelerations.segment<3>(first) = pose.acceleration;
      accelerations.segment<3>(first + 3) = f->R.transpose() * pose.angular_acceleration;
      continue;
    }
    const size_t n = static_cast<size_t>(body->node);
    accelerations.segment<3>(first) = committed.a[n],
    accelerations.segment<3>(first + 3) = committed.alpha[n];
    const Vec3 push = place->gradient.segment<3>(first), turn = place->gradient.segment<3>(first + 3);
    slowness_of_mass += push.squaredNorm() / body->mass + turn.dot(body->inverse_inertia * turn);
  }
  const Approach at{place->gap - p.law.smoothing, -place->gradient.dot(rates),
                    place->gradient.dot(accelerations), true};
  double slowness = 0;  // s
  if (at.gap < 0) {
    if (p.frequency == 0 || at.closing > 0) return;
    slowness = 1 / p.frequency;
  } else {
    if (!(at.closing > 0) || at.gap > at.closing * most) return;
    Both there = p.at;
    there.move(at.gap / at.closing);
    const double h = followed(p, there, most);
    to.limit(at.gap / at.closing + h);
    slowness = h * kStepsAPeriod / (2 * M_PI);
  }
  if (!p.counted) return;
  const auto group = [&](const PairBody& s) {
    return s.node < 0
               ? -1
               : mesh_.mesh->nodes[static_cast<size_t>(mesh_.global[static_cast<size_t>(s.node)])].line;
  };
  const int a = group(bodies_of_volumes_[p.a]), b = group(bodies_of_volumes_[p.b]);
  to.add(impact_event(slowness, p.law.smoothing, 1 / slowness_of_mass, at), std::max(a, b), std::min(a, b));
}

void BodyContactTerm::limit_step(const Kinematics& committed, ImpactEvents& to) const {
  for (const Pair& p : pairs_)
    if (p.here) limit_by(p, committed, to);
}

// What the trapezoidal rule takes for the work of the springs, against what they hold. A step that makes or
// loses too much is one that went too deep: it is taken again.
void BodyContactTerm::unresolved(const Kinematics& trial, UnresolvedImpacts& to) {
  for (const Pair& p : pairs_) {
    if (!p.here) continue;
    const Both now = both(p, trial);
    const Sum s = contact(p, now, kSprings);
    if (!s.active && p.potential == 0) continue;
    Vec12 way;
    way.segment<3>(0) = now.A.x - p.at.A.x, way.segment<3>(6) = now.B.x - p.at.B.x;
    way.segment<3>(3) = log_so3(Quat(Mat3(p.at.A.R.transpose() * now.A.R)));
    way.segment<3>(9) = log_so3(Quat(Mat3(p.at.B.R.transpose() * now.B.R)));
    const double made = s.potential - p.potential - 0.5 * (p.elastic + s.on.f).dot(way);
    if (!(std::abs(made) > kEnergyError * std::max(p.energy, s.potential))) continue;
    const double w = std::max(p.frequency, frequency(p, contact(p, now, kStiffness)));
    if (trial.step * w > 2 * M_PI / kShortest) to.too_deep = true;
  }
}

// Corners, edges and balls, in the frame of the other body; a corner is taken for as round as the ramp of its
// law is wide.
bool BodyContactTerm::tunnels(const Pair& pair, const Kinematics& trial) const {
  const PairBody &sa = bodies_of_volumes_[pair.a], &sb = bodies_of_volumes_[pair.b];
  const BodyFrame A = frame(sa, trial), B = frame(sb, trial);
  const Vec3 ca = sa.global < 0 ? Vec3(Vec3::Zero()) : sa.centre,
             cb = sb.global < 0 ? Vec3(Vec3::Zero()) : sb.centre;
  const auto before = [&](const Vec3& y) { return Vec3(pair.at.B.to_body(pair.at.A.to_space(y - ca)) + cb); };
  const auto after = [&](const Vec3& y) { return Vec3(B.to_body(A.to_space(y - ca)) + cb); };
  const Surface& surface = *volumes_[pair.b].surface;
  const Box& box = boxes_[pair.b];
  const BodySkeleton& skeleton = volumes_[pair.a].skeleton;
  const auto near = [&](const auto& b) {
    const Vec3 from = before(b.centre), to = after(b.centre), middle = 0.5 * (from + to);
    const double reach = b.radius + 0.5 * (to - from).norm() + pair.law.smoothing;
    return squared_distance(box, middle) <= reach * reach && surface.query(middle, reach);
  };
  const auto meets = [&](const Vec3& y0, const Vec3& y1, double radius) {
    return goes_through(distance_to(surface), BezierAxis::straight(before(y0), before(y1)),
                        BezierAxis::straight(after(y0), after(y1)), std::max(radius, pair.law.smoothing),
                        true);
  };
  return std::any_of(skeleton.features.begin(), skeleton.features.end(), [&](const SkeletonBundle& b) {
    return near(b) && std::any_of(b.parts.begin(), b.parts.end(),
                                  [&](const SkeletonPart& p) { return meets(p.from, p.to, p.radius); });
  });
}

Verdict BodyContactTerm::check_step(const Kinematics& trial) const {
  const bool through = trial.step > 0 && std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
                         return pair.counted && tunnels(pair, trial);
                       });
  return through ? Verdict{Verdict::Kind::shorter, "in it a body would pass through another one"} : Verdict{};
}

}  // namespace hawser
