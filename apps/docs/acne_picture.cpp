// Shadow acne and its four cures: on a floor with a ball, and on the same with everything a thousandth of the
// size, where a fixed distance is too large.
#include <algorithm>
#include <glm/geometric.hpp>
#include <velum/raycast/bvh/bvh.hpp>
#include <velum/raycast/leave_surface.hpp>

#include "blocks.hpp"
#include "paint.hpp"

namespace velum_docs {
namespace {

using namespace velum;

constexpr int side = 260;
constexpr int caption = 24;
constexpr double epsilon = 1e-3;

struct Cure {
  const char* name;
  SelfHitCure cure;
};
constexpr Cure cures[] = {{"none", SelfHitCure::none},
                          {"by direction", SelfHitCure::direction_offset},
                          {"by normal", SelfHitCure::normal_offset},
                          {"epsilon", SelfHitCure::global_epsilon},
                          {"sign", SelfHitCure::implicit_sign}};

/// A ball and a slanted sheet close above a floor; all of it `size` times as large.
class Stage {
 public:
  explicit Stage(float size) : size_(size) {
    add(shapes::grid(4.0f, 1), {0.0f, 0.0f, 0.0f});
    add(shapes::icosphere(0.5f, 3), {0.1f, 0.5f, -0.1f});
    add(shapes::box(0.5f, 0.02f, 0.5f), {-0.75f, 0.12f, 0.45f});
    for (glm::vec3& p : positions_) p *= size;
  }

  Image<Rgba8> panel(const Cure& cure) const;

 private:
  void add(const Mesh& mesh, const glm::vec3& at) {
    const auto first = static_cast<std::uint32_t>(positions_.size());
    for (const glm::vec3& p : mesh.positions) positions_.push_back(p + at);
    for (const glm::uvec3& t : mesh.triangles) triangles_.push_back(t + first);
  }
  glm::dvec3 normal_of(std::uint32_t triangle) const {
    const Triangle t = TriangleSet{positions_, triangles_}[triangle];
    return glm::normalize(glm::cross(t.b - t.a, t.c - t.a));
  }
  double light_at(const Bvh& bvh, const Ray& ray, const RayHit& hit, SelfHitCure cure) const;

  double size_;
  std::vector<glm::vec3> positions_;
  std::vector<glm::uvec3> triangles_;
};

/// What the one lamp gives, 0 … 1.
double Stage::light_at(const Bvh& bvh, const Ray& ray, const RayHit& hit, SelfHitCure cure) const {
  const SurfacePlace place{ray.at(hit.t), normal_of(hit.triangle), position_error(ray, hit.t, bvh.bounds())};
  const glm::dvec3 to_light = glm::dvec3(2.5, 3.5, 1.5) * size_ - place.position;
  const double cosine = glm::dot(place.normal, glm::normalize(to_light));
  if (cosine <= 0.0) return 0.0;
  const LeavingRay leaving = leave_surface(place, to_light, 1.0, cure, epsilon);
  const OnSurface on_surface(bvh.triangles(), place);
  const HitFilter filter = cure == SelfHitCure::implicit_sign ? on_surface.filter() : HitFilter{};
  CastCounters counters;
  return bvh.is_blocked(leaving.ray, leaving.range, counters, filter) ? 0.0 : cosine;
}

Image<Rgba8> Stage::panel(const Cure& cure) const {
  const Bvh bvh({positions_, triangles_});
  const Camera camera = Camera::perspective(
      Pose::towards(glm::dvec3(-0.6, 1.5, 3.2) * size_, glm::dvec3(-0.15, 0.3, 0.0) * size_),
      {VerticalAngle{0.62}}, 0.1 * size_, 20.0 * size_);
  const CameraRays rays(camera.viewing_transform(1.0), {side, side});
  Canvas canvas(side, side + caption, paper);
  Image<Rgba8> picture(side, side, Rgba8{222, 230, 240, 255});
  CastCounters counters;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const ViewRay view = rays.through(x + 0.5, y + 0.5);
      const RayHit hit = bvh.first_hit(view.ray, view.range, counters);
      if (!hit.is_hit()) continue;
      const auto light = static_cast<float>(0.12 + 0.75 * light_at(bvh, view.ray, hit, cure.cure));
      picture.at(x, y) = srgb_from_linear(glm::vec4(light, light, light, 1.0f));
    }
  }
  canvas.text({2, 5}, cure.name, 2, ink);
  paint_image(canvas, picture, 0, caption);
  return canvas.picture();
}

}  // namespace

Image<Rgba8> draw_acne() {
  std::vector<Image<Rgba8>> rows;
  for (const float size : {1.0f, 1.0f / 256.0f}) {
    const Stage stage(size);
    std::vector<Image<Rgba8>> panels;
    for (const Cure& cure : cures) panels.push_back(stage.panel(cure));
    rows.push_back(side_by_side(panels, 6));
  }
  Image<Rgba8> sheet(rows[0].width(), rows[0].height() + rows[1].height() + 6, paper);
  for (int y = 0; y < rows[0].height(); ++y) {
    std::copy_n(rows[0].row(y), sheet.width(), sheet.row(y));
    std::copy_n(rows[1].row(y), sheet.width(), sheet.row(y + rows[0].height() + 6));
  }
  return sheet;
}

}  // namespace velum_docs
