#include "engine/counted_allocations.hpp"

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

/// In front of each block: its size. As long as the strictest alignment, which the block keeps.
constexpr std::size_t header = alignof(std::max_align_t);
static_assert(header >= sizeof(std::size_t));

}  // namespace

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* const block = std::malloc(header + size);
  if (block == nullptr) return nullptr;
  ++allocations;
  bytes += static_cast<long>(size);
  *static_cast<std::size_t*>(block) = size;
  return static_cast<char*>(block) + header;
}
void* operator new(std::size_t size) {
  void* const memory = operator new(size, std::nothrow);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept {
  if (memory == nullptr) return;
  void* const block = static_cast<char*>(memory) - header;
  bytes -= static_cast<long>(*static_cast<std::size_t*>(block));
  std::free(block);
}
void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

namespace cs550::test {

long allocation_count() { return allocations; }
long allocated_bytes() { return bytes; }

}  // namespace cs550::test
