#pragma once
/// @file static_vector.hpp
/// A small list that lives inside its owner.

#include <array>
#include <cassert>
#include <cstddef>

namespace cs550 {

/// A vector of at most `Capacity` elements that never allocates: steps of the simulation that are
/// warm must not touch the heap. Copies cost what they hold, not what they could hold.
template <class T, int Capacity>
class StaticVector {
 public:
  using value_type = T;

  // The elements beyond size() are never read, so they are left unset on purpose.
  StaticVector() {}  // NOLINT(modernize-use-equals-default)
  StaticVector(const StaticVector& other) { *this = other; }
  StaticVector& operator=(const StaticVector& other) {
    size_ = other.size_;
    for (int i = 0; i < size_; ++i) items_[static_cast<std::size_t>(i)] = other[i];
    return *this;
  }

  static constexpr int capacity() { return Capacity; }
  int size() const { return size_; }
  bool empty() const { return size_ == 0; }
  bool full() const { return size_ == Capacity; }

  void clear() { size_ = 0; }
  /// Precondition: not full.
  void push_back(const T& item) {
    assert(!full());
    items_[static_cast<std::size_t>(size_++)] = item;
  }
  /// Precondition: 0 ≤ size ≤ size(). Drops the elements at the end.
  void shrink(int size) {
    assert(size >= 0 && size <= size_);
    size_ = size;
  }

  T& operator[](int i) { return items_[static_cast<std::size_t>(i)]; }
  const T& operator[](int i) const { return items_[static_cast<std::size_t>(i)]; }
  T* data() { return items_.data(); }
  const T* data() const { return items_.data(); }
  T* begin() { return items_.data(); }
  T* end() { return items_.data() + size_; }
  const T* begin() const { return items_.data(); }
  const T* end() const { return items_.data() + size_; }
  T& back() { return (*this)[size_ - 1]; }
  const T& back() const { return (*this)[size_ - 1]; }

 private:
  int size_ = 0;
  std::array<T, static_cast<std::size_t>(Capacity)> items_;
};

}  // namespace cs550
