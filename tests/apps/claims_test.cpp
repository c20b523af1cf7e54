// velum claims: the page of what the lectures claim.
#include <doctest/doctest.h>

#include <tuple>

#include "run_program.hpp"

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("velum claims writes a page with a formula, a figure and a verdict for each claim") {
  const Workplace place;
  const Outcome outcome = place.velum("claims --quick -o page.html");
  CHECK(outcome.code == 0);
  CHECK(contains(outcome.out, "page.html: written"));
  const std::string page = place.read("page.html");
  const std::size_t claims = count(page, "<h2 ");
  CHECK(claims >= 9);
  CHECK(count(page, "class=\"formula\"") == claims);
  CHECK(count(page, "Verdict: ") == claims);
  CHECK(count(page, "<svg ") >= claims);
  CHECK(count(page, "<svg ") == count(page, "</svg>"));
  CHECK_FALSE(contains(page, "\"nan\""));
  CHECK_FALSE(contains(page, "\"inf\""));
}

TEST_CASE("velum claims measures the scenes it is given, empty and single triangles too") {
  const Workplace place;
  place.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  place.write("none.obj", "v 0 0 0\n");
  CHECK(place.velum("claims --quick --quiet builtin:cube one.obj none.obj -o page.html").code == 0);
  CHECK(contains(place.read("page.html"), "cube (12 triangles), one (1 triangles)"));
  CHECK(place.velum("claims --quick missing.obj -o page.html").code == 3);
}

TEST_CASE("velum claims refuses a page that cannot be written before it measures anything") {
  const Workplace place;
  for (const auto& [output, code, why] :
       {std::tuple{"nowhere/page.html", 4, "there is no folder"}, std::tuple{"page.png", 2, ".html"}}) {
    const Outcome outcome = place.velum(std::string("claims --quick -o ") + output);
    CHECK(outcome.code == code);
    CHECK(contains(outcome.err, why));
    CHECK_FALSE(contains(outcome.err, "growth with n"));
  }
  CHECK(contains(place.velum("claims --quick --quiet -o -").out, "</html>"));
}
