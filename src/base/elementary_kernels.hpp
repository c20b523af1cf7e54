#pragma once

/// The vector versions of elementary functions over arrays; bit for bit what the scalar ones give.

#include <cstddef>

#include "isa.hpp"

namespace velum {

/// out[i] = elementary::pow(x[i], y[i]); count is a multiple of 8.
using PowEach = void (*)(const double* x, const double* y, std::size_t count, double* out);

/// The kernel for an instruction set. @pre is_available(isa), and not `reference`
PowEach pow_kernel(Isa isa);

}  // namespace velum
