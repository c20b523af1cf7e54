#include "base/executor.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cfloat>
#include <stdexcept>
#include <vector>

#include "base/floating_point.hpp"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

using namespace velum;

namespace {

constexpr ExecutorKind kinds[] = {ExecutorKind::tbb, ExecutorKind::std_thread, ExecutorKind::serial};

}  // namespace

TEST_CASE("An executor calls every index once, whatever the number of threads") {
  for (const ExecutorKind kind : kinds) {
    for (const int threads : {1, 2, 7, 16}) {
      Executor executor(threads, kind);
      CHECK(executor.threads() == (kind == ExecutorKind::serial ? 1 : threads));
      for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{3}, std::size_t{1000}}) {
        std::vector<std::atomic<int>> calls(count);
        executor.for_each(count, [&](std::size_t i, int) { ++calls[i]; });
        for (const std::atomic<int>& n : calls) CHECK(n == 1);
      }
    }
  }
}

TEST_CASE("Calls that run at the same time have different workers") {
  for (const ExecutorKind kind : kinds) {
    Executor executor(4, kind);
    std::vector<std::atomic<int>> inside(4);
    std::atomic<int> collisions = 0;
    executor.for_each(500, [&](std::size_t, int worker) {
      REQUIRE(worker >= 0);
      REQUIRE(worker < executor.threads());
      if (++inside[static_cast<std::size_t>(worker)] != 1) ++collisions;
      --inside[static_cast<std::size_t>(worker)];
    });
    CHECK(collisions == 0);
  }
}

TEST_CASE("An executor throws what a call threw, and works on") {
  for (const ExecutorKind kind : kinds) {
    Executor executor(3, kind);
    const auto fail = [](std::size_t i, int) {
      if (i == 5) throw std::runtime_error("five");
    };
    CHECK_THROWS_WITH_AS(executor.for_each(100, fail), "five", std::runtime_error);
    std::atomic<int> calls = 0;
    executor.for_each(10, [&](std::size_t, int) { ++calls; });
    CHECK(calls == 10);
  }
}

#ifdef __SSE2__
TEST_CASE("Every call runs under a FloatingPointScope") {
  const unsigned saved = _mm_getcsr();
  for (const ExecutorKind kind : kinds) {
    _mm_setcsr(saved | 0x8040u | 0x6000u);  // flush to zero, round towards zero
    std::atomic<int> wrong = 0;
    Executor(3, kind).for_each(200, [&](std::size_t, int) { wrong += (_mm_getcsr() & 0xe040u) != 0; });
    const bool restored = (_mm_getcsr() & 0xe040u) == (0x8040u | 0x6000u);
    _mm_setcsr(saved);
    CHECK(wrong == 0);
    CHECK(restored);
  }
}
#endif
