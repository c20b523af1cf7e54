#pragma once

#include <memory>

#include "../projection/camera.hpp"
#include "../scene/scene.hpp"
#include "picture.hpp"
#include "settings.hpp"

namespace velum {

/// Renders a scene as a camera sees it. A pure function: the same input gives the same bytes on every
/// machine.
/// @throws Error (usage) for sizes, a crop or a camera that cannot be used; Error (limit) before work begins
/// if the outputs would exceed the memory ceiling; Error (cancelled) if the progress callback returns false
Picture render(const Scene& scene, const Camera& camera, const RenderSettings& settings = {});

/// Renders with a shader of one's own, compiled into the loop over the pixels of a run: what is small is
/// inlined there. With a Renderer, set RenderSettings::inlined_shader to ShaderRef(shader) for the same.
/// @param shader  glm::vec4 operator()(const SurfacePoint&) const, linear with straight alpha; called on
/// several threads at once (RenderSettings::threads), so it must change nothing that another call sees. A
/// shader that cannot bear that goes to RenderSettings::shader, or with threads = 1
/// @throws as render(), and what the shader throws
template <typename CustomShader>
Picture render_with(const Scene& scene, const Camera& camera, RenderSettings settings,
                    const CustomShader& shader) {
  settings.inlined_shader = ShaderRef(shader);
  return render(scene, camera, settings);
}

/// Keeps its buffers between frames. One Renderer serves one thread at a time; several may share a const
/// Scene.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// The picture stays valid until the next call.
  const Picture& render(const Scene& scene, const Camera& camera, const RenderSettings& settings = {});

  /// Fills caller-owned memory. @throws Error (usage) if a view's size is not the picture's
  Counters render_into(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                       const PictureTarget& target);

  /// What is kept between frames; see render.cpp.
  struct Buffers;

 private:
  std::unique_ptr<Buffers> buffers_;
};

}  // namespace velum
