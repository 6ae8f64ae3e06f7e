#pragma once
/// @file static_vector.hpp
/// A small list that lives inside its owner.

#include <cassert>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace cs550 {

/// A vector of at most `Capacity` elements that never allocates: steps of the simulation that are
/// warm must not touch the heap. Making one costs nothing and copies cost what they hold, not what
/// they could hold.
template <class T, int Capacity>
class StaticVector {
  static_assert(std::is_trivially_destructible_v<T>, "elements are dropped without a destructor");

 public:
  using value_type = T;  ///< of the elements

  /// Empty, or a copy of the elements that there are.
  /// @{
  StaticVector() {}  // NOLINT(modernize-use-equals-default): a union member has no default
  StaticVector(const StaticVector& other) { *this = other; }
  StaticVector& operator=(const StaticVector& other) {
    size_ = other.size_;
    for (int i = 0; i < size_; ++i) std::construct_at(items_ + i, other[i]);
    return *this;
  }
  /// @}

  /// How many elements fit, and how many there are.
  /// @{
  static constexpr int capacity() { return Capacity; }
  int size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == Capacity; }
  /// @}

  /// Drops all elements.
  void clear() { size_ = 0; }
  /// Precondition: not full.
  void push_back(const T& item) {
    assert(!full());
    std::construct_at(items_ + size_++, item);
  }
  /// Precondition: 0 ≤ size ≤ size(). Drops the elements at the end.
  void shrink(int size) {
    assert(size >= 0 && size <= size_);
    size_ = size;
  }

  /// The elements, as in std::vector.
  /// @{
  T& operator[](int i) { return items_[i]; }
  const T& operator[](int i) const { return items_[i]; }
  T* data() { return items_; }
  const T* data() const { return items_; }
  T* begin() { return items_; }
  T* end() { return items_ + size_; }
  const T* begin() const { return items_; }
  const T* end() const { return items_ + size_; }
  T& back() { return (*this)[size_ - 1]; }
  const T& back() const { return (*this)[size_ - 1]; }
  /// @}

 private:
  int size_ = 0;
  // In a union the elements beyond size() are not made: a polygon of large capacity is free until
  // it has corners.
  union {
    T items_[static_cast<std::size_t>(Capacity)];  // NOLINT(readability-identifier-naming)
  };
};

}  // namespace cs550
