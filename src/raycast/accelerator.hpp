#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "../base/isa.hpp"
#include "accelerator_kind.hpp"
#include "camera_rays.hpp"
#include "search.hpp"

namespace velum {

/// Triangles of a mesh, arranged so that rays find them. Built once; then any number of threads may ask.
///
/// Triangles with a vertex that is not finite are hit by nothing. Of hits at the same t the lower triangle is
/// first. Each triangle is hit by intersect_watertight(), which is told the bounds of the mesh.
class Accelerator {
 public:
  virtual ~Accelerator() = default;

  /// @param range  the t that are wanted; both ends included
  RayHit first_hit(const Ray& ray, const Interval& range, CastCounters& counters,
                   const HitFilter& filter = {}) const;
  /// The first hit of each ray. Eight in a row are cast together where the structure can do that: best for
  /// rays that start near each other and go the same way. @pre as many hits as rays
  void first_hits(std::span<const ViewRay> rays, std::span<RayHit> hits, CastCounters& counters,
                  const HitFilter& filter = {}) const;
  /// Whether there is any hit in the range. For p and q: Ray{p, q - p}, 0 … 1.
  bool is_blocked(const Ray& ray, const Interval& range, CastCounters& counters,
                  const HitFilter& filter = {}) const;
  /// All hits in order of (t, triangle). @param out  overwritten
  void all_hits(const Ray& ray, const Interval& range, CastCounters& counters, std::vector<RayHit>& out,
                const HitFilter& filter = {}) const;

  const TriangleSet& triangles() const { return triangles_; }
  /// Around all triangles that can be hit; empty for none.
  const Aabb& bounds() const { return bounds_; }
  /// Bytes of the structure, without the caller's vertices and indices.
  virtual std::size_t memory() const = 0;

 protected:
  explicit Accelerator(const TriangleSet& triangles);
  /// The boxes of the triangles that can be hit, by ascending id.
  std::vector<BoxedItem> boxed_triangles() const;
  /// Hands the search what its ray may hit. @pre the ray is usable and meets the bounds
  virtual void traverse(Search& search) const = 0;
  /// Casts a ray by a way of its own, with counting, but for rays and hits.
  /// @param hit  what Aim::first and Aim::any find; otherwise unchanged
  /// @param all  where Aim::all puts what it finds, in any order
  /// @return false: the ray has to be traversed; nothing was done
  virtual bool cast_alone(const Ray& ray, const Interval& range, Search::Aim aim, const HitFilter& filter,
                          CastCounters& counters, RayHit& hit, std::vector<RayHit>* all) const;
  /// Casts up to eight rays at once, with the hits of first_hit(). @return false: they have to be cast one by
  /// one; nothing was done
  virtual bool first_hits_together(std::span<const ViewRay> rays, std::span<RayHit> hits,
                                   CastCounters& counters, const HitFilter& filter) const;

 private:
  RayHit cast(const Ray& ray, const Interval& range, Search::Aim aim, const HitFilter& filter,
              CastCounters& counters, std::vector<RayHit>* all = nullptr) const;

  TriangleSet triangles_;
  Aabb bounds_;
};

/// Builds a structure of a kind with its usual settings.
/// @param isa  which instructions cast rays, where the kind has vector kernels; the hits are the same
/// @pre the indices are in range, see validate(Mesh); the memory behind `triangles` stays as it is;
/// is_available(isa)
std::unique_ptr<Accelerator> build_accelerator(AcceleratorKind kind, const TriangleSet& triangles,
                                               Isa isa = Isa::best);

}  // namespace velum
