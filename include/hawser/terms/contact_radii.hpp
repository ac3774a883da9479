// Half the contact diameters of elements, m, by their line type, so that memory on every rank is proportional
// to the number of lines, not of elements.
#pragma once

#include <utility>
#include <vector>

#include "hawser/mesh/mesh.hpp"

namespace hawser {

class ContactRadii {
 public:
  // of_types: by line type, m; 0: its elements have no contact. takes_part: by line; empty: all do.
  explicit ContactRadii(std::vector<double> of_types, std::vector<bool> takes_part = {})
      : of_types_(std::move(of_types)), takes_part_(std::move(takes_part)) {}

  // 0: the element has no contact.
  double of(const Element& e) const {
    return takes_part_.empty() || takes_part_[e.line] ? of_types_[e.type] : 0;
  }

 private:
  std::vector<double> of_types_;
  std::vector<bool> takes_part_;
};

}  // namespace hawser
