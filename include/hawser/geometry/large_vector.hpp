// A vector for what is large and read here and there: from 2 MB up in pages of 2 MB, where the system grants
// them, so that a read waits for the data only and not for the page table as well. Once filled it can also
// lie in memory lent by somebody else (packing.hpp).
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace hawser {
namespace detail {

// Throws std::bad_alloc. `bytes` is what was asked for.
void* allocate_large(std::size_t bytes);
void free_large(void* at, std::size_t bytes) noexcept;

template <class T>
struct LargeAllocator {
  using value_type = T;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;
  LargeAllocator() = default;
  // What is at `lent` is taken as it is.
  explicit LargeAllocator(const T* lent) : lent_(lent) {}
  template <class U>
  LargeAllocator(const LargeAllocator<U>& o) : lent_(o.lent_) {}
  T* allocate(std::size_t n) {
    if (lent_) return const_cast<T*>(static_cast<const T*>(lent_));
    return static_cast<T*>(allocate_large(n * sizeof(T)));
  }
  void deallocate(T* at, std::size_t n) noexcept {
    if (!lent_) free_large(at, n * sizeof(T));
  }
  template <class U>
  void construct(U* at) {
    if (!lent_) ::new (static_cast<void*>(at)) U();
  }
  template <class U, class First, class... More>
  void construct(U* at, First&& first, More&&... more) {
    ::new (static_cast<void*>(at)) U(std::forward<First>(first), std::forward<More>(more)...);
  }
  // A copy has memory of its own.
  LargeAllocator select_on_container_copy_construction() const { return {}; }
  template <class U>
  bool operator==(const LargeAllocator<U>& o) const {
    return lent_ == o.lent_;
  }

  const void* lent_ = nullptr;
};

}  // namespace detail

template <class T>
using LargeVector = std::vector<T, detail::LargeAllocator<T>>;

// `size` of them that lie at `at` already. Only to be read.
template <class T>
LargeVector<T> lent_vector(const T* at, std::size_t size) {
  static_assert(std::is_trivially_destructible_v<T>);
  if (size == 0) return {};
  return LargeVector<T>(size, detail::LargeAllocator<T>(at));
}

template <class T>
LargeVector<T> large_copy(const std::vector<T>& v) {
  return LargeVector<T>(v.begin(), v.end());
}

}  // namespace hawser
