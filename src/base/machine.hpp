#pragma once

#include <cstdint>

namespace velum {

/// The machine's physical memory in bytes; 0 where the system does not tell.
std::uint64_t physical_memory();

}  // namespace velum
