// A vector for what is large and read here and there: from 2 MB up in pages of 2 MB, where the system grants
// them, so that a read waits for the data only and not for the page table as well.
#pragma once

#include <cstddef>
#include <vector>

namespace hawser {
namespace detail {

// Throws std::bad_alloc. `bytes` is what was asked for.
void* allocate_large(std::size_t bytes);
void free_large(void* at, std::size_t bytes) noexcept;

template <class T>
struct LargeAllocator {
  using value_type = T;
  LargeAllocator() = default;
  template <class U>
  LargeAllocator(const LargeAllocator<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(allocate_large(n * sizeof(T))); }
  void deallocate(T* at, std::size_t n) noexcept { free_large(at, n * sizeof(T)); }
  template <class U>
  bool operator==(const LargeAllocator<U>&) const {
    return true;
  }
};

}  // namespace detail

template <class T>
using LargeVector = std::vector<T, detail::LargeAllocator<T>>;

}  // namespace hawser
