// Entries of long maps as bytes. A line of a farm takes 0.3 kB so, and 7 kB as a tree; thousands of them are
// unpacked one at a time.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <utility>

#include "hawser/model/value.hpp"

namespace hawser::model {

// Packs a value that is not yet checked. Its line stays.
void pack(Value& v);
// The value before pack(); other values as they are.
Value unpacked(const Value& v);

// An entry of a map, unpacked and, if the map is, checked. Refers to the map.
class Entry {
 public:
  Entry() = default;  // none
  Entry(const Value& map, std::size_t i);
  explicit Entry(std::shared_ptr<const Value> value) : owned_(std::move(value)), at_(owned_.get()) {}
  explicit operator bool() const { return at_ != nullptr; }
  const Value& operator*() const { return *at_; }
  const Value* operator->() const { return at_; }

 private:
  std::shared_ptr<const Value> owned_;  // null: it is not packed
  const Value* at_ = nullptr;
};
// Entry of this name; none if the map has no such key. The map may be packed.
Entry find_entry(const Value& map, std::string_view name);

}  // namespace hawser::model
