// The class LineCandidates: validity of the list of near element pairs, prediction of paths, narrow test of a
// pair, exclusions along a line, and couplings of nodes.
#include "hawser/terms/line_candidates.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/base/mpi.hpp"
#include "hawser/geometry/box_pairs.hpp"
#include "hawser/geometry/segment_distance.hpp"
#include "hawser/kernels/bezier_axis.hpp"
#include "hawser/math/ordered.hpp"
#include "hawser/math/so3.hpp"

namespace hawser {
namespace {

// The length without contact near a shared place may shrink. The list excludes pairs only within this
// fraction of it, so that it remains valid for some time.
constexpr double kShared = 0.8;

// Data of an axis at the middle of its path, for the narrow test.
struct Middle {
  Vec3 a, b;   // chord
  Vec3 shift;  // mean displacement of its points from the middle to the end of the path
  // m, largest distance of the axis from the middle of its chord: half the chord and the bulge
  double around = 0;
  double bulge = 0;      // m, distance of the axis from its chord
  double spread = 0;     // m, deviation of the displacements from their mean
  double thickness = 0;  // m, sum of radius and skin
};

Middle middle(const SweptAxis& s) {
  BezierAxis p;
  std::array<Vec3, 4> d;
  Middle m;
  m.shift = Vec3::Zero();
  for (size_t i = 0; i < 4; ++i) {
    p.b[i] = 0.5 * (s.from[i] + s.to[i]);
    d[i] = 0.5 * (s.to[i] - s.from[i]);
    m.shift += 0.25 * d[i];
  }
  for (const Vec3& x : d) m.spread = std::max(m.spread, (x - m.shift).norm());
  m.a = p.b[0];
  m.b = p.b[3];
  m.bulge = p.sagitta();
  m.around = 0.5 * (m.b - m.a).norm() + m.bulge;
  m.thickness = s.radius + s.skin;
  return m;
}

// True if two axes anywhere on their paths may come nearer than the sum of both thicknesses.
bool near(const Middle& p, const Middle& q) {
  const double reach = p.thickness + q.thickness + p.spread + q.spread + (p.shift - q.shift).norm();
  const double around = reach + p.around + q.around;
  if ((0.5 * (p.a + p.b) - 0.5 * (q.a + q.b)).squaredNorm() > around * around) return false;
  return closest_points_of_segments(p.a, p.b, q.a, q.b).distance <= reach + p.bulge + q.bulge;
}

}  // namespace

Box swept_box(const SweptAxis& s) {
  Box b;
  for (const auto* end : {&s.from, &s.to})
    for (const Vec3& p : *end) b.add(p);
  return b.grown(s.radius + s.skin);
}

LineCandidates::LineCandidates(MPI_Comm comm, const LocalMesh& mesh, ContactRadii radii,
                               CandidateSettings settings)
    : comm_(comm), mesh_(mesh), radii_(std::move(radii)), settings_(std::move(settings)) {
  for (auto& p : settings_.excluded)
    if (p.first > p.second) std::swap(p.first, p.second);
  std::sort(settings_.excluded.begin(), settings_.excluded.end());
  if (settings_.shared) free_length_.assign(settings_.shared->size(), 0);
  gather();
}

// True if the list excludes pairs near a shared place that may touch in the present state.
bool LineCandidates::shares_less() const {
  for (size_t k = 0; k < free_length_.size(); ++k)
    if (settings_.shared->free_length(static_cast<int>(k)) < free_length_[k]) return true;
  return false;
}

void LineCandidates::gather() {
  local_.clear();
  built_.clear();
  list_.clear();
  local_.reserve(mesh_.elements.size());
  built_.reserve(mesh_.elements.size());
  for (const LocalElement& e : mesh_.elements)
    if (radius(e.global) > 0 && !is_in_feeder(e.global)) local_.push_back(e);
  for (const LocalElement& e : local_) built_.push_back(at_rest(e.global));
  bend_.resize(built_.size());
  // Most boxes that overlap are those of neighbours along a line. Their indices alone exclude these pairs.
  constexpr size_t kMost = 15;
  excluded_after_.assign(built_.size(), 0);
  for (size_t i = 0; i < built_.size(); ++i)
    for (size_t j = i + 1; j < std::min(built_.size(), i + 1 + kMost) && never(built_[i], built_[j]); ++j)
      ++excluded_after_[i];
  locate();
}

bool LineCandidates::set_elements_in_feeders(std::vector<std::array<int, 2>> inside) {
  if (inside == inside_) return false;
  inside_ = std::move(inside);
  gather();
  outdated_ = true;
  return true;
}

// First and last element of a line outside feeders.
std::array<int, 2> LineCandidates::outside(int line) const {
  const LineSpan& l = mesh_.mesh->lines[line];
  const std::array<int, 2> inside = inside_.empty() ? std::array{0, 0} : inside_[line];
  return {l.first_element + inside[0], l.first_element + l.elements - 1 - inside[1]};
}

bool LineCandidates::is_in_feeder(int element) const {
  if (inside_.empty()) return false;
  const auto [first, last] = outside(mesh_.mesh->part_of(element).line);
  return element < first || element > last;
}

// True if it is the element at a feeder's feed point, whose unstretched length differs from that of the mesh.
bool LineCandidates::at_feeder(int element) const {
  if (inside_.empty()) return false;
  const int line = mesh_.mesh->part_of(element).line;
  const auto [first, last] = outside(line);
  const std::array<int, 2>& inside = inside_[line];
  return (inside[0] > 0 && element == first) || (inside[1] > 0 && element == last);
}

double LineCandidates::skin(int element) const {
  return std::max(settings_.skin_diameters * 2 * radius(element),
                  settings_.skin_lengths * mesh_.mesh->length_of(element));
}

// Sets all members except the positions.
SweptAxis LineCandidates::at_rest(int element) const {
  const Element& e = mesh_.mesh->element(element);
  const auto arc = [&](int n) { return mesh_.mesh->node(n).arc; };
  return {element,         e.line,        e.first, e.second, {arc(e.first), arc(e.second)},
          radius(element), skin(element), {},      {}};
}

// Bézier points of the axis, Hermite's cubic (kernels/axis_shape.hpp), after a time h at the present rates.
std::array<Vec3, 4> LineCandidates::axis(const LocalElement& e, const Kinematics& state, double h) const {
  const size_t i = e.first;
  const size_t j = e.second;
  const Element& element = mesh_.element(e);
  const bool moves = h > 0;
  const auto place = [&](size_t n) -> Vec3 {
    return moves ? Vec3(state.x[n] + h * state.v[n] + (0.5 * h * h) * state.a[n]) : state.x[n];
  };
  const Vec3 a = place(i);
  const Vec3 b = place(j);
  if (!element.beam) return BezierAxis::straight(a, b).b;
  const double length = at_feeder(e.global) ? (b - a).norm() : element.length;
  const auto tangent = [&](size_t n) -> Vec3 {
    if (!moves) return state.q[n] * Vec3::UnitX();
    return state.q[n] * (exp_so3(h * state.w[n] + (0.5 * h * h) * state.alpha[n]) * Vec3::UnitX());
  };
  return BezierAxis::beam(a, tangent(i), b, tangent(j), length).b;
}

// True if every axis is within its skin of its predicted place at the fraction `tau` of its path. All axes
// must be at the same fraction, because a pair is excluded by the motion of both: an axis that stopped on its
// path could be hit by one that follows it.
bool LineCandidates::holds(const Kinematics& state, double h, double tau) const {
  if (builds_ == 0 && !local_.empty()) return false;
  for (size_t i = 0; i < local_.size(); ++i) {
    const SweptAxis& s = built_[i];
    const std::array<Vec3, 4> p = axis(local_[i], state, h);
    const double skin_i = skin(s.element);
    const double limit = skin_i * skin_i;
    const double bend = 4 * tau * (1 - tau);
    for (size_t k = 0; k < 4; ++k) {
      const Vec3 d = p[k] - s.from[k] - tau * (s.to[k] - s.from[k]) - bend * bend_[i][k];
      if (!(d.squaredNorm() <= limit)) return false;
    }
  }
  return true;
}

// The fraction of the path at a time. If no time has passed since the list was made (statics), the path leads
// to a trial state, and the fraction is that of its end, 1.
double LineCandidates::part(double time) const {
  if (!(time > built_at_)) return 1;
  return span_ > 0 ? std::min((time - built_at_) / span_, 1.0) : 0;
}

bool LineCandidates::covers(const Kinematics& trial) const {
  const bool held = holds(trial, 0, part(trial.time));
  outdated_ |= !held;
  return held;
}

bool LineCandidates::update(const Kinematics& committed, double h) {
  const bool known = builds_ > 0 && !outdated_ && !shares_less();
  // If no time has passed (statics), the axes may be at the end of the path, or at its start if the trial was
  // not taken.
  int usable[2] = {known && holds(committed, 0, part(committed.time)),
                   known && !(committed.time > built_at_) && holds(committed, 0, 0)};
  if (h > 0) {
    const bool predicted = known && holds(committed, h, part(committed.time + h));
    for (int& g : usable) g = g && predicted;
  }
  all_reduce(comm_, MPI_MIN, usable);
  if (usable[0] || usable[1]) return false;
  ++builds_;
  outdated_ = false;
  if (settings_.shared)
    for (size_t k = 0; k < free_length_.size(); ++k)
      free_length_[k] = kShared * settings_.shared->free_length(static_cast<int>(k));
  predict(committed, h);
  std::vector<std::pair<int, int>> pairs = search();
  const bool changed = on_any_rank(comm_, pairs != list_);
  list_ = std::move(pairs);
  return changed;
}

// The paths are parabolas in time. If they bend much (a line that is swung, a long step), they are predicted
// for fewer steps, but at least one, so that the bend is no more than a skin.
void LineCandidates::predict(const Kinematics& committed, double h) {
  built_at_ = committed.time;
  double steps = settings_.steps;
  const auto predict_paths = [&] {
    span_ = steps * h;
    double worst = 0;
    for (size_t i = 0; i < built_.size(); ++i) {
      SweptAxis& s = built_[i];
      const double straight = skin(s.element);
      double bend = 0;
      s.to = axis(local_[i], committed, span_);
      const std::array<Vec3, 4> half = axis(local_[i], committed, 0.5 * span_);
      for (size_t k = 0; k < 4; ++k) {
        bend_[i][k] = half[k] - 0.5 * (s.from[k] + s.to[k]);
        bend = std::max(bend, bend_[i][k].norm());
      }
      s.skin = straight + bend;
      worst = std::max(worst, bend / straight);
    }
    return worst;
  };
  for (size_t i = 0; i < built_.size(); ++i) built_[i].from = axis(local_[i], committed, 0);
  double worst = predict_paths();
  all_reduce(comm_, MPI_MAX, worst);
  if (worst > 1) {
    steps = std::max(1.0, std::floor(steps / std::sqrt(worst)));
    predict_paths();
  }
}

std::vector<std::pair<int, int>> LineCandidates::search() const {
  std::vector<Box> boxes;
  boxes.reserve(built_.size());
  for (const SweptAxis& s : built_) boxes.push_back(swept_box(s));
  const std::vector<SweptAxis> others = from_others(boxes);
  for (const SweptAxis& s : others) boxes.push_back(swept_box(s));
  const size_t local_count = built_.size();
  const auto axis_of = [&](size_t i) { return i < local_count ? &built_[i] : &others[i - local_count]; };
  std::vector<std::pair<int, int>> out;
  for (const auto& [first, second] : overlapping_pairs(boxes)) {
    const size_t i = first;
    const size_t j = second;
    if (i >= local_count) continue;  // pairs are ordered, so the second one is of another rank, too
    if (j - i <= excluded_after_[i]) continue;
    const SweptAxis* p = axis_of(i);
    const SweptAxis* q = axis_of(j);
    if (p->element > q->element) std::swap(p, q);  // so that all ranks compute identical results
    if (!excluded(*p, *q) && near(middle(*p), middle(*q))) out.emplace_back(p->element, q->element);
  }
  std::sort(out.begin(), out.end());
  return out;
}

// True if two elements are excluded regardless of their motion.
bool LineCandidates::never(const SweptAxis& p, const SweptAxis& q) const {
  if (!settings_.excluded.empty() &&
      std::binary_search(settings_.excluded.begin(), settings_.excluded.end(), ordered(p.line, q.line)))
    return true;
  const double exclusion = settings_.exclusion_diameters * (p.radius + q.radius);
  if (p.line == q.line && (p.second == q.first || q.second == p.first ||
                           std::max(q.arc[0] - p.arc[1], p.arc[0] - q.arc[1]) < exclusion))
    return true;
  return settings_.shared && settings_.shared->any_between(p.element, q.element, [&](const auto& f) {
    return f.one[0] + f.other[0] < exclusion;
  });
}

bool LineCandidates::excluded(const SweptAxis& p, const SweptAxis& q) const {
  if (never(p, q)) return true;
  return settings_.shared && settings_.shared->any_between(p.element, q.element, [&](const auto& f) {
    return std::max(f.one[1], f.other[1]) <= free_length_[f.place];
  });
}

void LineCandidates::list_couplings(Couplings& to) const {
  for (const auto& [a, b] : list_) {
    const Element& p = mesh_.mesh->element(a);
    const Element& q = mesh_.mesh->element(b);
    to.add({p.first, p.second}, {q.first, q.second});
  }
}

void LineCandidates::locate() {
  segments_.clear();
  pairs_.clear();
  std::vector<std::pair<int, int>> number;  // element and segment, sorted by element
  segments_.reserve(local_.size());
  number.reserve(local_.size());
  for (const LocalElement& e : local_) {
    number.emplace_back(e.global, static_cast<int>(segments_.size()));
    segments_.push_back({e.first, e.second, e.global, radius(e.global), mesh_.element(e)});
  }
  const auto find = [&](int element) {
    const auto at = std::lower_bound(number.begin(), number.end(), std::pair(element, 0));
    return at != number.end() && at->first == element ? at->second : -1;
  };
  std::vector<int> others;
  for (const auto& [a, b] : list_)
    for (int e : {a, b})
      if (find(e) < 0) others.push_back(e);
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  for (int e : others) {
    const Element& element = mesh_.mesh->element(e);
    ContactSegment s{mesh_.find(element.first), mesh_.find(element.second), e, radius(e), element};
    if (s.first < 0 || s.second < 0) throw std::logic_error("a candidate's nodes are not on this rank");
    number.emplace_back(e, static_cast<int>(segments_.size()));
    segments_.push_back(s);
  }
  std::sort(number.begin(), number.end());
  for (const auto& [a, b] : list_) {
    const int i = find(a);
    pairs_.push_back({i, find(b), segments_[i].first < mesh_.owned});
  }
}

}  // namespace hawser
