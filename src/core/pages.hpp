#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace arenite {

/// Large pages for memory that nothing was written to yet, where the system gives them.
inline void ask_for_large_pages(void* memory, std::size_t bytes) {
  constexpr std::uintptr_t page = 4096;
  const auto at = reinterpret_cast<std::uintptr_t>(memory), first = (at + page - 1) / page * page;
  if (bytes >= (std::size_t{1} << 21)) madvise(reinterpret_cast<void*>(first), at + bytes - first, MADV_HUGEPAGE);
}

/// Zeroed memory straight from the system, in large pages where it gives them: a walk over many rows at once would run
/// out of address translations with small pages, and the system takes longer to hand out thousands of these than a
/// lock-in takes to fit them.
template <class T> struct Pages {
  using value_type = T;
  bool operator==(const Pages&) const = default;
  T* allocate(std::size_t n) {
    void* p = mmap(nullptr, n * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (p == MAP_FAILED) throw std::bad_alloc();
    ask_for_large_pages(p, n * sizeof(T));
    return static_cast<T*>(p);
  }
  void deallocate(T* p, std::size_t n) { munmap(p, n * sizeof(T)); }
  void construct(T*) const {}  ///< zero as it is
};
template <class T> using Buffer = std::vector<T, Pages<T>>;

/// Room for n numbers in large pages, in a vector of the usual kind.
template <class T> void reserve_in_large_pages(std::vector<T>& to, std::size_t n) {
  if (n <= to.capacity()) return;
  to.reserve(n);
  ask_for_large_pages(to.data() + to.size(), (n - to.size()) * sizeof(T));
}

}  // namespace arenite
