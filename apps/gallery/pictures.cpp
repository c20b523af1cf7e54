#include "pictures.hpp"

#include <velum/shading/shading_names.hpp>

#include "html_text.hpp"

namespace velum_gallery {
namespace {

using namespace velum;

Shot shoot(Renderer& renderer, const Subject& subject, const Projection& projection, RenderSettings settings,
           const std::filesystem::path& folder, const std::string& file) {
  settings.width = shot_width;
  settings.height = shot_height;
  const double aspect = static_cast<double>(shot_width) / shot_height;
  FrameOptions framing;
  framing.aspect = aspect;
  framing.z_up = subject.scene.up == UpAxis::z;
  const Camera camera = frame(subject.scene.points(), projection, framing);
  const Picture& picture = renderer.render(subject.scene, camera, settings);
  write_png(folder / file, picture.colour.view());
  return {file, subject.title, camera.viewing_transform(aspect).stages(), picture.coverage()};
}

std::string parameters_text(const ProjectionEntry& entry) {
  std::string text;
  for (const auto& parameter : entry.parameters) {
    text += (text.empty() ? "" : ", ") + std::string(parameter.name) + " = " +
            number_text(parameter.default_value, 6) + (parameter.unit == "degrees" ? "°" : "");
  }
  return text;
}

}  // namespace

Section render_projection(Renderer& renderer, const ProjectionEntry& entry,
                          const std::vector<Subject>& subjects, const std::filesystem::path& folder) {
  const std::string name(entry.name);
  Section section{name,
                  name,
                  std::string(entry.family),
                  std::string(entry.summary),
                  parameters_text(entry),
                  std::string(entry.source),
                  {}};
  const Projection projection = parse_projection(name);
  for (const Subject& subject : subjects) {
    const std::string file = name + "_" + subject.stem + ".png";
    section.shots.push_back(shoot(renderer, subject, projection, {}, folder, file));
  }
  return section;
}

Section render_shadings(Renderer& renderer, const Subject& subject, const std::filesystem::path& folder) {
  Section section{"shadings", "Ways of colouring",
                  "",         "The same visible surfaces, seen through each shading and debug view.",
                  "",         "",
                  {}};
  const auto add = [&](const std::string& name, const RenderSettings& settings) {
    const std::string file = "shading_" + name + ".png";
    section.shots.push_back(shoot(renderer, subject, projection::perspective(), settings, folder, file));
    section.shots.back().caption = name;
  };
  RenderSettings settings;
  for (const NamedShading& named : shading_names) {
    settings.shading = named.shading;
    add(named.name, settings);
  }
  settings.shading = Shading::flat;
  settings.wireframe = true;
  add("wireframe", settings);
  return section;
}

}  // namespace velum_gallery
