#pragma once
/// @file counted_allocations.hpp

namespace cs550::test {

/// How often this program has called operator new.
long allocation_count();

}  // namespace cs550::test
