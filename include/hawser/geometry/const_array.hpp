// Read-only array that owns its values or refers to external memory (packing.hpp).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace hawser {

template <class T>
class ConstArray {
 public:
  ConstArray() = default;
  // Copies share the values.
  ConstArray(std::vector<T> values)
      : owned_(std::make_shared<const std::vector<T>>(std::move(values))), view_(*owned_) {}
  // `values` must outlive the array.
  static ConstArray lent(std::span<const T> values) {
    static_assert(std::is_trivially_destructible_v<T>);
    ConstArray a;
    a.view_ = values;
    return a;
  }
  const T& operator[](std::size_t i) const { return view_[i]; }
  const T* data() const { return view_.data(); }
  std::size_t size() const { return view_.size(); }
  bool empty() const { return view_.empty(); }
  auto begin() const { return view_.begin(); }
  auto end() const { return view_.end(); }
  operator std::span<const T>() const { return view_; }

 private:
  std::shared_ptr<const std::vector<T>> owned_;
  std::span<const T> view_;
};

}  // namespace hawser
