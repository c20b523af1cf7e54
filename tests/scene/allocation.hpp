#pragma once

#include <cstddef>

/// Counts what operator new hands out in this test program, to hold readers to their memory bound.
/// Not for several threads at once.
struct AllocationWatch {
  AllocationWatch();
  /// The most bytes that were alive at one time since construction, beyond those alive then.
  std::size_t peak() const;
};
