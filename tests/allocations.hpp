#pragma once
/// \file
/// Counts what the test program asks of the heap.

namespace goishi::test {

/// How often this thread has called `operator new`.
[[nodiscard]] long allocations();

}  // namespace goishi::test
