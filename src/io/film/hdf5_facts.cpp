#include "io/film/hdf5_facts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "io/film/formats.hpp"
#include "io/film/hdf5_times.hpp"
#include "io/hdf5/axes.hpp"
#include "io/stated_units.hpp"

namespace arenite::io {
namespace {

bool can_be_film(hid_t set) { return shape_of(set).size() == 3 && holds_numbers(set); }

/// Frames a second, 0 where none are stated: as a rate or an interval, in Hz and s or, in a text, in its own unit.
constexpr std::initializer_list<const char*> names_of_rate{"frame_rate", "frame_rate_Hz", "fps"};

double stated_rate(hid_t at, Hdf5Facts& facts) {
  if (const double rate = number_attribute(at, names_of_rate); rate > 0) return rate;
  if (const double interval = number_attribute(at, {"frame_interval", "frame_interval_s", "dt"}); interval > 0)
    return 1 / interval;
  if (const double interval = number_attribute(at, {"frame_interval_ms"}); interval > 0) return 1e3 / interval;
  for (const auto& [name, alone] :
       {std::pair("frame_rate", dimension::frequency), std::pair("fps", dimension::frequency),
        std::pair("frame_interval", dimension::time), std::pair("dt", dimension::time)}) {
    const std::string text = text_attribute(at, name);
    if (trimmed(text).empty()) continue;
    if (const auto rate = frames_per_second(text, alone)) return *rate;
    facts.times += fmt::format("It states {} = \"{}\", which is not understood and left aside.\n", name, text);
  }
  return 0;
}

/// The rate that MATLAB keeps as an array of one beside the film.
void look_for_rate(hid_t file, const Bytes& bytes, Hdf5Facts& facts) {
  const std::string group = facts.name.substr(0, facts.name.rfind('/') + 1);
  for (const char* name : names_of_rate)
    if (const auto rate = numbers_beside(file, bytes, group + name, 1);
        facts.frame_rate == 0 && !rate.empty() && rate[0] > 0)
      facts.frame_rate = rate[0];
}

/// The unit of pixels: of the dataset, or of the whole file, which is told.
void take_unit(hid_t set, hid_t file, Hdf5Facts& facts) {
  for (const hid_t at : {set, file})
    for (const char* name : {"units", "unit"}) {
      if (!facts.unit.empty()) return;
      facts.unit = text_attribute(at, name);
      if (at == file && !facts.unit.empty())
        facts.times += fmt::format("The file states the unit \"{}\", which is taken for its pixels.\n", facts.unit);
    }
}

/// By their names; an array of MATLAB, which lists its axes from the last to the first, lies column by column.
void take_axes(hid_t set, const Bytes& bytes, Hdf5Facts& facts) {
  const auto stored = shape_of(set);
  const AxisOrder order = order_by_names(names_of_axes(set), bytes->name(), facts.name);
  facts.by_matlab = is_of_matlab(set) && order.remark.empty();
  facts.axes = order.remark;
  facts.axis.assign(order.axis.begin(), order.axis.end());
  if (facts.by_matlab) facts.axis = {0, 2, 1};
  facts.shape = mapped(facts.axis, [&](std::int64_t axis) { return stored[static_cast<std::size_t>(axis)]; });
}

}  // namespace

void refuse_damaged_hdf5(const Bytes& bytes) {
  refuse(bytes->name(), "is an HDF5 file that is cut short or damaged; copy it again");
}

double most_in_chunk(const FilmChoice& choice) { return std::max(2.0 * static_cast<double>(choice.most_pixels), 1e6); }

FoundDataset find_hdf5_film(const Hdf5Handle& file, const Bytes& bytes, const std::string& name) {
  return find_dataset(*file, bytes->name(), name, can_be_film, "numbers over frames x height x width");
}

Hdf5Facts look_at_hdf5_film(const Bytes& bytes, const FilmChoice& choice) {
  Hdf5Facts facts;
  const auto file = open_foreign(bytes);
  const auto [name, set] = find_hdf5_film(file, bytes, choice.dataset);
  facts.name = name;
  take_axes(*set, bytes, facts);
  check_film_size(bytes->name(), facts.shape[2], facts.shape[1], facts.shape[0], choice);
  const Hdf5Numbers numbers(set, facts.name, bytes, most_in_chunk(choice));
  facts.pixel = numbers.number().type;
  facts.big_endian = numbers.number().big_endian;
  facts.notes = text_attribute(*set, "notes");
  take_unit(*set, *file, facts);
  for (const hid_t at : {static_cast<hid_t>(*set), static_cast<hid_t>(*file)}) {
    if (facts.frame_rate == 0) facts.frame_rate = stated_rate(at, facts);
    for (const char* key : names_of_rate) facts.no_rate = std::min(facts.no_rate, stated_number(at, key).value_or(0));
    if (facts.integration == 0) facts.integration = number_attribute(at, {"integration", "integration_s"});
  }
  facts.numbers = numbers_stated(*set, facts.pixel);
  look_for_rate(*file, bytes, facts);
  look_for_times(*file, *set, bytes, facts);
  return facts;
}

}  // namespace arenite::io
