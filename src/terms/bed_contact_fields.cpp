// The class BedContact: output fields of the seabed's force and friction at the nodes.
#include "hawser/terms/bed_contact.hpp"
#include "hawser/terms/contact_fields.hpp"

namespace hawser {

// The force at the middle of an element is output in halves at its nodes.
void BedContact::fields(FieldRegistry& registry) const {
  add_contact_fields(registry,
                     {.force = {.name = "seabed_force",
                                .unit = "N",
                                .is_support_force = true,
                                .contact_with = advice::ContactWith::seabed},
                      .friction = {.name = "seabed_friction", .unit = "N"}},
                     [this](const Kinematics&, ShowPoint show) {
                       for (const Point& p : points_)
                         for (const int node : {p.node, p.second})
                           if (p.history_index >= 0 && mesh_.owns(node))
                             show(node, fraction_on_node(p, node), Mat3::Identity(), history(p));
                     });
}

}  // namespace hawser
