#include "embree.hpp"

#include <embree3/rtcore.h>

#include <limits>
#include <stdexcept>

namespace velum_bench {
namespace {

RTCDevice new_device() {
  const RTCDevice device = rtcNewDevice("threads=1");
  if (device == nullptr) throw std::runtime_error("Embree gives no device");
  return device;
}

RTCRay ray_of(const FloatRay& in) {
  RTCRay ray{};
  ray.org_x = in.origin[0];
  ray.org_y = in.origin[1];
  ray.org_z = in.origin[2];
  ray.tnear = in.lower;
  ray.dir_x = in.direction[0];
  ray.dir_y = in.direction[1];
  ray.dir_z = in.direction[2];
  ray.tfar = in.upper;
  ray.mask = ~0u;
  return ray;
}

void set(RTCRay8& rays, int i, const FloatRay& in) {
  rays.org_x[i] = in.origin[0];
  rays.org_y[i] = in.origin[1];
  rays.org_z[i] = in.origin[2];
  rays.tnear[i] = in.lower;
  rays.dir_x[i] = in.direction[0];
  rays.dir_y[i] = in.direction[1];
  rays.dir_z[i] = in.direction[2];
  rays.tfar[i] = in.upper;
  rays.time[i] = 0.0f;
  rays.mask[i] = ~0u;
  rays.id[i] = 0;
  rays.flags[i] = 0;
}

}  // namespace

struct EmbreeScene::State {
  const velum::Mesh& mesh;
  bool robust;
  std::vector<float> vertices;  ///< Embree reads 4 bytes beyond the last one
  RTCDevice device = new_device();
  RTCScene scene = nullptr;
  std::int64_t bytes = 0;

  State(const velum::Mesh& mesh_in, bool robust_in) : mesh(mesh_in), robust(robust_in) {
    for (const glm::vec3& p : mesh.positions) vertices.insert(vertices.end(), {p.x, p.y, p.z});
    vertices.push_back(0.0f);
    rtcSetDeviceMemoryMonitorFunction(
        device,
        [](void* self, ssize_t change, bool) {
          static_cast<State*>(self)->bytes += change;
          return true;
        },
        this);
  }
  ~State() {
    if (scene != nullptr) rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

bool has_embree() {
  return true;
}

std::vector<FloatRay> float_rays(const std::vector<velum::ViewRay>& rays) {
  std::vector<FloatRay> result;
  result.reserve(rays.size());
  for (const velum::ViewRay& ray : rays) {
    const glm::vec3 o(ray.ray.origin), d(ray.ray.direction);
    result.push_back({{o.x, o.y, o.z},
                      static_cast<float>(ray.range.lower),
                      {d.x, d.y, d.z},
                      static_cast<float>(ray.range.upper)});
  }
  return result;
}

EmbreeScene::EmbreeScene(const velum::Mesh& mesh, bool robust)
    : state_(std::make_unique<State>(mesh, robust)) {
  build();
}

EmbreeScene::~EmbreeScene() = default;

void EmbreeScene::build() {
  State& s = *state_;
  if (s.scene != nullptr) rtcReleaseScene(s.scene);
  s.scene = rtcNewScene(s.device);
  rtcSetSceneFlags(s.scene, s.robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  const RTCGeometry geometry = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, s.vertices.data(), 0,
                             sizeof(glm::vec3), s.mesh.positions.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, s.mesh.triangles.data(), 0,
                             sizeof(glm::uvec3), s.mesh.triangles.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(s.scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(s.scene);
  if (rtcGetDeviceError(s.device) != RTC_ERROR_NONE) throw std::runtime_error("Embree cannot build");
}

std::int64_t EmbreeScene::memory() const {
  return state_->bytes;
}

void EmbreeScene::first_hits(const std::vector<FloatRay>& rays, std::vector<std::uint32_t>& ids) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RTCRayHit hit{};
    hit.ray = ray_of(rays[i]);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(state_->scene, &context, &hit);
    ids[i] = hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? velum::no_triangle : hit.hit.primID;
  }
}

void EmbreeScene::first_hits_by_eight(const std::vector<FloatRay>& rays,
                                      std::vector<std::uint32_t>& ids) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(32) const int valid[8] = {-1, -1, -1, -1, -1, -1, -1, -1};
  alignas(32) RTCRayHit8 hits{};
  for (std::size_t first = 0; first < rays.size(); first += 8) {
    for (int i = 0; i < 8; ++i) {
      set(hits.ray, i, rays[first + static_cast<std::size_t>(i)]);
      hits.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect8(valid, state_->scene, &context, &hits);
    for (std::size_t i = 0; i < 8; ++i)
      ids[first + i] =
          hits.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? velum::no_triangle : hits.hit.primID[i];
  }
}

void EmbreeScene::any_hits(const std::vector<FloatRay>& rays, std::vector<std::uint32_t>& ids) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RTCRay ray = ray_of(rays[i]);
    rtcOccluded1(state_->scene, &context, &ray);
    ids[i] = ray.tfar < 0.0f ? 0u : velum::no_triangle;
  }
}

}  // namespace velum_bench
