#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace velum {

/// Cuts polygons in space into triangles. Keeps its buffers between polygons.
class Triangulator {
 public:
  /// A concave polygon may have so many corners; the time is at worst corners · reflex corners. Convex ones
  /// may have any number.
  static constexpr std::size_t most_concave_corners = 8192;

  /// Appends n - 2 triangles for n ≥ 3 corners, none for fewer: corner numbers 0 … n-1, turning as the
  /// polygon does. For a planar polygon that does not cross itself they cover it exactly, concave or not,
  /// also where corners lie on one line or a hole is joined to the outline by a double edge. For any other
  /// (crossing itself, without area, with coordinates that are not finite) they are some n - 2 triangles of
  /// its corners.
  /// @return false, with nothing appended, for a concave polygon with more than most_concave_corners
  bool triangulate(std::span<const glm::vec3> corners, std::vector<glm::uvec3>& triangles);

 private:
  struct Link {
    std::uint32_t previous;
    std::uint32_t next;
  };

  int turn(std::size_t corner) const;
  bool is_convex() const;
  void project(std::span<const glm::vec3> corners, int axis, bool mirrored);
  void start_ears();
  void clip_ears(std::vector<glm::uvec3>& triangles);
  bool is_ear(std::uint32_t corner) const;
  bool is_blocked(std::uint32_t corner) const;
  void clip(std::uint32_t corner, std::vector<glm::uvec3>& triangles);
  void update_reflex(std::uint32_t corner);
  std::uint32_t next_candidate();
  std::uint32_t least_bad() const;
  void push(std::uint32_t corner);
  void push_all();

  std::vector<glm::vec2> points_;          // the polygon in its dominant plane, counter-clockwise
  std::vector<Link> links_;                // ring of the corners that are left
  std::vector<std::uint32_t> reflex_;      // corners left that are not strictly convex
  std::vector<std::uint32_t> reflex_at_;   // place of a corner in reflex_, or none
  std::vector<std::uint32_t> candidates_;  // corners to test, in order; circular
  std::vector<bool> is_candidate_;
  std::size_t first_candidate_ = 0;
  std::uint32_t some_corner_ = 0;  // any corner that is left
  std::size_t left_ = 0;
};

}  // namespace velum
