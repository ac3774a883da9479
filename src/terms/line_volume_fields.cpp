// What touches in the accepted state, shown at the nodes and told to the clash report.
#include <algorithm>
#include <cmath>

#include "hawser/mesh/arc.hpp"
#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {

void LineVolumeContact::fields(FieldRegistry& registry) const {
  // The share of each point of the elements at an owned node, by the shape functions of positions.
  const auto shared = [this](const auto& put) {
    for (const Pair& p : pairs_)
      for (const ContactPoint& q : p.points)
        share_at_ends(element(p), local(p).first, local(p).second, mesh_.owned, q.xi,
                      [&](int node, double share) { put(static_cast<size_t>(node), p, q, share); });
  };
  const auto vector = [this, shared](Vec3 ContactHistory::*value) {
    return [this, shared, value](const Kinematics& at, std::span<double> out) {
      std::fill(out.begin(), out.end(), 0.0);
      std::vector<Quat> turned;
      for (int v = 0; v < volumes(); ++v) turned.push_back(volumes_.pose_of(v, at).rotation);
      shared([&](size_t node, const Pair& p, const ContactPoint& q, double share) {
        const Vec3 f = share * q.weight * (turned[static_cast<size_t>(p.volume)] * (q.*value));
        for (size_t c = 0; c < 3; ++c) out[3 * node + c] += f[static_cast<Eigen::Index>(c)];
      });
    };
  };
  registry.add({"contact_force", "N", 3, vector(&ContactHistory::force)});
  registry.add({"contact_normal_force", "N", 1, [shared](const Kinematics&, std::span<double> out) {
                  std::fill(out.begin(), out.end(), 0.0);
                  shared([&](size_t node, const Pair&, const ContactPoint& q, double share) {
                    out[node] += share * q.weight * q.normal_force;
                  });
                }});
  registry.add({"friction_force", "N", 3, vector(&ContactHistory::friction)});
  registry.add({"penetration", "m", 1, [shared](const Kinematics&, std::span<double> out) {
                  std::fill(out.begin(), out.end(), 0.0);
                  shared([&](size_t node, const Pair&, const ContactPoint& q, double share) {
                    if (share >= 0.5) out[node] = std::max(out[node], -q.gap);
                  });
                }});
}

// One for each panel: panels that meet are put together where stretches are.
void LineVolumeContact::touches(Touches& out) const {
  for (const Pair& pair : pairs_) {
    if (!local(pair).counted) continue;
    const Element& e = element(pair);
    double panel = NAN;
    for (const ContactPoint& p : pair.points) {
      if (p.from != panel) {
        Touch& t = out.emplace_back();
        t.line = e.line, t.volume = pair.volume;
        t.from = arc_at(*mesh_.mesh, e, p.from), t.to = arc_at(*mesh_.mesh, e, p.to);
        panel = p.from;
      }
      Touch& t = out.back();
      t.force += p.weight * p.normal_force, t.energy += p.weight * p.potential;
      t.depth = std::max(t.depth, -p.gap);
    }
  }
}

std::vector<Vec3> LineVolumeContact::forces_by_volume(const Kinematics& at) const {
  std::vector<Vec3> out(static_cast<size_t>(volumes()), Vec3::Zero());
  for (const Pair& pair : pairs_)
    if (local(pair).counted)
      for (const ContactPoint& p : pair.points) out[static_cast<size_t>(pair.volume)] += p.weight * p.force;
  for (int v = 0; v < volumes(); ++v)
    if (Vec3& f = out[static_cast<size_t>(v)]; !f.isZero(0)) f = volumes_.pose_of(v, at).rotation * f;
  return out;
}

int LineVolumeContact::touching() const {
  int count = 0;
  const Pair* last = nullptr;  // walls of one volume count once
  for (const Pair& p : pairs_) {
    if (p.points.empty() || !local(p).counted) continue;
    count += !(last && last->element == p.element && last->volume == p.volume);
    last = &p;
  }
  return count;
}

}  // namespace hawser
