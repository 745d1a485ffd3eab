#pragma once
#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

/// The processes that share a sample: the first has all of it, reads and writes; each works at a box.
namespace arenite::cluster {

inline constexpr int first_rank = 0;
int own_rank();
int rank_count();

/// Nodes or cells, half open.
struct Box {
  std::array<std::int64_t, 3> low{}, high{};
  std::int64_t size(std::size_t axis) const { return high[axis] - low[axis]; }
  std::size_t count() const { return static_cast<std::size_t>(size(0) * size(1) * size(2)); }
  /// visit(x, y, z), x fastest.
  template <class Visit> void each(const Visit& visit) const {
    for (auto z = low[2]; z < high[2]; ++z)
      for (auto y = low[1]; y < high[1]; ++y)
        for (auto x = low[0]; x < high[0]; ++x) visit(x, y, z);
  }
};

/// The boxes of all ranks, in their order; every rank calls it with its own.
std::vector<Box> boxes_of_all(const Box& own);

// To and from another rank, however much it is.
void send_bytes(const void* from, std::size_t bytes, int rank);
void receive_bytes(void* to, std::size_t bytes, int rank);
/// The first rank's, on every rank.
void tell_bytes(void* what, std::size_t bytes);

template <class T> T told(T value) {
  static_assert(std::is_trivially_copyable_v<T>);
  tell_bytes(&value, sizeof value);
  return value;
}

/// What the first rank packs of every rank's box, on that rank: pack(box, values) appends.
template <class T, class Pack> std::vector<T> handed_out(const Box& own, std::size_t each, const Pack& pack) {
  const std::vector<Box> boxes = boxes_of_all(own);
  std::vector<T> values;
  if (own_rank() != first_rank) {
    values.resize(each * own.count());
    receive_bytes(values.data(), values.size() * sizeof(T), first_rank);
    return values;
  }
  for (int rank = rank_count(); rank-- > 0;) {  // its own last: those stay
    values.clear();
    const Box& box = boxes[static_cast<std::size_t>(rank)];
    values.reserve(each * box.count());
    pack(box, values);
    if (rank != first_rank) send_bytes(values.data(), values.size() * sizeof(T), rank);
  }
  return values;
}

/// The way back: unpack(box, values) of every rank's on the first one.
template <class T, class Unpack>
void handed_in(const Box& own, std::size_t each, std::vector<T> values, const Unpack& unpack) {
  const std::vector<Box> boxes = boxes_of_all(own);
  if (own_rank() != first_rank) return send_bytes(values.data(), values.size() * sizeof(T), first_rank);
  unpack(own, values);
  for (int rank = 1; rank < rank_count(); ++rank) {
    const Box& box = boxes[static_cast<std::size_t>(rank)];
    values.resize(each * box.count());
    receive_bytes(values.data(), values.size() * sizeof(T), rank);
    unpack(box, values);
  }
}

}  // namespace arenite::cluster
