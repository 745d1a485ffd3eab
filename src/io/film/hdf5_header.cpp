#include "io/film/hdf5_header.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>

#include "io/film/formats.hpp"
#include "io/hdf5/handle.hpp"

namespace arenite::io {
namespace {

void write_notes(hid_t file, hid_t set, const FilmInfo& info, hsize_t frames) {
  if (info.frame_rate > 0) write_number(set, "frame_rate", info.frame_rate);
  if (info.integration > 0) write_number(set, "integration", info.integration);
  if (const std::string notes = film_notes(info); !notes.empty()) write_text(set, "notes", notes);
  const hsize_t count = std::min<hsize_t>(frames, info.time.size());
  if (count == 0) return;
  write_set(file, "time", {count}, H5T_IEEE_F64LE, *timeless(H5P_DATASET_CREATE), info.time.data());
  write_text(*made(H5Dopen2(file, "time", H5P_DEFAULT), H5Dclose), "units", "s");
}

/// Puts the place of the frames, which HDF5 leaves open as long as nothing is written to them, into a file that it
/// made, and the length of the whole (File Format Specification 3.0: layout message 3 of a contiguous dataset,
/// superblock 0).
void put_frames_behind(std::string& file, std::size_t room, std::uint64_t size) {
  std::string open("\3\1\xff\xff\xff\xff\xff\xff\xff\xff", 10);
  append<std::uint64_t>(open, size);
  const std::size_t at = file.find(open);
  if (file.size() > room || at == std::string::npos || file.find(open, at + 1) != std::string::npos)
    throw std::runtime_error("HDF5 made a file of another form");
  put<std::uint64_t>(file, at + 2, room);
  put<std::uint64_t>(file, 40, room + size);
  file.resize(room);
}

}  // namespace

std::string hdf5_header(const FilmInfo& info, std::size_t frames) {
  constexpr std::size_t page = 4096;
  const std::size_t room = (3 * page + film_notes(info).size() + 8 * info.time.size()) / page * page;
  if (frames == 0) return std::string(room, '\0');
  const Hdf5Turn turn;
  const auto access = memory_properties(), creation = timeless(H5P_FILE_CREATE), of_set = timeless(H5P_DATASET_CREATE);
  done(H5Pset_libver_bounds(*access, H5F_LIBVER_EARLIEST, H5F_LIBVER_V18));
  const auto file = made(H5Fcreate(unused_name().c_str(), H5F_ACC_TRUNC, *creation, *access), H5Fclose);
  const std::array<hsize_t, 3> shape{frames, static_cast<hsize_t>(info.height), static_cast<hsize_t>(info.width)};
  const auto space = made(H5Screate_simple(3, shape.data(), nullptr), H5Sclose);
  done(H5Pset_alloc_time(*of_set, H5D_ALLOC_TIME_LATE));
  done(H5Pset_fill_time(*of_set, H5D_FILL_TIME_NEVER));
  auto set = made(H5Dcreate2(*file, "frames", info.floating ? H5T_IEEE_F32LE : H5T_STD_U16LE, *space, H5P_DEFAULT,
                             *of_set, H5P_DEFAULT),
                  H5Dclose);
  write_notes(*file, *set, info, frames);
  set.reset();
  std::string bytes = bytes_of_file(*file);
  put_frames_behind(bytes, room, frames * info.pixels() * (info.floating ? sizeof(float) : sizeof(std::uint16_t)));
  return bytes;
}

}  // namespace arenite::io
