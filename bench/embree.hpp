#pragma once

#include <cstdint>
#include <memory>
#include <vector>
#include <velum/velum.hpp>

#include "ray_loads.hpp"

namespace velum_bench {

/// Whether this program was built with Embree.
bool has_embree();

/// A ray as Embree takes it.
struct FloatRay {
  float origin[3], lower;
  float direction[3], upper;
};
std::vector<FloatRay> float_rays(const std::vector<velum::ViewRay>& rays);

/// Embree's structure over one mesh: the peer that is measured beside velum's ray casting. One thread.
class EmbreeScene {
 public:
  /// Builds it. @param mesh  outlives it. @param robust  RTC_SCENE_FLAG_ROBUST: no ray slips through edges
  /// @throws std::runtime_error if Embree fails, or is not built in
  EmbreeScene(const velum::Mesh& mesh, bool robust);
  ~EmbreeScene();
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// Throws the structure away and builds it again.
  void build();
  /// Bytes of the structure.
  std::int64_t memory() const;

  // Per ray the triangle that is hit first, or no_triangle. @param ids  of as many elements as there are rays
  void first_hits(const std::vector<FloatRay>& rays, std::vector<std::uint32_t>& ids) const;
  /// Eight coherent rays at once. @pre rays.size() % 8 == 0
  void first_hits_by_eight(const std::vector<FloatRay>& rays, std::vector<std::uint32_t>& ids) const;
  /// 0: there is any hit; otherwise no_triangle.
  void any_hits(const std::vector<FloatRay>& rays, std::vector<std::uint32_t>& ids) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace velum_bench
