#include "explain_pixel.hpp"

#include <algorithm>
#include <span>

#include "../base/floating_point.hpp"
#include "check_request.hpp"
#include "line_stages.hpp"

namespace velum {
namespace {

/// Asks the raster itself whether a piece covers the pixel, and how deep it is there.
class PixelProbe {
 public:
  PixelProbe(int x, int y, const RenderSettings& settings)
      : settings_(settings), rect_{x, y, 1, 1}, buffer_(1, 1) {}

  std::optional<float> reversed_depth_of(const ScreenTriangle& piece) {
    buffer_.clear(1, 1);
    const RasterCounts counts =
        rasterize({&piece, 1}, {buffer_, rect_, nullptr, settings_.depth_format}, settings_, tables_);
    if (counts.fragments == 0) return std::nullopt;
    return buffer_.reversed_depth.at(0, 0);
  }

 private:
  const RenderSettings& settings_;
  ScanlineTables tables_;
  Rect rect_;
  VisibilityBuffer buffer_;
};

EdgeAtCentre edge_at(const SnappedVertex& from, const SnappedVertex& to, const PixelExplanation& pixel) {
  return {from, to, doubled_area({from, to, pixel.centre}),
          EdgeFunction::between(from, to, pixel.x, pixel.y).value};
}

CoveringFragment fragment_of(const ScreenTriangle& piece, float reversed_depth,
                             const PixelExplanation& pixel) {
  CoveringFragment fragment;
  fragment.primitive = piece.primitive;
  fragment.triangle = piece;
  std::array<SnappedVertex, 3>& v = fragment.triangle.vertices;
  fragment.is_turned = doubled_area(v) < 0;
  if (fragment.is_turned) std::swap(v[1], v[2]);
  fragment.edges = {edge_at(v[0], v[1], pixel), edge_at(v[1], v[2], pixel), edge_at(v[2], v[0], pixel)};
  fragment.reversed_depth = reversed_depth;
  return fragment;
}

/// Adds the fragments of one triangle's pieces.
void collect(std::span<const ScreenTriangle> pieces, const PrimitivePlace& place, PixelProbe& probe,
             PixelExplanation& pixel) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::optional<float> r = probe.reversed_depth_of(pieces[i]);
    if (!r) continue;
    CoveringFragment fragment = fragment_of(pieces[i], *r, pixel);
    fragment.place = place;
    fragment.piece = static_cast<int>(i);
    fragment.pieces = static_cast<int>(pieces.size());
    pixel.fragments.push_back(fragment);
  }
}

/// Adds the fragments of an instance's segments and points.
void collect_lines(const Scene& scene, std::uint32_t index, const ClipVertices& vertices,
                   const RenderSettings& settings, PixelProbe& probe, PixelExplanation& pixel) {
  const Mesh& mesh = scene.meshes()[scene.instances()[index].mesh];
  const Viewport viewport{settings.width, settings.height};
  std::vector<ScreenTriangle> pieces;
  for (std::uint32_t i = 0; i < mesh.segments.size(); ++i) {
    const PrimitivePlace place{index, i, PrimitiveKind::segment};
    pieces.clear();
    set_up_segment(vertices, mesh.segments[i], scene.primitive(place), settings.line_width, viewport,
                   pixel.counters, pieces);
    collect(pieces, place, probe, pixel);
  }
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    const PrimitivePlace place{index, i, PrimitiveKind::point};
    pieces.clear();
    set_up_point(vertices, mesh.points[i], scene.primitive(place), settings.point_size, viewport,
                 pixel.counters, pieces);
    collect(pieces, place, probe, pixel);
  }
}

void collect_instance(const Scene& scene, std::uint32_t index, const ViewingTransform& viewing,
                      const RenderSettings& settings, PixelExplanation& pixel) {
  const Instance& instance = scene.instances()[index];
  const Mesh& mesh = scene.meshes()[instance.mesh];
  ClipVertices vertices;
  transform_vertices(mesh.positions.span(), viewing.clip_from_object(instance.world_from_object), vertices);
  const bool mirrored = is_mirroring(instance.world_from_object);
  PixelProbe probe(pixel.x, pixel.y, settings);
  std::vector<ScreenTriangle> pieces;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const AssembledTriangle triangle = assemble(vertices, mesh.triangles[i], mirrored, settings.cull,
                                                clip_volume_of(settings), pixel.counters);
    if (triangle.fate != TriangleFate::accepted && triangle.fate != TriangleFate::to_clip) continue;
    pieces.clear();
    set_up(triangle, scene.first_primitive(index) + i, {settings.width, settings.height}, pixel.counters,
           pieces);
    collect(pieces, {index, i}, probe, pixel);
  }
  collect_lines(scene, index, vertices, settings, probe, pixel);
}

/// Puts the fragments in the order in which they are seen and says why each stands where it does.
void order_by_depth(std::vector<CoveringFragment>& fragments) {
  std::stable_sort(fragments.begin(), fragments.end(),
                   [](const CoveringFragment& a, const CoveringFragment& b) {
                     return is_nearer(a.reversed_depth, a.primitive, b.reversed_depth, b.primitive);
                   });
  for (std::size_t i = 1; i < fragments.size(); ++i) {
    const CoveringFragment& seen = fragments[0];
    CoveringFragment& fragment = fragments[i];
    if (fragment.primitive == seen.primitive) {
      fragment.outcome = FragmentOutcome::same_triangle;
    } else if (fragment.reversed_depth == seen.reversed_depth) {
      fragment.outcome = FragmentOutcome::higher_id;
    } else {
      fragment.outcome = FragmentOutcome::farther;
    }
  }
}

}  // namespace

PixelExplanation explain_pixel(const Scene& scene, const Camera& camera, const RenderSettings& settings,
                               int x, int y) {
  const FloatingPointScope floating_point;
  RenderSettings whole = settings;
  whole.crop.reset();
  check_pixel(requested_rect(whole), x, y);
  check_method(settings);
  check_widths(settings);
  const ViewingTransform viewing = requested_view(camera, settings);
  PixelExplanation pixel;
  pixel.x = x;
  pixel.y = y;
  pixel.centre = {x * subpixels + subpixels / 2, y * subpixels + subpixels / 2};
  for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
    collect_instance(scene, i, viewing, settings, pixel);
  }
  order_by_depth(pixel.fragments);
  if (!pixel.fragments.empty() && pixel.fragments[0].place.kind == PrimitiveKind::triangle) {
    pixel.winner = trace_triangle(scene, camera, settings, pixel.fragments[0].primitive);
  }
  return pixel;
}

}  // namespace velum
