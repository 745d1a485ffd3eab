#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/film/film.hpp"
#include "io/hdf5/foreign.hpp"
#include "io/hdf5/netcdf.hpp"

// What an HDF5 file of anybody's says of its film; to be asked in a sandbox (io/hdf5/foreign.hpp).
namespace arenite::io {

/// What the file says of its film. A number that it does not state is none.
struct Hdf5Facts {
  std::string name, notes, unit, time_unit;
  std::string axes;                            ///< a sentence on their order, if it needs one
  std::string times;                           ///< sentences on times, numbers and masks of frames, a line each
  std::vector<std::int64_t> shape;             ///< frames, rows, columns
  std::vector<std::int64_t> axis = {0, 1, 2};  ///< the stored one of each
  NumberType pixel = NumberType::u16;
  bool big_endian = false, by_matlab = false;
  double frame_rate = 0, integration = 0;
  double no_rate = 0;  ///< Hz, what is stated instead of a rate and can be none: below 0
  NumbersStated numbers;
  std::vector<double> time;          ///< of frames, in their unit; empty without
  std::vector<std::int64_t> number;  ///< of frames; empty without
};

/// One list of members for both ways.
template <class Archive> void transfer(Archive& a, Hdf5Facts& facts) {
  auto pixel = static_cast<std::uint8_t>(facts.pixel), big_endian = static_cast<std::uint8_t>(facts.big_endian);
  auto by_matlab = static_cast<std::uint8_t>(facts.by_matlab);
  a(facts.name), a(facts.notes), a(facts.unit), a(facts.time_unit), a(facts.axes), a(facts.times), a(facts.shape),
      a(facts.axis), a(pixel), a(big_endian), a(by_matlab);
  NumbersStated& n = facts.numbers;
  a(facts.frame_rate), a(facts.no_rate), a(facts.integration), a(n.scale), a(n.offset), a(n.missing), a(n.least),
      a(n.most), a(facts.time), a(facts.number);
  facts.pixel = static_cast<NumberType>(pixel);
  facts.big_endian = big_endian != 0;
  facts.by_matlab = by_matlab != 0;
}

/// Of the file's only film, or of the dataset that is chosen.
Hdf5Facts look_at_hdf5_film(const Bytes& bytes, const FilmChoice& choice);

/// The dataset of this name in the file, or the only one that can be a film.
FoundDataset find_hdf5_film(const Hdf5Handle& file, const Bytes& bytes, const std::string& name);

/// Numbers of a chunk, which is read as a whole.
double most_in_chunk(const FilmChoice& choice);

[[noreturn]] void refuse_damaged_hdf5(const Bytes& bytes);

}  // namespace arenite::io
