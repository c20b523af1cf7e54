#include "triangle_text.hpp"

#include <algorithm>

#include "matrix_text.hpp"
#include "text.hpp"
#include "trace_text.hpp"

namespace velum_app {
namespace {

using namespace velum;

/// One triangle's text in the making.
class Writer {
 public:
  Writer(const TriangleTrace& trace, const glm::dmat4& world_from_object, const ViewingTransform& viewing,
         const RenderSettings& settings)
      : trace_(trace), world_from_object_(world_from_object), viewing_(viewing), settings_(settings) {
    for (const Stage& stage : viewing.stages()) width_ = std::max(width_, text_width(image_name(stage)));
  }

  std::string text() {
    write_stages();
    for (int i = 0; i < 3; ++i) write_vertex(i);
    write_facing();
    write_fate();
    if (trace_.pieces.empty()) return text_;
    write_polygon();
    write_pieces();
    write_depth_plane();
    return text_;
  }

 private:
  void heading(const std::string& name) { text_ += "\n  " + name + "\n"; }
  void line(const std::string& name, const std::string& value) {
    text_ += "    " + padded_right(name, width_) + "  " + value + "\n";
  }

  /// The lecture's camera space is where the world stands once it is moved and turned.
  static std::string image_name(const Stage& stage) {
    return "after " + std::string(stage.name) + (stage.name == "M_rot^T" ? ", camera" : "");
  }

  void write_stages() {
    if (world_from_object_ != glm::dmat4(1.0)) {
      heading("The model matrix, from object to world space");
      text_ += long_matrix_text(world_from_object_);
    }
    heading("The stages from world to clip space, in the order of application");
    int number = 0;
    for (const Stage& stage : viewing_.stages()) {
      text_ += "    " + std::to_string(++number) + ". " + std::string(stage.name) + ": " +
               std::string(stage.meaning) + "\n" + long_matrix_text(stage.matrix);
    }
  }

  void write_vertex(int i) {
    const VertexTrace& vertex = trace_.vertices[static_cast<std::size_t>(i)];
    heading("Vertex " + std::to_string(i) + " (the mesh's vertex " + std::to_string(vertex.index) + ")");
    line("object", tuple_text(vertex.object));
    line("world", tuple_text(vertex.images[0]));
    for (std::size_t s = 0; s < viewing_.stages().size(); ++s)
      line(image_name(viewing_.stages()[s]), tuple_text(vertex.images[s + 1]));
    line("clip", tuple_text(vertex.clip) + "  by the product of all matrices");
    line("outcode", outcode_text(vertex.code));
    if (vertex.is_in_front()) {
      write_place(place_on_picture(vertex.clip, viewport(), trace_.assembled.volume));
    } else {
      line("canonical: / w", "none: w is not positive, the vertex is not in front of the eye");
    }
  }

  Viewport viewport() const { return {settings_.width, settings_.height}; }

  void write_place(const PlacedPoint& point) {
    const std::string w = " / " + operand_text(point.clip.w);
    line("canonical: / w", "x: " + long_text(point.clip.x) + w + " = " + long_text(point.ndc.x) +
                               "   y: " + long_text(point.clip.y) + w + " = " + long_text(point.ndc.y) +
                               "   z: " + long_text(point.clip.z) + w + " = " + long_text(point.ndc.z));
    line("pixel", "x' = " + std::to_string(settings_.width) + "/2 * (" + long_text(point.ndc.x) +
                      " + 1) = " + long_text(point.pixel.x) + "   y' = " + std::to_string(settings_.height) +
                      "/2 * (1 - " + operand_text(point.ndc.y) + ") = " + long_text(point.pixel.y));
    if (!point.is_snapped) return;
    line("snapped", "floor(256 x' + 1/2) = " + std::to_string(point.snapped.x) +
                        "   floor(256 y' + 1/2) = " + std::to_string(point.snapped.y));
  }

  void write_facing() {
    const double determinant = trace_.assembled.determinant;
    heading("Facing");
    line("determinant", "of the columns (x, y, w): " + long_text(determinant));
    const std::string turn = determinant > 0.0   ? "> 0: counter-clockwise in the picture"
                             : determinant < 0.0 ? "< 0: clockwise in the picture"
                                                 : "= 0: seen edge-on, counts as front";
    const std::string mirrored =
        trace_.mirrored ? "the instance is mirrored, which turns that: " : "the instance is not mirrored: ";
    line("",
         turn + "; " + mirrored + (trace_.assembled.facing == Facing::front ? "front" : "back") + " face");
  }

  void write_fate() {
    heading("Clipping");
    line("AND of the outcodes", bits_text(trace_.assembled.all_outside));
    line("OR of the outcodes", bits_text(trace_.assembled.some_outside));
    switch (trace_.assembled.fate) {
      case TriangleFate::not_finite:
        return line("", "skipped: a vertex is not a finite number");
      case TriangleFate::culled:
        return line("", "removed by the way it faces");
      case TriangleFate::rejected:
        return line("", "rejected: all vertices are outside of one plane (" +
                            plane_names(trace_.assembled.all_outside) + ")");
      case TriangleFate::accepted:
        return line("", trace_.assembled.some_outside == 0
                            ? "accepted: no vertex is outside of any plane"
                            : "accepted: in the guard band around the picture nothing needs to be cut");
      case TriangleFate::to_clip:
        break;
    }
    line("", trace_.pieces.empty() ? "cut, and nothing is left"
                                   : "cut by: " + plane_names(trace_.cut_by) + how_text());
  }

  /// The guard band's sides have the view volume's names.
  std::string how_text() const {
    constexpr unsigned near_and_far = 3;
    if (settings_.clip == ClipPolicy::exact || (trace_.cut_by & ~near_and_far) == 0) {
      return " (velum clip-trace shows how)";
    }
    return " of the guard band (velum clip-trace shows how the view volume itself would cut)";
  }

  /// The corners of a cut triangle; those of a whole one stand at its vertices.
  void write_polygon() {
    if (trace_.assembled.fate == TriangleFate::accepted) return;
    for (std::size_t i = 0; i < trace_.polygon.size(); ++i) {
      heading("Corner " + std::to_string(i) + " of what is left");
      line("clip", tuple_text(trace_.polygon[i].clip));
      write_place(trace_.polygon[i]);
    }
  }

  void write_pieces() {
    heading("Pieces (a fan; corners in 1/256 pixel)");
    for (std::size_t i = 0; i < trace_.pieces.size(); ++i) {
      const std::array<SnappedVertex, 3>& v = trace_.pieces[i].vertices;
      line("piece " + std::to_string(i), tuple_text(v[0]) + " " + tuple_text(v[1]) + " " + tuple_text(v[2]) +
                                             "  twice the area: " + std::to_string(doubled_area(v)) +
                                             (doubled_area(v) < 0 ? " (counter-clockwise, y down)" : ""));
    }
  }

  void write_depth_plane() {
    const DepthPlane& plane = trace_.pieces[0].depth;
    heading("Depth plane of the whole triangle (reversed depth r = 1 - z, float32)");
    line("reference pixel", "x_ref = " + std::to_string(plane.x_ref) + ", y_ref = " +
                                std::to_string(plane.y_ref) + ", r_ref = " + long_text(plane.r_ref));
    line("per pixel", "dx = " + long_text(plane.dx) + " to the right, dy = " + long_text(plane.dy) + " down");
    line("range", "from " + long_text(plane.lower) + " to " + long_text(plane.upper));
    for (std::size_t i = 0; i < 3; ++i) {
      if (trace_.vertices[i].is_in_front()) write_depth_at_vertex(i, plane);
    }
  }

  /// Pixel x has its centre at x + 1/2, so the plane's argument at x' is x' - 1/2.
  void write_depth_at_vertex(std::size_t i, const DepthPlane& plane) {
    const PlacedPoint point = place_on_picture(trace_.vertices[i].clip, viewport());
    const double x = point.pixel.x - 0.5 - plane.x_ref, y = point.pixel.y - 0.5 - plane.y_ref;
    const double r = double{plane.r_ref} + double{plane.dx} * x + double{plane.dy} * y;
    line("at vertex " + std::to_string(i),
         "x' - 1/2 - x_ref = " + long_text(x) + ", y' - 1/2 - y_ref = " + long_text(y) +
             ": r = " + long_text(r) + "   1 - z = " + long_text(1.0 - point.ndc.z));
  }

  const TriangleTrace& trace_;
  const glm::dmat4& world_from_object_;
  const ViewingTransform& viewing_;
  const RenderSettings& settings_;
  std::size_t width_ = 20;
  std::string text_;
};

}  // namespace

std::string triangle_text(const TriangleTrace& trace, const Scene& scene, const ViewingTransform& viewing,
                          const RenderSettings& settings) {
  return "The way of triangle " + std::to_string(trace.primitive) + " (" + place_text(scene, trace.place) +
         ")\n" +
         Writer(trace, scene.instances()[trace.place.instance].world_from_object, viewing, settings).text();
}

}  // namespace velum_app
