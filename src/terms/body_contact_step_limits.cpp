// The class BodyContact: step length when bodies approach, touch and separate, and check of the energy
// error of a step. Bodies have few contacts and large masses: the motion on their springs is known exactly,
// and coming contact is found by moving the bodies ahead. See docs/theory/body-contact.md, "Steps".
#include <algorithm>
#include <cmath>

#include "hawser/advice/steps.hpp"
#include "hawser/kernels/axis_sweep.hpp"
#include "hawser/math/so3.hpp"
#include "hawser/math/symmetric.hpp"
#include "hawser/terms/axis_distance.hpp"
#include "hawser/terms/body_contact.hpp"

namespace hawser {
namespace {

constexpr double kStepsAPeriod = 20;
constexpr double kMaxStepsAPeriod = 200;  // that is requested
constexpr double kEnergyError = 3e-4;     // per step, fraction of the energy of the relative motion
constexpr int kLevels = 3;                // of an edge: the gap has one minimum in each eighth
constexpr int kMostSteps = 20;            // that are examined
// Relative tolerance of a frequency: with constant stiffness, the frequency at the end of the longest step
// differs from that at its start only by rounding.
constexpr double kRounding = 1e-9;

}  // namespace

void BodyContact::PairFrames::move(double time) {
  for (BodyFrame* f : {&A, &B}) {
    f->x += time * f->v;
    f->R = f->R * exp_so3(time * f->w).toRotationMatrix();
  }
}

// The velocity of A is that relative to the material of B at its place, as the springs depend on the relative
// motion alone:
//   v_A - v_B - W x r,   a_A - a_B - W' x r - W x (W x r) - 2 W x (v_A - v_B - W x r),   r = x_A - x_B.
// For the angular acceleration both bodies are assumed to turn together.
std::pair<Vec6, Vec6> BodyContact::PairFrames::relative_motion() const {
  const Vec3 arm = A.x - B.x;
  const Vec3 turning = B.R * B.w;
  const Vec3 velocity = A.v - B.v - turning.cross(arm);
  const Vec3 carried = B.a + (B.R * B.alpha).cross(arm) + turning.cross(turning.cross(arm));
  const Vec3 acceleration = A.a - carried - 2 * turning.cross(velocity);
  const Mat3 back = turn().transpose();
  return {(Vec6() << velocity, A.w - back * B.w).finished(),
          (Vec6() << acceleration, A.alpha - back * B.alpha).finished()};
}

// With the root L of the inverse mass matrix the modes obey L'KL e = w² e. Rates q' of the unknowns deform
// the spring of a mode at the rate u = e.L'K q'/w², accelerations q'' likewise at c = e.L'K q''/w², and it
// vibrates about its equilibrium with the energy (u² + c²/w²)/2. Springs of friction are taken to be as stiff
// as the fastest of these modes: a body that begins to slide or to stick with the acceleration a vibrates on
// them with the energy m a²/2w².
BodyContact::Frequencies BodyContact::frequencies(const Pair& pair, const PairFrames& at,
                                                  const Sum& s) const {
  if (!s.active) return {};
  const Mat12 springs = pair.root.transpose() * s.residual.K;
  const Eigenpairs modes = eigenpairs(Mat12(springs * pair.root));
  const auto [rates, accelerations] = at.relative_motion();
  const Vec12 by_rates = springs.leftCols<6>() * rates;
  const Vec12 by_accelerations = springs.leftCols<6>() * accelerations;
  const double highest = std::max(modes.values[11], 0.0);
  Frequencies out{.highest = std::sqrt(highest)};
  if (pair.friction.axial > 0 &&
      0.5 * pair.mass * accelerations.head<3>().squaredNorm() > kEnergyError * pair.energy * highest) {
    out.significant = out.highest;
    return out;
  }
  double energy = 0;
  for (Eigen::Index i = 11; i >= 0 && modes.values[i] > kRounding * highest; --i) {
    const double square = modes.values[i];
    const double u = modes.vectors.col(i).dot(by_rates) / square;
    const double c = modes.vectors.col(i).dot(by_accelerations) / square;
    energy += 0.5 * (u * u + c * c / square);
    if (energy > kEnergyError * pair.energy) {
      out.significant = std::sqrt(square);
      return out;
    }
  }
  return out;
}

double BodyContact::relative_energy(const Pair& pair, const PairFrames& at) const {
  const Vec3 speed = at.A.v - at.B.velocity(at.B.to_body(at.A.x));
  return 0.5 * (pair.mass * speed.squaredNorm() + at.A.w.dot(bodies_of_volumes_[pair.a].inertia * at.A.w) +
                at.B.w.dot(bodies_of_volumes_[pair.b].inertia * at.B.w));
}

double BodyContact::fastest(const Pair& pair, const PairFrames& at) const {
  const SkeletonParts& leads = volumes_[pair.a].skeleton.features;
  const double arm = (leads.centre() - at.A.centre).norm() + leads.radius();
  return (at.A.v - at.B.v).norm() + at.A.w.norm() * arm + at.B.w.norm() * (arm + (at.A.x - at.B.x).norm());
}

std::optional<BodyContact::Nearest> BodyContact::nearest(const Pair& pair, const PairFrames& at,
                                                         double within) const {
  const Surface& surface = *volumes_[pair.b].surface;
  auto field = distance_to(surface);
  Vec3 y = Vec3::Zero();  // point of A
  double gap = within;
  double distance = -HUGE_VAL;
  volumes_[pair.a].skeleton.features.walk(
      [&](const Vec3& centre, double radius) { return near(pair.b, at.across(centre), radius, gap); },
      [&](const SkeletonPart& p) {
        const BezierAxis axis = BezierAxis::straight(at.across(p.from), at.across(p.to));
        const auto closest = nearest_to(field, axis, gap + p.radius, p.from == p.to ? 0 : kLevels);
        if (!closest) return;
        y = p.from + closest->xi * (p.to - p.from);
        distance = closest->distance;
        gap = distance - p.radius;
      });
  if (!(gap < within)) return std::nullopt;
  const Vec3 z = at.across(y);
  const auto s = surface.query(z, std::max(distance, 0.0) * (1 + 1e-9) + 1e-9);
  if (!s) return std::nullopt;
  const Vec3 n = at.B.R * s->normal;
  Nearest out{gap, {}};
  out.gradient << n, (y - at.A.centre).cross(at.A.R.transpose() * n), -n, s->normal.cross(z - at.B.centre);
  return out;
}

// The stiffness increases with the features that come into contact during the step, so the criterion is a
// twentieth of the period at the end of the step. Let w be the frequency at the end of a step. If the step is
// too long, 2 pi/20 w is short enough; if the step is short enough, 2 pi/20 w is an upper limit of the
// result, provided that w increases with the step. Otherwise the geometric mean of the limits is tried.
double BodyContact::resolved_step(const PairFrames& at, double max_step, FrequencyAt frequency_at) {
  double accepted = 1e-4 * max_step;
  double rejected = max_step;
  double h = max_step;
  bool by_mean = true;  // not by the frequency, which after a rejection may come no nearer
  for (int k = 0; k < kMostSteps && rejected > 1.1 * accepted; ++k) {
    PairFrames moved = at;
    moved.move(h);
    const double w = frequency_at(moved);
    const double resolving = 2 * M_PI / (kStepsAPeriod * w);
    const bool resolves = h <= resolving * (1 + kRounding);
    if (resolves && h == max_step) return max_step;
    (resolves ? accepted : rejected) = h;
    if (resolves) rejected = std::min(rejected, resolving);
    by_mean = resolves || !by_mean || resolving <= accepted;
    h = by_mean ? std::sqrt(accepted * rejected) : resolving;
  }
  return accepted;
}

void BodyContact::limit_by(const Pair& p, ImpactEvents& to) const {
  const SkeletonParts& leads = volumes_[p.a].skeleton.features;
  const double speed = fastest(p, p.frames);
  const double reach = std::isfinite(to.max_step) ? speed * to.max_step : HUGE_VAL;
  if (!near(p.b, p.frames.across(leads.centre()), leads.radius(), p.law.smoothing + reach)) return;
  const double time_to_depth = speed > 0 ? std::max(p.max_approach / speed, 1e-6) : HUGE_VAL;
  to.limit(time_to_depth);  // not deeper in one step than at a first touch
  const double max_step = std::min(to.max_step, time_to_depth);
  const auto frequencies_at = [&](const PairFrames& at) {
    return frequencies(p, at, contact(p, at, kStiffness));
  };
  const auto highest = [&](const PairFrames& at) { return frequencies_at(at).highest; };
  const auto significant = [&](const PairFrames& at) { return frequencies_at(at).significant; };
  if (p.frequencies.highest > 0) {
    const double w = p.frequencies.significant;
    const double resolved = w > 0 ? 2 * M_PI / (kStepsAPeriod * w) : HUGE_VAL;
    to.limit(resolved_step(p.frames, std::min(max_step, resolved), significant));
  }

  const auto place = nearest(p, p.frames, p.law.smoothing + speed * std::min(max_step, 1e6));
  if (!place) return;
  const Approach at{place->gap - p.law.smoothing, -place->gradient.dot(p.frames.rates()),
                    place->gradient.dot(p.frames.accelerations()), true};
  double inverse_frequency = 0;  // s
  if (at.gap < 0) {
    if (p.frequencies.highest == 0 || at.closing > 0) return;
    inverse_frequency = 1 / p.frequencies.highest;
  } else {
    if (!(at.closing > 0) || at.gap > at.closing * max_step) return;
    PairFrames moved = p.frames;
    moved.move(at.gap / at.closing);
    const double h = resolved_step(moved, max_step, highest);
    to.limit(at.gap / at.closing + h);
    inverse_frequency = h * kStepsAPeriod / (2 * M_PI);
  }
  if (!p.counted) return;
  const auto group = [&](size_t volume) {
    const int node = bodies_of_volumes_[volume].global;
    return node < 0 ? -1 : mesh_.mesh->node(node).line;
  };
  const double mass = 1 / (p.root.transpose() * place->gradient).squaredNorm();
  to.add(impact_event(inverse_frequency, p.law.smoothing, mass, at), std::max(group(p.a), group(p.b)),
         std::min(group(p.a), group(p.b)));
}

void BodyContact::limit_step(const Kinematics&, ImpactEvents& to) {
  for (const Pair& p : pairs_)
    if (p.owns_body) limit_by(p, to);
}

// Compares the trapezoidal work of the springs with the energy that they store. A step with too large a
// difference went too deep and is repeated.
void BodyContact::unresolved(const Kinematics& trial, UnresolvedImpacts& to) {
  for (const Pair& p : pairs_) {
    if (!p.owns_body) continue;
    const PairFrames now = frames_of(p, trial);
    const Sum s = contact(p, now, kSprings);
    if (!s.active && p.potential == 0) continue;
    Vec12 displacement;
    displacement.segment<3>(0) = now.A.x - p.frames.A.x;
    displacement.segment<3>(6) = now.B.x - p.frames.B.x;
    displacement.segment<3>(3) = log_so3(Quat(Mat3(p.frames.A.R.transpose() * now.A.R)));
    displacement.segment<3>(9) = log_so3(Quat(Mat3(p.frames.B.R.transpose() * now.B.R)));
    const double created = s.potential - p.potential - 0.5 * (p.elastic + s.residual.f).dot(displacement);
    if (!(std::abs(created) > kEnergyError * std::max(p.energy, s.potential))) continue;
    const Frequencies at_end = frequencies(p, now, contact(p, now, kStiffness));
    const double w = std::max(p.frequencies.highest, at_end.highest);
    if (trial.step * w > 2 * M_PI / kMaxStepsAPeriod) to.too_fast = true;
  }
}

// Tests corners, edges and balls in the frame of the other body. The radius of a corner is taken as the width
// of the law's ramp, at least its default.
bool BodyContact::tunnels(const Pair& pair, const Kinematics& trial) const {
  const PairFrames& before = pair.frames;
  const PairFrames now = frames_of(pair, trial);
  auto field = distance_to(*volumes_[pair.b].surface);
  const double smoothing = pair.law.smoothing;
  const double round = std::max(smoothing, pair.round);
  const double turned = now.turned_since(before).norm();
  bool through = false;
  volumes_[pair.a].skeleton.features.walk(
      [&](const Vec3& centre, double radius) {
        const Vec3 from = before.across(centre);
        const Vec3 to = now.across(centre);
        const double path = (to - from).norm();
        // passes_through() does not test points that move less than the radius.
        return !through && path + turned * radius > round &&
               near(pair.b, 0.5 * (from + to), radius + 0.5 * path, smoothing);
      },
      [&](const SkeletonPart& p) {
        through =
            through || passes_through(field, BezierAxis::straight(before.across(p.from), before.across(p.to)),
                                      BezierAxis::straight(now.across(p.from), now.across(p.to)),
                                      std::max(p.radius, round), true);
      });
  return through;
}

Verdict BodyContact::check_step(const Kinematics& trial) const {
  for (const Pair& pair : pairs_) {
    if (!pair.counted) continue;
    if (const auto pressed = pressed_through(pair, trial)) return {Verdict::Kind::shorter, *pressed};
    if (tunnels(pair, trial) || (pair.needs_overlap_check && overlaps_within_step(pair, trial)))
      return {Verdict::Kind::shorter, advice::BodyPassesBody{names_[pair.a], names_[pair.b]}};
  }
  return {};
}

}  // namespace hawser
