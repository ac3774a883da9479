// What LineContact is made from, what it remembers, shows and keeps.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hawser/mesh/arc.hpp"
#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/line_contact.hpp"

namespace hawser {

LineContact::LineContact(const LocalMesh& mesh, std::shared_ptr<const Bodies> bodies,
                         std::vector<ContactVolume> volumes, std::vector<LineContactElement> elements,
                         MPI_Comm comm)
    : Contact(mesh, std::move(bodies), std::move(volumes), comm),
      mesh_(mesh),
      elements_(std::move(elements)) {
  if (elements_.size() != mesh_.elements.size())
    throw std::invalid_argument("contact along lines needs one LineContactElement for each local element");
  for (const LocalElement& e : mesh_.elements)
    lengths_.push_back(mesh_.mesh->elements[static_cast<size_t>(e.global)].length);
  accounts_.resize(elements_.size());
}

double LineContact::thickest() const {
  double most = 0;
  for (const LineContactElement& e : elements_) most = std::max(most, e.radius);
  return most;
}

ContactLaw LineContact::element_law(size_t element, const model::Volume& v) const {
  const double diameter = 2 * elements_[element].radius;
  double share = 1;  // of a metre: what turns the basis into N/m²
  if (v.basis == model::StiffnessBasis::per_point) share = 1 / lengths_[element];
  if (v.basis == model::StiffnessBasis::per_area) share = diameter;
  return law(v, share, diameter, elements_[element].mass_per_length);
}

AxisEnds LineContact::ends(const Kinematics& at, int element) const {
  const LocalElement& e = mesh_.elements[static_cast<size_t>(element)];
  return element_axis(at, mesh_.mesh->elements[static_cast<size_t>(e.global)], e.first, e.second,
                      elements_[static_cast<size_t>(element)].tangent);
}

Contact::Share LineContact::part_of(int element, int volume) const {
  if (left_out_.empty()) return {};
  const Mesh& mesh = *mesh_.mesh;
  const Element& g = mesh.elements[static_cast<size_t>(mesh_.elements[static_cast<size_t>(element)].global)];
  return takes_part(mesh, g.line, volume, arc_at(mesh, g, 0), arc_at(mesh, g, 1));
}

// Evaluated again at the accepted state, so that what is kept belongs to it and to no other trial.
void LineContact::commit(const Kinematics& accepted) {
  pose_bodies(accepted, poses_);
  bool open = false;
  for (size_t i = 0; i < pairs_.size(); ++i) {
    Pair& pair = pairs_[i];
    if (!pair.walls) continue;
    find(pair, AxisShape(ends(accepted, pair.element)), poses_[body(pair.volume)]);
    open = open || lacks_pairs(i);
  }
  if (open) open_pairs();
  for (Pair& pair : pairs_) {
    const AxisShape shape(ends(accepted, pair.element));
    const RigidPose& pose = poses_[body(pair.volume)];
    const ContactLaw laws = applied(pair.law);
    std::vector<Point> next;
    Account& sum = accounts_[static_cast<size_t>(pair.element)];
    const Found& found = find(pair, shape, pose);
    const Rolled roll = rolled(pair, shape);
    for (size_t i = 0; i < found.panels.size(); ++i)
      for (size_t q = 0; q < ContactRule::kPoints; ++q) {
        const ContactStretch& s = found.panels[i];
        const double xi = s.from + (s.to - s.from) * ContactRule::place()[q];
        const SurfacePoint& there = found.points[ContactRule::kPoints * i + q];
        if (!seen(pair, there)) continue;
        ContactTrial at = trial(pair, shape, pose, xi, accepted.step > 0, there);
        ContactStart begin;
        if (laws.friction.active()) begin = start(pair, origin(pair, xi));
        if (roll.on) at.roll = roll.angle(xi), at.lever = elements_[static_cast<size_t>(pair.element)].radius;
        const PointContact c = volume_contact(laws, begin, at, false);
        if (!(c.normal.elastic > 0)) continue;
        Point p(c, at.normal);
        p.xi = xi, p.from = s.from, p.to = s.to, p.gap = at.gap;
        p.weight = length(pair.element) * (s.to - s.from) * ContactRule::weight()[q];
        sum.reaches(-p.gap, accepted.time, pair.volume, xi < 0.5 ? 0 : 1);
        next.push_back(p);
      }
    if (accepted.step > 0 && !(next.empty() && pair.history.empty())) account(pair, shape, next);
    pair.history = std::move(next);
  }
  keep_raise();
}

// Trapezoid over the step, as in the nodes method: half with the forces at its start where they were, half
// with those at its end where they are. Of a step in which a point met or left only the part in touch counts.
void LineContact::account(Pair& pair, const AxisShape& shape, const std::vector<Point>& next) {
  const RigidPose &before = start_poses_[body(pair.volume)], &after = poses_[body(pair.volume)];
  const StepOfBody step(before, after, !floats(pair.volume));
  const double smoothing = pair.law.normal.smoothing;
  Account& sum = accounts_[static_cast<size_t>(pair.element)];
  // The way of a place, and how far it came off the surface otherwise than by sliding along its own line: a
  // pipe that is drawn over a roller comes and goes all the time, yet as much of it touches as before.
  struct Way {
    Vec3 y0, y1, lifted, along;
  };
  const Rolled roll = rolled(pair, shape);
  const double radius = elements_[static_cast<size_t>(pair.element)].radius;
  // What the line's surface moves by because the line rolls; friction's work on it goes with that on the
  // axis.
  const auto add = [&](const Point& p, const Mat3& R, const Way& w, double share) {
    add_work(sum, step, p, R, w.y0, w.y1, share);
    if (!roll.on) return;
    const Vec3 surface = -radius * roll.angle(p.xi) * w.along.cross(p.normal);
    sum.friction -= 0.25 * share * (R * p.friction).dot((step.R0 + step.R1) * surface);
  };
  const auto way = [&](double xi) {
    Way w;
    w.y0 = before.to_body(pair.start.point(xi)), w.y1 = after.to_body(shape.point(xi));
    w.along = ((before.rotation.conjugate() * pair.start.slope(xi)).normalized() +
               (after.rotation.conjugate() * shape.slope(xi)).normalized())
                  .normalized();
    const Vec3 moved = w.y1 - w.y0;
    w.lifted = moved - w.along * w.along.dot(moved);
    return w;
  };
  // Where the stiffness was raised, what the spring gave and has is not its own: it was brought in.
  const double raise = raised(pair.volume) ? 1 : 0;
  const auto elastic = [](const Point& p) { return p.normal_force - p.damping_force; };
  for (const Point& p : pair.history) {
    const Way w = way(p.xi);
    const double away = p.normal.dot(w.lifted), deep = std::max(smoothing - p.gap, 0.0);
    const double share = p.weight * (away > deep ? deep / away : 1);
    add(p, step.R0, w, share);
    sum.work += raise * (0.5 * share * elastic(p) * p.normal.dot(w.y1 - w.y0) - p.weight * p.potential);
  }
  for (const Point& p : next) {
    const Way w = way(p.xi);
    const double came = -p.normal.dot(w.lifted), deep = smoothing - p.gap;
    const double share = p.weight * (came > deep ? deep / came : 1);
    add(p, step.R1, w, share);
    sum.work += raise * (0.5 * share * elastic(p) * p.normal.dot(w.y1 - w.y0) + p.weight * p.potential);
  }
}

// In dynamics of the committed state. Statics asks for trials: its line search goes down this energy.
Energy LineContact::energy(const Kinematics& at) const {
  Energy e;
  for (const Pair& p : pairs_) {
    if (!mesh_.elements[static_cast<size_t>(p.element)].counted) continue;
    if (at.step > 0) {
      for (const Point& q : p.history) e.strain += q.weight * q.potential;
      continue;
    }
    if (p.slot > 0) continue;  // as the first has as many walls as it sees
    Pair pair = p;
    const AxisShape shape(ends(at, p.element));
    const RigidPose pose = pose_of(p.volume, at);
    const double radius = elements_[static_cast<size_t>(p.element)].radius;
    size_t walls = 1;
    for (; pair.slot < static_cast<int>(walls); ++pair.slot) {
      if (pair.slot > 0) pair.found = {};
      const Found& found = find(pair, shape, pose);
      if (pair.seen && pair.seen->walls.several()) walls = pair.seen->walls.of.size();
      for (size_t i = 0; i < found.panels.size(); ++i)
        for (size_t q = 0; q < ContactRule::kPoints; ++q) {
          const SurfacePoint& there = found.points[ContactRule::kPoints * i + q];
          if (!seen(p, there)) continue;
          const ContactStretch& s = found.panels[i];
          e.strain += length(p.element) * (s.to - s.from) * ContactRule::weight()[q] *
                      normal_force(p.law.normal, there.distance - radius, 0).potential;
        }
    }
  }
  for (size_t i = 0; i < accounts_.size(); ++i) {
    if (!mesh_.elements[i].counted) continue;
    e.friction += accounts_[i].friction, e.damping += accounts_[i].damping, e.work += accounts_[i].work;
  }
  return e;
}

void LineContact::fields(FieldRegistry& registry) const {
  // The share of each Gauss point of the elements at an owned node, by the shape functions of positions.
  const auto shared = [this](const auto& put) {
    for (const Pair& p : pairs_) {
      const LocalElement& e = mesh_.elements[static_cast<size_t>(p.element)];
      for (const Point& q : p.history)
        share_at_ends(mesh_.mesh->elements[static_cast<size_t>(e.global)], e.first, e.second, mesh_.owned,
                      q.xi, [&](int node, double share) { put(node, p, q, share); });
    }
  };
  const auto vector = [this, shared](Vec3 ContactHistory::*value) {
    return [this, shared, value](const Kinematics& at, std::span<double> out) {
      std::fill(out.begin(), out.end(), 0.0);
      std::vector<RigidPose> poses;
      pose_bodies(at, poses);
      shared([&](int node, const Pair& p, const Point& q, double share) {
        const Vec3 f = share * q.weight * (poses[body(p.volume)].rotation * (q.*value));
        for (int c = 0; c < 3; ++c) out[static_cast<size_t>(3 * node + c)] += f[c];
      });
    };
  };
  registry.add({"contact_force", "N", 3, vector(&ContactHistory::force)});
  registry.add({"contact_normal_force", "N", 1, [shared](const Kinematics&, std::span<double> out) {
                  std::fill(out.begin(), out.end(), 0.0);
                  shared([&](int node, const Pair&, const Point& q, double share) {
                    out[static_cast<size_t>(node)] += share * q.weight * q.normal_force;
                  });
                }});
  registry.add({"friction_force", "N", 3, vector(&ContactHistory::friction)});
  registry.add({"penetration", "m", 1, [shared](const Kinematics&, std::span<double> out) {
                  std::fill(out.begin(), out.end(), 0.0);
                  shared([&](int node, const Pair&, const Point& q, double share) {
                    if (share >= 0.5)
                      out[static_cast<size_t>(node)] = std::max(out[static_cast<size_t>(node)], -q.gap);
                  });
                }});
}

Penetration LineContact::largest_penetration() const {
  Penetration p;
  for (size_t i = 0; i < accounts_.size(); ++i) {
    const LocalElement& e = mesh_.elements[i];
    const Account& a = accounts_[i];
    if (e.counted && a.depth > p.depth)
      p = {a.depth, mesh_.global[static_cast<size_t>(a.end ? e.second : e.first)], a.volume, a.time};
  }
  return p;
}

int LineContact::candidates() const {
  return static_cast<int>(
      std::count_if(pairs_.begin(), pairs_.end(), [](const Pair& p) { return p.slot == 0; }));
}

int LineContact::touching() const {
  int count = 0;
  const Pair* last = nullptr;  // walls of one volume count once
  for (const Pair& p : pairs_) {
    if (p.history.empty() || !mesh_.elements[static_cast<size_t>(p.element)].counted) continue;
    count += !(last && last->element == p.element && last->volume == p.volume);
    last = &p;
  }
  return count;
}

}  // namespace hawser
