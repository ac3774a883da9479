// Platforms of a farm that are nearer to each other than their size.
#include <algorithm>

#include "hawser/advice/input_warnings.hpp"
#include "hawser/model/check.hpp"
#include "hawser/model/farm.hpp"

namespace hawser::advice {

using namespace model;

namespace {

struct PlacedBody {
  const Body* body = nullptr;
  const FarmPlace* place = nullptr;
  double radius = 0;  // m, of its line ends about its origin, in plan
};

// Bodies of platforms with line ends, by x.
std::vector<PlacedBody> placed_bodies(const Case& c) {
  std::vector<PlacedBody> out;
  const std::vector<std::vector<EndAtBody>> ends = line_ends_by_body(c);
  for (std::size_t b = 0; b < c.bodies.size(); ++b) {
    PlacedBody placed{&c.bodies[b], find_placed(c, c.bodies[b].name).place};
    for (const EndAtBody& e : ends[b]) placed.radius = std::max(placed.radius, e.end.at.head<2>().norm());
    if (placed.place && placed.radius > 0) out.push_back(placed);
  }
  std::stable_sort(out.begin(), out.end(), [](const PlacedBody& a, const PlacedBody& b) {
    return a.body->position.x() < b.body->position.x();
  });
  return out;
}

}  // namespace

// The nearest pair, relative to the size of the larger one. Pairs at one place have a note of their own.
void warn_of_farms(const Case& c, std::vector<InputWarning>& out) {
  constexpr double kSamePlace = 1e-3;  // m
  if (!c.farm) return;
  const std::vector<PlacedBody> bodies = placed_bodies(c);
  double largest = 0;
  for (const PlacedBody& b : bodies) largest = std::max(largest, b.radius);
  const PlacedBody* first = nullptr;
  const PlacedBody* second = nullptr;
  double nearest = 1;
  for (auto a = bodies.begin(); a != bodies.end(); ++a)
    for (auto b = a + 1; b != bodies.end(); ++b) {
      const Vec3 apart = b->body->position - a->body->position;
      if (apart.x() > largest) break;
      const double distance = apart.head<2>().norm();
      const double relative = distance / std::max(a->radius, b->radius);
      if (a->place == b->place || distance < kSamePlace || relative >= nearest) continue;
      nearest = relative;
      first = &*a;
      second = &*b;
    }
  if (!first) return;
  const double radius = std::max(first->radius, second->radius);
  add_warning(out, "farm", Effect::all,
              "bodies {} and {} are {:.4g} m apart, and lines end up to {:.4g} m from the origin of such a "
              "body: do the platforms overlap?",
              first->body->name, second->body->name, nearest * radius, radius);
}

}  // namespace hawser::advice
