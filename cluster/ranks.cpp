#include "ranks.hpp"

#include <algorithm>

namespace arenite::cluster {
namespace {

constexpr std::size_t most = std::size_t{1} << 30;  ///< bytes of one message: MPI counts them in an int

/// pass(place, bytes) for each message.
template <class Byte, class Pass> void in_messages(Byte* at, std::size_t bytes, const Pass& pass) {
  for (std::size_t begin = 0; begin < bytes; begin += most)
    pass(at + begin, static_cast<int>(std::min(most, bytes - begin)));
}

}  // namespace

int own_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int rank_count() {
  int count = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

std::vector<Box> boxes_of_all(const Box& own) {
  std::vector<Box> boxes(static_cast<std::size_t>(rank_count()));
  MPI_Allgather(&own, sizeof own, MPI_BYTE, boxes.data(), sizeof own, MPI_BYTE, MPI_COMM_WORLD);
  return boxes;
}

void send_bytes(const void* from, std::size_t bytes, int rank) {
  in_messages(static_cast<const char*>(from), bytes,
              [&](const char* at, int n) { MPI_Send(at, n, MPI_BYTE, rank, 0, MPI_COMM_WORLD); });
}

void receive_bytes(void* to, std::size_t bytes, int rank) {
  in_messages(static_cast<char*>(to), bytes,
              [&](char* at, int n) { MPI_Recv(at, n, MPI_BYTE, rank, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE); });
}

void tell_bytes(void* what, std::size_t bytes) {
  in_messages(static_cast<char*>(what), bytes,
              [](char* at, int n) { MPI_Bcast(at, n, MPI_BYTE, first_rank, MPI_COMM_WORLD); });
}

}  // namespace arenite::cluster
