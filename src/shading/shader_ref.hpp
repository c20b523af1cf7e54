#pragma once

#include <cstddef>
#include <glm/vec4.hpp>

#include "surface_point.hpp"

namespace velum {

/// A custom shader by reference, entered once per run of neighbouring points: the callable is compiled into
/// the loop over them, so a small one is inlined there, which a std::function (see Shader) prevents.
///
/// Runs are shaded on several threads at once: the callable must bear that, so it should only read what it
/// captures. It must outlive every render that it is used in. What it throws ends the render.
class ShaderRef {
 public:
  /// No shader.
  ShaderRef() = default;

  /// @param shader  glm::vec4 operator()(const SurfacePoint&) const: linear, straight alpha
  template <typename CustomShader>
  explicit ShaderRef(const CustomShader& shader)
      : object_(&shader),
        shade_([](const void* object, const SurfacePoint* points, std::size_t count, glm::vec4* colours) {
          const auto& shader_of_one = *static_cast<const CustomShader*>(object);
          for (std::size_t i = 0; i < count; ++i) colours[i] = shader_of_one(points[i]);
        }) {}

  explicit operator bool() const { return shade_ != nullptr; }

  /// colours[i] = shader(points[i]). @pre there is a shader
  void operator()(const SurfacePoint* points, std::size_t count, glm::vec4* colours) const {
    shade_(object_, points, count, colours);
  }

 private:
  const void* object_ = nullptr;
  void (*shade_)(const void* object, const SurfacePoint* points, std::size_t count,
                 glm::vec4* colours) = nullptr;
};

}  // namespace velum
