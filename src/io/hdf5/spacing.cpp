#include "io/hdf5/spacing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/error.hpp"
#include "io/hdf5/axes.hpp"
#include "io/hdf5/dataset_search.hpp"
#include "io/hdf5/foreign.hpp"
#include "io/hdf5/sandbox.hpp"
#include "io/stated_units.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t axes_in_space = 3;
using Sides = std::vector<double>;  // of axes as they are stored

/// element_size_um = [z, y, x] and the like, of which a picture has the last two.
std::optional<Sides> by_attribute(hid_t set, std::size_t rank, StatedSpacing& stated) {
  for (const char* word : {"element_size", "voxel_size", "pixel_size", "spacing"})
    for (const char* unit : {"um", "nm", "mm", "m", ""}) {
      const std::string name = *unit == '\0' ? word : fmt::format("{}_{}", word, unit);
      Sides sides = stated_numbers(set, name.c_str()).value;
      if (sides.size() == 1) sides.assign(rank, sides.front());
      const bool is_of_axes = sides.size() == rank || sides.size() == axes_in_space;
      if (!is_of_axes || !std::ranges::all_of(sides, [](double s) { return s > 0 && std::isfinite(s); })) continue;
      stated.by = name;
      const auto factor = in_metres(1, unit);
      if (!factor) return std::nullopt;
      sides.erase(sides.begin(), sides.end() - static_cast<std::ptrdiff_t>(rank));
      for (double& side : sides) side *= *factor;
      return sides;
    }
  return std::nullopt;
}

/// Of coordinates at equal distances, whichever way they run; 0 of others.
double step_of(const Hdf5Handle& scale, const Bytes& bytes) {
  std::string unit = text_attribute(*scale, "units");
  if (unit.empty()) unit = text_attribute(*scale, "unit");
  const auto factor = in_metres(1, unit);
  const auto shape = shape_of(*scale);
  constexpr std::int64_t most = 1 << 20;
  if (!factor || shape.size() != 1 || shape[0] < 2 || shape[0] > most || !holds_numbers(*scale)) return 0;
  Hdf5Numbers numbers(scale, "coordinates", bytes, most);
  std::string stored;
  numbers.read(0, static_cast<hsize_t>(shape[0]), stored);
  std::vector<double> place(static_cast<std::size_t>(shape[0]));
  each_number(numbers.number().type, numbers.number().big_endian, stored.data(), place.size(),
              [&](std::size_t i, auto v) { place[i] = static_cast<double>(v); });
  const double step = (place.back() - place.front()) / static_cast<double>(place.size() - 1);
  for (std::size_t i = 0; i + 1 < place.size(); ++i)
    if (!(std::abs(place[i + 1] - place[i] - step) <= 1e-3 * std::abs(step))) return 0;
  return std::abs(step) * *factor;
}

Sides by_coordinates(hid_t set, const Bytes& bytes, StatedSpacing& stated) {
  const std::vector<Hdf5Handle> scales = scales_of_axes(set);
  Sides sides(scales.size());
  for (std::size_t axis = 0; axis < scales.size(); ++axis)
    if (scales[axis]) sides[axis] = step_of(scales[axis], bytes);
  if (std::ranges::any_of(sides, [](double side) { return side > 0; })) stated.by = "coordinates";
  return sides;
}

bool is_stack(hid_t set) { return shape_of(set).size() == axes_in_space && holds_numbers(set); }
bool is_picture(hid_t set) { return is_stack(set) || (shape_of(set).size() == 2 && holds_numbers(set)); }
bool is_whole_picture(hid_t set) {
  const auto type = own(H5Dget_type(set), H5Tclose);
  return is_picture(set) && type && H5Tget_class(*type) == H5T_INTEGER;
}

/// The one that is read: of pictures one of whole numbers rather than of floating ones.
std::string name_of_dataset(hid_t file, const SpacingOf& of) {
  if (!of.dataset.empty()) return of.dataset;
  auto found = datasets_in(file, of.is_stack ? is_stack : is_whole_picture);
  if (found.empty() && !of.is_stack) found = datasets_in(file, is_picture);
  return found.size() == 1 ? found.front() : std::string();
}

StatedSpacing look(const Bytes& bytes, const SpacingOf& of) {
  StatedSpacing stated;
  const auto file = open_foreign(bytes);
  const std::string name = name_of_dataset(*file, of);
  const auto set = name.empty() ? nullptr : own(H5Dopen2(*file, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set || !is_picture(*set)) return stated;
  const std::size_t rank = shape_of(*set).size();
  const auto attribute = by_attribute(*set, rank, stated);
  const Sides sides = attribute ? *attribute : stated.by.empty() ? by_coordinates(*set, bytes, stated) : Sides(rank);
  const AxisOrder order = order_by_names(names_of_axes(*set), bytes->name(), name);
  for (std::size_t role = 0; role < rank; ++role) stated.side[axes_in_space - rank + role] = sides[order.axis[role]];
  return stated;
}

}  // namespace

StatedSpacing stated_spacing(const Bytes& bytes, const SpacingOf& of) {
  prepare_hdf5();
  const auto transfer = [](auto& archive, StatedSpacing& spacing) { archive(spacing.side), archive(spacing.by); };
  const auto work = [&] { return look(bytes, of); };
  constexpr std::size_t most = 4096;
  const std::size_t room = bytes->path() != nullptr ? 0 : 3 * static_cast<std::size_t>(bytes->size());
  try {
    StatedSpacing stated = record_from_sandbox<StatedSpacing>(bytes->name(), work, transfer, most, room);
    if (stated.side.size() == axes_in_space) return stated;
  } catch (const InputError&) {  // said by what reads the numbers
  }
  return {};
}

}  // namespace arenite::io
