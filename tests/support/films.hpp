#pragma once
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/film/film.hpp"

/// Small films, written byte by byte or made in memory.
namespace arenite::test {

inline std::filesystem::path infrared(const std::string& name) {
  return std::filesystem::path(ARENITE_SOURCE_DIR) / "tests/data/infrared" / name;
}

inline void spill(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

template <class T> void add(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}
template <class T> void set(std::string& bytes, std::size_t at, T value) {
  std::memcpy(bytes.data() + at, &value, sizeof(T));
}

/// A film whose every number is given by its place: 1000 frame + 10 row + column.
inline Film counted(int width = 5, int height = 4, int frames = 3, bool floating = false) {
  Film film;
  film.about.width = width;
  film.about.height = height;
  film.about.frames = frames;
  film.about.floating = floating;
  film.about.bits = floating ? 0 : 14;
  film.about.quantity = floating ? FilmQuantity::kelvin : FilmQuantity::digital_level;
  film.about.frame_rate = 125;
  film.about.integration = 0.0015;
  film.about.camera = "Counter";
  for (int f = 0; f < frames; ++f)
    for (int r = 0; r < height; ++r)
      for (int c = 0; c < width; ++c) {
        const int n = 1000 * f + 10 * r + c;
        if (floating) film.value.push_back(static_cast<float>(n) + 0.25F);
        else film.level.push_back(static_cast<std::uint16_t>(n));
      }
  return film;
}

/// All frames of a film at once.
inline FrameBlock all_of(FilmSource& film) {
  FrameBlock block;
  film.read(0, static_cast<std::size_t>(film.info().frames), block);
  return block;
}

/// Headers of a .ptw film with the few fields that count, and its frames.
inline std::string ptw(const Film& film, double step = 0.01, std::size_t main = 3476, std::size_t head = 1016) {
  std::string bytes(main, '\0');
  bytes.replace(0, 3, "CED");
  const auto words = static_cast<std::int32_t>(film.about.pixels());
  set(bytes, 11, static_cast<std::int32_t>(main));
  set(bytes, 15, static_cast<std::int32_t>(head));
  set(bytes, 19, words + static_cast<std::int32_t>(head / 2));
  set(bytes, 23, words);
  set(bytes, 27, static_cast<std::int32_t>(film.about.frames));
  set(bytes, 377, static_cast<std::int16_t>(film.about.width));
  set(bytes, 379, static_cast<std::int16_t>(film.about.height));
  set(bytes, 381, std::int16_t{14});
  set(bytes, 403, 0.01F);
  for (std::int64_t f = 0; f < film.about.frames; ++f) {
    std::string header(head, '\0');
    const auto us = static_cast<std::uint64_t>(86399.99e6 + static_cast<double>(f) * step * 1e6 + 0.5) %
                    86400000000ULL;  // midnight comes
    if (head >= 163) {
      header[81] = static_cast<char>(us / 3600000000ULL);
      header[80] = static_cast<char>(us / 60000000 % 60);
      header[83] = static_cast<char>(us / 1000000 % 60);
      header[82] = static_cast<char>(us / 10000 % 100);
      header[160] = static_cast<char>(us / 1000 % 10);
      set(header, 161, static_cast<std::uint16_t>(us % 1000));
    }
    bytes += header;
    bytes.append(
        reinterpret_cast<const char*>(film.level.data()) + static_cast<std::size_t>(f) * film.about.pixels() * 2,
        film.about.pixels() * 2);
  }
  return bytes;
}

/// A Telops film of two headers' worth of fields; `gap` is the time between frames in units of 100 ns.
inline std::string hcc(const Film& film, int mode = 1, int exponent = 0, float shift = 0, std::uint32_t gap = 80000) {
  std::string bytes;
  for (std::int64_t f = 0; f < film.about.frames; ++f) {
    std::string header(
        static_cast<std::size_t>(2 * film.about.width) * ((256 + 2 * film.about.width - 1) / (2 * film.about.width)),
        '\0');
    header.replace(0, 2, "TC");
    set(header, 4, static_cast<std::uint16_t>(header.size()));
    set(header, 8, static_cast<std::uint32_t>(f));
    set(header, 12, shift);
    header[16] = static_cast<char>(exponent);
    set(header, 24, std::uint32_t{150000});
    header[28] = static_cast<char>(mode);
    set(header, 32, static_cast<std::uint16_t>(film.about.width));
    set(header, 34, static_cast<std::uint16_t>(film.about.height));
    set(header, 44, std::uint32_t{125000});
    const auto tick = 9999000U + static_cast<std::uint32_t>(f) * gap;
    set(header, 100, 1700000000U + tick / 10000000U);
    set(header, 104, tick % 10000000U);
    bytes += header;
    bytes.append(
        reinterpret_cast<const char*>(film.level.data()) + static_cast<std::size_t>(f) * film.about.pixels() * 2,
        film.about.pixels() * 2);
  }
  return bytes;
}

inline std::string sfmov(const Film& film, const std::string& more = "") {
  std::string bytes = "HdSize auto\r\nxPixls " + std::to_string(film.about.width) + "\r\nyPixls " +
                      std::to_string(film.about.height) + "\r\nNumDPs " + std::to_string(film.about.frames) + "\r\n" +
                      (film.about.floating ? "DaType Flt32\r\n" : "DaType UINT16\r\n") + more +
                      "saf_padding ............\r\nDATA\r\n";
  if (film.about.floating) bytes.append(reinterpret_cast<const char*>(film.value.data()), film.value.size() * 4);
  else bytes.append(reinterpret_cast<const char*>(film.level.data()), film.level.size() * 2);
  return bytes;
}

inline std::string npy(const std::string& type, const std::string& shape, const std::string& data,
                       const std::string& fortran = "False") {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
  header.resize(((header.size() + 10) / 64 + 1) * 64 - 10 - 1, ' ');
  header += '\n';
  std::string bytes("\x93NUMPY\x01\0", 8);
  add(bytes, static_cast<std::uint16_t>(header.size()));
  return bytes + header + data;
}

}  // namespace arenite::test
