#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

namespace arenite {

/// The seam for threads: a pool that does one thing after another on all its members at once. Steps of a simulation
/// last some tens of microseconds, so members wait for the next thing in a loop, and only sleep when none comes for
/// much longer than that. On a busy machine a member may lose its processor at any moment: whoever is there does what
/// it has not begun, and while members cost more time than they save, the caller works alone.
class ThreadPool {
 public:
  explicit ThreadPool(int size = 1);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int size() const { return static_cast<int>(members_.size()) + 1; }

  /// Calls work(begin, end) for ranges that make up 0 .. n-1, each once, and returns when all are done. Ranges begin at
  /// multiples of eight; how many there are and who does which changes from call to call, so nothing that is kept may
  /// depend on it. `work` must not throw.
  template <class Work> void for_ranges(std::size_t n, Work&& work) const {
    if (members_.empty()) return work(std::size_t{0}, n);
    run([](void* what, std::size_t begin,
           std::size_t end) { (*static_cast<std::remove_reference_t<Work>*>(what))(begin, end); },
        &work, n);
  }

  /// Calls see(k, result) for k = 0 .. n-1 and returns the results, one of each block of so many, which do not depend
  /// on who makes them.
  template <class Result, class See>
  std::vector<Result> by_blocks(std::size_t n, std::size_t size, const See& see) const {
    std::vector<Result> results((n + size - 1) / size);
    for_ranges(results.size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t block = begin; block < end; ++block)
        for (std::size_t k = block * size; k < std::min(n, (block + 1) * size); ++k) see(k, results[block]);
    });
    return results;
  }

  /// Calls work(k) for k = 0 .. n-1, each once, by whichever member: for things that take long.
  template <class Work> void for_each(std::size_t n, const Work& work) const {
    for_ranges(8 * n, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin / 8; k < end / 8; ++k) work(k);
    });
  }

 private:
  using Call = void (*)(void*, std::size_t, std::size_t);
  struct Shared;

  void run(Call call, void* what, std::size_t n) const;
  static void serve(Shared& shared, std::size_t member);

  std::unique_ptr<Shared> shared_;
  std::vector<std::thread> members_;
};

}  // namespace arenite
