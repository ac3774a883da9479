// An optional value that is stored outside of the object it belongs to.
#pragma once

#include <memory>
#include <utility>

namespace hawser {

// An object without the value is small, and copies share the value until one of them changes it. Access
// through a non-const object counts as a change. References from it are valid until the object is copied.
template <class T>
class Shared {
 public:
  Shared() = default;
  Shared(T value) : at_(std::make_shared<T>(std::move(value))) {}

  bool has_value() const { return at_ != nullptr; }
  explicit operator bool() const { return has_value(); }
  const T& operator*() const { return *at_; }
  const T* operator->() const { return at_.get(); }
  T& operator*() { return unshared(); }
  T* operator->() { return &unshared(); }
  template <class... From>
  T& emplace(From&&... from) {
    at_ = std::make_shared<T>(std::forward<From>(from)...);
    return *at_;
  }
  void reset() { at_.reset(); }

 private:
  T& unshared() {
    if (at_.use_count() > 1) at_ = std::make_shared<T>(*at_);
    return *at_;
  }
  std::shared_ptr<T> at_;
};

}  // namespace hawser
