#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "io/film/formats.hpp"
#include "io/film/hdf5_facts.hpp"
#include "io/film/hdf5_header.hpp"
#include "io/hdf5/sandbox.hpp"
#include "io/time_units.hpp"

namespace arenite::io {
namespace {

/// HDF5 trusts what it reads: it is used in a process of its own, which a damaged file may bring down.
class Hdf5Film : public KnownFilm {
 public:
  Hdf5Film(const Bytes& bytes, const FilmChoice& choice) : bytes_(bytes), most_(most_in_chunk(choice)) {
    prepare_hdf5();
    const auto facts = [&] { return look_at_hdf5_film(bytes_, choice); };
    take(record_from_sandbox<Hdf5Facts>(
             bytes_->name(), facts, [](auto& archive, Hdf5Facts& f) { transfer(archive, f); }, most_told, room()),
         choice);
    FrameBlock last;  // what is cut short lacks it
    read(info_.frames - 1, 1, last);
  }

  void fill(std::int64_t first, std::size_t count, FrameBlock& block) override {
    const std::size_t pixels = info_.pixels(),
                      at_once = std::max<std::size_t>(1, most_at_once / (pixels * bytes_of(layout_.pixel)));
    for (std::size_t n = 0; n < count; n += at_once) {
      const std::size_t part = std::min(at_once, count - n), size = part * pixels * bytes_of(layout_.pixel);
      const std::string stored = in_sandbox(
          bytes_->name(), [&] { return frames(static_cast<hsize_t>(first) + n, part); }, size, room());
      if (stored.size() != size) refuse_damaged_hdf5(bytes_);
      take_pixels(layout_, stored.data(), part * pixels, block, n * pixels);
      if (!std::isnan(missing_)) forget_missing(stored, part * pixels, block.value.data() + n * pixels);
      if (by_columns_ && info_.floating) turn(block.value.data() + n * pixels, part);
      if (by_columns_ && !info_.floating) turn(block.level.data() + n * pixels, part);
    }
  }

 private:
  static constexpr std::size_t most_at_once = std::size_t{32} << 20, most_told = std::size_t{2} << 30;  // bytes

  /// A file in memory is copied by HDF5.
  std::size_t room() const { return bytes_->path() != nullptr ? 0 : 3 * static_cast<std::size_t>(bytes_->size()); }

  void take(const Hdf5Facts& facts, const FilmChoice& choice) {
    if (facts.shape.size() != 3 || bytes_of(facts.pixel) == 0) refuse_damaged_hdf5(bytes_);
    name_ = facts.name;
    layout_.pixel = facts.pixel;
    layout_.big_endian = facts.big_endian;
    take_shape(info_, bytes_->name(), facts.shape, facts.pixel, choice);
    if (facts.by_matlab) {
      by_columns_ = true;
      std::swap(info_.width, info_.height);
      info_.remarks.push_back(fmt::format("An array of MATLAB, height x width x frames: {} x {} x {}.", info_.height,
                                          info_.width, info_.frames));
    }
    take_notes(facts.notes, info_);
    take_scale(facts);
    if (info_.frame_rate == 0) info_.frame_rate = facts.frame_rate;
    if (info_.integration == 0) info_.integration = facts.integration;
    take_times(facts);
    take_choice(info_, choice);
  }

  /// What pixels are, as netCDF writes it.
  void take_scale(const Hdf5Facts& facts) {
    const bool celsius = facts.unit == "degC" || facts.unit == "celsius" || facts.unit == "degree_Celsius" ||
                         facts.unit ==
                             "\xc2\xb0"
                             "C";
    const bool kelvin = facts.unit == "K" || facts.unit == "kelvin" || facts.unit == "Kelvin";
    missing_ = facts.missing;
    layout_.scale = std::isnan(facts.scale) ? 1 : facts.scale;
    layout_.shift = (std::isnan(facts.offset) ? 0 : facts.offset) + (celsius ? 273.15 : 0);
    layout_.scaled = layout_.scale != 1 || layout_.shift != 0 || !std::isnan(missing_);
    if (layout_.scaled) info_.floating = true, info_.bits = 0;
    if (celsius || kelvin) info_.quantity = FilmQuantity::kelvin;
    else if (!facts.unit.empty()) info_.remarks.push_back(fmt::format("Its pixels are in \"{}\".", facts.unit));
  }

  void take_times(const Hdf5Facts& facts) {
    const auto seconds = seconds_of(facts.time_unit.substr(0, facts.time_unit.find(' ')));  // "seconds since .."
    if (!facts.time.empty() && !seconds)
      return info_.remarks.push_back(
          fmt::format("Its times are in \"{}\", a unit that is not known; they are left aside.", facts.time_unit));
    std::vector<double> time = facts.time;
    const double first = time.empty() ? 0 : time.front();
    for (double& t : time) t = (t - first) * seconds.value_or(1);
    take_stamps(info_, std::move(time));
    if (!facts.time.empty()) info_.start = first * seconds.value_or(1);
  }

  /// Numbers that stand for none.
  void forget_missing(const std::string& stored, std::size_t count, float* value) const {
    each_number(layout_.pixel, layout_.big_endian, stored.data(), count, [&](std::size_t i, auto v) {
      if (static_cast<double>(v) == missing_) value[i] = std::numeric_limits<float>::quiet_NaN();
    });
  }

  /// Pictures that lie column by column.
  template <class T> void turn(T* pixels, std::size_t frames) const {
    const auto width = static_cast<std::size_t>(info_.width), height = static_cast<std::size_t>(info_.height);
    std::vector<T> columns(width * height);
    for (std::size_t f = 0; f < frames; ++f, pixels += columns.size()) {
      std::copy_n(pixels, columns.size(), columns.begin());
      for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) pixels[y * width + x] = columns[x * height + y];
    }
  }

  /// In the process of its own.
  std::string frames(hsize_t first, hsize_t count) const {
    const auto file = open_hdf5_film(bytes_);
    std::string stored;
    Hdf5Numbers(find_hdf5_film(file, bytes_, name_).set, name_, bytes_, most_).read(first, count, stored);
    return stored;
  }

  Bytes bytes_;
  double most_;
  std::string name_;
  PlainLayout layout_;
  bool by_columns_ = false;
  double missing_ = no_number;
};

}  // namespace

/// HDF5: a dataset of frames x height x width, perhaps with times beside it and attributes.
const FilmFormat films::hdf5{
    .name = "hdf5",
    .sentence = "HDF5",
    .states = {{"times of frames (time, times, timestamps) with units", "used; told where the unit is unknown"},
               {"frame_rate, frame_rate_Hz, fps, integration", "used, as attributes or as arrays of one number"},
               {"MATLAB_class (MATLAB, save -v7.3)", "axes are taken as height x width x frames"},
               {"scale_factor, add_offset, units of netCDF",
                "pixels become numbers in that unit, degrees Celsius become kelvin"},
               {"_FillValue, missing_value; chunks never written", "no numbers"},
               {"groups nested more than 64 deep", "not searched"},
               {"frames of NaN, or of zeros", "left out as lost, and named"}},

    .endings = {".h5", ".hdf5"},
    .marked = true,
    .has_datasets = true,
    .is = is_hdf5,
    .open = [](const Bytes& bytes, const FilmChoice& choice) -> FilmPointer {
      return std::make_unique<Hdf5Film>(bytes, choice);
    },
    .create = [](const auto& path, const FilmInfo& info) { return create_plain_film(path, info, {hdf5_header}); }};

}  // namespace arenite::io
