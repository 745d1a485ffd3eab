#include "core/threads.hpp"

#include <immintrin.h>

#include <atomic>
#include <chrono>
#include <cstdint>

namespace arenite {

namespace {

using Clock = std::chrono::steady_clock;

/// Parts of the work of one member: of so many, the last one to be finished is waited for.
constexpr std::size_t parts_of_a_member = 8, most_parts = 65535;

/// Parts of a round that are still to be begun, first .. last - 1, in one word: who changes it has taken a part, and
/// whoever still looks at a former round finds another word.
struct Open {
  std::uint32_t round;
  std::uint16_t first, last;

  std::uint64_t word() const { return std::uint64_t{round} << 32 | std::uint64_t{first} << 16 | last; }
  static Open of(std::uint64_t word) {
    return {static_cast<std::uint32_t>(word >> 32), static_cast<std::uint16_t>(word >> 16),
            static_cast<std::uint16_t>(word)};
  }
};

struct alignas(64) Share {
  std::atomic<std::uint64_t> open{0};
};

/// Waits in a loop for about 0.05 ms, longer than members ever wait for each other within a step, then goes to sleep:
/// whoever is late by more has lost its processor, and may need this one.
template <class T> void wait_while(const std::atomic<T>& value, T old) {
  for (int turn = 0; turn < 2000; ++turn) {
    if (value.load(std::memory_order_acquire) != old) return;
    _mm_pause();
  }
  value.wait(old, std::memory_order_acquire);
}

/// Whether the others pay. What waiting for them has cost beyond the time that they saved is a debt, and for a debt the
/// caller works alone for twenty times as long: on whatever machine, the pool loses a twentieth at most. What they
/// saved is not saved up, for it is told by a clock that also runs while the caller itself has lost its processor.
class Worth {
 public:
  bool alone(Clock::time_point now) const { return now < until_; }

  void book(Clock::duration waited, Clock::duration saved, Clock::time_point now) {
    debt_ = std::max(debt_ + waited - saved, Clock::duration::zero());
    if (debt_ < smallest_debt) return;
    until_ = now + 20 * debt_;
    debt_ = Clock::duration::zero();
  }

 private:
  static constexpr std::chrono::microseconds smallest_debt{200};
  Clock::duration debt_{0};
  Clock::time_point until_{};
};

}  // namespace

/// Members watch `round`; the caller watches `done`. Each on a cache line of its own. What a round is about is written
/// while none of its parts is open, and read by whoever then takes one.
struct ThreadPool::Shared {
  alignas(64) std::atomic<std::uint32_t> round{0};
  alignas(64) std::atomic<std::size_t> done{0};
  alignas(64) std::atomic<Call> call{nullptr};
  std::atomic<void*> what{nullptr};
  std::atomic<std::size_t> count{0}, parts{0};
  std::atomic<bool> over{false};
  std::vector<Share> share;
  Worth worth;  // the caller's

  explicit Shared(std::size_t size) : share(size) {}

  void open(Call new_call, void* new_what, std::size_t n, std::size_t new_parts) {
    call.store(new_call, std::memory_order_relaxed);
    what.store(new_what, std::memory_order_relaxed);
    count.store(n, std::memory_order_relaxed);
    parts.store(new_parts, std::memory_order_relaxed);
    done.store(0, std::memory_order_relaxed);
    const std::uint32_t next = round.load(std::memory_order_relaxed) + 1;
    const auto cut = [&](std::size_t member) { return static_cast<std::uint16_t>(new_parts * member / share.size()); };
    for (std::size_t m = 0; m < share.size(); ++m)
      share[m].open.store(Open{next, cut(m), cut(m + 1)}.word(), std::memory_order_release);
    round.store(next, std::memory_order_release);
    round.notify_all();
  }

  /// Does one part of a share, the first if it is one's own (what lies side by side stays with one member), else the
  /// last. False if none was open.
  bool take(Share& from, bool own, std::size_t& of) {
    std::uint64_t word = from.open.load(std::memory_order_acquire);
    while (true) {
      const Open now = Open::of(word);
      if (now.first >= now.last) return false;
      const Call todo = call.load(std::memory_order_relaxed);
      void* const with = what.load(std::memory_order_relaxed);
      const std::size_t n = count.load(std::memory_order_relaxed), all = parts.load(std::memory_order_relaxed);
      Open left = now;
      const std::size_t part = own ? left.first++ : --left.last;
      // Succeeds in the round of `word` only, and then what was read is of that round.
      if (!from.open.compare_exchange_weak(word, left.word(), std::memory_order_acq_rel, std::memory_order_acquire))
        continue;
      const auto cut = [&](std::size_t at) { return at == all ? n : n * at / all / 8 * 8; };
      todo(with, cut(part), cut(part + 1));
      of = all;
      return true;
    }
  }

  /// Does parts until none is open, the member's own first; returns how many.
  std::size_t work(std::size_t member) {
    std::size_t mine = 0, all = 0;
    for (std::size_t k = 0; k < share.size(); ++k)
      while (take(share[(member + k) % share.size()], k == 0, all)) ++mine;
    if (mine > 0 && done.fetch_add(mine, std::memory_order_acq_rel) + mine == all) done.notify_one();
    return mine;
  }
};

ThreadPool::ThreadPool(int size) : shared_(std::make_unique<Shared>(static_cast<std::size_t>(std::max(size, 1)))) {
  for (std::size_t member = 1; member < shared_->share.size(); ++member)
    members_.emplace_back([shared = shared_.get(), member] { serve(*shared, member); });
}

ThreadPool::~ThreadPool() {
  shared_->over.store(true, std::memory_order_relaxed);
  shared_->round.fetch_add(1, std::memory_order_release);
  shared_->round.notify_all();
  for (auto& member : members_) member.join();
}

void ThreadPool::serve(Shared& shared, std::size_t member) {
  for (std::uint32_t seen = 0;;) {
    wait_while(shared.round, seen);
    seen = shared.round.load(std::memory_order_acquire);
    if (shared.over.load(std::memory_order_relaxed)) return;
    shared.work(member);
  }
}

void ThreadPool::run(Call call, void* what, std::size_t n) const {
  Shared& s = *shared_;
  const std::size_t parts = std::min({parts_of_a_member * s.share.size(), n / 8, most_parts});
  const auto start = Clock::now();
  if (parts < 2 || s.worth.alone(start)) return call(what, 0, n);
  s.open(call, what, n, parts);
  const std::size_t mine = s.work(0);
  const auto worked = Clock::now();
  for (std::size_t done; (done = s.done.load(std::memory_order_acquire)) != parts;) wait_while(s.done, done);
  const auto end = Clock::now();
  // Alone, the parts of the others would have taken as long as one's own.
  if (mine > 0) s.worth.book(end - worked, (worked - start) * (parts - mine) / mine, end);
}

}  // namespace arenite
