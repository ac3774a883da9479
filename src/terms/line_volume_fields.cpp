// The class LineVolumeContact: contact in the accepted state for nodal output and the clash report.
#include <algorithm>
#include <utility>

#include "hawser/terms/contact_fields.hpp"
#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/line_volume_contact.hpp"

namespace hawser {

void LineVolumeContact::fields(FieldRegistry& registry) const {
  using Report = Field::Report;
  add_contact_fields(registry,
                     {.force = {.name = "contact_force", .unit = "N", .is_support_force = true},
                      .normal_force = {.name = "contact_normal_force",
                                       .unit = "N",
                                       .history = Field::History::yes,
                                       .statistics = true,
                                       .report = Report::graph,
                                       .order = 8,
                                       .contact_with = advice::ContactWith::volume},
                      .friction = {.name = "friction_force", .unit = "N"},
                      .penetration = {.name = "penetration",
                                      .unit = "m",
                                      .history = Field::History::yes,
                                      .statistics = true,
                                      .extreme = "penetration",
                                      .report = Report::table,
                                      .order = 11}},
                     [this](const Kinematics& state, ShowPoint show) {
                       std::vector<Mat3> axes;
                       for (int v = 0; v < volumes(); ++v)
                         axes.push_back(volumes_.pose_of(v, state).rotation.toRotationMatrix());
                       for (const Pair& p : pairs_)
                         for (const AxisContactPoint& q : p.start.points)
                           weights_at_ends(
                               element(p), local(p).first, local(p).second, mesh_.owned, q.xi,
                               [&](int node, double weight) { show(node, weight, axes[p.volume], q); });
                     });
}

// Adds one contact for each panel; adjacent panels are joined where intervals are.
void LineVolumeContact::active_contacts(ActiveContacts& out) const {
  for (const Pair& pair : pairs_) {
    if (!local(pair).counted) continue;
    const Element& e = element(pair);
    std::pair<int, double> panel(-1, 0);  // facet group, and where the panel begins
    for (const AxisContactPoint& p : pair.start.points) {
      if (std::pair(p.group, p.from) != panel) {
        ActiveContact& t = out.emplace_back();
        t.line = e.line;
        t.volume = pair.volume;
        t.from = arc_at(mesh_, local(pair), p.from);
        t.to = arc_at(mesh_, local(pair), p.to);
        panel = {p.group, p.from};
      }
      ActiveContact& t = out.back();
      t.force += p.weight * p.normal_force;
      t.energy += p.weight * p.potential;
      t.depth = std::max(t.depth, -p.gap);
    }
  }
}

void LineVolumeContact::resultants(const Kinematics& state, ContactResultants& out) const {
  for (const Pair& pair : pairs_) {
    if (!local(pair).counted) continue;
    const AxisShape shape = axis(state, pair.element);
    const Mat3 turn = volumes_.pose_of(pair.volume, state).rotation.toRotationMatrix();
    for (size_t i = 0; i < pair.start.points.size();) {
      const int group = pair.start.points[i].group;
      ResultantSum sum;
      for (; i < pair.start.points.size() && pair.start.points[i].group == group; ++i) {
        const AxisContactPoint& p = pair.start.points[i];
        sum.add(shape.point(p.xi) - (pair.radius + p.gap) * (turn * p.normal), p, turn);
      }
      if (sum.any()) out.push_back({element(pair).line, -1, pair.volume, -1, sum.place(), sum.force()});
    }
  }
}

std::vector<Vec3> LineVolumeContact::forces_by_volume(const Kinematics& state) const {
  std::vector<Vec3> out(static_cast<size_t>(volumes()), Vec3::Zero());
  for (const Load& l : loads(state))
    if (mesh_.elements[l.element].counted) out[l.volume] += l.force;
  return out;
}

std::array<Vec3, 2> LineVolumeContact::reaction(int volume, const Kinematics& state) const {
  std::array<Vec3, 2> out{Vec3::Zero(), Vec3::Zero()};
  for (const Load& l : loads(state)) {
    if (l.volume != volume || !mesh_.elements[l.element].counted) continue;
    const Vec3 arm = axis(state, l.element).point(l.xi) - volumes_.pose_of(volume, state).position;
    out[0] += l.force;
    out[1] += arm.cross(l.force);
  }
  return out;
}

std::vector<LineVolumeContact::Load> LineVolumeContact::loads(const Kinematics& state) const {
  std::vector<Load> out;
  for (const Pair& pair : pairs_)
    for (const AxisContactPoint& p : pair.start.points)
      out.push_back({pair.element, pair.volume, p.xi,
                     p.weight * (volumes_.pose_of(pair.volume, state).rotation * p.force), p.from, p.to,
                     p.gap, pair.smoothing()});
  return out;
}

int LineVolumeContact::active_count() const {
  return static_cast<int>(std::count_if(pairs_.begin(), pairs_.end(), [this](const Pair& p) {
    return !p.start.points.empty() && local(p).counted;
  }));
}

}  // namespace hawser
