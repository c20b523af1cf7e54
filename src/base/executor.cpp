#include "executor.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "contract.hpp"
#include "error.hpp"
#include "floating_point.hpp"

#ifdef VELUM_HAS_TBB
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace velum {
namespace {

/// One for_each: the indices still to be taken, and the first exception.
struct Job {
  std::size_t count = 0;
  const void* function = nullptr;
  void (*call)(const void*, std::size_t, int) = nullptr;
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr error;

  void work(int worker) {
    const FloatingPointScope floating_point;
    try {
      for (std::size_t i = next++; i < count; i = next++) call(function, i, worker);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
    }
  }
};

int machine_threads() {
  const unsigned threads = std::thread::hardware_concurrency();
  return threads == 0 ? 1 : static_cast<int>(threads);
}

/// Threads that wait for jobs.
class Workers {
 public:
  explicit Workers(int count) {
    try {
      for (int worker = 1; worker <= count; ++worker) {
        threads_.emplace_back([this, worker] { wait_for_jobs(worker); });
      }
    } catch (const std::system_error&) {
      end();
      throw Error(ErrorKind::limit,
                  "the system gives no more than " + std::to_string(threads_.size()) + " threads", "threads",
                  "ask for fewer");
    }
  }
  ~Workers() { end(); }

  void run(Job& job) {
    {
      const std::lock_guard lock(mutex_);
      job_ = &job;
      busy_ = threads_.size();
      ++generation_;
    }
    work_.notify_all();
    job.work(0);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
  }

 private:
  void end() {
    {
      const std::lock_guard lock(mutex_);
      is_over_ = true;
    }
    work_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }

  void wait_for_jobs(int worker) {
    std::size_t seen = 0;
    std::unique_lock lock(mutex_);
    for (;;) {
      work_.wait(lock, [&] { return is_over_ || generation_ != seen; });
      if (is_over_) return;
      seen = generation_;
      Job& job = *job_;
      lock.unlock();
      job.work(worker);
      lock.lock();
      if (--busy_ == 0) done_.notify_one();
    }
  }

  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable work_;
  std::condition_variable done_;
  Job* job_ = nullptr;
  std::size_t busy_ = 0;
  std::size_t generation_ = 0;
  bool is_over_ = false;
};

}  // namespace

struct Executor::Pool {
  int threads = 1;
  std::unique_ptr<Workers> workers;
#ifdef VELUM_HAS_TBB
  std::unique_ptr<oneapi::tbb::task_arena> arena;
#endif

  void run(Job& job) {
#ifdef VELUM_HAS_TBB
    if (arena) {
      arena->execute([&] {
        oneapi::tbb::parallel_for(
            0, threads, [&](int worker) { job.work(worker); }, oneapi::tbb::simple_partitioner());
      });
      return;
    }
#endif
    if (workers) {
      workers->run(job);
    } else {
      job.work(0);
    }
  }
};

Executor::Executor(int threads, ExecutorKind kind) : pool_(std::make_unique<Pool>()) {
  VELUM_REQUIRE(threads >= 0, {"threads", threads});
  pool_->threads = kind == ExecutorKind::serial ? 1 : (threads == 0 ? machine_threads() : threads);
  if (pool_->threads == 1) return;
#ifdef VELUM_HAS_TBB
  if (kind == ExecutorKind::tbb) {
    // More than oneTBB's own limit would make it print a warning; the workers then share its threads.
    pool_->arena = std::make_unique<oneapi::tbb::task_arena>(
        std::min(pool_->threads, oneapi::tbb::info::default_concurrency()));
    return;
  }
#endif
  pool_->workers = std::make_unique<Workers>(pool_->threads - 1);
}

Executor::~Executor() = default;
Executor::Executor(Executor&&) noexcept = default;
Executor& Executor::operator=(Executor&&) noexcept = default;

int Executor::threads() const {
  return pool_->threads;
}

void Executor::run(std::size_t count, const void* function, Call call) {
  Job job;
  job.count = count;
  job.function = function;
  job.call = call;
  if (count <= 1 || pool_->threads == 1) {
    job.work(0);
  } else {
    pool_->run(job);
  }
  if (job.error) std::rethrow_exception(job.error);
}

}  // namespace velum
