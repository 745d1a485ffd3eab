#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <new>
#include <utility>

namespace arenite::peridynamics {

/// A zeroed array of plain numbers straight from the system, in large pages where it gives them: the stencil walks over
/// a dozen rows at once, and small pages would run it out of address translations.
template <class T>
class Buffer {
 public:
  Buffer() = default;
  explicit Buffer(std::size_t n) : size_(n), bytes_((n * sizeof(T) + page - 1) / page * page) {
    if (n == 0) return;
    void* p = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (p == MAP_FAILED) throw std::bad_alloc();
    if (bytes_ >= (std::size_t{1} << 21)) madvise(p, bytes_, MADV_HUGEPAGE);
    data_ = static_cast<T*>(p);
  }
  Buffer(Buffer&& b) noexcept
      : data_(std::exchange(b.data_, nullptr)), size_(std::exchange(b.size_, 0)), bytes_(b.bytes_) {}
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

/// A plane vector at every node of a grid.
template <class T>
struct Field {
  Buffer<T> x, y;
  Field() = default;
  explicit Field(std::size_t padded_size) : x(padded_size), y(padded_size) {}
};

}  // namespace arenite::peridynamics
