#include "core/threads.hpp"

#include <immintrin.h>

#include <algorithm>
#include <cstdint>

namespace arenite {

/// Members watch `round`; the caller watches `busy`. Each on a cache line of its own.
struct Team::Shared {
  alignas(64) std::atomic<std::uint32_t> round{0};
  alignas(64) std::atomic<int> busy{0};
  alignas(64) Call call = nullptr;
  void* what = nullptr;
  std::size_t count = 0;
  int size = 1;
  bool over = false;

  void work(int member) const {
    const auto cut = [&](int at) {
      return at == size ? count : count * static_cast<std::size_t>(at) / static_cast<std::size_t>(size) / 8 * 8;
    };
    call(what, cut(member), cut(member + 1));
  }
};

namespace {

/// Waits in a loop for about 0.05 ms, longer than members ever wait for each other within a step, then goes to sleep:
/// whoever is late by more has lost its processor, and may need this one.
template <class T>
void wait_while(const std::atomic<T>& value, T old) {
  for (int turn = 0; turn < 2000; ++turn) {
    if (value.load(std::memory_order_acquire) != old) return;
    _mm_pause();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Team::Team(int size) : shared_(std::make_unique<Shared>()) {
  shared_->size = std::max(size, 1);
  for (int member = 1; member < shared_->size; ++member)
    members_.emplace_back([shared = shared_.get(), member] { serve(*shared, member); });
}

Team::~Team() {
  shared_->over = true;
  shared_->round.fetch_add(1, std::memory_order_release);
  shared_->round.notify_all();
  for (auto& member : members_) member.join();
}

void Team::serve(Shared& shared, int member) {
  for (std::uint32_t seen = 0;; ++seen) {
    wait_while(shared.round, seen);
    if (shared.over) return;
    shared.work(member);
    if (shared.busy.fetch_sub(1, std::memory_order_acq_rel) == 1) shared.busy.notify_one();
  }
}

void Team::run(Call call, void* what, std::size_t n) const {
  shared_->call = call;
  shared_->what = what;
  shared_->count = n;
  shared_->busy.store(static_cast<int>(members_.size()), std::memory_order_relaxed);
  shared_->round.fetch_add(1, std::memory_order_release);
  shared_->round.notify_all();
  shared_->work(0);
  for (int left; (left = shared_->busy.load(std::memory_order_acquire)) != 0;) wait_while(shared_->busy, left);
}

}  // namespace arenite
