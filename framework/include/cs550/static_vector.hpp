#pragma once
/// @file static_vector.hpp
/// A vector of fixed capacity with inline storage.

#include <cassert>
#include <cstddef>
#include <memory>
#include <type_traits>

namespace cs550 {

/// A vector of at most `Capacity` elements that never allocates, because a steady-state step must
/// not allocate. Construction is free, and copying costs as much as the elements present, not the
/// capacity.
template <class T, int Capacity>
class StaticVector {
  static_assert(std::is_trivially_destructible_v<T>, "elements are dropped without a destructor");

 public:
  using value_type = T;  ///< of the elements

  /// An empty vector, or a copy of the elements of another.
  /// @{
  StaticVector() {}  // NOLINT(modernize-use-equals-default): a union member has no default
  StaticVector(const StaticVector& other) { *this = other; }
  StaticVector& operator=(const StaticVector& other) {
    size_ = other.size_;
    for (int i = 0; i < size_; ++i) std::construct_at(items_ + i, other[i]);
    return *this;
  }
  /// @}

  /// The capacity and the number of elements.
  /// @{
  static constexpr int capacity() { return Capacity; }
  int size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == Capacity; }
  /// @}

  /// Removes all elements.
  void clear() { size_ = 0; }
  /// Appends an element. Precondition: not full.
  void push_back(const T& item) {
    assert(!full());
    std::construct_at(items_ + size_++, item);
  }
  /// Removes elements from the end. Precondition: 0 ≤ size ≤ size().
  void shrink(int size) {
    assert(size >= 0 && size <= size_);
    size_ = size;
  }

  /// The elements, as in std::vector. Precondition: 0 ≤ i < size().
  /// @{
  T& operator[](int i) {
    assert(i >= 0 && i < size_);
    return items_[i];
  }
  const T& operator[](int i) const {
    assert(i >= 0 && i < size_);
    return items_[i];
  }
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
  // A union does not construct the elements beyond size(): an empty polygon of large capacity costs
  // nothing.
  union {
    T items_[static_cast<std::size_t>(Capacity)];  // NOLINT(readability-identifier-naming)
  };
};

}  // namespace cs550
