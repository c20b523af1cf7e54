// A caller's rounding mode changes no byte, whatever public function it calls (DESIGN §5).
#include <doctest/doctest.h>

#include <cfenv>
#include <cstring>
#include <map>
#include <velum/velum.hpp>

using namespace velum;

namespace {

/// A caller that rounds upwards; put back at the end.
struct RoundingUp {
  int saved = std::fegetround();
  RoundingUp() { std::fesetround(FE_UPWARD); }
  ~RoundingUp() { std::fesetround(saved); }
};

using Bytes = std::string;

template <typename T>
void append(Bytes& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <typename T>
void append(Bytes& bytes, const Image<T>& image) {
  for (int y = 0; y < image.height(); ++y)
    append(bytes, image.row(y), static_cast<std::size_t>(image.width()));
}

void append(Bytes& bytes, const glm::dmat4& matrix) {
  append(bytes, &matrix, 1);
}

void append(Bytes& bytes, const Camera& camera) {
  const ViewingTransform viewing = camera.viewing_transform(4.0 / 3.0);
  append(bytes, viewing.clip_from_world());
  append(bytes, viewing.world_from_clip());
  const glm::dvec4 plane = metric_depth_plane(camera);
  append(bytes, &plane, 1);
}

Bytes bytes_of(const Mesh& mesh) {
  Bytes bytes;
  append(bytes, mesh.positions.data(), mesh.positions.size());
  append(bytes, mesh.normals.data(), mesh.normals.size());
  const std::vector<glm::vec3> smooth = smooth_normals(mesh);
  append(bytes, smooth.data(), smooth.size());
  return bytes;
}

Bytes bytes_of(const Scene& scene, const Projection& projection) {
  FrameOptions framing;
  framing.aspect = 4.0 / 3.0;
  const Camera camera = frame(scene.points(), projection, framing);
  RenderSettings settings;
  settings.width = 32;
  settings.height = 24;
  const Picture picture = render(scene, camera, settings);
  Bytes bytes;
  append(bytes, camera);
  append(bytes, frame(scene.bounds(), projection, framing));
  append(bytes, picture.colour);
  append(bytes, picture.depth);
  append(bytes, picture.metric_depth);
  return bytes;
}

Bytes bytes_of_cameras() {
  Bytes bytes;
  const Pose pose = Pose::towards({1.1, 2.3, 4.7}, {0.1, 0.2, 0.3});
  append(bytes, Camera::perspective(pose, {VerticalAngle{0.7}, {0.1, 0.3}}, 0.3, 11.3));
  append(bytes, Camera::off_axis(pose, {-0.1, 0.3, -0.2, 0.1}, 0.3, 11.3));
  ParallelWindow window;
  window.height = 0.7;
  window.shear = {0.1, 0.3};
  window.focus = 1.7;
  append(bytes, Camera::parallel(pose, window, 0.3, 11.3));
  const glm::dmat4 clip = Camera::parallel(pose, window, 0.3, 11.3).viewing_transform(1.3).clip_from_world();
  append(bytes, Camera::from_clip_matrix(clip, DepthRange::minus_one_to_one));
  return bytes;
}

/// What the public functions give, by name.
std::map<std::string, Bytes> everything() {
  std::map<std::string, Bytes> all;
  all["cameras"] = bytes_of_cameras();
  for (const std::string_view name : builtin_names()) all[std::string(name)] = bytes_of(builtin_shape(name));
  const Scene house = load_scene("builtin:house");
  for (const ProjectionEntry& entry : projection_catalogue()) {
    all[std::string(entry.name)] = bytes_of(house, parse_projection(entry.name));
  }
  all["trimetric in C++"] = bytes_of(house, projection::trimetric(0.3, 0.7));
  all["checkerboard"] = bytes_of(load_scene("builtin:checkerboard"), projection::isometric());
  SheetOptions sheet;
  sheet.width = 360;
  sheet.height = 300;
  append(all["sheet"], draw_sheet(house, sheet).picture);
  return all;
}

}  // namespace

TEST_CASE("a caller that rounds upwards gets the same bytes from every public function") {
  const std::map<std::string, Bytes> usual = everything();
  std::map<std::string, Bytes> rounded_up;
  {
    const RoundingUp caller;
    rounded_up = everything();
  }
  for (const auto& [name, bytes] : usual) {
    CAPTURE(name);
    const bool same = bytes == rounded_up.at(name);
    CHECK(same);
  }
}
