#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "load_scene.hpp"

namespace velum {

/// Reads Wavefront OBJ (Wavefront Technologies, "Advanced Visualizer Manual", appendix B1, 1995) and its MTL
/// libraries. Consecutive polygons of one object (o) with one material become a mesh and an instance, in file
/// order, so primitive ids follow the file; the line and point elements (l, p) among them become another one
/// behind it, without normals; g and s are not used. Vertices are shared where position, texture
/// coordinate and normal are the same. Colours behind a position are sRGB values 0…1, as Blender and MeshLab
/// write them; the material of faces that name none is then white.
///
/// Corners without a normal get a smooth one, over all faces of the file that share the position, or the
/// triangle's own. Without any face, line or point element every vertex is drawn as a
/// point. What had to be left out or assumed, a
/// library that is missing, or read only as far as a fault, too, is told in Scene::notes.
/// @param directory  where libraries are looked for; empty: they are not read
/// @throws Error (read) with file:line
Scene read_obj(std::string_view text, const std::string& name, const std::filesystem::path& directory,
               const LoadOptions& options);

}  // namespace velum
