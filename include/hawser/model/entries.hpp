// Lines and bodies of a case. A rank of a farm forgets those of other ranks.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace hawser::model {

// Like std::vector, but each entry has its own memory, which forget() frees. Access to a forgotten entry
// throws std::logic_error.
template <class T>
class Entries {
 public:
  using value_type = T;

  template <class List, class Item>
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = Item*;
    using reference = Item&;

    Iterator() = default;
    Iterator(List* list, std::size_t at) : list_(list), at_(at) {}
    reference operator*() const { return (*list_)[at_]; }
    pointer operator->() const { return &**this; }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    Iterator operator++(int) { return {list_, at_++}; }
    bool operator==(const Iterator& other) const { return at_ == other.at_; }

   private:
    List* list_ = nullptr;
    std::size_t at_ = 0;
  };
  using iterator = Iterator<Entries, T>;
  using const_iterator = Iterator<const Entries, const T>;

  Entries() = default;
  Entries(std::initializer_list<T> entries) {
    for (const T& x : entries) push_back(x);
  }
  Entries(const Entries& other) {
    reserve(other.size());
    for (const auto& x : other.entries_) entries_.push_back(x ? std::make_unique<T>(*x) : nullptr);
  }
  Entries(Entries&&) noexcept = default;
  Entries& operator=(Entries other) noexcept {
    entries_.swap(other.entries_);
    return *this;
  }

  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }
  void reserve(std::size_t n) { entries_.reserve(n); }
  template <class... From>
  T& emplace_back(From&&... from) {
    return *entries_.emplace_back(std::make_unique<T>(std::forward<From>(from)...));
  }
  void push_back(T entry) { emplace_back(std::move(entry)); }

  T& operator[](std::size_t i) { return of(entries_[i]); }
  const T& operator[](std::size_t i) const { return of(entries_[i]); }
  T& front() { return (*this)[0]; }
  const T& front() const { return (*this)[0]; }
  T& back() { return (*this)[size() - 1]; }
  const T& back() const { return (*this)[size() - 1]; }
  iterator begin() { return {this, 0}; }
  iterator end() { return {this, size()}; }
  const_iterator begin() const { return {this, 0}; }
  const_iterator end() const { return {this, size()}; }

  // False: forgotten.
  bool has(std::size_t i) const { return entries_[i] != nullptr; }
  void forget(std::size_t i) { entries_[i].reset(); }

 private:
  static T& of(const std::unique_ptr<T>& entry) {
    if (!entry) throw std::logic_error("an entry of the case that this rank has forgotten");
    return *entry;
  }
  std::vector<std::unique_ptr<T>> entries_;
};

}  // namespace hawser::model
