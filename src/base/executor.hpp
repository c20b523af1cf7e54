#pragma once

#include <cstddef>
#include <memory>

namespace velum {

/// Who runs the threads. All give the same results; they differ in speed and in what they need.
enum class ExecutorKind {
  tbb,         ///< oneTBB's workers; where velum was built without it, std_thread
  std_thread,  ///< threads of its own: for ThreadSanitizer, which Debian's oneTBB misleads
  serial,      ///< the calling thread alone
};

/// Calls a function for every index of a range, on several threads at once. The only place that knows the
/// thread library. Which thread takes which index is left to chance; so is the order.
class Executor {
 public:
  /// @param threads  how many, the calling one included; 0: as many as the machine runs at once
  /// @throws Error (limit) if the system does not give that many
  explicit Executor(int threads = 1, ExecutorKind kind = ExecutorKind::tbb);
  ~Executor();
  Executor(Executor&&) noexcept;
  Executor& operator=(Executor&&) noexcept;

  /// How many calls may run at once, ≥ 1.
  int threads() const;

  /// Calls function(index, worker) for index 0 … count-1 and returns when all are done. Calls that run at the
  /// same time have different workers, 0 … threads()-1: index scratch memory by it. Every call runs under a
  /// FloatingPointScope. Allocates nothing except inside oneTBB.
  /// @pre one thread at a time, and not from within a call
  /// @throws what a call threw first; indices not yet begun are then left out
  template <typename Function>
  void for_each(std::size_t count, const Function& function) {
    run(count, &function, [](const void* f, std::size_t index, int worker) {
      (*static_cast<const Function*>(f))(index, worker);
    });
  }

 private:
  struct Pool;
  using Call = void (*)(const void* function, std::size_t index, int worker);
  void run(std::size_t count, const void* function, Call call);

  std::unique_ptr<Pool> pool_;
};

}  // namespace velum
