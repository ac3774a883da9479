// The node fields of a result file: what is known of each, and how its values are made. A new field is one
// call of add() in the fields() of the force term that knows its values, as in terms/structure.cpp; of
// contact by terms/contact_fields.cpp. Those made of other fields (utilisation) are added in
// record/utilisation.cpp.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "hawser/state/kinematics.hpp"
#include "hawser/system/field.hpp"

namespace hawser {

struct FieldSource : Field {
  // Fills values[node * components + c] for this rank's owned nodes from an accepted state.
  std::function<void(const Kinematics& at, std::span<double> values)> fill;
  // A field added before, of the same shape, whose values `values` holds when fill is called; empty: none.
  std::string onto = {};
};

class FieldRegistry {
 public:
  // A field that is made onto another stands behind it, and behind those that are already.
  void add(FieldSource source);
  const std::vector<FieldSource>& sources() const { return sources_; }

 private:
  std::vector<FieldSource> sources_;
};

}  // namespace hawser
