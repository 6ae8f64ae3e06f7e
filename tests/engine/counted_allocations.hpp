#pragma once
/// @file counted_allocations.hpp

namespace cs550::test {

/// The number of calls of operator new so far.
long allocation_count();

}  // namespace cs550::test
