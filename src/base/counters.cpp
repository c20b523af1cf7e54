#include "counters.hpp"

#include <algorithm>

namespace velum {

HierarchyCounters& HierarchyCounters::operator+=(const HierarchyCounters& other) {
  batches += other.batches;
  nodes_visited += other.nodes_visited;
  nodes_outside += other.nodes_outside;
  nodes_hidden += other.nodes_hidden;
  clusters_away += other.clusters_away;
  clusters_drawn += other.clusters_drawn;
  clusters_remembered += other.clusters_remembered;
  triangles_left_out += other.triangles_left_out;
  polygons_tested += other.polygons_tested;
  polygons_hidden += other.polygons_hidden;
  for (int i = 0; i < most_pyramid_levels; ++i) nodes_hidden_at[i] += other.nodes_hidden_at[i];
  for (int i = 0; i < most_pyramid_levels; ++i) polygons_hidden_at[i] += other.polygons_hidden_at[i];
  octree_bytes = std::max(octree_bytes, other.octree_bytes);
  return *this;
}

Counters& Counters::operator+=(const Counters& other) {
  instances += other.instances;
  instances_beside += other.instances_beside;
  vertices += other.vertices;
  triangles += other.triangles;
  segments += other.segments;
  segments_clipped += other.segments_clipped;
  segments_outside += other.segments_outside;
  points += other.points;
  points_outside += other.points_outside;
  not_finite += other.not_finite;
  back_facing += other.back_facing;
  edge_on += other.edge_on;
  culled += other.culled;
  trivially_accepted += other.trivially_accepted;
  trivially_rejected += other.trivially_rejected;
  clipped += other.clipped;
  clipped_away += other.clipped_away;
  at_eye += other.at_eye;
  for (int i = 0; i < 6; ++i) outside[i] += other.outside[i];
  for (int i = 0; i < 6; ++i) cut_by[i] += other.cut_by[i];
  screen_triangles += other.screen_triangles;
  zero_area += other.zero_area;
  reversed += other.reversed;
  hidden_triangles += other.hidden_triangles;
  hidden_blocks += other.hidden_blocks;
  drawn_blocks += other.drawn_blocks;
  pixels_tested += other.pixels_tested;
  spans += other.spans;
  fragments += other.fragments;
  fragments_written += other.fragments_written;
  rays += other.rays;
  ray_nodes += other.ray_nodes;
  ray_boxes += other.ray_boxes;
  ray_tests += other.ray_tests;
  hierarchy += other.hierarchy;
  pixels_shaded += other.pixels_shaded;
  layers = layers > other.layers ? layers : other.layers;
  return *this;
}

Counters Counters::of_pixels() const {
  Counters pixels;
  pixels.hidden_triangles = hidden_triangles;
  pixels.hidden_blocks = hidden_blocks;
  pixels.drawn_blocks = drawn_blocks;
  pixels.pixels_tested = pixels_tested;
  pixels.spans = spans;
  pixels.fragments = fragments;
  pixels.fragments_written = fragments_written;
  pixels.pixels_shaded = pixels_shaded;
  pixels.layers = layers;
  return pixels;
}

}  // namespace velum
