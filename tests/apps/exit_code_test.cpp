// DESIGN's exit codes: 0 ok, 1 rendered but blank, 2 usage, 3 cannot read, 4 cannot write.
#include <doctest/doctest.h>

#include "run_program.hpp"

namespace {

const std::vector<std::string> nothing;

/// Demands the code, a message that begins with "velum: " and has the text, and that no file is left.
void check_refused(const std::string& arguments, int code, const std::string& text) {
  const Workplace place;
  const Outcome outcome = place.velum(arguments);
  CAPTURE(arguments);
  CAPTURE(outcome.err);
  CHECK(outcome.code == code);
  CHECK(outcome.err.starts_with("velum: "));
  CHECK(contains(outcome.err, text));
  CHECK(outcome.out.empty());
  CHECK(place.files() == nothing);
}

}  // namespace

TEST_CASE("a file that cannot be read ends with 3 and leaves nothing") {
  check_refused("render nothere.obj", 3, "nothere.obj");
  check_refused("info nothere.obj", 3, "nothere.obj");
}

TEST_CASE("a file that is no mesh ends with 3") {
  const Workplace place;
  place.write("noise.obj", "this is no mesh\n\x01\x02\x03");
  const Outcome outcome = place.velum("render noise.obj");
  CHECK(outcome.code == 3);
  CHECK(contains(outcome.err, "noise.obj"));
  CHECK(place.files() == std::vector<std::string>{"noise.obj"});
}

TEST_CASE("a projection's parameter that is no number ends with 2") {
  check_refused("render builtin:cube --projection cabinet:scale=x", 2, "scale");
  check_refused("render builtin:cube --projection fisheye", 2, "fisheye");
}

TEST_CASE("options that would be ignored end with 2") {
  const std::string equation = "render builtin:sphere --visibility raycast --analytic ";
  check_refused("render builtin:cube --accelerator grid", 2, "--accelerator");
  check_refused(equation + "--accelerator grid", 2, "--accelerator");
  check_refused(equation + "--depth-format 16", 2, "--depth-format");
  check_refused(equation + "--z-interpolation edges", 2, "--z-interpolation");
  check_refused(equation + "--show octree", 2, "--show");
  check_refused(equation + "--layers 2", 2, "--layers");
  check_refused(equation + "--triangle-ids ids.npy", 2, "--triangle-ids");
  check_refused("agree builtin:sphere --analytic -o map.png", 2, "--output");
  check_refused("agree builtin:sphere --analytic --accelerator grid", 2, "--accelerator");
  check_refused("agree builtin:sphere --analytic --cull back", 2, "--cull");
  check_refused("agree builtin:sphere --json -o -", 2, "--json");
  check_refused("ray builtin:sphere --pixel 4,4 --json -o -", 2, "--json");
  const std::string trees = "render builtin:cube --visibility raycast --accelerator kdtree --kd-file ";
  check_refused(trees + "a.npy --depth ./a.npy", 2, "--kd-file");
  check_refused(trees + "cube.png", 2, "--kd-file");
}

TEST_CASE("options that cannot be used end with 2 and say which") {
  check_refused("render", 2, "IN");
  check_refused("render builtin:cube --size 0x10", 2, "--size");
  check_refused("render builtin:cube --size 640", 2, "--size");
  check_refused("render builtin:cube --eye 1,2", 2, "--eye");
  check_refused("render builtin:cube --eye 1,nan,2", 2, "--eye");
  check_refused("render builtin:cube --fov 180", 2, "--fov");
  check_refused("render builtin:cube --fov 40 --hfov 40", 2, "--hfov");
  check_refused("render builtin:cube --near 5 --far 4", 2, "--near");
  check_refused("render builtin:cube --up 0,0,1 --eye 0,0,5 --target 0,0,0", 2, "up");
  check_refused("render builtin:cube --background blue", 2, "--background");
  check_refused("render builtin:cube --background '#12345g'", 2, "--background");
  check_refused("render builtin:cube --crop 1,2,3", 2, "--crop");
  check_refused("render builtin:cube --shading toon", 2, "--shading");
  check_refused("render builtin:cube --layers -1", 2, "--layers");
  check_refused("render builtin:cube --layers 99999999999999999999", 2, "--layers");
  check_refused("render builtin:cube --world-up x", 2, "--world-up");
  check_refused("render builtin:cube --wat", 2, "--wat");
  check_refused("render builtin:spoon", 2, "spoon");
  check_refused("wat", 2, "there is no verb \"wat\"");
}

TEST_CASE("a wrong extension ends with 2 before any work and names the known ones") {
  check_refused("render builtin:cube -o cube.gif", 2, ".png or .ppm");
  check_refused("render builtin:cube --depth d.png", 2, ".pfm or .npy");
  check_refused("render builtin:cube --metric-depth d", 2, ".pfm or .npy");
  check_refused("render builtin:cube --normals n.png", 2, ".pfm or .npy");
  check_refused("render builtin:cube --object-ids ids.pfm", 2, ".npy or .png");
  check_refused("render builtin:cube --report r.txt", 2, ".json");
  check_refused("render nothere.obj -o cube.gif", 2, ".png or .ppm");
}

TEST_CASE("a picture that a PNG cannot hold ends with 2 before any work") {
  check_refused("render nothere.obj --size 32768x8193 -o big.png", 2, "big.png: 32768x8193 pixels");
  check_refused("render nothere.obj --size 32768x8193 -o -", 2, "standard output");
  check_refused("render nothere.obj --size 32768x10923 --background '#ffffff'", 2, "nothere.png");
  check_refused("render nothere.obj --size 32768x8193 -o big.ppm --object-ids i.png", 2, ".npy");
  check_refused("views nothere.obj --size 32768x10923", 2, "nothere-views.png");
  // These PNGs can be written; it is the file that is missing.
  check_refused("render nothere.obj --size 32768x8192", 3, "nothere.obj");
  check_refused("render nothere.obj --size 32768x10922 --background '#ffffff'", 3, "nothere.obj");
  check_refused("render nothere.obj --size 32768x8193 -o big.ppm", 3, "nothere.obj");
  check_refused("render nothere.obj --size 32768x32768 --crop 0,0,64,64", 3, "nothere.obj");
}

TEST_CASE("two outputs in one place end with 2") {
  check_refused("render builtin:cube -o a.png --object-ids ./a.png", 2, "--object-ids");
  check_refused("render builtin:cube -o - --depth -", 2, "--depth");
}

TEST_CASE("an output that cannot be written ends with 4 and leaves nothing") {
  check_refused("render builtin:cube -o nowhere/cube.png", 4, "nowhere");
  check_refused("render builtin:cube --depth nowhere/d.npy", 4, "nowhere");
  check_refused("views nothere.obj -o nowhere/v.png", 4, "there is no folder");
}

TEST_CASE("an output that is a folder is refused before any work") {
  check_refused("render nothere.obj -o sub/", 2, "names a folder");
  check_refused("render nothere.obj -o new.png/", 2, "names a folder");
  const Workplace place;
  std::filesystem::create_directories(place.path("taken.png"));
  for (const std::string command : {"render nothere.obj -o taken.png", "views nothere.obj -o taken.png",
                                    "render nothere.obj --object-ids taken.png"}) {
    const Outcome outcome = place.velum(command);
    CHECK(outcome.code == 4);
    CHECK(contains(outcome.err, "taken.png: is a folder"));
  }
}

TEST_CASE("numbers of extreme size and empty names end with a message that helps") {
  check_refused("render builtin:cube --near 1e-300 --far 1e300", 2, "near 1e-300, far 1e+300");
  check_refused("render builtin:cube --target 1e300,0,0", 2, "usual size");
  check_refused("render builtin:", 2, "known are tetrahedron");
  check_refused("render ''", 3, "the file name is empty");
}

TEST_CASE("an output whose place is taken by a folder ends with 4 and leaves no partial file") {
  const Workplace place;
  std::filesystem::create_directories(place.path("cube.png/inside"));
  const Outcome outcome = place.velum("render builtin:cube -o cube.png --size 40x30");
  CHECK(outcome.code == 4);
  CHECK(contains(outcome.err, "cube.png"));
  CHECK(place.files() == std::vector<std::string>{"cube.png"});
}

TEST_CASE("a full device ends with 4") {
  const Workplace place;
  // The # hides the redirection that velum() appends.
  CHECK(place.velum("render builtin:cube --size 40x30 -o - >/dev/full 2>/dev/null; exit $? #").code == 4);
  CHECK(place.velum("projections >/dev/full 2>/dev/null; exit $? #").code == 4);
}

TEST_CASE("a scene behind the camera is rendered, ends with 1 and says why") {
  const Workplace place;
  const Outcome outcome =
      place.velum("render builtin:cube --eye 0,0,5 --target 0,0,10 --near 0.1 --far 100 --size 40x30");
  CHECK(outcome.code == 1);
  CHECK(
      contains(outcome.err,
               "the picture is blank: all 12 triangles lie behind the camera (in front of the near plane)"));
  CHECK(contains(outcome.out, "0 % covered"));
  CHECK(place.has("cube.png"));
}

TEST_CASE("other blank pictures say why, too") {
  const Workplace place;
  const auto reason = [&place](const std::string& options) {
    const Outcome outcome = place.velum("render builtin:cube --size 40x30 --quiet " + options);
    CHECK(outcome.code == 1);
    CHECK(outcome.out.empty());
    return outcome.err;
  };
  const std::string straight = "--eye 0,0,5 --target 0,0,0 --fov 40 ";
  CHECK(contains(reason(straight + "--near 1 --far 2"), "behind the far plane (farther than 2)"));
  CHECK(contains(reason(straight + "--near 20 --far 30"), "in front of the near plane (nearer than 20)"));
  CHECK(contains(reason("--eye 0,0,5 --target 50,0,0 --near 1 --far 99"), "to the left of the picture"));
  CHECK(contains(reason("--crop 0,0,2,2"), "--crop"));
}

TEST_CASE("a picture is blank for the same reason whatever the method") {
  const Workplace place;
  place.write("back.obj", "v 0 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\n");
  place.write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  const auto reason = [&place](const std::string& options) {
    const Outcome outcome = place.velum("render " + options + " --size 40x30 --quiet -o blank.png");
    CHECK(outcome.code == 1);
    return outcome.err;
  };
  const std::string straight = " --eye 0,0,5 --target 0,0,0 --fov 40 --near 1 --far 9";
  for (const std::string scene : {"builtin:cube --crop 0,0,2,2", "back.obj --cull back", "line.obj"}) {
    CAPTURE(scene);
    const std::string expected = reason(scene + straight);
    for (const char* method :
         {" --visibility raycast", " --visibility scanline", " --visibility hierarchical"}) {
      CHECK(reason(scene + straight + method) == expected);
    }
  }
}

TEST_CASE("a picture is not blank where samples colour a pixel beside its centre") {
  const Workplace place;
  place.write("corner.obj", "v 0 0 0\nv 0.8 0 0\nv 0 0.8 0\nf 1 2 3\n");
  const std::string render =
      "render corner.obj --size 2x2 --quiet --eye 0,0,5 --target 0,0,0 --fov 40 --near 1 --far 9 --samples ";
  CHECK(place.velum(render + "1").code == 1);
  CHECK(place.velum(render + "16").code == 0);
}

TEST_CASE("no arguments show the help and end with 2; --help and --version end with 0") {
  const Workplace place;
  CHECK(place.velum("").code == 2);
  CHECK(contains(place.velum("").err, "velum render bunny.obj"));
  const Outcome version = place.velum("--version");
  CHECK(version.code == 0);
  CHECK(version.out.starts_with("velum "));
  for (const std::string verb :
       {"", "render", "matrix", "info", "projections", "views", "pixel", "clip-trace", "diff"}) {
    const Outcome help = place.velum(verb + " --help");
    CAPTURE(verb);
    CHECK(help.code == 0);
    CHECK(contains(help.out, "Examples:"));
    CHECK(help.err.empty());
  }
}
