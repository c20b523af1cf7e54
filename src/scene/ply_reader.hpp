#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "load_scene.hpp"

namespace velum {

/// PLY (G. Turk, "The PLY Polygon File Format", 1994): ASCII or binary, either byte order, any layout of
/// elements and properties; what is not named here is skipped by its declared type.
///
/// - vertex: x y z; nx ny nz; red green blue [alpha] (also r g b a, diffuse_red …); s t, u v, texture_u …
///   Whole colours are sRGB codes, real ones linear; the material below them is then white.
/// - face: a list vertex_indices or vertex_index; polygons are triangulated.
/// - tristrips: the same list; -1 begins a new strip.
/// - edge: vertex1 vertex2; they become the segments of a second mesh, without normals unless the file has
///   them.
///
/// Without faces and edges every vertex is a point. What is left out is told in Scene::notes.
/// @throws Error (read) with file:line or byte
Scene read_ply(std::span<const std::byte> bytes, const std::string& name, const LoadOptions& options);

}  // namespace velum
