#include "triangulate.hpp"

#include <algorithm>

#include "orientation.hpp"

namespace velum {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;
// When no ear is found, all corners are tested once more, but only so often: degenerate polygons must end
// too.
constexpr int most_rounds = 8;

// M. E. Newell's normal (Sutherland, Sproull & Schumacker 1974): right for concave and slightly bent
// polygons. Relative to the first corner, so that polygons far from the origin keep their digits.
glm::dvec3 newell_normal(std::span<const glm::vec3> corners) {
  glm::dvec3 normal(0.0);
  const glm::dvec3 origin(corners[0]);
  glm::dvec3 a = glm::dvec3(corners.back()) - origin;
  for (const glm::vec3& corner : corners) {
    const glm::dvec3 b = glm::dvec3(corner) - origin;
    normal.x += (a.y - b.y) * (a.z + b.z);
    normal.y += (a.z - b.z) * (a.x + b.x);
    normal.z += (a.x - b.x) * (a.y + b.y);
    a = b;
  }
  return normal;
}

int dominant_axis(const glm::dvec3& v) {
  const double x = v.x < 0 ? -v.x : v.x, y = v.y < 0 ? -v.y : v.y, z = v.z < 0 ? -v.z : v.z;
  if (x >= y && x >= z) return 0;
  return y >= z ? 1 : 2;
}

bool is_usable(const glm::dvec3& normal) {
  const double size = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
  return size > 0.0 && size - size == 0.0;  // neither zero, nor NaN, nor infinite
}

void append_fan(std::size_t corner_count, std::uint32_t first, std::vector<glm::uvec3>& triangles) {
  const auto n = static_cast<std::uint32_t>(corner_count);
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    triangles.emplace_back(first, (first + i) % n, (first + i + 1) % n);
  }
}

}  // namespace

bool Triangulator::triangulate(std::span<const glm::vec3> corners, std::vector<glm::uvec3>& triangles) {
  const std::size_t n = corners.size();
  if (n < 3) return true;
  const glm::dvec3 normal = n == 3 ? glm::dvec3(0.0) : newell_normal(corners);
  if (!is_usable(normal)) {
    append_fan(n, 0, triangles);
    return true;
  }
  const int axis = dominant_axis(normal);
  project(corners, axis, normal[axis] < 0.0);
  if (is_convex()) {
    append_fan(n, 0, triangles);
    return true;
  }
  if (n > most_concave_corners) return false;
  clip_ears(triangles);
  return true;
}

std::string Triangulator::note_on_fans(const std::string& first) const {
  return std::to_string(fan_count_) + " concave polygons, the first " + first +
         ", are filled as fans and may look wrong: to cut them up rightly would take too long; triangulate " +
         "them in the program they come from";
}

// Drops the axis the normal leans to most: exact, and the area shrinks by a factor of √3 at most.
void Triangulator::project(std::span<const glm::vec3> corners, int axis, bool mirrored) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  points_.clear();
  for (const glm::vec3& corner : corners) {
    points_.push_back(mirrored ? glm::vec2(corner[v], corner[u]) : glm::vec2(corner[u], corner[v]));
  }
}

int Triangulator::turn(std::size_t corner) const {
  const std::size_t n = points_.size();
  return orientation(points_[corner == 0 ? n - 1 : corner - 1], points_[corner],
                     points_[corner + 1 == n ? 0 : corner + 1]);
}

// No right turn, and once around: x changes its direction twice.
bool Triangulator::is_convex() const {
  const std::size_t n = points_.size();
  int changes = 0, first = 0, last = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (turn(i) < 0) return false;
    const float step = points_[i + 1 == n ? 0 : i + 1].x - points_[i].x;
    const int direction = (step > 0.0f) - (step < 0.0f);
    if (direction == 0) continue;
    if (first == 0) first = direction;
    if (last != 0 && direction != last) ++changes;
    last = direction;
  }
  return changes + (first != last ? 1 : 0) <= 2;
}

// G. H. Meisters, "Polygons have ears", 1975; only reflex corners can block an ear (Eberly 1998), and
// clipping an ear changes the answer for its two neighbours only, so a queue of candidates makes it O(n ·
// reflex).
void Triangulator::clip_ears(std::vector<glm::uvec3>& triangles) {
  const std::size_t before = triangles.size();
  start_ears();
  int rounds = 1;
  while (left_ > 3) {
    if (steps_left_ == 0) {
      triangles.resize(before);
      append_fan(points_.size(), 0, triangles);
      ++fan_count_;
      return;
    }
    std::uint32_t corner = next_candidate();
    if (corner == none && rounds < most_rounds) {
      ++rounds;
      push_all();
      corner = next_candidate();
    }
    clip(corner != none ? corner : least_bad(), triangles);
  }
  const Link last = links_[some_corner_];
  triangles.emplace_back(last.previous, some_corner_, last.next);
}

void Triangulator::start_ears() {
  const auto n = static_cast<std::uint32_t>(points_.size());
  links_.resize(n);
  for (std::uint32_t i = 0; i < n; ++i) links_[i] = {i == 0 ? n - 1 : i - 1, i + 1 == n ? 0 : i + 1};
  some_corner_ = 0;
  left_ = n;
  reflex_.clear();
  reflex_at_.assign(n, none);
  for (std::uint32_t i = 0; i < n; ++i) update_reflex(i);
  candidates_.clear();
  first_candidate_ = 0;
  is_candidate_.assign(n, false);
  push_all();
}

void Triangulator::push(std::uint32_t corner) {
  if (is_candidate_[corner]) return;
  is_candidate_[corner] = true;
  candidates_.push_back(corner);
}

void Triangulator::push_all() {
  spend(left_);
  candidates_.clear();
  first_candidate_ = 0;
  std::uint32_t corner = some_corner_;
  do {
    push(corner);
    corner = links_[corner].next;
  } while (corner != some_corner_);
}

// The next corner that is an ear, or none when all candidates are used up.
std::uint32_t Triangulator::next_candidate() {
  while (first_candidate_ < candidates_.size()) {
    const std::uint32_t corner = candidates_[first_candidate_++];
    is_candidate_[corner] = false;
    const bool is_left = links_[corner].next != none;
    if (is_left && is_ear(corner)) return corner;
  }
  return none;
}

void Triangulator::update_reflex(std::uint32_t corner) {
  const Link link = links_[corner];
  const bool is_reflex = orientation(points_[link.previous], points_[corner], points_[link.next]) <= 0;
  const std::uint32_t place = reflex_at_[corner];
  if (is_reflex && place == none) {
    reflex_at_[corner] = static_cast<std::uint32_t>(reflex_.size());
    reflex_.push_back(corner);
  } else if (!is_reflex && place != none) {
    reflex_[place] = reflex_.back();
    reflex_at_[reflex_[place]] = place;
    reflex_.pop_back();
    reflex_at_[corner] = none;
  }
}

bool Triangulator::is_ear(std::uint32_t corner) {
  return reflex_at_[corner] == none && !is_blocked(corner);
}

// Whether a reflex corner lies in the closed triangle at the corner. One that coincides with a corner of the
// triangle (the ends of a double edge) does not block: its chain would have another corner inside.
bool Triangulator::is_blocked(std::uint32_t corner) {
  spend(reflex_.size());
  const glm::vec2 a = points_[links_[corner].previous], b = points_[corner], c = points_[links_[corner].next];
  const glm::vec2 lower(std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}));
  const glm::vec2 upper(std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}));
  for (const std::uint32_t other : reflex_) {
    const glm::vec2 p = points_[other];
    if (p.x < lower.x || p.x > upper.x || p.y < lower.y || p.y > upper.y) continue;
    if (p == a || p == b || p == c) continue;
    if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0) return true;
  }
  return false;
}

void Triangulator::clip(std::uint32_t corner, std::vector<glm::uvec3>& triangles) {
  const Link link = links_[corner];
  triangles.emplace_back(link.previous, corner, link.next);
  if (reflex_at_[corner] != none) {
    reflex_[reflex_at_[corner]] = reflex_.back();
    reflex_at_[reflex_.back()] = reflex_at_[corner];
    reflex_.pop_back();
    reflex_at_[corner] = none;
  }
  links_[link.previous].next = link.next;
  links_[link.next].previous = link.previous;
  links_[corner] = {none, none};
  some_corner_ = link.next;
  --left_;
  update_reflex(link.previous);
  update_reflex(link.next);
  push(link.previous);
  push(link.next);
}

// No ear is left: a corner on a line costs nothing; else (the polygon crosses itself) a convex one, or any.
std::uint32_t Triangulator::least_bad() {
  spend(left_);
  std::uint32_t convex = none;
  std::uint32_t corner = some_corner_;
  do {
    const Link link = links_[corner];
    const int side = orientation(points_[link.previous], points_[corner], points_[link.next]);
    if (side == 0) return corner;
    if (side > 0 && convex == none) convex = corner;
    corner = link.next;
  } while (corner != some_corner_);
  return convex != none ? convex : some_corner_;
}

}  // namespace velum
