// How long a step may be where bodies meet, touch and part; and what a step that was taken made of energy.
// Bodies have few contacts with few, large masses: the motion on their springs is known exactly, and what is
// ahead is found by moving the bodies on. See docs/theory/body-contact.md, "Steps".
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "body_contact_sum.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

constexpr double kStepsAPeriod = 20;
constexpr double kShortest = 200;      // no more steps a period are asked for
constexpr double kEnergyError = 3e-4;  // of the energy of the motion against each other, in a step
constexpr int kPieces = 8;             // of an edge, in each of which the gap has one minimum
constexpr int kHalvings = 12;

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
  if (!s.touches) return 0;
  Mat12 W = Mat12::Zero();  // inverse of the root of the mass
  for (const auto& [side, first] : {std::pair(&sides_[pair.a], 0), std::pair(&sides_[pair.b], 6)}) {
    if (side->global < 0) continue;
    W.block<3, 3>(first, first) = Mat3::Identity() / std::sqrt(side->mass);
    W.block<3, 3>(first + 3, first + 3) = side->inverse_inertia.llt().matrixL();
  }
  const Mat12 K = W.transpose() * s.stiffness * W;
  const Eigen::SelfAdjointEigenSolver<Mat12> solver(K, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues()[11], 0.0));
}

double BodyContactTerm::relative_energy(const Pair& pair, const Both& at) const {
  const Vec3 there = at.B.v + at.B.R * at.B.w.cross(at.B.to_body(at.A.x));
  double e = 0.5 * pair.mass * (at.A.v - there).squaredNorm();
  for (const auto& [side, f] : {std::pair(&sides_[pair.a], &at.A), std::pair(&sides_[pair.b], &at.B)})
    if (side->global >= 0) e += 0.5 * f->w.dot(side->inertia * f->w);
  return e;
}

double BodyContactTerm::fastest(const Pair& pair, const Both& at) const {
  const double arm = pair.middle.norm() + pair.radius;
  return (at.A.v - at.B.v).norm() + at.A.w.norm() * arm + at.B.w.norm() * (arm + (at.A.x - at.B.x).norm());
}

void BodyContactTerm::look_along(const Both& at, const Vec3& from, const Vec3& to, double radius,
                                 const Surface& surface, Nearest& best) const {
  const Vec3 way = to - from, along = at.A.R * way;
  const double piece = way.norm() / kPieces;
  struct Place {
    double gap = HUGE_VAL, slope = 0;
  };
  const auto look = [&](double xi) {
    const Vec3 y = from + xi * way;
    const auto s = surface.query(at.Bs.to_body(at.A.to_space(y)), std::max(best.gap, 0.0) + radius + piece);
    if (!s) return Place{};
    const Place p{s->distance - radius, (at.B.R * s->normal).dot(along)};
    if (p.gap < best.gap) best = {p.gap, body_gap_gradient(at.A, y, at.B, *s)};
    return p;
  };
  Place left = look(0);
  for (int i = 0; i < kPieces; ++i) {
    const Place right = look((i + 1.0) / kPieces);
    double a = static_cast<double>(i) / kPieces, b = a + 1.0 / kPieces;
    // The distance falls no faster than what is gone along.
    if (left.slope < 0 && right.slope > 0 && 0.5 * (left.gap + right.gap - piece) < best.gap)
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (a + b);
        (look(middle).slope > 0 ? b : a) = middle;
      }
    left = right;
  }
}

std::optional<BodyContactTerm::Nearest> BodyContactTerm::nearest(const Pair& pair, const Both& at,
                                                                 double within) const {
  const Vec3& ca = sides_[pair.a].centre;
  const Surface& surface = *volumes_[pair.b].surface;
  const BodySkeleton& skeleton = volumes_[pair.a].skeleton;
  Nearest best;
  best.gap = within;
  const auto near = [&](const auto& b) {
    const Vec3 z = at.Bs.to_body(at.A.to_space(b.centre - ca));
    const double reach = b.radius + std::max(best.gap, 0.0);
    if (squared_distance(boxes_[pair.b], z) > reach * reach) return false;
    const auto s = surface.query(z, reach);
    return s && s->distance - b.radius < best.gap;
  };
  for (const auto& b : skeleton.points)
    if (near(b))
      for (const SkeletonPoint& p : b.items) {
        const Vec3 y = p.at - ca;
        const auto s = surface.query(at.Bs.to_body(at.A.to_space(y)), std::max(best.gap, 0.0) + p.radius);
        if (s && s->distance - p.radius < best.gap)
          best = {s->distance - p.radius, body_gap_gradient(at.A, y, at.B, *s)};
      }
  for (const auto& b : skeleton.edges)
    if (near(b))
      for (const SkeletonEdge& e : b.items) look_along(at, e.from - ca, e.to - ca, e.radius, surface, best);
  if (!(best.gap < within)) return std::nullopt;
  return best;
}

// The stiffness grows with what gets into touch on the way: a twentieth of the period that the springs have
// at the end of the step.
double BodyContactTerm::followed(const Pair& pair, const Both& at, double most) const {
  const auto follows = [&](double h) {
    Both there = at;
    there.move(h);
    const double w = frequency(pair, touch(pair, there, false, true));
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
  const double room = speed > 0 ? std::max(p.room / speed, 1e-6) : HUGE_VAL;
  to.limit(room);  // it must not go deeper at once than a first touch would
  const double most = std::min(to.most, room);
  if (p.frequency > 0) {
    const double period = 2 * M_PI / p.frequency;
    to.limit(followed(p, p.at, std::min(most, period / kStepsAPeriod)));
  }

  const auto place = nearest(p, p.at, p.law.smoothing + speed * std::min(most, 1e6));
  if (!place) return;
  Vec12 rates = Vec12::Zero(), accelerations = Vec12::Zero();
  double slowness_of_mass = 0;  // 1/kg
  for (const auto& [side, f, first] :
       {std::tuple(&sides_[p.a], &p.at.A, 0), std::tuple(&sides_[p.b], &p.at.B, 6)}) {
    rates.segment<3>(first) = f->v, rates.segment<3>(first + 3) = f->w;
    if (side->global < 0) {
      const RigidPose pose = bodies_->pose(side->body, committed.time);
      accelerations.segment<3>(first) = pose.acceleration;
      accelerations.segment<3>(first + 3) = f->R.transpose() * pose.angular_acceleration;
      continue;
    }
    const size_t n = static_cast<size_t>(side->node);
    accelerations.segment<3>(first) = committed.a[n],
    accelerations.segment<3>(first + 3) = committed.alpha[n];
    const Vec3 push = place->gradient.segment<3>(first), turn = place->gradient.segment<3>(first + 3);
    slowness_of_mass += push.squaredNorm() / side->mass + turn.dot(side->inverse_inertia * turn);
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
  const auto group = [&](const Side& s) {
    return s.node < 0
               ? -1
               : mesh_.mesh->nodes[static_cast<size_t>(mesh_.global[static_cast<size_t>(s.node)])].line;
  };
  const int a = group(sides_[p.a]), b = group(sides_[p.b]);
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
    const Sum s = touch(p, now, false, true);
    if (!s.touches && p.potential == 0) continue;
    Vec12 way;
    way.segment<3>(0) = now.A.x - p.at.A.x, way.segment<3>(6) = now.B.x - p.at.B.x;
    way.segment<3>(3) = log_so3(Quat(Mat3(p.at.A.R.transpose() * now.A.R)));
    way.segment<3>(9) = log_so3(Quat(Mat3(p.at.B.R.transpose() * now.B.R)));
    const double made = s.potential - p.potential - 0.5 * (p.elastic + s.elastic).dot(way);
    if (!(std::abs(made) > kEnergyError * std::max(p.energy, s.potential))) continue;
    const double w = std::max(p.frequency, frequency(p, s));
    if (trial.step * w > 2 * M_PI / kShortest) to.too_deep = true;
  }
}

}  // namespace hawser
