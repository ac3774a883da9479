// The class LinePairs: contact in the accepted state for nodal output and the clash report.
#include <algorithm>
#include <cmath>

#include "hawser/terms/contact_fields.hpp"
#include "hawser/terms/element_axis.hpp"
#include "hawser/terms/line_pairs.hpp"

namespace hawser {
namespace {

void extend(double& from, double& to, double arc) {
  from = std::min(from, arc);
  to = std::max(to, arc);
}

}  // namespace

ActiveContact LinePairs::active_contact(const Pair& pair, const ContactPoints& contact) const {
  const auto arc = [this](const ContactSegment& s, double xi) {
    return arc_at(mesh_, {.first = s.first, .second = s.second}, xi);
  };
  const ContactSegment& a = segment(pair.a);
  const ContactSegment& b = segment(pair.b);
  ActiveContact t;
  t.line = a.element.line;
  t.other_line = b.element.line;
  t.from = t.other_from = HUGE_VAL;
  t.to = t.other_to = -HUGE_VAL;
  for (size_t k = 0; k < kPasses; ++k) {
    const bool swapped = kPassKinds[k].swapped;
    const ContactSegment& slave = swapped ? b : a;
    const ContactSegment& master = swapped ? a : b;
    double& from = swapped ? t.other_from : t.from;
    double& to = swapped ? t.other_to : t.to;
    double& foot_from = swapped ? t.from : t.other_from;
    double& foot_to = swapped ? t.to : t.other_to;
    const auto& points = contact[k];
    for (const LinePairContactPoint& h : points) {
      extend(from, to, arc(slave, h.from));
      extend(from, to, arc(slave, h.to));
      extend(foot_from, foot_to, arc(master, std::clamp(h.eta, 0.0, 1.0)));
      t.force += h.weight * h.normal_force;
      t.energy += h.weight * h.potential;
    }
    if (kPassKinds[k].on_element()) t.depth = std::max(t.depth, largest_depth_of(points));
  }
  return t;
}

void LinePairs::active_contacts(ActiveContacts& out) const {
  for (const Pair& pair : pairs_)
    if (pair.counted && pair.points) out.push_back(active_contact(pair, *pair.points));
}

void LinePairs::active_contacts(const Kinematics& evaluated, ActiveContacts& out) const {
  for (const Pair& pair : pairs_) {
    if (!pair.counted || !pair.trial || !pair.trial->active || !pair.trial->evaluated) continue;
    const Trial& t = *pair.trial;
    if (t.a.same_axis(axis(evaluated, pair.a).now) && t.b.same_axis(axis(evaluated, pair.b).now))
      out.push_back(active_contact(pair, t.points));
  }
}

// The contact point is midway between both surfaces, at r + g/2 from the axis of the slave, against the
// normal (r: radius of the slave, g: gap).
void LinePairs::resultants(const Kinematics& state, ContactResultants& out) const {
  for (const Pair& pair : pairs_) {
    if (!pair.counted || !pair.points) continue;
    const AxisShape shapes[] = {AxisShape(ends(state, pair.a)), AxisShape(ends(state, pair.b))};
    const double radii[] = {type_of_segment(pair.a).radius, type_of_segment(pair.b).radius};
    ResultantSum sum;
    for (size_t k = 0; k < kPasses; ++k) {
      const size_t slave = kPassKinds[k].swapped ? 1 : 0;
      for (const LinePairContactPoint& h : (*pair.points)[k])
        sum.add(shapes[slave].point(h.xi) - (radii[slave] + 0.5 * h.gap) * h.normal, h, Mat3::Identity(),
                slave == 0 ? 1 : -1);
    }
    if (sum.any())
      out.push_back({line_of_segment(pair.a), line_of_segment(pair.b), -1, -1, sum.place(), sum.force()});
  }
}

void LinePairs::fields(FieldRegistry& registry) const {
  add_contact_fields(
      registry,
      {.force = {.name = "line_contact_force", .unit = "N", .is_support_force = true},
       .normal_force = {.name = "line_contact_normal_force",
                        .unit = "N",
                        .report = Field::Report::graph,
                        .order = 9,
                        .contact_with = advice::ContactWith::line},
       .friction = {.name = "line_friction_force", .unit = "N"},
       .penetration = {.name = "line_penetration", .unit = "m", .report = Field::Report::table, .order = 12}},
      [this](const Kinematics&, ShowPoint show) {
        const auto put = [&](const ContactSegment& s, double xi, double sign, const LinePairContactPoint& h) {
          weights_at_ends(s.element, s.first, s.second, mesh_.owned, xi,
                          [&](int node, double weight) { show(node, weight, sign * Mat3::Identity(), h); });
        };
        for (const Pair& p : pairs_) {
          if (!p.points) continue;
          const ContactSegment& a = segment(p.a);
          const ContactSegment& b = segment(p.b);
          for (size_t k = 0; k < kPasses; ++k)
            for (const LinePairContactPoint& h : (*p.points)[k]) {
              put(kPassKinds[k].swapped ? b : a, h.xi, 1, h);
              put(kPassKinds[k].swapped ? a : b, h.eta, -1, h);
            }
        }
      });
}

}  // namespace hawser
