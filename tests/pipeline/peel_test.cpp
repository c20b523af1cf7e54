#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <velum/velum.hpp>

#include "pipeline/memory_need.hpp"
#include "random.hpp"

using namespace velum;

namespace {

struct Pane {
  std::array<glm::vec3, 3> corners;
  glm::vec3 colour;
  float alpha;
};

/// Random translucent triangles of different depths (no two depths are equal), in front of each other
/// everywhere.
std::vector<Pane> random_sheets(Random& random, int count) {
  std::vector<Pane> sheets;
  const auto f = [&](double a, double b) { return static_cast<float>(random.uniform(a, b)); };
  for (int i = 0; i < count; ++i) {
    Pane sheet;
    for (glm::vec3& corner : sheet.corners) corner = {f(-1.5, 1.5), f(-1.5, 1.5), f(-1.0, 1.0)};
    sheet.colour = {f(0, 1), f(0, 1), f(0, 1)};
    sheet.alpha = i % 7 == 6 ? 1.0f : f(0.1, 0.9);
    sheets.push_back(sheet);
  }
  return sheets;
}

/// Each sheet an object of its own, so that only (depth, id) orders them.
Scene scene_of(const std::vector<Pane>& sheets) {
  Scene scene;
  for (const Pane& sheet : sheets) {
    Mesh mesh;
    mesh.positions = {sheet.corners[0], sheet.corners[1], sheet.corners[2]};
    mesh.triangles = {glm::uvec3(0, 1, 2)};
    Material material;
    material.base_colour = sheet.colour;
    material.alpha = sheet.alpha;
    scene.add(mesh, glm::dmat4(1.0), scene.add_material(material));
  }
  return scene;
}

RenderSettings unlit(int size) {
  RenderSettings settings;
  settings.width = settings.height = size;
  settings.shader = [](const SurfacePoint& point) {
    return glm::vec4(point.material->base_colour, point.material->alpha);
  };
  return settings;
}

Camera front_camera() {
  ParallelWindow window;
  window.height = 2.0;
  return Camera::parallel(Pose::towards({0, 0, 5}, {0, 0, 0}), window, 1.0, 10.0, 1.0);
}

/// The oracle: all opaque renderings of single sheets, sorted by (depth, id) and blended front to back.
glm::vec4 blended_at(const std::vector<Picture>& alone, const std::vector<Pane>& sheets, int x, int y) {
  std::vector<std::pair<float, std::size_t>> fragments;
  for (std::size_t i = 0; i < alone.size(); ++i) {
    if (alone[i].triangle_id.at(x, y) != 0xFFFFFFFFu) fragments.emplace_back(alone[i].depth.at(x, y), i);
  }
  std::sort(fragments.begin(), fragments.end());
  glm::vec4 front(0.0f);
  for (const auto& [depth, i] : fragments) {
    const float share = (1.0f - front.w) * sheets[i].alpha;
    front += glm::vec4(sheets[i].colour * share, share);
    if (sheets[i].alpha >= 1.0f) break;
  }
  return front;
}

}  // namespace

TEST_CASE("translucent sheets blend front to back, exactly as sorted fragments do") {
  Random random{21};
  const std::vector<Pane> sheets = random_sheets(random, 15);
  const Picture picture = render(scene_of(sheets), front_camera(), unlit(48));
  std::vector<Picture> alone;
  for (const Pane& sheet : sheets) alone.push_back(render(scene_of({sheet}), front_camera(), unlit(48)));
  int worst = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 48; ++x) {
      const glm::vec4 front = blended_at(alone, sheets, x, y);
      if (front.w <= 0.0f) continue;
      const Rgba8 expected = srgb_from_linear(glm::vec4(glm::vec3(front) / front.w, front.w));
      const Rgba8 got = picture.colour.at(x, y);
      worst = std::max({worst, std::abs(expected.r - got.r), std::abs(expected.g - got.g),
                        std::abs(expected.b - got.b), std::abs(expected.a - got.a)});
    }
  }
  CHECK(worst <= 1);
  CHECK(picture.counters.layers > 3);
  CHECK(picture.counters.layers <= 15);
}

TEST_CASE("the order of the scene does not matter where no two depths are equal") {
  Random random{22};
  std::vector<Pane> sheets = random_sheets(random, 12);
  const Picture forwards = render(scene_of(sheets), front_camera(), unlit(48));
  std::reverse(sheets.begin(), sheets.end());
  const Picture backwards = render(scene_of(sheets), front_camera(), unlit(48));
  int different = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 48; ++x) different += !(forwards.colour.at(x, y) == backwards.colour.at(x, y));
  }
  CHECK(different == 0);
}

TEST_CASE("peeling stops at the nearest opaque fragment, at the limit, and when nothing is left") {
  const auto sheet = [](float z, float alpha) {
    return Pane{{glm::vec3(-9, -9, z), glm::vec3(9, -9, z), glm::vec3(0, 9, z)}, glm::vec3(1.0f), alpha};
  };
  RenderSettings settings = unlit(8);
  CHECK(render(scene_of({sheet(0.5f, 1.0f), sheet(0.0f, 0.5f)}), front_camera(), settings).counters.layers ==
        1);
  CHECK(render(scene_of({sheet(0.5f, 0.5f), sheet(0.0f, 1.0f), sheet(-0.5f, 0.5f)}), front_camera(), settings)
            .counters.layers == 2);
  const Scene three = scene_of({sheet(0.5f, 0.5f), sheet(0.0f, 0.5f), sheet(-0.5f, 0.5f)});
  CHECK(render(three, front_camera(), settings).colour.at(4, 4).a == 223);  // 1 - 0.5³ of 255, half up
  settings.layers = 2;
  const Picture limited = render(three, front_camera(), settings);
  CHECK(limited.counters.layers == 2);
  CHECK(limited.colour.at(4, 4).a == 191);
  settings.background = {0, 0, 0, 255};
  CHECK(render(three, front_camera(), settings).colour.at(4, 4) ==
        srgb_from_linear(glm::vec4(0.75f, 0.75f, 0.75f, 1.0f)));
}

TEST_CASE("depth and ids are those of the first layer; a crop of a translucent picture equals the whole") {
  Random random{23};
  const Scene scene = scene_of(random_sheets(random, 9));
  RenderSettings settings = unlit(40);
  const Picture whole = render(scene, front_camera(), settings);
  settings.layers = 1;
  const Picture first = render(scene, front_camera(), settings);
  settings.layers = 0;
  settings.crop = Rect{7, 9, 20, 11};
  const Picture part = render(scene, front_camera(), settings);
  int different = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      different += whole.triangle_id.at(x, y) != first.triangle_id.at(x, y) ||
                   whole.depth.at(x, y) != first.depth.at(x, y);
      if (settings.crop->contains(x, y))
        different += !(part.colour.at(x - 7, y - 9) == whole.colour.at(x, y));
    }
  }
  CHECK(different == 0);
}

TEST_CASE("a Renderer that drew a translucent frame draws an opaque one as a new Renderer does") {
  const auto sheet = [](float alpha) {
    return Pane{{glm::vec3(-9, -9, 0), glm::vec3(9, -9, 0), glm::vec3(0, 9, 0)}, glm::vec3(1.0f), alpha};
  };
  Renderer renderer;
  renderer.render(scene_of({sheet(0.5f)}), front_camera(), unlit(48));
  // Smaller, too: what the first frame left must not be written beyond the picture.
  const Scene opaque = scene_of({sheet(1.0f)});
  const Picture& again = renderer.render(opaque, front_camera(), unlit(16));
  const Picture fresh = render(opaque, front_camera(), unlit(16));
  int different = 0;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) different += !(again.colour.at(x, y) == fresh.colour.at(x, y));
  }
  CHECK(different == 0);
}

TEST_CASE("little memory for the fragments changes no byte of a translucent picture") {
  Random random{24};
  const Scene scene = scene_of(random_sheets(random, 20));
  RenderSettings settings = unlit(48);
  const Picture freely = render(scene, front_camera(), settings);
  const Rect rect{0, 0, 48, 48};  // nothing is left for lists: a pixel at a time
  settings.memory_ceiling = picture_bytes(rect) + buffer_bytes(scene, settings, rect);
  const Picture tightly = render(scene, front_camera(), settings);
  int different = 0;
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 48; ++x) different += !(freely.colour.at(x, y) == tightly.colour.at(x, y));
  }
  CHECK(different == 0);
  CHECK(freely.counters.layers == tightly.counters.layers);
  CHECK(freely.counters.pixels_shaded == tightly.counters.pixels_shaded);
}
