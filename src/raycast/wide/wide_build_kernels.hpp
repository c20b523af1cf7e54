#pragma once

#include <cstdint>

#include "../../base/isa.hpp"

namespace velum {

/// A box for vectors: the upper side negated, so that one minimum joins two boxes. The fourth and the last
/// number are whatever.
struct alignas(32) MinBox {
  float side[8];  ///< lower x, y, z, –, -upper x, y, z, –

  float size(std::uint32_t axis) const { return -side[4 + axis] - side[axis]; }
  /// Half the surface.
  float half_area() const { return size(0) * size(1) + size(1) * size(2) + size(2) * size(0); }
};

/// What the builder sorts: a triangle's box, with its id in the fourth number.
using BuildItem = MinBox;

/// Items of one subtree.
struct BuildRange {
  std::uint32_t begin = 0, end = 0;
  MinBox box;      ///< around the items
  MinBox centres;  ///< around twice their centres

  std::uint32_t size() const { return end - begin; }
};

/// Divides items in two by the binned surface-area heuristic (Wald 2007, "On fast Construction of SAH-based
/// Bounding Volume Hierarchies"); a leaf costs as much as its blocks of four triangles.
/// @param items  of the whole tree; those of the range are put in their new order
/// @return false, and nothing done, where all centres are in one place
using SplitItems = bool (*)(BuildItem* items, const BuildRange& range, BuildRange& left, BuildRange& right);

/// The boxes of range.begin … range.end.
using MeasureItems = void (*)(const BuildItem* items, BuildRange& range);

struct WideBuildKernels {
  SplitItems split;
  MeasureItems measure;
};

/// @param isa  reference: as emulated. @pre is_available(isa)
WideBuildKernels wide_build_kernels(Isa isa);

}  // namespace velum
