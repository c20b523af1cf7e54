#include <doctest/doctest.h>

#include <velum/velum.hpp>

using namespace velum;

namespace {

constexpr int width = 640;
constexpr int height = 40;

Picture white_scene() {
  Picture picture;
  picture.colour.resize(width, height);
  picture.triangle_id.resize(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      picture.colour.at(x, y) = {255, 255, 255, 255};
      picture.triangle_id.at(x, y) = x < width / 2 ? 7 : no_primitive;
    }
  }
  return picture;
}

/// All agree but for single pixels of one class each.
struct Marked {
  int x, y;
  Agreement reason;
};
AgreementReport report_of(std::initializer_list<Marked> marks) {
  AgreementReport report;
  report.classes.resize(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) report.classes.at(x, y) = 0;
  }
  for (const Marked& mark : marks) {
    report.classes.at(mark.x, mark.y) = static_cast<std::uint8_t>(mark.reason);
    ++report.counts[static_cast<std::size_t>(mark.reason)];
    report.differences.push_back({mark.x, mark.y, 0, 1, mark.reason});
  }
  return report;
}

int count_of(const Image<Rgba8>& map, const Rgba8& colour, int from, int to) {
  int count = 0;
  for (int y = from; y < to; ++y) {
    for (int x = 0; x < map.width(); ++x) count += map.at(x, y) == colour;
  }
  return count;
}

int marked(const Image<Rgba8>& map, Agreement reason) {
  return count_of(map, agreement_class(reason).colour, 0, height);
}

}  // namespace

TEST_CASE("the map of differences shows single pixels large, each class in its colour") {
  const Image<Rgba8> map = draw_agreement(report_of({{20, 10, Agreement::edge},
                                                     {40, 10, Agreement::cut},
                                                     {60, 10, Agreement::tie},
                                                     {90, 20, Agreement::unexplained},
                                                     {639, 39, Agreement::edge}}),
                                          white_scene());
  CHECK(map.width() == width);
  CHECK(marked(map, Agreement::edge) == 9 + 4);  // the one in the corner is cut
  CHECK(marked(map, Agreement::cut) == 9);
  CHECK(marked(map, Agreement::tie) == 9);
  CHECK(marked(map, Agreement::unexplained) == 49);
  CHECK(map.at(90, 20) == agreement_class(Agreement::unexplained).colour);
  CHECK(map.at(99, 20).r > 200);  // its ring
  CHECK(map.at(99, 20).g > 200);
}

TEST_CASE("rings hide no fault beside them") {
  const Image<Rgba8> map = draw_agreement(
      report_of({{90, 20, Agreement::unexplained}, {98, 20, Agreement::unexplained}}), white_scene());
  CHECK(marked(map, Agreement::unexplained) == 2 * 49);
}

TEST_CASE("a fault is never hidden by other marks around it") {
  const Image<Rgba8> map = draw_agreement(
      report_of({{90, 20, Agreement::unexplained}, {91, 20, Agreement::edge}, {91, 21, Agreement::tie}}),
      white_scene());
  CHECK(marked(map, Agreement::unexplained) == 49);
}

TEST_CASE("the scene beneath the map is grey and darker than every mark") {
  const Image<Rgba8> map = draw_agreement(report_of({}), white_scene());
  const Rgba8 seen = map.at(10, 10), empty = map.at(width - 10, 10);
  CHECK(seen.r == seen.g);
  CHECK(seen.g == seen.b);
  CHECK(seen.r < 160);
  CHECK(empty.g + 20 < seen.g);
}

TEST_CASE("the map's legend shows every colour and another text for other counts") {
  const Image<Rgba8> none = draw_agreement(report_of({}), white_scene());
  const Image<Rgba8> one = draw_agreement(report_of({{20, 10, Agreement::tie}}), white_scene());
  REQUIRE(none.height() == one.height());
  for (int i = 1; i < agreement_count; ++i) {
    CHECK(count_of(none, agreement_class(static_cast<Agreement>(i)).colour, height, none.height()) == 256);
  }
  int differing = 0;
  for (int y = height; y < none.height(); ++y) {
    for (int x = 0; x < none.width(); ++x) differing += !(none.at(x, y) == one.at(x, y));
  }
  CHECK(differing > 0);
}

TEST_CASE("a small map is magnified") {
  AgreementReport report;
  report.classes.resize(20, 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) report.classes.at(x, y) = 0;
  }
  report.classes.at(0, 0) = static_cast<std::uint8_t>(Agreement::cut);
  Picture beneath;
  beneath.colour.resize(20, 10);
  beneath.triangle_id.resize(20, 10);
  const Image<Rgba8> map = draw_agreement(report, beneath);
  CHECK(count_of(map, agreement_class(Agreement::cut).colour, 0, 16 * 10) == 16 * 16);
}
