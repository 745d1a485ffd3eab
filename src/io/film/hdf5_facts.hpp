#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "io/film/film.hpp"
#include "io/hdf5/foreign.hpp"

// What an HDF5 file of anybody's says of its film; to be asked in a sandbox (io/hdf5/foreign.hpp).
namespace arenite::io {

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// What the file says of its film. A number that it does not state is none.
struct Hdf5Facts {
  std::string name, notes, unit, time_unit;
  std::string axes, times;          ///< a sentence on their order and on the times of frames, if they need one
  std::vector<std::int64_t> shape;  ///< frames, rows, columns
  std::vector<std::int64_t> axis = {0, 1, 2};  ///< the stored one of each
  NumberType pixel = NumberType::u16;
  bool big_endian = false, by_matlab = false;
  double frame_rate = 0, integration = 0;
  double no_rate = 0;                            ///< Hz, what is stated instead of a rate and can be none: below 0
  double scale = no_number, offset = no_number;  ///< by the conventions of netCDF, as what follows
  std::vector<double> missing;                   ///< numbers that stand for none, as they are stored
  double least = no_number, most = no_number;    ///< what lies beyond stands for none, as it is stored
  std::vector<double> time;
};

/// One list of members for both ways.
template <class Archive> void transfer(Archive& a, Hdf5Facts& facts) {
  auto pixel = static_cast<std::uint8_t>(facts.pixel), big_endian = static_cast<std::uint8_t>(facts.big_endian);
  auto by_matlab = static_cast<std::uint8_t>(facts.by_matlab);
  a(facts.name), a(facts.notes), a(facts.unit), a(facts.time_unit), a(facts.axes), a(facts.times), a(facts.shape),
      a(facts.axis), a(pixel), a(big_endian), a(by_matlab);
  a(facts.frame_rate), a(facts.no_rate), a(facts.integration), a(facts.scale), a(facts.offset), a(facts.missing),
      a(facts.least), a(facts.most), a(facts.time);
  facts.pixel = static_cast<NumberType>(pixel);
  facts.big_endian = big_endian != 0;
  facts.by_matlab = by_matlab != 0;
}

/// Of the file's only film, or of the dataset that is chosen.
Hdf5Facts look_at_hdf5_film(const Bytes& bytes, const FilmChoice& choice);

/// The file, and the dataset of this name in it, or the only one that can be a film.
Hdf5Handle open_hdf5_film(const Bytes& bytes);
FoundDataset find_hdf5_film(const Hdf5Handle& file, const Bytes& bytes, const std::string& name);

/// Numbers of a chunk, which is read as a whole.
double most_in_chunk(const FilmChoice& choice);

[[noreturn]] void refuse_damaged_hdf5(const Bytes& bytes);

}  // namespace arenite::io
