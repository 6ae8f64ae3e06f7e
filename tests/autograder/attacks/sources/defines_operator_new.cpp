#include <cstdlib>
#include <new>
void* operator new(std::size_t size) { return std::malloc(size + 4096); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
