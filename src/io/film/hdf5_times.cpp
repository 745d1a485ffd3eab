#include "io/film/hdf5_times.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "io/film/stated_times.hpp"
#include "io/hdf5/axes.hpp"
#include "io/hdf5/dataset_search.hpp"

namespace arenite::io {
namespace {

/// Numbers of which a name says that they are of the frames.
struct OfFrames {
  std::string name, unit;
  std::vector<double> value;  ///< empty where there is not one for each frame
};

constexpr std::int64_t most_frames = 100'000'000;

std::string leaf_of(const std::string& dataset) { return dataset.substr(dataset.rfind('/') + 1); }

bool is_no_film(hid_t set) { return shape_of(set).size() < 3; }
bool is_picture_or_film(hid_t set) { return shape_of(set).size() == 2 || shape_of(set).size() == 3; }

/// Names of the datasets that are in the group of the film, without it.
std::vector<std::string> datasets_beside(hid_t file, const std::string& film, bool (*fits)(hid_t)) {
  std::vector<std::string> names = datasets_in(file, fits);
  const std::string path = film.substr(std::min(film.find_first_not_of('/'), film.size())),
                    group = path.substr(0, path.rfind('/') + 1);
  const auto is_elsewhere = [&](const std::string& name) { return name.substr(0, name.rfind('/') + 1) != group; };
  std::erase_if(names, [&](const std::string& name) { return name == path || is_elsewhere(name); });
  return names;
}

std::vector<std::string> attributes_of(hid_t at) {
  std::vector<std::string> names;
  std::array<char, 256> name{};
  const auto next = [&] {
    const hsize_t place = names.size();
    return H5Aget_name_by_idx(at, ".", H5_INDEX_NAME, H5_ITER_INC, place, name.data(), name.size(), H5P_DEFAULT) > 0;
  };
  while (next()) names.emplace_back(name.data());
  return names;
}

std::string stated_unit(hid_t at) {
  const std::string units = text_attribute(at, "units");
  return units.empty() ? text_attribute(at, "unit") : units;
}

/// Everything whose name `is` takes, datasets first. One number alone, where there are more frames, is of the film.
template <class Is>
std::vector<OfFrames> stated_of_frames(hid_t file, hid_t set, const Bytes& bytes, const Hdf5Facts& facts, Is&& is) {
  std::vector<OfFrames> found;
  for (const std::string& name : datasets_beside(file, facts.name, is_no_film)) {
    if (!is(leaf_of(name))) continue;
    const auto open = own(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (!open || is_only_a_length(*open)) continue;
    found.push_back({leaf_of(name), stated_unit(*open), numbers_beside(file, bytes, name, facts.shape[0])});
  }
  for (const hid_t at : {set, file})
    for (const std::string& name : attributes_of(at)) {
      if (!is(name)) continue;
      std::vector<double> value = stated_numbers(at, name.c_str(), static_cast<std::size_t>(most_frames)).value;
      if (value.empty() || (value.size() == 1 && facts.shape[0] > 1)) continue;
      if (static_cast<std::int64_t>(value.size()) != facts.shape[0]) value.clear();
      found.push_back({name, "", std::move(value)});
    }
  return found;
}

void tell(Hdf5Facts& facts, const std::string& sentence) { facts.times += sentence + "\n"; }

/// The first that has a number for each frame; the others are told.
OfFrames first_whole(const std::vector<OfFrames>& found, Hdf5Facts& facts) {
  OfFrames taken;
  for (const OfFrames& each : found) {
    if (each.value.empty())
      tell(facts, fmt::format("Its \"{}\" are not a number for each of the {} frames; they are left aside.", each.name,
                              facts.shape[0]));
    else if (taken.value.empty()) taken = each;
    else tell(facts, fmt::format("Its \"{}\" are left aside beside \"{}\".", each.name, taken.name));
  }
  return taken;
}

/// Of times without one: that in which frames are as far apart as the frame rate says, or else seconds.
std::string unit_by_rate(const std::vector<double>& time, double rate) {
  std::vector<double> step;
  for (std::size_t i = 1; i < time.size(); ++i) step.push_back(time[i] - time[i - 1]);
  if (step.empty() || !(rate > 0)) return "s";
  const auto middle = step.begin() + static_cast<std::ptrdiff_t>((step.size() - 1) / 2);  // of two the smaller
  std::nth_element(step.begin(), middle, step.end());
  const double frames = *middle * rate;
  for (const auto& [unit, seconds] : {std::pair{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}})
    if (std::abs(frames * seconds - 1) < 0.1) return unit;
  return "s";
}

void take_times(OfFrames times, Hdf5Facts& facts) {
  if (times.value.empty()) return;
  facts.time_unit = times.unit.empty() ? unit_of_time_name(times.name).value_or("") : times.unit;
  if (facts.time_unit.empty()) {
    facts.time_unit = unit_by_rate(times.value, facts.frame_rate);
    tell(facts, facts.time_unit == "s"
                    ? fmt::format("Its \"{}\" state no unit; seconds are taken.", times.name)
                    : fmt::format("Its \"{}\" state no unit; {} are taken, which fit the frame rate.", times.name,
                                  facts.time_unit));
  }
  facts.time = std::move(times.value);
}

void take_frame_numbers(const OfFrames& numbers, Hdf5Facts& facts) {
  constexpr double most = 1e15;  // beyond it doubles skip whole numbers
  const auto is_number = [](double n) { return std::abs(n) < most && std::trunc(n) == n; };
  if (!std::ranges::all_of(numbers.value, is_number))
    return tell(facts, fmt::format("Its \"{}\" are not all whole numbers; they are left aside.", numbers.name));
  facts.number.assign(numbers.value.begin(), numbers.value.end());
}

/// Files do not agree on whether 1 in a mask stands for what is good or for what is not.
void tell_masks(hid_t file, Hdf5Facts& facts) {
  for (const std::string& name : datasets_beside(file, facts.name, is_picture_or_film)) {
    const std::string leaf = lower_case(leaf_of(name));
    if (leaf == "mask" || leaf == "masks" || leaf == "valid" || leaf == "bad_pixels")
      tell(facts, fmt::format("Its \"{}\" is left aside; store NaN in the frames where they hold no valid number.",
                              leaf_of(name)));
  }
}

}  // namespace

std::vector<double> numbers_beside(hid_t file, const Bytes& bytes, const std::string& name, std::int64_t count) {
  const auto set = own(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  const auto shape = set ? shape_of(*set) : std::vector<std::int64_t>();
  using Shape = std::vector<std::int64_t>;
  // MATLAB's lines have a second length, 1.
  if (shape != Shape{count} && shape != Shape{1, count} && shape != Shape{count, 1}) return {};
  if (count > most_frames || !holds_numbers(*set)) return {};
  Hdf5Numbers numbers(set, name, bytes, 1e8);
  std::string stored;
  numbers.read(0, static_cast<hsize_t>(shape.front()), stored);
  std::vector<double> values(static_cast<std::size_t>(count));
  each_number(numbers.number().type, numbers.number().big_endian, stored.data(), values.size(),
              [&](std::size_t i, auto v) { values[i] = static_cast<double>(v); });
  return values;
}

void look_for_times(hid_t file, hid_t set, const Bytes& bytes, Hdf5Facts& facts) {
  const auto is_time = [](const std::string& name) { return unit_of_time_name(name).has_value(); };
  auto times = stated_of_frames(file, set, bytes, facts, is_time);
  // Of several the shortest name is the plainest: "time" before "time_ms" and "timestamps".
  std::ranges::stable_sort(times, {}, [](const OfFrames& each) { return each.name.size(); });
  take_times(first_whole(times, facts), facts);
  take_frame_numbers(first_whole(stated_of_frames(file, set, bytes, facts, names_array_of_numbers), facts), facts);
  tell_masks(file, facts);
}

}  // namespace arenite::io
