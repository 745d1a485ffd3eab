#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <vector>

namespace arenite {

/// Zeroed memory straight from the system, in large pages where it gives them: a walk over many rows at once would run
/// out of address translations with small pages, and the system takes longer to hand out thousands of these than a
/// lock-in takes to fit them.
template <class T> struct Pages {
  using value_type = T;
  bool operator==(const Pages&) const = default;
  T* allocate(std::size_t n) {
    void* p = mmap(nullptr, n * sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (p == MAP_FAILED) throw std::bad_alloc();
    if (n * sizeof(T) >= (std::size_t{1} << 21)) madvise(p, n * sizeof(T), MADV_HUGEPAGE);
    return static_cast<T*>(p);
  }
  void deallocate(T* p, std::size_t n) { munmap(p, n * sizeof(T)); }
  void construct(T*) const {}  ///< zero as it is
};
template <class T> using Buffer = std::vector<T, Pages<T>>;

}  // namespace arenite
