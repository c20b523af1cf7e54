#include "shading/texture_filter.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "image/image.hpp"
#include "random.hpp"

using namespace velum;

namespace {

using Wraps = std::array<TextureWrap, 2>;

constexpr TextureWrap all_wraps[] = {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::mirror};
constexpr TextureFilter all_filters[] = {TextureFilter::nearest, TextureFilter::bilinear,
                                         TextureFilter::trilinear};

Image<Rgba8> noise(int width, int height, bool opaque = true) {
  Random random{7};
  Image<Rgba8> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint64_t bits = random.next();
      picture.at(x, y) = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                          static_cast<std::uint8_t>(bits >> 16),
                          opaque ? std::uint8_t{255} : static_cast<std::uint8_t>(bits >> 24)};
    }
  }
  return picture;
}

/// The texel at a place of the endless, wrapped axis, one step at a time.
int place(long long i, int size, TextureWrap wrap) {
  const long long periods = i >= 0 ? i / size : -((size - 1 - i) / size);
  if (wrap == TextureWrap::clamp) return static_cast<int>(std::min<long long>(std::max(i, 0LL), size - 1));
  const int within = static_cast<int>(i - periods * size);
  return wrap == TextureWrap::mirror && periods % 2 != 0 ? size - 1 - within : within;
}

glm::dvec4 texel_at(const Image<Rgba8>& picture, long long column, long long row_from_below,
                    const Wraps& wrap) {
  const int x = place(column, picture.width(), wrap[0]);
  const int y = picture.height() - 1 - place(row_from_below, picture.height(), wrap[1]);
  return glm::dvec4(linear_from_srgb(picture.at(x, y)));
}

void check_close(const glm::vec4& a, const glm::dvec4& b, double tolerance = 1e-6) {
  for (int i = 0; i < 4; ++i) CHECK(std::abs(double(a[i]) - b[i]) <= tolerance);
}

/// Small numbers near 0, and now and then up to a million.
double coordinate(Random& random) {
  return random.below(3) == 0 ? random.uniform(-1e6, 1e6) : random.uniform(-2.5, 2.5);
}

}  // namespace

TEST_CASE("every filter and wrap meets the texels where they are, far out too") {
  const int sizes[][2] = {{1, 1}, {1, 5}, {6, 1}, {4, 4}, {5, 3}, {7, 12}};
  Random random{11};
  for (const auto& [width, height] : sizes) {
    const Image<Rgba8> picture = noise(width, height);
    const Texture texture(picture);
    for (const TextureWrap across : all_wraps) {
      for (const TextureWrap up : all_wraps) {
        for (int i = 0; i < 60; ++i) {
          const Wraps wrap{across, up};
          // At a texel's centre all filters agree; a footprint of one texel is no minification.
          const auto column = static_cast<long long>(std::floor(coordinate(random) * width));
          const auto row = static_cast<long long>(std::floor(coordinate(random) * height));
          const TextureLookup lookup{{(double(column) + 0.5) / width, (double(row) + 0.5) / height},
                                     {1.0 / width, 0.0},
                                     {0.0, 1.0 / height}};
          for (const TextureFilter filter : all_filters)
            check_close(filtered(texture, wrap, filter, lookup), texel_at(picture, column, row, wrap), 2e-6);
        }
      }
    }
  }
}

TEST_CASE("bilinear is the hand computation between four texels, for every wrap") {
  const Image<Rgba8> picture = noise(5, 3);
  const Texture texture(picture);
  Random random{12};
  for (const TextureWrap across : all_wraps) {
    for (const TextureWrap up : all_wraps) {
      for (int i = 0; i < 200; ++i) {
        const Wraps wrap{across, up};
        const glm::dvec2 at(coordinate(random), coordinate(random));
        // Clamped coordinates stop at the picture's edge, half a texel beyond the last centre.
        const double x = at.x * 5 - 0.5, y = at.y * 3 - 0.5, fx = std::floor(x), fy = std::floor(y);
        const auto c = static_cast<long long>(fx), r = static_cast<long long>(fy);
        const glm::dvec4 expected =
            (texel_at(picture, c, r, wrap) * (1 - (x - fx)) + texel_at(picture, c + 1, r, wrap) * (x - fx)) *
                (1 - (y - fy)) +
            (texel_at(picture, c, r + 1, wrap) * (1 - (x - fx)) +
             texel_at(picture, c + 1, r + 1, wrap) * (x - fx)) *
                (y - fy);
        check_close(filtered(texture, wrap, TextureFilter::bilinear, {at, {}, {}}), expected);
        // λ = 0 and below: a magnified picture is bilinear.
        check_close(filtered(texture, wrap, TextureFilter::trilinear, {at, {0.01, 0.0}, {0.0, 0.02}}),
                    expected);
      }
    }
  }
}

TEST_CASE("(0,0) is the lower left of the picture") {
  Image<Rgba8> picture(2, 2, Rgba8{0, 0, 0, 255});
  picture.at(0, 1) = {255, 0, 0, 255};  // lower left
  picture.at(1, 0) = {0, 255, 0, 255};  // upper right
  const Texture texture(picture);
  const Wraps wrap{};
  CHECK(filtered(texture, wrap, TextureFilter::nearest, {{0.1, 0.1}, {}, {}}) == glm::vec4(1, 0, 0, 1));
  CHECK(filtered(texture, wrap, TextureFilter::nearest, {{0.9, 0.9}, {}, {}}) == glm::vec4(0, 1, 0, 1));
  // Just below a whole number, and a number so small that it vanishes when 1 is added.
  CHECK(filtered(texture, wrap, TextureFilter::nearest, {{-1e-30, -1e-30}, {}, {}}).a == 1.0f);
  check_close(filtered(texture, wrap, TextureFilter::bilinear, {{-1e-30, 0.25}, {}, {}}),
              {0.5, 0.0, 0.0, 1.0});
}

TEST_CASE("coordinates and derivatives that are not finite have a defined result") {
  const Texture texture(noise(6, 5));
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const TextureWrap wrap : all_wraps) {
    const Wraps wraps{wrap, wrap};
    for (const TextureFilter filter : all_filters) {
      const glm::vec4 at_zero = filtered(texture, wraps, filter, {});
      for (const double broken : {nan, infinity, -infinity})
        CHECK(filtered(texture, wraps, filter, {{broken, broken}, {}, {}}) == at_zero);
      for (const double huge : {1e300, -1e300, 1e17})
        CHECK(filtered(texture, wraps, filter, {{huge, huge}, {}, {}}).a == 1.0f);
    }
    const glm::vec4 mean = texture.level(texture.level_count() - 1).at(0, 0);
    for (const double broken : {nan, infinity, 1e200, 1e150})
      CHECK(filtered(texture, wraps, TextureFilter::trilinear, {{0.3, 0.3}, {broken, 0}, {0, 1}}) == mean);
  }
}

TEST_CASE("a round footprint of 2^k texels reads level k; between them the levels are blended") {
  const Image<Rgba8> picture = noise(16, 16);
  const Texture texture(picture);
  const Wraps wrap{};
  for (int k = 0; k < 5; ++k) {
    const int size = 16 >> k;
    const double step = 1.0 / size;
    const TextureLookup lookup{{0.5 * step, 0.5 * step}, {0.0, step}, {-step, 0.0}};
    check_close(filtered(texture, wrap, TextureFilter::trilinear, lookup),
                glm::dvec4(texture.level(k).at(0, size - 1)), 2e-6);
  }
  // √2 · 4 texels: half of level 2 and half of level 3, at a place where both are at a texel's centre or not.
  const double step = 4.0 * 1.4142135623730951 / 16.0;
  const TextureLookup lookup{{0.125, 0.125}, {step, 0.0}, {0.0, step}};
  const Image<glm::vec4>& coarse = texture.level(3);
  const glm::dvec4 corner = glm::dvec4(coarse.at(0, 1)) * 0.75 * 0.75 + glm::dvec4(coarse.at(1, 1)) * 0.1875 +
                            glm::dvec4(coarse.at(0, 0)) * 0.1875 + glm::dvec4(coarse.at(1, 0)) * 0.0625;
  check_close(filtered(texture, wrap, TextureFilter::trilinear, lookup),
              glm::dvec4(texture.level(2).at(0, 3)) * 0.5 + corner * 0.5, 2e-6);
}

TEST_CASE("a long footprint blurs along its longer axis only, whichever way it lies") {
  // Stripes one texel wide: across the footprint they stay, along it they vanish.
  Image<Rgba8> picture(64, 64, Rgba8{0, 0, 0, 255});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; x += 8) {
      for (int i = 0; i < 4; ++i) picture.at(x + i, y) = {255, 255, 255, 255};
    }
  }
  const Texture texture(picture);
  const Wraps wrap{};
  const double texel = 1.0 / 64.0, centre_of_stripe = 2.0 * texel;
  const glm::dvec2 along(0.0, 12.0 * texel), across(texel, 0.0);
  for (const auto& [dx, dy] :
       {std::pair(along, across), std::pair(across, along), std::pair(-across, along)}) {
    const TextureLookup lookup{{centre_of_stripe, 0.3}, dx, dy};
    CHECK(filtered(texture, wrap, TextureFilter::trilinear, lookup).r > 0.99f);
  }
  for (double at = 0.0; at < 1.0; at += 0.0173) {
    const TextureLookup lookup{{at, 0.3}, {16.0 * texel, 0.0}, {0.0, texel}};
    CHECK(double(filtered(texture, wrap, TextureFilter::trilinear, lookup).r) ==
          doctest::Approx(0.5).epsilon(0.02));
  }
  // Sheared derivatives, nearly parallel, make a long thin ellipse: one texel across, not 12.
  const TextureLookup sheared{{centre_of_stripe, 0.3}, along + across * 0.5, along - across * 0.5};
  CHECK(filtered(texture, wrap, TextureFilter::trilinear, sheared).r > 0.9f);
}

TEST_CASE("a constant texture stays what it is under every footprint") {
  const Texture texture(Image<Rgba8>(13, 9, Rgba8{200, 100, 50, 128}));
  const glm::dvec4 expected(linear_from_srgb(Rgba8{200, 100, 50, 128}));
  Random random{13};
  for (int i = 0; i < 300; ++i) {
    const glm::dvec2 at(coordinate(random), coordinate(random));
    const glm::dvec2 dx(coordinate(random), coordinate(random)), dy(coordinate(random), coordinate(random));
    for (const TextureFilter filter : all_filters)
      check_close(filtered(texture, {}, filter, {at, dx, dy}), expected);
  }
}

TEST_CASE("transparent texels lend no colour, and an opaque texture is exactly opaque") {
  Image<Rgba8> picture(2, 1);
  picture.at(0, 0) = {255, 0, 0, 255};
  picture.at(1, 0) = {0, 255, 0, 0};
  const Texture texture(picture);
  check_close(filtered(texture, {}, TextureFilter::bilinear, {{0.5, 0.5}, {}, {}}), {1.0, 0.0, 0.0, 0.5});
  CHECK(filtered(texture, {}, TextureFilter::nearest, {{0.75, 0.5}, {}, {}}) == glm::vec4(0.0f));
  const Texture opaque(noise(7, 5));
  Random random{14};
  for (int i = 0; i < 300; ++i) {
    const glm::dvec2 dx(coordinate(random), coordinate(random)), dy(coordinate(random), coordinate(random));
    CHECK(filtered(opaque, {}, TextureFilter::trilinear, {{coordinate(random), coordinate(random)}, dx, dy})
              .a == 1.0f);
  }
}
