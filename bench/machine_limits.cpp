#include "machine_limits.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>
#include <vector>

#include "bare_loops.hpp"

namespace velum_bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds duration{120};

/// Repeats a piece of work for a while on each of so many threads; sums their units per second.
/// @param make  called on each thread: gives the work, which gives the units it did
template <typename Make>
double units_per_second(int threads, const Make& make) {
  std::atomic<int> ready{0};
  std::vector<double> rates(static_cast<std::size_t>(threads));
  std::vector<std::thread> pool;
  for (double& rate : rates) {
    pool.emplace_back([&, make] {
      auto work = make();
      work();
      ++ready;
      while (ready < threads) std::this_thread::yield();
      const auto begin = Clock::now();
      double units = 0.0;
      while (Clock::now() - begin < duration) units += work();
      rate = units / std::chrono::duration<double>(Clock::now() - begin).count();
    });
  }
  double sum = 0.0;
  for (std::thread& thread : pool) thread.join();
  for (const double rate : rates) sum += rate;
  return sum;
}

/// The compiler must take memory as read here.
void is_read(const void* memory) {
  asm volatile("" : : "g"(memory) : "memory");
}

/// Bytes/s of memset over a buffer that the threads share out.
double memset_rate(std::size_t bytes, int threads) {
  return units_per_second(threads, [size = bytes / static_cast<std::size_t>(threads)] {
    return [size, memory = std::make_shared<std::vector<char>>(size), value = 0]() mutable {
      std::memset(memory->data(), ++value & 255, size);
      is_read(memory->data());
      return static_cast<double>(size);
    };
  });
}

/// Vertices/s of the bare loop.
template <typename T>
double vertex_rate(int threads) {
  return units_per_second(threads, [] {
    auto block = std::make_shared<VertexBlock<T>>();
    for (std::size_t i = 0; i < block->count; ++i) {
      block->x[i] = static_cast<T>(i % 7);
      block->y[i] = static_cast<T>(i % 11);
      block->z[i] = static_cast<T>(i % 13);
    }
    return [block] {
      static constexpr T matrix[16] = {2, 0, 0, 0, 0, 3, 0, 0, 0, 0, T(-1.1), 1, 0, 0, 1, 20};
      constexpr int repeats = 64;
      for (int i = 0; i < repeats; ++i) {
        transform_block(*block, matrix);
        is_read(block.get());
      }
      return static_cast<double>(block->count * repeats);
    };
  });
}

}  // namespace

MachineLimits measure_machine_limits() {
  constexpr std::size_t mega = 1'000'000;
  MachineLimits limits;
  limits.memset_cached = {memset_rate(8 * mega, 1), memset_rate(8 * mega, 2)};
  limits.memset_uncached = {memset_rate(64 * mega, 1), memset_rate(64 * mega, 2)};
  limits.vertices_float = {vertex_rate<float>(1), vertex_rate<float>(2)};
  limits.vertices_double = {vertex_rate<double>(1), vertex_rate<double>(2)};
  return limits;
}

double load_average() {
  double load = 0.0;
  return getloadavg(&load, 1) == 1 ? load : 0.0;
}

std::string machine_description() {
  std::string name = "unknown processor";
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    name = line.substr(line.find(':') + 2);
    break;
  }
  std::ostringstream text;
  text.precision(2);
  text << name << ", " << std::thread::hardware_concurrency() << " threads, load " << std::fixed
       << load_average();
  return text.str();
}

}  // namespace velum_bench
