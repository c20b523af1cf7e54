#include "llvmpipe.hpp"

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <cstdlib>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>
#include <string>

namespace velum_bench {
namespace {

/// velum's clip matrix for OpenGL's depth range: z from 0 … w to -w … w.
glm::dmat4 for_opengl(const glm::dmat4& clip_from_object) {
  glm::dmat4 range(1.0);
  range[2].z = 2.0;
  range[3].z = -1.0;
  return range * clip_from_object;
}

template <typename Function>
Function opengl(const char* name) {
  const auto address = OSMesaGetProcAddress(name);
  if (address == nullptr) throw std::runtime_error(std::string("OSMesa has no ") + name);
  return reinterpret_cast<Function>(address);
}

struct Draw {
  std::uint32_t mesh;
  glm::dmat4 clip_from_object;
};

struct Buffers {
  GLuint vertices = 0;
  GLuint indices = 0;
  GLsizei count = 0;
};

}  // namespace

struct Llvmpipe::State {
  OSMesaContext context = nullptr;
  int width = 0, height = 0;
  bool has_colour = true;
  std::vector<std::uint8_t> pixels;
  std::vector<Buffers> meshes;
  std::vector<Draw> draws;
  PFNGLBINDBUFFERPROC bind_buffer = nullptr;

  void upload(const velum::Mesh& mesh) {
    const auto gen_buffers = opengl<PFNGLGENBUFFERSPROC>("glGenBuffers");
    const auto buffer_data = opengl<PFNGLBUFFERDATAPROC>("glBufferData");
    Buffers buffers;
    gen_buffers(1, &buffers.vertices);
    gen_buffers(1, &buffers.indices);
    bind_buffer(GL_ARRAY_BUFFER, buffers.vertices);
    buffer_data(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.positions.size() * sizeof(glm::vec3)),
                mesh.positions.data(), GL_STATIC_DRAW);
    bind_buffer(GL_ELEMENT_ARRAY_BUFFER, buffers.indices);
    buffer_data(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.triangles.size() * sizeof(glm::uvec3)),
                mesh.triangles.data(), GL_STATIC_DRAW);
    buffers.count = static_cast<GLsizei>(mesh.triangles.size() * 3);
    meshes.push_back(buffers);
  }
};

bool has_llvmpipe() {
  return true;
}

void set_llvmpipe_threads(int threads) {
  // Mesa counts the workers beside the calling thread.
  setenv("LP_NUM_THREADS", std::to_string(threads - 1).c_str(), 1);
}

Llvmpipe::Llvmpipe(const BenchScene& bench, bool has_colour) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.has_colour = has_colour;
  s.width = bench.width;
  s.height = bench.height;
  s.pixels.resize(4u * static_cast<std::size_t>(s.width) * static_cast<std::size_t>(s.height));
  s.context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (s.context == nullptr ||
      !OSMesaMakeCurrent(s.context, s.pixels.data(), GL_UNSIGNED_BYTE, s.width, s.height)) {
    throw std::runtime_error("OSMesa gives no context");
  }
  OSMesaPixelStore(OSMESA_Y_UP, 0);
  s.bind_buffer = opengl<PFNGLBINDBUFFERPROC>("glBindBuffer");
  for (const velum::Mesh& mesh : bench.scene.meshes()) s.upload(mesh);
  const velum::ViewingTransform viewing = bench.camera.viewing_transform(bench.aspect());
  for (const velum::Instance& instance : bench.scene.instances()) {
    s.draws.push_back({instance.mesh, for_opengl(viewing.clip_from_object(instance.world_from_object))});
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnableClientState(GL_VERTEX_ARRAY);
  const GLboolean mask = has_colour ? GL_TRUE : GL_FALSE;
  glColorMask(mask, mask, mask, mask);
  glMatrixMode(GL_PROJECTION);
  glViewport(0, 0, s.width, s.height);
}

Llvmpipe::~Llvmpipe() {
  if (state_->context != nullptr) OSMesaDestroyContext(state_->context);
}

void Llvmpipe::draw() {
  State& s = *state_;
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glColor4f(1.0f, 0.8f, 0.6f, 1.0f);
  std::uint32_t bound = ~0u;
  for (const Draw& draw : s.draws) {
    const Buffers& mesh = s.meshes[draw.mesh];
    glLoadMatrixd(glm::value_ptr(draw.clip_from_object));
    if (draw.mesh != bound) {
      s.bind_buffer(GL_ARRAY_BUFFER, mesh.vertices);
      glVertexPointer(3, GL_FLOAT, 0, nullptr);
      s.bind_buffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
      bound = draw.mesh;
    }
    glDrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
  }
  glFinish();
}

std::vector<std::uint8_t> Llvmpipe::coverage() const {
  const State& s = *state_;
  std::vector<std::uint8_t> covered(s.pixels.size() / 4);
  if (s.has_colour) {
    for (std::size_t i = 0; i < covered.size(); ++i) covered[i] = s.pixels[4 * i + 3] != 0;
    return covered;
  }
  const auto width = static_cast<std::size_t>(s.width);
  std::vector<float> row(width);
  for (int y = 0; y < s.height; ++y) {
    glReadPixels(0, s.height - 1 - y, s.width, 1, GL_DEPTH_COMPONENT, GL_FLOAT, row.data());
    for (std::size_t x = 0; x < width; ++x) covered[static_cast<std::size_t>(y) * width + x] = row[x] < 1.0f;
  }
  return covered;
}

}  // namespace velum_bench
