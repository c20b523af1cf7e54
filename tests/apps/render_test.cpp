#include <doctest/doctest.h>

#include <cstdlib>
#include <velum/velum.hpp>

#include "run_program.hpp"

namespace {

const std::string triangle_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

bool is_png(const std::string& bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1a\n");
}

}  // namespace

TEST_CASE(
    "with no option at all the picture is NAME.png in the current folder, 800x600, and shows something") {
  const Workplace place;
  const Outcome outcome = place.velum("render builtin:house");
  CHECK(outcome.code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.starts_with("house.png: 800x600, perspective, "));
  CHECK(contains(outcome.out, " % covered\n"));
  CHECK(place.files() == std::vector<std::string>{"house.png"});
  const velum::Image<velum::Rgba8> picture = velum::read_png(place.path("house.png"));
  CHECK(picture.width() == 800);
  CHECK(picture.height() == 600);
  CHECK(picture.at(0, 0).a == 0);
  CHECK(picture.at(400, 300).a == 255);
}

TEST_CASE("the name of the picture comes from the file, wherever that lies") {
  const Workplace place;
  std::filesystem::create_directory(place.path("models"));
  place.write("models/one.v2.obj", triangle_obj);
  CHECK(place.velum("render models/one.v2.obj --size 32x24 --quiet").code == 0);
  CHECK(place.files() == std::vector<std::string>{"models", "one.v2.png"});
}

TEST_CASE("IN and OUT may be -") {
  const Workplace place;
  place.write("triangle.obj", triangle_obj);
  const Outcome piped = place.velum("render - -o - --size 32x24", "triangle.obj");
  CHECK(piped.code == 0);
  CHECK(is_png(piped.out));
  CHECK(contains(piped.err, "standard output: 32x24"));
  CHECK(place.velum("render triangle.obj -o a.png --size 32x24").code == 0);
  CHECK(place.read("a.png") == piped.out);
  CHECK(place.velum("render - --size 32x24 --quiet", "triangle.obj").out.empty());
  CHECK(place.read("stdin.png") == piped.out);
}

TEST_CASE("every output is written in every format it has") {
  const Workplace place;
  const std::string render = "render builtin:cube --size 32x24 --quiet ";
  CHECK(place
            .velum(render + "-o c.ppm --depth d.pfm --metric-depth m.pfm --normals n.pfm --object-ids o.npy "
                            "--triangle-ids t.npy --report r.json")
            .code == 0);
  CHECK(place
            .velum(render + "-o c.png --depth d.npy --metric-depth m.npy --normals n.npy --object-ids o.png "
                            "--triangle-ids t.PNG")
            .code == 0);
  CHECK(place.files() == std::vector<std::string>{"c.png", "c.ppm", "d.npy", "d.pfm", "m.npy", "m.pfm",
                                                  "n.npy", "n.pfm", "o.npy", "o.png", "r.json", "t.PNG",
                                                  "t.npy"});
  const velum::Image<float> depth = velum::read_pfm(place.path("d.pfm"));
  CHECK(depth.at(0, 0) == 1.0f);
  CHECK(depth.at(16, 12) < 1.0f);
  CHECK(velum::read_png(place.path("o.png")).at(16, 12).a == 255);
}

TEST_CASE("every projection of the catalogue makes a picture") {
  const Workplace place;
  for (const velum::ProjectionEntry& entry : velum::projection_catalogue()) {
    const std::string name(entry.name);
    CAPTURE(name);
    const Outcome outcome = place.velum("render builtin:letter-f --size 48x36 --projection " + name);
    CHECK(outcome.code == 0);
    CHECK(contains(outcome.out, ", " + name + ", "));
  }
}

TEST_CASE("the projections of the catalogue are those that were promised, in order") {
  const std::vector<std::string> promised{
      "front",    "back",          "left",        "right",      "top",       "bottom",     "isometric",
      "dimetric", "dimetric-2to1", "trimetric",   "axonometry", "cavalier",  "cabinet",    "natural-oblique",
      "military", "oblique",       "perspective", "one-point",  "two-point", "three-point"};
  std::vector<std::string> names;
  for (const velum::ProjectionEntry& entry : velum::projection_catalogue()) names.emplace_back(entry.name);
  CHECK(names == promised);
}

TEST_CASE("a crop equals the same part of the whole picture") {
  const Workplace place;
  CHECK(place.velum("render builtin:torus --size 80x60 -o whole.png --quiet").code == 0);
  CHECK(place.velum("render builtin:torus --size 80x60 --crop 30,10,25,20 -o part.png --quiet").code == 0);
  const auto whole = velum::read_png(place.path("whole.png"));
  const auto part = velum::read_png(place.path("part.png"));
  REQUIRE(part.width() == 25);
  REQUIRE(part.height() == 20);
  int different = 0;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 25; ++x) different += part.at(x, y) == whole.at(x + 30, y + 10) ? 0 : 1;
  }
  CHECK(different == 0);
}

TEST_CASE("--background, --shading, --cull, --wireframe and --world-up do what they say") {
  const Workplace place;
  const auto picture = [&place](const std::string& options) {
    REQUIRE(place.velum("render builtin:house --size 64x48 --quiet -o p.png " + options).code == 0);
    return velum::read_png(place.path("p.png"));
  };
  CHECK(picture("--background '#1020fF'").at(0, 0) == velum::Rgba8{0x10, 0x20, 0xff, 255});
  const std::string plain = (picture(""), place.read("p.png"));
  for (const std::string options :
       {"--shading flat --wireframe", "--wireframe --line-width 3", "--shading normal", "--shading depth",
        "--shading triangle-id", "--shading barycentric", "--cull front", "--world-up z", "--up 0,0,1",
        "--fov 20 --eye 4,3,6"}) {
    CAPTURE(options);
    picture(options);
    CHECK(place.read("p.png") != plain);
  }
}

TEST_CASE("--texture-filter chooses how textures are filtered; trilinear is the default") {
  const Workplace place;
  const auto bytes = [&place](const std::string& options) {
    REQUIRE(
        place
            .velum(
                "render builtin:checkerboard --eye 0.3,1.5,127 --target 0.3,1.2,125 --size 64x36 -o p.png " +
                options)
            .code == 0);
    return place.read("p.png");
  };
  const std::string trilinear = bytes("");
  CHECK(bytes("--texture-filter trilinear") == trilinear);
  CHECK(bytes("--texture-filter bilinear") != trilinear);
  CHECK(bytes("--texture-filter nearest") != bytes("--texture-filter bilinear"));
  CHECK(place.velum("render builtin:checkerboard --texture-filter sharp").code == 2);
}

TEST_CASE("a locale with a decimal comma changes nothing") {
  const Workplace place;
  const std::string render = "render builtin:cube --size 32x24 --eye 1.5,2.5,3.5 --fov 33.5 ";
  CHECK(place.velum(render + "-o a.png --report a.json").code == 0);
  setenv("LC_ALL", "de_DE.UTF-8", 1);
  CHECK(place.velum(render + "-o b.png --report b.json").code == 0);
  unsetenv("LC_ALL");
  CHECK(place.read("a.png") == place.read("b.png"));
  CHECK(place.read("a.json") == place.read("b.json"));
}

TEST_CASE("--samples and --supersample smooth edges and change nothing but colour") {
  const Workplace place;
  const std::string render = "render builtin:letter-f --size 64x48 --quiet ";
  REQUIRE(place.velum(render + "-o a.png --depth a.npy").code == 0);
  REQUIRE(place.velum(render + "--samples 8 -o b.png --depth b.npy").code == 0);
  REQUIRE(place.velum(render + "--supersample 2 --filter mitchell -o c.png --depth c.npy").code == 0);
  CHECK(place.read("a.npy") == place.read("b.npy"));
  CHECK(place.read("a.npy") == place.read("c.npy"));
  CHECK(place.read("a.png") != place.read("b.png"));
  CHECK(place.read("b.png") != place.read("c.png"));
}

TEST_CASE("samples and filters that do not exist end with 2 and say what there is") {
  const Workplace place;
  const Outcome samples = place.velum("render builtin:cube --samples 5");
  CHECK(samples.code == 2);
  CHECK(contains(samples.err, "--samples"));
  CHECK(contains(samples.err, "16"));
  CHECK(place.velum("render builtin:cube --supersample 9").code == 2);
  CHECK(place.velum("render builtin:cube --supersample 2 --filter lanczos").code == 2);
  const Outcome alone = place.velum("render builtin:cube --filter tent");
  CHECK(alone.code == 2);
  CHECK(contains(alone.err, "--supersample"));
  const Outcome large = place.velum("render builtin:cube --size 20000x100 --supersample 2");
  CHECK(large.code == 2);
  CHECK(contains(large.err, "32768"));
  CHECK(place.files().empty());
}

TEST_CASE("--kd-file writes a scene's kd-trees, reads them again, and refuses those of others") {
  const Workplace place;
  const std::string options =
      " --visibility raycast --accelerator kdtree --size 64x48 --kd-file trees.kd -o ";
  REQUIRE(place.velum("render builtin:torus" + options + "built.png").code == 0);
  CHECK(place.has("trees.kd"));
  REQUIRE(place.velum("render builtin:torus" + options + "read.png").code == 0);
  CHECK(place.read("built.png") == place.read("read.png"));
  const Outcome other = place.velum("render builtin:cone" + options + "other.png");
  CHECK(other.code == 3);
  CHECK(contains(other.err, "other triangles"));
  CHECK_FALSE(place.has("other.png"));
  CHECK(place.velum("render builtin:torus --kd-file trees.kd --visibility raycast").code == 2);
  CHECK(place.velum("render builtin:torus --kd-file trees.kd --accelerator kdtree").code == 2);
  const Outcome nowhere = place.velum(
      "render builtin:torus --visibility raycast --accelerator kdtree --size 64x48 --kd-file no/where.kd");
  CHECK(nowhere.code == 4);
}

TEST_CASE("render --analytic sees a round shape by its equation") {
  const Workplace place;
  const std::string sphere = "render builtin:sphere --size 64x48 --visibility raycast";
  const Outcome outcome = place.velum(sphere + " --analytic -o body.png");
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.out, "by its equation"));
  REQUIRE(place.velum(sphere + " -o triangles.png").code == 0);
  CHECK(place.read("body.png") != place.read("triangles.png"));
  CHECK(place.velum("render builtin:sphere --analytic").code == 2);
  CHECK(place.velum(sphere + " --analytic --samples 4").code == 2);
  CHECK(place.velum("render builtin:cube --visibility raycast --analytic").code == 2);
}
