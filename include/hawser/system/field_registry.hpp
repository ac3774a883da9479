// The node fields of a result file: metadata of each, and the function that computes its values. A new field
// is one call of add() in fields() of the force term that computes it, as in terms/line_structure_fields.cpp;
// contact uses terms/contact_fields.cpp. Fields that are computed from other fields (utilisation) are added
// in record/utilisation.cpp.
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
  std::function<void(const Kinematics& state, std::span<double> values)> fill;
  // Name of a field added before, of the same shape, to which this one is added: `values` holds that field
  // when fill is called. Empty: none.
  std::string onto = {};
};

class FieldRegistry {
 public:
  // A field with `onto` is inserted after that field and after earlier fields with the same `onto`.
  void add(FieldSource source);
  const std::vector<FieldSource>& sources() const { return sources_; }

 private:
  std::vector<FieldSource> sources_;
};

}  // namespace hawser
