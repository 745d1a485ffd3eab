#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/option.hpp"
#include "core/text.hpp"
#include "io/film/formats.hpp"
#include "io/film/hdf5_facts.hpp"
#include "io/film/hdf5_header.hpp"
#include "io/hdf5/sandbox.hpp"
#include "io/stated_units.hpp"
#include "io/table/table.hpp"

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
    const std::size_t pixels = info_.pixels(), frame = pixels * bytes_of(layout_.pixel),
                      at_once = std::max<std::size_t>(1, most_at_once / frame);
    for (std::size_t n = 0; n < count; n += at_once) {
      const std::size_t part = std::min(at_once, count - n), from = static_cast<std::size_t>(first) + n;
      const std::string stored =
          turned_.empty() ? slabs(from, part, part * frame) : turned_.substr(from * frame, part * frame);
      take_pixels(layout_, stored.data(), part * pixels, block, n * pixels);
      if (numbers_.may_miss()) forget_missing(stored, part * pixels, block.value.data() + n * pixels);
      if (by_columns_ && info_.floating) turn(block.value.data() + n * pixels, part);
      if (by_columns_ && !info_.floating) turn(block.level.data() + n * pixels, part);
    }
  }

 private:
  static constexpr std::size_t most_at_once = std::size_t{32} << 20, most_told = std::size_t{2} << 30;  // bytes
  static constexpr double most_turned = 1 << 30;

  /// A file in memory is copied by HDF5.
  std::size_t room() const { return bytes_->path() != nullptr ? 0 : 3 * static_cast<std::size_t>(bytes_->size()); }

  void take(const Hdf5Facts& facts, const FilmChoice& choice) {
    if (facts.shape.size() != 3 || bytes_of(facts.pixel) == 0) refuse_damaged_hdf5(bytes_);
    if (facts.axis.size() != 3 || !std::ranges::is_permutation(facts.axis, Hdf5Facts().axis))
      refuse_damaged_hdf5(bytes_);
    name_ = facts.name;
    layout_.pixel = facts.pixel;
    layout_.big_endian = facts.big_endian;
    take_shape(info_, bytes_->name(), facts.shape, facts.pixel, choice);
    by_columns_ = facts.axis[0] == 0 && facts.axis[1] > facts.axis[2];
    if (facts.axis[0] != 0) turn_all(facts.axis);
    if (!facts.axes.empty()) info_.remarks.push_back(facts.axes);
    Lines sentences(facts.times);
    for (std::string_view sentence; sentences.next(sentence);) info_.remarks.emplace_back(sentence);
    if (facts.by_matlab)
      info_.remarks.push_back(fmt::format("An array of MATLAB, height x width x frames: {} x {} x {}.", info_.height,
                                          info_.width, info_.frames));
    take_notes(facts.notes, info_);
    take_scale(facts, choice);
    if (info_.frame_rate == 0) info_.frame_rate = facts.frame_rate;
    if (info_.integration == 0) info_.integration = facts.integration;
    take_times(facts, choice);
    if (facts.no_rate < 0 && info_.frame_rate == 0 && info_.time.empty() && !choice.frame_rate)
      refuse(bytes_->name(),
             "states a frame rate of {:g} Hz, which is none; give the right one ({}, frame_rate in [film] of a recipe)",
             facts.no_rate, option("frame-rate"));
    take_choice(info_, choice);
  }

  /// What pixels are, as netCDF writes it.
  void take_scale(const Hdf5Facts& facts, const FilmChoice& choice) {
    const auto zero = zero_of_temperatures(facts.unit);
    numbers_ = facts.numbers;
    layout_.scale = numbers_.scale;
    layout_.shift = numbers_.offset + (choice.gives_temperatures() ? 0 : zero.value_or(0));
    layout_.scaled = layout_.scale != 1 || layout_.shift != 0 || numbers_.may_miss();
    if (layout_.scaled) info_.floating = true, info_.bits = 0;
    if (zero) info_.quantity = FilmQuantity::kelvin;
    else if (!facts.unit.empty()) info_.remarks.push_back(fmt::format("Its pixels are in \"{}\".", facts.unit));
  }

  void take_times(const Hdf5Facts& facts, const FilmChoice& choice) {
    const auto seconds = seconds_of(facts.time_unit.substr(0, facts.time_unit.find(' ')));  // "seconds since .."
    std::vector<double> time;
    if (seconds) time = facts.time;
    else if (!facts.time.empty())
      info_.remarks.push_back(
          fmt::format("Its times are in \"{}\", a unit that is not known; they are left aside.", facts.time_unit));
    const double first = time.empty() ? 0 : time.front();
    for (double& t : time) t = (t - first) * *seconds;
    const bool stamped = !time.empty();
    take_stamps_and_numbers(info_, std::move(time), facts.number, choice.frame_rate.has_value());
    if (stamped) info_.start = first * *seconds;
  }

  /// Numbers that stand for none.
  void forget_missing(const std::string& stored, std::size_t count, float* value) const {
    each_number(layout_.pixel, layout_.big_endian, stored.data(), count, [&](std::size_t i, auto v) {
      if (numbers_.is_missing(static_cast<double>(v))) value[i] = std::numeric_limits<float>::quiet_NaN();
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

  /// Slabs along the first stored axis, as they are stored.
  std::string slabs(hsize_t first, hsize_t count, std::size_t size) const {
    std::string stored = in_sandbox(
        bytes_->name(), [&] { return frames(first, count); }, size, room());
    if (stored.size() != size) refuse_damaged_hdf5(bytes_);
    return stored;
  }

  /// A film whose frames are not its first axis lies nowhere in one piece, so it is read as a whole and turned.
  void turn_all(const std::vector<std::int64_t>& axis) {
    const std::size_t number = bytes_of(layout_.pixel);
    const std::size_t length[] = {static_cast<std::size_t>(info_.frames), static_cast<std::size_t>(info_.height),
                                  static_cast<std::size_t>(info_.width)};
    const double bytes = static_cast<double>(length[0]) * static_cast<double>(info_.pixels() * number);
    if (bytes > most_turned)
      refuse(bytes_->name(),
             "holds a film of {:.0f} MB whose frames are not its first axis; store it as time x rows x columns",
             bytes / 1e6);
    std::size_t stored[3], step[3];  // of the stored axes; then of frames, rows and columns
    for (std::size_t role = 0; role < 3; ++role) stored[static_cast<std::size_t>(axis[role])] = length[role];
    const std::size_t stride[] = {stored[1] * stored[2], stored[2], 1};
    for (std::size_t role = 0; role < 3; ++role) step[role] = stride[static_cast<std::size_t>(axis[role])];
    const std::string all = slabs(0, stored[0], static_cast<std::size_t>(bytes));
    turned_.resize(all.size());
    char* to = turned_.data();
    for (std::size_t f = 0; f < length[0]; ++f)
      for (std::size_t y = 0; y < length[1]; ++y)
        for (std::size_t x = 0; x < length[2]; ++x, to += number)
          std::memcpy(to, all.data() + (f * step[0] + y * step[1] + x * step[2]) * number, number);
  }

  /// In the process of its own.
  std::string frames(hsize_t first, hsize_t count) const {
    const auto file = open_foreign(bytes_);
    std::string stored;
    Hdf5Numbers(find_hdf5_film(file, bytes_, name_).set, name_, bytes_, most_).read(first, count, stored);
    return stored;
  }

  Bytes bytes_;
  double most_;
  std::string name_;
  PlainLayout layout_;
  bool by_columns_ = false;
  std::string turned_;  ///< the whole film, where its frames are not its first axis
  NumbersStated numbers_;
};

}  // namespace

/// HDF5: a dataset of frames x height x width, perhaps with times beside it and attributes.
const FilmFormat films::hdf5{
    .name = "hdf5",
    .sentence = "HDF5",
    .states =
        {{"times of frames beside the film or as an attribute (time, timestamps, t, frame_times, acquisition_time ..)",
          "used, in the unit of units, unit or the name (time_ms); told where the unit is unknown or not stated, or "
          "where there are not as many as frames"},
         {"numbers of frames likewise (frame_number, frame_index, frame_id, frame, index, image_number ..)",
          "numbers that are missing give gaps in time where there are no times"},
         {"mask, valid, bad_pixels beside the film", "told, not used"},
         {"frame_rate, frame_rate_Hz, fps, integration", "used, as attributes or as arrays of one number"},
         {"a frame rate below 0", "refused where nothing else states times and no rate is given"},
         {"frame_interval, frame_interval_s, frame_interval_ms, dt",
          "used, as attributes; rates and intervals may be texts, \"30 Hz\""},
         {"MATLAB_class (MATLAB, save -v7.3)", "axes are taken as height x width x frames"},
         {"scale_factor, add_offset, units (unit) of netCDF",
          "pixels become numbers in that unit, degrees Celsius become kelvin"},
         {"_FillValue, missing_value, what lies beyond valid_min, valid_max or valid_range; chunks never written",
          "no numbers"},
         {"names of axes (axistags of ilastik, DIMENSION_LABELS, dimension scales of netCDF and xarray)",
          "time, y, x and the like say which axis is which, whatever their order; names that are not known are told, "
          "two axes of one kind are refused"},
         {"groups nested more than 64 deep", "not searched"},
         {"frames of NaN, of one number, or the frame before once more", "left out as lost, and named"}},

    .endings = {".h5", ".hdf5"},
    .marked = true,
    .has_datasets = true,
    .is = is_hdf5,
    .open = [](const Bytes& bytes, const FilmChoice& choice) -> FilmPointer {
      return std::make_unique<Hdf5Film>(bytes, choice);
    },
    .create = [](const auto& path, const FilmInfo& info) { return create_plain_film(path, info, {hdf5_header}); }};

}  // namespace arenite::io
