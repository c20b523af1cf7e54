#pragma once

#include "scene.hpp"

namespace velum {

/// A plane y = 0, 256 units wide and deep and facing +y, with a checkerboard of unit cells as its texture:
/// the test of every texture filter, seen from just above it (`--eye 0,1.5,128 --target 0,1.2,120`).
Scene checkerboard_scene();

}  // namespace velum
