#pragma once
/// @file counted_allocations.hpp

namespace cs550::test {

/// The number of calls of operator new so far.
long allocation_count();
/// The bytes that were requested by operator new and not yet returned.
long allocated_bytes();

}  // namespace cs550::test
