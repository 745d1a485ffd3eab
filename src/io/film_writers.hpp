#pragma once
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include "io/atomic_file.hpp"
#include "io/film_writer.hpp"

// One a format, each in a file of its name; the list is in film_writer.cpp.
namespace arenite::io {

using FilmWriterPointer = std::unique_ptr<FilmWriter>;
FilmWriterPointer create_tiff_film(const std::filesystem::path& path, const FilmInfo& info);
FilmWriterPointer create_npy_film(const std::filesystem::path& path, const FilmInfo& info);
FilmWriterPointer create_hdf5_film(const std::filesystem::path& path, const FilmInfo& info);
FilmWriterPointer create_sfmov_film(const std::filesystem::path& path, const FilmInfo& info);
FilmWriterPointer create_ptw_film(const std::filesystem::path& path, const FilmInfo& info);

/// The pixels of some frames of a block as they lie in memory. Throws std::invalid_argument for a block that is not of
/// this film.
std::string_view pixel_bytes(const FilmInfo& info, const FrameBlock& block);

/// Puts a number into bytes, lowest byte first.
template <class T>
void put(std::string& bytes, std::size_t at, std::type_identity_t<T> value) {
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}
template <class T>
void append(std::string& bytes, std::type_identity_t<T> value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

}  // namespace arenite::io
