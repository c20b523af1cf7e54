#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

namespace velum {

/// Cuts polygons in space into triangles. Keeps its buffers between polygons.
class Triangulator {
 public:
  /// @param steps  how many steps concave polygons may take in all: comparisons of a corner with a triangle,
  /// and visits of a corner
  explicit Triangulator(std::uint64_t steps = steps_for(0)) : steps_left_(steps) {}

  /// What the polygons of a file may take: some seconds' worth, and more for every byte. Polygons of the real
  /// world take about one step a byte; only crafted ones, or many with thousands of corners, come near this.
  static constexpr std::uint64_t steps_for(std::size_t file_bytes) {
    return (std::uint64_t{1} << 28) + 64 * std::uint64_t{file_bytes};
  }

  /// A concave polygon may have so many corners; the time is at worst corners · reflex corners. Convex ones
  /// may have any number.
  static constexpr std::size_t most_concave_corners = 8192;

  /// Appends n - 2 triangles for n ≥ 3 corners, none for fewer: corner numbers 0 … n-1, turning as the
  /// polygon does. For a planar polygon that does not cross itself they cover it exactly, concave or not,
  /// also where corners lie on one line or a hole is joined to the outline by a double edge. For any other
  /// (crossing itself, without area, with coordinates that are not finite) they are some n - 2 triangles of
  /// its corners; so it is for concave ones when the steps are used up.
  /// @return false, with nothing appended, for a concave polygon with more than most_concave_corners
  bool triangulate(std::span<const glm::vec3> corners, std::vector<glm::uvec3>& triangles);

  /// How many concave polygons were filled as a fan because the steps were used up.
  std::size_t fan_count() const { return fan_count_; }
  /// A sentence about them for Scene::notes. @param first  where the first of them is
  std::string note_on_fans(const std::string& first) const;

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
  bool is_ear(std::uint32_t corner);
  bool is_blocked(std::uint32_t corner);
  void clip(std::uint32_t corner, std::vector<glm::uvec3>& triangles);
  void update_reflex(std::uint32_t corner);
  std::uint32_t next_candidate();
  std::uint32_t least_bad();
  void spend(std::uint64_t steps) { steps_left_ -= steps < steps_left_ ? steps : steps_left_; }
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
  std::uint64_t steps_left_;
  std::size_t fan_count_ = 0;
};

}  // namespace velum
