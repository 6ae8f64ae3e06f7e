#include "engine/counted_allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

// Counts all allocations of this program. These operators are in a separate file, because a
// compiler that inlines one of them into a caller warns of a mismatch of new and free.

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace cs550::test {

long allocation_count() { return allocations; }

}  // namespace cs550::test
