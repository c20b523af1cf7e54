#include "camera_options.hpp"

namespace velum_app {
namespace {

constexpr const char* group = "Camera";

template <typename Read, typename Value>
void read_if_given(const std::optional<std::string>& text, const char* option, Read read,
                   std::optional<Value>& value) {
  if (text) value = read(*text, option);
}

void check_near_far(const velum::FrameOptions& framing) {
  if (framing.near && framing.far && *framing.near >= *framing.far) {
    throw velum::Error(velum::ErrorKind::usage, "the near plane is not nearer than the far plane", "--near",
                       "give --near smaller than --far");
  }
}

}  // namespace

void CameraOptions::add_to(CLI::App& parser) {
  const auto add = [&parser](const char* name, auto& value, const char* type, const char* help) {
    return parser.add_option(name, value, help)->type_name(type)->group(group);
  };
  add("--projection", projection, "NAME[:k=v,...]",
      "The projection, e.g. isometric, cabinet:angle=30 (default: perspective); see `velum projections`");
  add("--eye", eye, "X,Y,Z", "Where the camera stands (default: framed so that the scene fills the picture)");
  add("--target", target, "X,Y,Z", "The point in the middle of the view");
  add("--up", up, "X,Y,Z", "The direction that is up in the picture");
  CLI::Option* vertical = add("--fov", fov, "DEG", "Vertical opening angle in degrees (perspective)");
  CLI::Option* horizontal = add("--hfov", hfov, "DEG", "Horizontal opening angle in degrees (perspective)");
  vertical->excludes(horizontal);
  add("--near", near, "N", "Distance of the near plane (default: just before the scene)");
  add("--far", far, "F", "Distance of the far plane (default: just behind the scene)");
  add("--world-up", world_up, "y|z", "The axis of the world that points up (default: y)")
      ->check(CLI::IsMember({"y", "z"}));
  add("--size", size, "WxH", "Size of the picture in pixels (default: 800x600)");
}

View view_from(const CameraOptions& options) {
  View view{velum::parse_projection(options.projection), {}, size_from(options.size, "--size")};
  velum::FrameOptions& framing = view.framing;
  framing.aspect = static_cast<double>(view.size.width) / view.size.height;
  framing.z_up = options.world_up == "z";
  read_if_given(options.eye, "--eye", vector_from, framing.eye);
  read_if_given(options.target, "--target", vector_from, framing.target);
  read_if_given(options.up, "--up", vector_from, framing.up);
  read_if_given(options.fov, "--fov", opening_angle_from, framing.vertical_angle);
  read_if_given(options.hfov, "--hfov", opening_angle_from, framing.horizontal_angle);
  read_if_given(options.near, "--near", number_from, framing.near);
  read_if_given(options.far, "--far", number_from, framing.far);
  check_near_far(framing);
  return view;
}

}  // namespace velum_app
