// The class LineVolumeContact: construction, and preparation of a step: contact laws of each element, and
// pairs of an element and a volume, or its facet groups, that may touch.
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {
LineVolumeContact::LineVolumeContact(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                                     std::vector<ContactVolume> volumes,
                                     std::vector<LineContactElement> elements, MPI_Comm comm,
                                     model::ContactMethod method)
    : mesh_(mesh),
      volumes_(mesh, std::move(bodies), std::move(volumes), comm),
      finder_(volumes_, method),
      elements_(std::move(elements)) {
  if (elements_.size() != mesh_.elements.size())
    throw std::invalid_argument("contact of lines needs one LineContactElement for each local element");
  accounts_.resize(elements_.size());
}

bool LineVolumeContact::refresh_couplings(const Kinematics& from, double h) {
  double thickest = 0;
  for (const LineContactElement& e : elements_) thickest = std::max(thickest, e.radius);
  return volumes_.refresh_couplings(from, h, thickest);
}

// The element at a feeder's feed point has the length at the speed of the start of the step, as for masses.
// It does not depend on the trial's positions, so the tangent is exact.
AxisEnds LineVolumeContact::ends(const Kinematics& state, int element) const {
  const LocalElement& e = mesh_.elements[element];
  AxisEnds out = element_axis(state, mesh_.element(e), e.first, e.second);
  if (feeders_)
    if (const FedLine* fed = feeders_->find(e.global)) out.length = fed->predicted;
  return out;
}

// An element inside a feeder touches nothing: its nodes coincide, and the cubic between them is a loop.
bool LineVolumeContact::idle(int element) const {
  return feeders_ && feeders_->idle(mesh_.elements[element].global);
}

std::array<ContactLaw, 2> LineVolumeContact::laws(const Pair& pair) const {
  const model::Volume& v = volumes_.settings(pair.volume);
  const LocalElement& e = mesh_.elements[pair.element];
  const double diameter = 2 * settings(pair).radius;
  std::array<ContactLaw, 2> laws;
  for (size_t i = 0; i < 2; ++i) {
    double factor = 1;  // 1/m, converts the basis to N/m²
    if (v.basis == model::StiffnessBasis::per_point)
      factor = 1 / (finder_.at_nodes() ? mesh_.node(i ? e.second : e.first).tributary : pair.length);
    if (v.basis == model::StiffnessBasis::per_area) factor = diameter;
    laws[i] = contact_law(v, factor, diameter, settings(pair).mass_per_length);
  }
  return laws;
}

void LineVolumeContact::renew_laws() {
  for (Pair& pair : pairs_) {
    pair.laws = laws(pair);
    pair.trial.evaluation = Pair::Evaluation::none;
  }
}

void LineVolumeContact::enable_friction(bool on) {
  friction_on_ = on;
  for (Pair& pair : pairs_) pair.trial.evaluation = Pair::Evaluation::none;
}

void LineVolumeContact::prepare(const Kinematics& from, double h) {
  volumes_.pose_start(from);
  near_.clear();
  std::vector<Pair> old;
  old.swap(pairs_);
  pairs_.reserve(old.size());
  size_t known = 0;
  Pair pair;  // reused, because most pairs are far apart and discarded
  for (int e = 0; e < static_cast<int>(elements_.size()); ++e) {
    if (!(elements_[e].radius > 0) || idle(e)) continue;
    const AxisEnds at = ends(from, e);
    const AxisShape shape(at);
    for (int k = 0; k < volumes(); ++k) {
      const auto key = [&] { return std::pair(old[known].element, old[known].volume); };
      while (known < old.size() && key() < std::pair(e, k)) ++known;
      pair.element = e;
      pair.volume = k;
      double motion = 0;
      if (!start_pair(pair, at, shape, h, motion)) continue;
      if (known < old.size() && key() == std::pair(e, k)) reuse_previous(old[known], pair);
      start_facet_groups(pair, motion);
      pairs_.push_back(std::move(pair));
      pair = {};
    }
  }
}

// A pair is a candidate if the volume's box is nearer to the element than the contact distance and a margin:
// twice the distance by which line and body can approach each other in the step at their present speed, and
// at least half an element. In statics (h = 0) Newton iterations may move the line anywhere, so every pair is
// a candidate; so is every pair of gap springs.
bool LineVolumeContact::start_pair(Pair& pair, const AxisEnds& at, const AxisShape& shape, double h,
                                   double& motion) const {
  const LocalElement& e = mesh_.elements[pair.element];
  const RigidPose& pose = volumes_.start_pose(pair.volume);
  pair.length = at.length;
  pair.radius = settings(pair).radius;
  pair.held = settings(pair).held;
  pair.laws = laws(pair);
  pair.contact_distance = pair.radius + pair.smoothing();
  const double speed =
      std::max((at.v1 - pose.velocity_at(at.x1)).norm(), (at.v2 - pose.velocity_at(at.x2)).norm());
  const double margin = std::max(2 * h * speed, 0.5 * pair.length);
  const double away = distance(volumes_.box(pair.volume), pose.to_body(shape.point(0.5)));
  if (h > 0 && away > pair.contact_distance + margin + 0.5 * shape.slope_bound() && !finder_.by_gap())
    return false;
  pair.part =
      volumes_.takes_part(mesh_.element(e).line, pair.volume, arc_at(mesh_, e, 0), arc_at(mesh_, e, 1));
  if (pair.part.none()) return false;
  pair.levels = contact_levels(pair.length, pair.radius);
  pair.start.shape = shape;
  pair.start.pose = pose;
  motion = h > 0 ? 2 * h * speed : std::numeric_limits<double>::max();
  return true;
}

// Takes over the results of the last step. `contact` is reused only if it refers to the whole surface,
// because facet groups may have changed, and only without contact, because panels must be split as at the
// start of this step.
void LineVolumeContact::reuse_previous(Pair& previous, Pair& pair) const {
  if (!previous.start.several_groups && previous.start.points.empty())
    pair.trial.contact = std::move(previous.trial.contact);
  pair.start.points = std::move(previous.start.points);
  pair.start.springs = previous.start.springs;
  pair.cache = std::move(previous.cache);
  if (pair.start.points.empty()) pair.cache.near_facets.clear();
}

// Determines whether several facet groups may be reached in the step. Gap springs need only their anchor.
void LineVolumeContact::start_facet_groups(Pair& pair, double motion) const {
  const AxisShape& shape = pair.start.shape;
  const RigidPose& pose = pair.start.pose;
  if (!finder_.by_gap()) {
    const bool touched = !pair.start.points.empty() && pair.start.points.back().group > 0;
    pair.start.several_groups = touched || !finder_.one_facet_group(pair, motion);
    if (pair.start.several_groups) pair.trial.contact = {};
    return;
  }
  for (size_t i = 0; i < 2; ++i)
    if (!pair.start.springs[i].paired)
      pair.start.springs[i] = finder_.spring_at(
          pair.volume, pose.to_body(shape.point(static_cast<double>(i))), pair.contact_distance);
}

int LineVolumeContact::candidates() const { return static_cast<int>(pairs_.size()); }

}  // namespace hawser
