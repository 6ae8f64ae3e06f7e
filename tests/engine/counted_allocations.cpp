#include "engine/counted_allocations.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

// Counts all allocations of this program. These operators are in a separate file, because a
// compiler that inlines one of them into a caller warns of a mismatch of new and free. The form that
// does not throw is among them: std::stable_sort frees with the same delete what it has from that form,
// and AddressSanitizer has one of its own.

namespace {

std::atomic<long> allocations{0};
std::atomic<long> bytes{0};

/// In front of each block: its size. As long as the block's alignment, which it keeps.
std::size_t header_of(std::size_t alignment) {
  constexpr std::size_t usual = alignof(std::max_align_t);
  static_assert(usual >= sizeof(std::size_t));
  return std::max(alignment, usual);
}

/// @returns nullptr if there is no memory
void* allocate(std::size_t size, std::size_t alignment) {
  const std::size_t header = header_of(alignment);
  const std::size_t whole =
      (header + size + header - 1) / header * header;  // a multiple, for aligned_alloc()
  void* const block = std::aligned_alloc(header, whole);
  if (block == nullptr) return nullptr;
  ++allocations;
  bytes += static_cast<long>(size);
  *static_cast<std::size_t*>(block) = size;
  return static_cast<char*>(block) + header;
}

void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  void* const memory = allocate(size, alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void release(void* memory, std::size_t alignment) {
  if (memory == nullptr) return;
  void* const block = static_cast<char*>(memory) - header_of(alignment);
  bytes -= static_cast<long>(*static_cast<std::size_t*>(block));
  std::free(block);
}

/// Types that ask for no more have the operators without an alignment.
constexpr std::size_t usual_alignment = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

std::size_t number(std::align_val_t alignment) { return static_cast<std::size_t>(alignment); }

}  // namespace

void* operator new(std::size_t size) { return allocate_or_throw(size, usual_alignment); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, usual_alignment);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, number(alignment));
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(size, number(alignment));
}
void operator delete(void* memory) noexcept { release(memory, usual_alignment); }
void operator delete(void* memory, std::size_t) noexcept { release(memory, usual_alignment); }
void operator delete(void* memory, std::align_val_t alignment) noexcept {
  release(memory, number(alignment));
}
void operator delete(void* memory, std::size_t, std::align_val_t alignment) noexcept {
  release(memory, number(alignment));
}

namespace cs550::test {

long allocation_count() { return allocations; }
long allocated_bytes() { return bytes; }

}  // namespace cs550::test
