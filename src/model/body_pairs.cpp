// Rules for contact between bodies: the slave volume of each pair, its stiffness and its share of the
// force.
#include "hawser/model/body_pairs.hpp"

#include <algorithm>

namespace hawser::model {

bool is_ball(const Volume& v) { return v.shape && std::holds_alternative<SphereShape>(*v.shape); }

namespace {

bool is_bar(const Volume& v) {
  return v.shape &&
         (std::holds_alternative<CapsuleShape>(*v.shape) || std::holds_alternative<TorusShape>(*v.shape));
}

// Order of a volume; the lower one is the slave. Planes and volumes without a stiffness are never slaves.
constexpr int kNever = 9;
int rank(const Volume& v) {
  if (v.basis == StiffnessBasis::automatic) return kNever;
  const bool bar = is_bar(v);
  if (v.is_plane()) return kNever;
  if (is_ball(v)) return v.basis == StiffnessBasis::per_point ? 0 : kNever;
  if (bar && v.basis != StiffnessBasis::per_area) return 0;
  return v.basis == StiffnessBasis::per_point ? 1 : v.basis == StiffnessBasis::per_length ? 2 : 3;
}

bool needs_overlap_check(const Volume& v) {
  const bool bar = is_bar(v);
  return v.basis == StiffnessBasis::per_point ? !is_ball(v) : v.basis == StiffnessBasis::per_length && !bar;
}

// Lowest coefficients of a volume, at rest and sliding; without `kinetic` they are equal.
double lowest_static(const Friction& f) { return std::min(f.axial, f.lateral); }
double lowest_kinetic(const Friction& f) {
  return f.blend_speed > 0 ? std::min(f.axial_kinetic, f.lateral_kinetic) : lowest_static(f);
}

// Friction of a pair; `a` is the slave.
Friction friction_between(const Volume& a, const Volume& b) {
  Friction f = a.friction;
  const Friction& g = b.friction;
  f.axial = f.lateral = std::min(lowest_static(a.friction), lowest_static(g));
  f.axial_kinetic = f.lateral_kinetic = std::min(lowest_kinetic(a.friction), lowest_kinetic(g));
  if (!(f.blend_speed > 0)) f.blend_speed = g.blend_speed;
  f.lateral_mobilisation_length = f.mobilisation_length;
  return f;
}

bool touch(const Case& c, const Volume& a, const Volume& b) {
  const auto floats = [&c](const Volume& v) { return c.floats(c.body_index(v.body)); };
  const auto takes_part = [&c](const Volume& v) {
    return !v.roller && c.contact.takes_part(v) && !c.rides(c.body_index(v.body));
  };
  return a.body != b.body && takes_part(a) && takes_part(b) && (floats(a) || floats(b));
}

}  // namespace

ContactOfBody contact_of_body(const Case& c, const std::string& body) {
  ContactOfBody out = ContactOfBody::none;
  for (const Volume& carried : c.volumes) {
    if (carried.body != body) continue;
    for (const Volume& other : c.volumes) {
      if (!touch(c, carried, other)) continue;
      if (friction_between(carried, other).axial > 0) return ContactOfBody::with_friction;
      out = ContactOfBody::frictionless;
    }
  }
  return out;
}

std::vector<BodyPair> body_pairs(const Case& c) {
  std::vector<BodyPair> pairs;
  const auto add = [&](std::size_t leads, std::size_t other, double stiffness, double force_factor) {
    const Volume& a = c.volumes[leads];
    const Volume& b = c.volumes[other];
    pairs.push_back({leads, other, stiffness, force_factor, friction_between(a, b), needs_overlap_check(a)});
  };
  for (std::size_t i = 0; i < c.volumes.size(); ++i)
    for (std::size_t j = i + 1; j < c.volumes.size(); ++j) {
      const Volume& a = c.volumes[i];
      const Volume& b = c.volumes[j];
      if (!touch(c, a, b)) continue;
      const int ra = rank(a);
      const int rb = rank(b);
      const double k = a.basis == b.basis ? std::min(a.normal_stiffness, b.normal_stiffness) : 0;
      const auto stiffness = [&](const Volume& v) { return k > 0 ? k : v.normal_stiffness; };
      if (ra == kNever && rb == kNever) {
        add(i, j, 0, 1);
      } else if (ra < rb || (ra == rb && ra == 0)) {
        add(i, j, stiffness(a), 1);
      } else if (rb < ra) {
        add(j, i, stiffness(b), 1);
      } else {
        const double force_factor = ra == 3 ? 0.5 : 1;
        add(i, j, stiffness(a), force_factor);
        add(j, i, stiffness(b), force_factor);
      }
    }
  return pairs;
}

}  // namespace hawser::model
