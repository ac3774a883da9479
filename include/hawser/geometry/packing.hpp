// Stores all arrays of an object contiguously in one block of memory, for example memory shared by all ranks
// of a host.
//
// A packed class lists its members once and in a fixed order in a function
//   template <class Self, class P> static void pack(Self& self, P& p)
// that calls p.value() for members without pointers, p.array() for each ConstArray and p.flags() for each
// std::vector<bool>. Measure counts the bytes, Writer copies them, Reader refers to arrays in the block
// without a copy, and copies the rest.
#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

#include "hawser/geometry/const_array.hpp"

namespace hawser::packing {

constexpr std::size_t kLine = 64;  // every item begins on a cache line
inline std::size_t next_line(std::size_t at) { return (at + kLine - 1) / kLine * kLine; }

template <class Pass>
class Packing {
 public:
  template <class T>
  void value(T& v) {
    static_assert(std::is_trivially_destructible_v<std::remove_const_t<T>>);
    pass().bytes(&v, sizeof(T));
  }
  std::size_t size() const { return at_; }

 protected:
  Pass& pass() { return static_cast<Pass&>(*this); }
  std::size_t room(std::size_t bytes) {
    const std::size_t from = next_line(at_);
    at_ = from + bytes;
    return from;
  }

 private:
  std::size_t at_ = 0;
};

class Measure : public Packing<Measure> {
 public:
  void bytes(const void*, std::size_t n) { room(n); }
  template <class T>
  void array(const ConstArray<T>& v) {
    room(sizeof(std::size_t));
    room(v.size() * sizeof(T));
  }
  void flags(const std::vector<bool>& v) {
    room(sizeof(std::size_t));
    room(v.size());
  }
};

// `to` must be aligned to a cache line and have the size counted by Measure.
class Writer : public Packing<Writer> {
 public:
  explicit Writer(std::byte* to) : to_(to) {}
  void bytes(const void* from, std::size_t n) {
    std::byte* at = to_ + room(n);
    if (n > 0) std::memcpy(at, from, n);
  }
  template <class T>
  void array(const ConstArray<T>& v) {
    const std::size_t n = v.size();
    bytes(&n, sizeof n);
    bytes(v.data(), n * sizeof(T));
  }
  void flags(const std::vector<bool>& v) {
    const std::size_t n = v.size();
    bytes(&n, sizeof n);
    std::byte* at = to_ + room(n);
    for (std::size_t i = 0; i < n; ++i) at[i] = std::byte{v[i]};
  }

 private:
  std::byte* to_;
};

// The block must outlive the objects read from it.
class Reader : public Packing<Reader> {
 public:
  explicit Reader(const std::byte* from) : from_(from) {}
  void bytes(void* to, std::size_t n) {
    const std::byte* at = from_ + room(n);
    if (n > 0) std::memcpy(to, at, n);
  }
  template <class T>
  void array(ConstArray<T>& v) {
    std::size_t n = 0;
    bytes(&n, sizeof n);
    v = ConstArray<T>::lent({reinterpret_cast<const T*>(from_ + room(n * sizeof(T))), n});
  }
  void flags(std::vector<bool>& v) {
    std::size_t n = 0;
    bytes(&n, sizeof n);
    const std::byte* at = from_ + room(n);
    v.resize(n);
    for (std::size_t i = 0; i < n; ++i) v[i] = at[i] != std::byte{0};
  }

 private:
  const std::byte* from_;
};

}  // namespace hawser::packing
