// The class FieldRegistry: order, lookup and display names of output fields. Force terms declare them in
// fields(); their metadata is in field.hpp.
#include "hawser/system/field_registry.hpp"

#include <algorithm>

namespace hawser {

int find_field(std::span<const Field> fields, std::string_view name) {
  const auto at = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
  return at == fields.end() ? -1 : static_cast<int>(at - fields.begin());
}

std::string label_of(const Field& field) {
  std::string label = field.label.empty() ? field.name : field.label;
  if (field.label.empty()) std::replace(label.begin(), label.end(), '_', ' ');
  return label;
}

void FieldRegistry::add(FieldSource source) {
  const auto same_group = [&](const FieldSource& f) {
    return f.name == source.onto || f.onto == source.onto;
  };
  auto at = sources_.end();
  if (!source.onto.empty())
    for (auto f = sources_.begin(); f != sources_.end(); ++f)
      if (same_group(*f)) at = f + 1;
  sources_.insert(at, std::move(source));
}

}  // namespace hawser
