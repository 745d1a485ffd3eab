#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/film/film.hpp"
#include "io/film/stamps.hpp"
#include "io/formats.hpp"

// What the formats of films share.
namespace arenite::io {

/// A film that knows what it is before its frames are read.
class KnownFilm : public FilmSource {
 public:
  const FilmInfo& info() const override { return info_; }
  /// Throws std::out_of_range unless the film has these frames.
  void read(std::int64_t first, std::size_t count, FrameBlock& block) final;
  void is_of(std::string_view format) { info_.format = format; }

 protected:
  /// The same into a block that has its size already.
  virtual void fill(std::int64_t first, std::size_t count, FrameBlock& block) = 0;
  FilmInfo info_;
};

using FilmPointer = std::unique_ptr<KnownFilm>;
using FilmWriterPointer = std::unique_ptr<FilmWriter>;

/// How a format is known, read and written.
struct FilmFormat {
  std::string_view name, sentence;
  Statements states = {};
  std::array<std::string_view, 2> endings = {};  ///< of names of films that are to be written in it
  bool marked = false;                           ///< begins with a mark that nothing else begins with
  bool has_datasets = false;                     ///< may hold several films, of which FilmChoice::dataset names one
  bool levels_only = false;                      ///< has no place for temperatures
  std::string_view sidecar = {};                 ///< of a text beside a file of frames: how it is written
  bool (*is)(std::string_view head);
  FilmPointer (*open)(const Bytes& bytes, const FilmChoice& choice);
  FilmWriterPointer (*create)(const std::filesystem::path& path, const FilmInfo& info) = nullptr;
  std::vector<double> (*lock_in_line)(const ByteSource& bytes) = nullptr;  ///< io::lock_in_line
};
namespace films {
ARENITE_FAMILY(FilmFormat, ARENITE_FILM_FORMATS)
}

/// A film whose numbers are temperatures, if the choice says so; the film itself otherwise.
FilmPointer scaled_film(FilmPointer film, const FilmChoice& choice);

/// Files of one frame or more each, one after the other; a file is opened when its frames are read.
FilmPointer open_series(const std::filesystem::path& pattern, const FilmChoice& choice);

/// Where the pixels of a film lie: frame i begins at offset + i stride.
struct PlainLayout {
  std::uint64_t offset = 0, stride = 0;  ///< bytes
  NumberType pixel = NumberType::u16;
  bool big_endian = false;
  bool scaled = false;  ///< a pixel is scale * number + shift, floating
  double scale = 1, shift = 0;
};

/// Where temperatures in this unit count from, K: 273.15 of degrees Celsius as programs write them, 0 of kelvin;
/// nothing of what is no unit of temperature.
std::optional<double> zero_of_temperatures(std::string_view unit);

/// The same of a line beside frames that states what they are: "Temperature [°C]", "# unit = K"; "Ambient [°C]: 20" is
/// of something else.
std::optional<double> zero_stated_in(std::string_view line);

/// InputError unless a film of this size can be meant: pixels and frames there, not too many pixels in a frame.
void check_film_size(const std::string& file, std::int64_t width, std::int64_t height, std::int64_t frames,
                     const FilmChoice& choice);

/// How many whole frames a file of this layout holds.
std::int64_t frames_there(const ByteSource& bytes, const PlainLayout& layout, std::size_t pixels);

/// InputError unless the film's size can be meant and the file is long enough for its frames.
void check_layout(const ByteSource& bytes, const FilmInfo& info, const PlainLayout& layout, const FilmChoice& choice);

/// A film whose pixels lie as they are in a file, checked.
FilmPointer plain_film(Bytes bytes, FilmInfo info, const PlainLayout& layout, const FilmChoice& choice);

/// Size and kind of pixel of a film, checked (check_film_size).
void take_shape(FilmInfo& info, const std::string& file, const std::vector<std::int64_t>& frames_height_width,
                NumberType pixel, const FilmChoice& choice);

/// Takes the frame rate that was chosen, if one was.
void take_choice(FilmInfo& info, const FilmChoice& choice);

/// Makes `count` pixels of their bytes into levels or values of a prepared block, from its pixel `at` on.
void take_pixels(const PlainLayout& layout, const char* from, std::size_t count, FrameBlock& block, std::size_t at);

/// The pixels of some frames of a block as they lie in memory. Throws std::invalid_argument for a block that is not of
/// this film.
std::string_view pixel_bytes(const FilmInfo& info, const FrameBlock& block);

/// What stands before all frames and before each (or null); the frames themselves are written as they lie in memory.
/// The header says how many frames there are, which is known at the end, so it is written again then and must be as
/// long for any number.
struct FilmForm {
  std::string (*header)(const FilmInfo&, std::size_t frames);
  std::string (*before)(const FilmInfo&, std::size_t frame) = nullptr;
};
FilmWriterPointer create_plain_film(const std::filesystem::path& path, const FilmInfo& info, const FilmForm& form);

/// What a film says about itself as lines "key = value", for formats that have no place of their own for it.
std::string film_notes(const FilmInfo& info);

/// Takes what such lines say; other lines are left aside.
void take_notes(std::string_view text, FilmInfo& info);

}  // namespace arenite::io
