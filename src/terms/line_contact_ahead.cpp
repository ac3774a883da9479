// How long a step may be: what touches, and what elements may come to.
#include <algorithm>
#include <array>
#include <limits>

#include "hawser/terms/line_contact.hpp"

namespace hawser {
namespace {

constexpr std::array<double, 3> kPlaces{0, 0.5, 1};  // of an element
constexpr size_t kBatch = 2048;                      // pairs that ask in one call

}  // namespace

// What is to be asked of the places of some pairs. An end of an element is mostly that of the next as well,
// and is asked once.
class LineContact::Ahead {
 public:
  explicit Ahead(const LineContact& contact) : contact_(contact) {}
  void clear() { places_.clear(), asked_.clear(), ends_.assign(contact_.volumes_.size(), -1); }
  // Of a place of a pair, in their order.
  void skip() { places_.push_back({}); }
  void add(const Pair& pair, size_t place, const Vec3& y, double within) {
    int& end = ends_[static_cast<size_t>(pair.volume)];
    int me = place == 0 ? end : -1;
    if (me < 0 || asked_[static_cast<size_t>(me)].question.point != y) {
      me = static_cast<int>(asked_.size());
      asked_.push_back({pair.volume, {y, within, pair.ahead[place]}, {}});
    }
    Asked& asked = asked_[static_cast<size_t>(me)];
    asked.question.max_distance = std::max(asked.question.max_distance, within);
    if (place == 2) end = me;
    places_.push_back({me, within});
  }
  void ask(Questions& questions) {
    for (size_t i = 0; i < asked_.size(); ++i) questions.add(asked_[i].volume, i, asked_[i].question);
    questions.ask(contact_.volumes_,
                  [&](size_t i, std::optional<SurfacePoint>& p) { asked_[i].answer = std::move(p); });
  }
  // Of the i-th place.
  const SurfacePoint* answer(size_t i) const {
    const Place& place = places_[i];
    if (place.asked < 0) return nullptr;
    const auto& p = asked_[static_cast<size_t>(place.asked)].answer;
    return p && p->distance <= place.within ? &*p : nullptr;
  }
  // How far away nothing is known to be, m; less than zero: it was not asked.
  double free(size_t i) const {
    if (places_[i].asked < 0) return -1;
    const Asked& a = asked_[static_cast<size_t>(places_[i].asked)];
    return contact_.volumes_[static_cast<size_t>(a.volume)].surface->free_radius(
        a.question.point, a.answer ? a.answer->distance : a.question.max_distance);
  }

 private:
  struct Place {
    int asked = -1;
    double within = 0;  // m
  };
  struct Asked {
    int volume;
    SurfaceQuestion question;
    std::optional<SurfacePoint> answer;
  };
  const LineContact& contact_;
  std::vector<Place> places_;
  std::vector<Asked> asked_;
  std::vector<int> ends_;  // by volume, the place at 1 of the last pair
};

void LineContact::look(const Pair& pair, const Kinematics& committed, double xi, double share, double gap,
                       const Vec3& normal, bool last, Strikes& to) const {
  const LineContactElement& element = elements_[static_cast<size_t>(pair.element)];
  const LocalElement& e = mesh_.elements[static_cast<size_t>(pair.element)];
  const RigidPose& pose = start_poses_[body(pair.volume)];
  const Quat back = pose.rotation.conjugate();
  const Vec3 velocity = back * (pair.start.velocity(xi) - pose.velocity_at(pair.start.point(xi)));
  const Vec3 acceleration = back * ((1 - xi) * committed.a[static_cast<size_t>(e.first)] +
                                    xi * committed.a[static_cast<size_t>(e.second)]);
  const Approach at{gap, -normal.dot(velocity), normal.dot(acceleration), last};
  limit_depth(element.radius, at, to);
  if (e.counted && share > 0)
    to.add(strikes(pair.law.normal, element.mass_per_length, share, element.radius, at),
           mesh_.mesh->elements[static_cast<size_t>(e.global)].line);
}

void LineContact::look_ahead(const Pair& pair, const Kinematics& committed, double xi, bool touching,
                             const SurfacePoint& p, Strikes& to) const {
  // Simpson's rule; what touches has been looked at.
  const double gap = p.distance - pair.touch;
  const double share = gap < 0 && touching ? 0 : length(pair.element) * (xi == 0.5 ? 4 : 1) / 6;
  look(pair, committed, xi, share, gap, p.normal, false, to);
}

// Nothing is asked of a place that is known to have nothing ahead, nor where nothing it may come to could
// limit the step or strike.
void LineContact::foresee(const Pair& pair, const Kinematics& committed, const Strikes& to,
                          Ahead& ahead) const {
  const LineContactElement& element = elements_[static_cast<size_t>(pair.element)];
  const LocalElement& e = mesh_.elements[static_cast<size_t>(pair.element)];
  const RigidPose& pose = start_poses_[body(pair.volume)];
  const double room = room_at_start(pair);
  for (size_t i = 0; i < kPlaces.size(); ++i) {
    const double xi = kPlaces[i];
    const Vec3 x = pair.start.point(xi);
    const double speed = (pair.start.velocity(xi) - pose.velocity_at(x)).norm();
    const double acceleration = ((1 - xi) * committed.a[static_cast<size_t>(e.first)] +
                                 xi * committed.a[static_cast<size_t>(e.second)])
                                    .norm();
    // Look ahead as far as it gets in half a second.
    const double far = 0.5 * (pair.start.reach() + speed);
    const bool matters =
        may_limit(element.radius, room, speed, to) ||
        may_strike(pair.law.normal, element.mass_per_length, element.radius, speed, acceleration);
    if (room > far || !matters || !pair.part.has(xi))
      ahead.skip();
    else
      ahead.add(pair, i, pose.to_body(x), pair.touch + far);
  }
}

void LineContact::limit_step(const Kinematics& committed, Strikes& to) const {
  Questions questions;
  Ahead ahead(*this);
  for (size_t from = 0, end = 0; from < pairs_.size(); from = end) {
    ahead.clear();
    for (size_t pairs = 0; end < pairs_.size() && (pairs < kBatch || pairs_[end].slot > 0); ++end) {
      if (pairs_[end].slot > 0) continue;
      foresee(pairs_[end], committed, to, ahead);
      ++pairs;
    }
    ahead.ask(questions);
    size_t place = 0;
    for (size_t i = from; i < end; ++i) {
      limit_by_touch(pairs_[i], committed, to);
      if (pairs_[i].slot > 0) continue;
      limit_by(pairs_[i], committed, ahead, place, to);
      place += kPlaces.size();
    }
  }
}

void LineContact::limit_by_touch(const Pair& pair, const Kinematics& committed, Strikes& to) const {
  const auto deepest = std::min_element(pair.history.begin(), pair.history.end(),
                                        [](const Point& a, const Point& b) { return a.gap < b.gap; });
  // All of the contact ends with the deepest place.
  double all = 0;
  for (const Point& p : pair.history) all += p.weight;
  for (auto p = pair.history.begin(); p != pair.history.end(); ++p)
    look(pair, committed, p->xi, p == deepest ? all : p->weight, p->gap - pair.law.normal.smoothing,
         p->normal, p == deepest, to);
}

void LineContact::limit_by(const Pair& pair, const Kinematics& committed, const Ahead& ahead, size_t place,
                           Strikes& to) const {
  std::vector<FreePlace>& free = places_;
  free.clear();
  const bool walls = pair.walls && look_ahead_at_walls(pair, committed, to);
  for (size_t i = 0; i < kPlaces.size(); ++i) {
    if (const double f = ahead.free(place + i); f > 0) free.push_back({kPlaces[i], f});
    const SurfacePoint* p = ahead.answer(place + i);
    if (!p) continue;
    pair.ahead[i] = p->triangle;
    if (!walls) look_ahead(pair, committed, kPlaces[i], !pair.history.empty(), *p, to);
  }
  if (free.size() == kPlaces.size()) {
    double worst = 0;
    pair.room().offer(points(pair.start, start_poses_[body(pair.volume)]),
                      least_distance(free, pair.start.reach(), pair.start.bend_bound(), worst) - pair.touch);
  }
}

}  // namespace hawser
