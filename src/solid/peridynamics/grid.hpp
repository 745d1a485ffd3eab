#pragma once
#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace arenite::peridynamics {

/// How a raster lies in memory while it is worked on: rows padded with empty nodes by at least a horizon on every side,
/// so that no loop asks where the sample ends, and to whole vectors of 16 nodes, so that loops run in full lanes.
struct Grid {
  static constexpr int lanes = 8;    ///< nodes of a group
  static constexpr int vector = 16;  ///< nodes of the widest vector
  int width = 0, height = 0;         ///< nodes of the sample
  int groups = 0;                    ///< groups of 8 nodes a row
  std::ptrdiff_t stride = 0;         ///< nodes from one row to the next

  Grid() = default;
  Grid(int w, int h) : width(w), height(h), groups((w + lanes - 1) / lanes), stride(row_vectors() * vector + vector) {
    if (stride % 128 == 0) stride += vector;  // rows a power of two apart share cache sets
  }
  int row_vectors() const { return (width + vector - 1) / vector; }
  std::ptrdiff_t row(int y) const { return (y + 3) * stride + vector; }
  std::ptrdiff_t index(int x, int y) const { return row(y) + x; }
  /// Every node of the sample in the map's order: visit(i, y).
  template <class Visit> void each(const Visit& visit) const {
    for (int y = 0; y < height; ++y)
      for (std::ptrdiff_t i = row(y), end = i + width; i < end; ++i) visit(i, y);
  }
  std::size_t padded_size() const { return static_cast<std::size_t>((height + 6) * stride + 3 * vector); }
};

/// A zeroed array of plain numbers straight from the system, in large pages where it gives them: the stencil walks over
/// a dozen rows at once, and small pages would run it out of address translations.
template <class T> class Buffer {
 public:
  Buffer() = default;
  explicit Buffer(std::size_t n) : size_(n), bytes_((n * sizeof(T) + page - 1) / page * page) {
    if (n == 0) return;
    void* p = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (p == MAP_FAILED) throw std::bad_alloc();
    if (bytes_ >= (std::size_t{1} << 21)) madvise(p, bytes_, MADV_HUGEPAGE);
    data_ = static_cast<T*>(p);
  }
  Buffer(Buffer&& b) noexcept : data_(std::exchange(b.data_, nullptr)), size_(std::exchange(b.size_, 0)), bytes_(b.bytes_) {}
  Buffer& operator=(Buffer&& b) noexcept {
    std::swap(data_, b.data_);
    std::swap(size_, b.size_);
    std::swap(bytes_, b.bytes_);
    return *this;
  }
  ~Buffer() {
    if (data_) munmap(data_, bytes_);
  }

  T* data() { return data_; }
  const T* data() const { return data_; }
  std::size_t size() const { return size_; }
  T& operator[](std::ptrdiff_t i) { return data_[i]; }
  const T& operator[](std::ptrdiff_t i) const { return data_[i]; }

 private:
  static constexpr std::size_t page = 4096;
  T* data_ = nullptr;
  std::size_t size_ = 0, bytes_ = 0;
};

template <class T> void copy(const Buffer<T>& from, Buffer<T>& to) { std::copy_n(from.data(), from.size(), to.data()); }

/// Between a buffer and a list of the same length.
template <class T> void put(const Buffer<T>& from, std::vector<T>& to) { to.assign(from.data(), from.data() + from.size()); }
template <class T> void put(const std::vector<T>& from, Buffer<T>& to) { std::copy_n(from.data(), from.size(), to.data()); }

/// A plane vector at every node of a grid.
template <class T> struct Field {
  Buffer<T> x, y;
  Field() = default;
  explicit Field(std::size_t padded_size) : x(padded_size), y(padded_size) {}
};

template <class T> void copy(const Field<T>& from, Field<T>& to) {
  copy(from.x, to.x);
  copy(from.y, to.y);
}

template <class T> void set_zero(Field<T>& a) {
  std::fill_n(a.x.data(), a.x.size(), T(0));
  std::fill_n(a.y.data(), a.y.size(), T(0));
}

}  // namespace arenite::peridynamics
