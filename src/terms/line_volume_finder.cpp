// The class LineVolumeFinder: finds contact in a trial, as intervals with Gauss points along an element or at
// its ends, and the contact-free tube in which no search is necessary.
#include "hawser/terms/line_volume_finder.hpp"

#include <algorithm>
#include <limits>

namespace hawser {
namespace {

// If an axis is free, up to kProbes more points are queried until the radius of the free tube is at least
// kCertain times the smallest distance.
constexpr int kProbes = 4;
constexpr double kCertain = 0.5;
// Range of the first query at the middle, in multiples of the upper bound of |dx/dxi|.
constexpr double kFirst = 2;
// Fraction of an element's length, by the weights of its Gauss points, above which all of it touched.
constexpr double kAll = 1 - 1e-9;

// Restricts panels to the part of the axis that may touch. The limit is a fixed material point.
void clip(const ActiveInterval& part, std::vector<ContactInterval>& panels) {
  for (ContactInterval& s : panels) {
    if (s.from < part.from) {
      s.from = part.from;
      s.from_moves = false;
    }
    if (s.to > part.to) {
      s.to = part.to;
      s.to_moves = false;
    }
  }
  std::erase_if(panels, [](const ContactInterval& s) { return !(s.from < s.to); });
}

bool touched_all_along(const LineVolumePair& pair, int group) {
  double touched = 0;
  for (const AxisContactPoint& p : pair.previous(group)) touched += p.weight;
  return touched > kAll * pair.length;
}

}  // namespace

BezierAxis bezier_in(const RigidPose& pose, const AxisShape& shape) {
  BezierAxis axis = shape.bezier();
  for (Vec3& p : axis.b) p = pose.to_body(p);
  return axis;
}

// Gap minus smoothing along the axis, for the search for intervals, with a list of the queried distances.
class LineVolumeFinder::Gap {
 public:
  Gap(const LineVolumeFinder& finder, LineVolumePair& pair, int group, const AxisShape& shape,
      const RigidPose& pose, std::vector<ClearancePoint>& places)
      : finder_(finder), pair_(pair), group_(group), shape_(shape), pose_(pose), places_(places) {
    places_.clear();
  }

  std::optional<SurfacePoint> query(double xi, double within) {
    const Vec3 y = pose_.to_body(shape_.point(xi));
    const auto p = finder_.query(pair_, group_, xi, y, pair_.contact_distance + within);
    places_.push_back({xi, p ? p->distance : pair_.contact_distance + within});
    if (p) pair_.cache.hint = p->triangle;
    return p;
  }
  // True if the axis may touch somewhere: the gap at its middle is less than half the bound of the slope.
  bool may_touch() {
    const double within = kFirst * shape_.slope_bound();
    const auto p = query(0.5, within);
    middle_ = {p ? p->distance - pair_.contact_distance : within, p ? slope(0.5, *p) : 0};
    return middle_->gap < 0.5 * shape_.slope_bound();
  }
  AxisGap operator()(double xi, double within) {
    if (xi == 0.5 && middle_) return *middle_;
    const auto p = query(xi, within);
    return p ? AxisGap{p->distance - pair_.contact_distance, slope(xi, *p)} : AxisGap{within, 0};
  }

 private:
  double slope(double xi, const SurfacePoint& p) const {
    return (pose_.rotation * p.normal).dot(shape_.slope(xi));
  }
  const LineVolumeFinder& finder_;
  LineVolumePair& pair_;
  int group_;
  const AxisShape& shape_;
  const RigidPose& pose_;
  std::vector<ClearancePoint>& places_;
  std::optional<AxisGap> middle_;
};

bool LineVolumeFinder::certainly_clear(const LineVolumePair& pair, const AxisShape& shape,
                                       const RigidPose& pose) {
  return pair.cache.clearance.radius_about(bezier_in(pose, shape)) > 0;
}

bool LineVolumeFinder::skip_if_clear(LineVolumePair& pair, const AxisShape& shape,
                                     const RigidPose& pose) const {
  if (!certainly_clear(pair, shape, pose)) return false;
  pair.trial.contact.clear();
  pair.trial.near = {};
  pair.trial.evaluation = LineVolumePair::Evaluation::none;
  return true;
}

double LineVolumeFinder::clearance_at_start(const LineVolumePair& pair) {
  return pair.cache.clearance.radius_about(bezier_in(pair.start.pose, pair.start.shape));
}

void LineVolumeFinder::update_clearance(LineVolumePair& pair, const AxisShape& shape, const RigidPose& pose,
                                        std::vector<ClearancePoint>& places) const {
  const auto by_xi = [](const ClearancePoint& a, const ClearancePoint& b) { return a.xi < b.xi; };
  std::sort(places.begin(), places.end(), by_xi);
  double smallest_gap = std::numeric_limits<double>::infinity();
  double worst = 0;
  for (const ClearancePoint& p : places)
    smallest_gap = std::min(smallest_gap, p.distance - pair.contact_distance);
  if (!(smallest_gap > 0)) return;
  const auto free_radius = [&] {
    return least_distance(places, shape.slope_bound(), shape.bend_bound(), worst) - pair.contact_distance;
  };
  double free = free_radius();
  for (int i = 0; i < kProbes && free < kCertain * smallest_gap; ++i) {
    const double within = pair.contact_distance + 2 * smallest_gap;
    const auto p = surface(pair).query(pose.to_body(shape.point(worst)), within, pair.cache.hint);
    const ClearancePoint more{worst, p ? p->distance : within};
    places.insert(std::upper_bound(places.begin(), places.end(), more, by_xi), more);
    smallest_gap = std::min(smallest_gap, more.distance - pair.contact_distance);
    free = free_radius();
  }
  if (!(free > 0)) return;  // Surface::free_radius() only shortens distances
  for (ClearancePoint& p : places)
    p.distance = surface(pair).free_radius(pose.to_body(shape.point(p.xi)), p.distance, pair.cache.hint);
  pair.cache.clearance.offer(bezier_in(pose, shape), free_radius());
}

const std::vector<ContactInterval>& LineVolumeFinder::intervals_at_start(LineVolumePair& pair) const {
  static const std::vector<ContactInterval> kNone;
  if (pair.group(0)) return kNone;
  if (pair.start.intervals) return *pair.start.intervals;
  pair.start.intervals.emplace();
  if (pair.start.points.empty()) return kNone;
  if (touched_all_along(pair, 0)) {
    pair.start.intervals->emplace_back();
    return *pair.start.intervals;
  }
  // More halvings than in a trial, which would otherwise fill intervals that are missed here.
  constexpr int kCloser = 2;
  const AxisShape& start = pair.start.shape;
  std::vector<ClearancePoint> places;
  Gap gap(*this, pair, 0, start, pair.start.pose, places);
  *pair.start.intervals = contact_intervals(
      gap, {start.slope_bound(), pair.contact_distance, start.bend_bound()}, pair.levels + kCloser);
  return *pair.start.intervals;
}

std::vector<ContactInterval> LineVolumeFinder::locate(LineVolumePair& pair, int group, const AxisShape& shape,
                                                      const RigidPose& pose) const {
  const std::vector<ContactInterval>& before = intervals_at_start(pair);
  Gap gap(*this, pair, group, shape, pose, places_);
  const bool near = gap.may_touch();
  // If the element touched all along, contact is not expected to begin, end or lift off within it, and fewer
  // halvings suffice.
  const int levels = touched_all_along(pair, group) ? panel_levels(pair.length, pair.radius) : pair.levels;
  std::vector<ContactInterval> intervals;
  if (near)
    intervals = contact_intervals(gap, {shape.slope_bound(), pair.contact_distance, shape.bend_bound()},
                                  levels, middles(inactive_intervals(before)));
  // The distance to one facet group is no bound for the others.
  if (intervals.empty() && !pair.group(group)) update_clearance(pair, shape, pose, places_);
  std::vector<ContactInterval> panels =
      split_intervals(as_split_before(intervals, before, pair.trial.contact.filled), levels);
  if (!pair.part.all()) clip(pair.part, panels);
  return panels;
}

void LineVolumeFinder::find_along(LineVolumePair& pair, int group, const AxisShape& shape,
                                  const RigidPose& pose) const {
  pair.trial.contact.add_panels(locate(pair, group, shape, pose), group, pair.length, [&](double xi) {
    const auto p = query(pair, group, xi, pose.to_body(shape.point(xi)), pair.contact_distance);
    if (p) pair.cache.hint = p->triangle;
    return p;
  });
}

// The trapezoidal rule: each end has the weight of its half of the element.
void LineVolumeFinder::find_at_nodes(LineVolumePair& pair, int group, const AxisShape& shape,
                                     const RigidPose& pose) const {
  ContactQuadrature& f = pair.trial.contact;
  Gap gap(*this, pair, group, shape, pose, places_);
  // The middle cannot show contact behind one of several facet groups.
  const bool near = by_gap() || pair.group(group) || gap.may_touch();
  for (const double xi : {0.0, 1.0}) {
    if (!near || !takes_part(pair, xi)) continue;
    const auto p = gap.query(xi, 0.5 * shape.slope_bound());
    if (!p || !pair.in_contact(*p)) continue;
    f.quadrature.push_back({xi, 0.5 * pair.length, {xi, 1}, f.panels.size(), *p});
    f.panels.push_back({{0.5 * xi, 0.5 + 0.5 * xi}, group});
  }
  if (f.panels.empty() && !pair.group(group) && !by_gap()) update_clearance(pair, shape, pose, places_);
}

bool LineVolumeFinder::takes_part(const LineVolumePair& pair, double xi) const {
  if (!pair.part.has(xi)) return false;
  // At a held end the support carries the force that a surface would exert.
  return !at_nodes() || (xi == 0 && !pair.held[0]) || (xi == 1 && !pair.held[1]);
}

const ContactQuadrature& LineVolumeFinder::find(LineVolumePair& pair, const AxisShape& shape,
                                                const RigidPose& pose) const {
  return skip_if_clear(pair, shape, pose) ? pair.trial.contact : search(pair, shape, pose);
}

const ContactQuadrature& LineVolumeFinder::search(LineVolumePair& pair, const AxisShape& shape,
                                                  const RigidPose& pose) const {
  const bool same = pair.trial.contact.configuration.same_configuration(shape, pose);
  if (!pair.trial.contact.configuration.same_motion(shape, pose))
    pair.trial.evaluation = LineVolumePair::Evaluation::none;
  if (!same) pair.trial.contact.clear();
  pair.trial.contact.configuration = {true, shape, pose};
  if (same) return pair.trial.contact;
  pair.trial.near = {};
  if (pair.start.several_groups) find_facet_groups(pair, shape, pose);
  for (int w = 0; w < pair.facet_groups(); ++w)
    at_nodes() ? find_at_nodes(pair, w, shape, pose) : find_along(pair, w, shape, pose);
  return pair.trial.contact;
}

// The surface is searched at any distance; the box of a plane has no useful size.
GapSpring LineVolumeFinder::spring_at(int volume, const Vec3& y, double contact_distance) const {
  const Surface& surface = volumes_.surface(volume);
  const Box box = surface.bounds();
  const auto p = surface.query(y, distance(box, y) + std::min(box.extent().norm(), 1e6) + contact_distance);
  return p ? GapSpring{true, y - p->distance * p->normal, p->normal} : GapSpring{};
}

}  // namespace hawser
