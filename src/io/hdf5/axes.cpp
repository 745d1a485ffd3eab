#include "io/hdf5/axes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <utility>

#include "core/problems.hpp"
#include "core/text.hpp"

namespace arenite::io {
namespace {

/// What netCDF writes as the name of a scale that only counts; its dimension is called as the scale is.
constexpr std::string_view only_counts = "This is a netCDF dimension";

std::string name_of_scale(const Hdf5Handle& scale) {
  if (!scale) return {};
  std::string name = text_attribute(*scale, "NAME");
  if (!name.empty() && !name.starts_with(only_counts)) return name;
  std::array<char, 1024> path{};
  if (H5Iget_name(*scale, path.data(), path.size()) <= 0) return {};
  const std::string whole = path.data();
  return whole.substr(whole.rfind('/') + 1);
}

/// JSON, {"axes": [{"key": "z", ..}, ..]} in the order in which the axes are stored; nothing unless there is one for
/// each.
std::vector<std::string> keys_of_tags(hid_t set, std::size_t rank) {
  const std::string tags = text_attribute(set, "axistags");
  std::vector<std::string> keys;
  constexpr std::string_view key = "\"key\"";
  for (std::size_t at = 0; (at = tags.find(key, at)) != std::string::npos;) {
    const std::size_t from = tags.find('"', at += key.size()), to = tags.find('"', from + 1);
    if (from == std::string::npos || to == std::string::npos) return {};
    keys.push_back(tags.substr(from + 1, to - from - 1));
  }
  return keys.size() == rank ? keys : std::vector<std::string>{};
}

/// What an axis counts; in the order in which pictures are read.
enum class AxisRole : std::size_t { picture, row, column };
constexpr const char* role_words[] = {"frames or slices", "rows", "columns"};

std::optional<AxisRole> role_of_axis(const std::string& name) {
  static constexpr std::pair<std::string_view, AxisRole> known[] = {
      {"time times t frame frames image images picture pictures page pages z depth slice slices layer layers plane "
       "planes",
       AxisRole::picture},
      {"y row rows lat latitude height line lines", AxisRole::row},
      {"x col cols column columns lon longitude width", AxisRole::column}};
  std::string word = name.substr(0, name.find_first_of(" ([,"));
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const auto& [words, role] : known)
    if (std::ranges::count(split_blanks(words), word) > 0) return role;
  return std::nullopt;
}

}  // namespace

/// DIMENSION_LIST: for every axis the references to its scales.
std::vector<Hdf5Handle> scales_of_axes(hid_t set) {
  const std::size_t rank = shape_of(set).size();
  std::vector<Hdf5Handle> scales(rank);
  if (H5Aexists(set, "DIMENSION_LIST") <= 0) return scales;
  const auto list = own(H5Aopen(set, "DIMENSION_LIST", H5P_DEFAULT), H5Aclose);
  const auto space = list ? own(H5Aget_space(*list), H5Sclose) : nullptr,
             type = list ? own(H5Aget_type(*list), H5Tclose) : nullptr;
  if (!space || !type || H5Sget_simple_extent_npoints(*space) != static_cast<hssize_t>(rank)) return scales;
  const auto item = H5Tget_class(*type) == H5T_VLEN ? own(H5Tget_super(*type), H5Tclose) : nullptr;
  if (!item || H5Tequal(*item, H5T_STD_REF_OBJ) <= 0) return scales;
  const auto references = own(H5Tvlen_create(H5T_STD_REF_OBJ), H5Tclose);
  std::vector<hvl_t> of_axis(rank);
  if (!references || H5Aread(*list, *references, of_axis.data()) < 0) return scales;
  for (std::size_t axis = 0; axis < rank; ++axis)
    if (of_axis[axis].len > 0)
      scales[axis] =
          own(H5Rdereference2(set, H5P_DEFAULT, H5R_OBJECT, static_cast<const hobj_ref_t*>(of_axis[axis].p)), H5Oclose);
  H5Dvlen_reclaim(*references, *space, H5P_DEFAULT, of_axis.data());
  return scales;
}

bool is_only_a_length(hid_t set) { return text_attribute(set, "NAME").starts_with(only_counts); }

std::vector<std::string> names_of_axes(hid_t set) {
  const std::size_t rank = shape_of(set).size();
  std::vector<std::string> names = texts_attribute(set, "DIMENSION_LABELS"), of_tags = keys_of_tags(set, rank);
  const std::vector<Hdf5Handle> scales = scales_of_axes(set);
  names.resize(rank), of_tags.resize(rank);
  for (std::size_t axis = 0; axis < rank; ++axis) {
    if (names[axis].empty()) names[axis] = of_tags[axis];
    if (names[axis].empty()) names[axis] = name_of_scale(scales[axis]);
  }
  return names;
}

AxisOrder order_by_names(const std::vector<std::string>& names, const std::string& file, const std::string& dataset) {
  const std::size_t rank = names.size(), none = rank, first_role = 3 - rank;
  AxisOrder order{std::vector<std::size_t>(rank, none), {}};
  std::vector<std::string> unknown;
  std::vector<std::size_t> left;
  for (std::size_t axis = 0; axis < rank; ++axis) {
    const auto role = role_of_axis(names[axis]);
    const auto number = static_cast<std::size_t>(role.value_or(AxisRole::picture));
    if (!role || number < first_role) {
      left.push_back(axis);
      if (!names[axis].empty()) unknown.push_back(fmt::format("\"{}\"", names[axis]));
      continue;
    }
    std::size_t& taken = order.axis[number - first_role];
    if (taken != none)
      refuse(file, "holds a dataset \"{}\" with two axes of {}, \"{}\" and \"{}\"; give each axis its own name",
             dataset, role_words[number], names[taken], names[axis]);
    taken = axis;
  }
  std::size_t next = 0;
  for (std::size_t& taken : order.axis)
    if (taken == none) taken = left[next++];
  const auto told = [&](const std::vector<std::size_t>& axes) {
    std::vector<std::string> words;
    for (const std::size_t axis : axes) words.push_back(names[axis].empty() ? "(no name)" : names[axis]);
    return fmt::format("{}", list_of(words));
  };
  if (!std::ranges::is_sorted(order.axis))
    order.remark = fmt::format("Its axes are turned, by their names, to {}.", told(order.axis));
  if (!unknown.empty())
    order.remark += fmt::format(
        "{}The name{} of its axes {} {} not known; its axes are taken as {}: {}.", order.remark.empty() ? "" : " ",
        unknown.size() > 1 ? "s" : "", list_of(unknown), unknown.size() > 1 ? "are" : "is",
        rank == 2 ? "rows and columns" : "frames (or slices), rows and columns", told(order.axis));
  return order;
}

}  // namespace arenite::io
