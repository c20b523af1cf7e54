#pragma once

#include <string>
#include <vector>
#include <velum/velum.hpp>

/// The one table of scenes behind the golden pictures and the hash matrix. Between them they pass through
/// every stage: readers, every projection, clipping, ties, all shadings, transparency.
namespace golden {

/// How the camera is placed with respect to what it looks at.
enum class Placement {
  around,       ///< the whole is seen
  cut,          ///< the near plane cuts through the middle, the far plane takes the last tenth
  from_inside,  ///< the camera stands in the middle of the box and looks the projection's way
  to_horizon    ///< the camera stands 1.5 above the box's front edge and looks over it, a little down
};

struct GoldenScene {
  std::string name;
  velum::Scene scene;
  std::vector<glm::dvec3> framed;  ///< what the camera is framed on; most often the scene's points
  velum::RenderSettings settings;
  Placement placement = Placement::around;
  std::vector<std::string> projections;  ///< names of the catalogue
};

std::vector<GoldenScene> golden_scenes();

/// A way of finding what is seen; all of them must give the same bytes.
struct Mode {
  std::string name;
  velum::VisibilityMethod method;
  velum::Isa isa = velum::Isa::best;
  int threads = 0;
};
const std::vector<Mode>& golden_modes();
/// The z-buffer with every instruction set that this machine has, the plain one among them, on 1, 2 and 7
/// threads.
std::vector<Mode> machine_modes();

/// One picture of the table.
struct GoldenPicture {
  const GoldenScene* scene;
  std::string projection;

  std::string name() const { return scene->name + "/" + projection; }
  /// Whether a PNG is committed beside the hashes: one per projection and one per scene.
  bool has_file() const;
  velum::Camera camera() const;
  velum::Picture render(const Mode& mode) const;
};

/// @param scenes must outlive the result
std::vector<GoldenPicture> golden_pictures(const std::vector<GoldenScene>& scenes);

}  // namespace golden
