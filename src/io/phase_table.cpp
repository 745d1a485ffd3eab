#include "io/phase_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/error.hpp"
#include "core/nearest.hpp"

namespace arenite::io {
namespace {

constexpr std::string_view names[] = {"void", "matrix", "particle"};
constexpr std::string_view form = "write for example \"0=void,128=matrix,255=particle\"";

using Counts = std::map<std::int32_t, std::size_t>;

Counts count_values(const Image& image) {
  Counts counts;
  for (std::size_t i = 0; i < image.value.size();) {
    std::size_t end = i + 1;
    while (end < image.value.size() && image.value[end] == image.value[i]) ++end;
    counts[image.value[i]] += end - i;
    i = end;
  }
  return counts;
}

/// "0 (44.9 %), 85 (40.1 %)", at most eight values.
std::string listed(const Counts& counts, std::size_t total) {
  constexpr int most = 8;
  std::string text;
  int shown = 0;
  for (const auto& [value, count] : counts) {
    if (shown++ == most) return text + fmt::format(" and {} more", counts.size() - most);
    text += fmt::format("{}{} ({:.3g} %)", text.empty() ? "" : ", ", value,
                        100 * static_cast<double>(count) / static_cast<double>(total));
  }
  return text;
}

/// A table that could be meant: the lowest value void, the highest particle, those between matrix.
std::string proposal(const Counts& counts) {
  std::string text;
  for (auto it = counts.begin(); it != counts.end(); ++it)
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", it->first,
                        it == counts.begin() ? "void" : std::next(it) == counts.end() ? "particle" : "matrix");
  return text;
}

PhaseTable guess(const Counts& counts, std::size_t total, const std::string& file, std::vector<std::string>& notes) {
  if (counts.size() == 1)
    throw InputError(file, 0, fmt::format("has the value {} everywhere: nothing tells particles from void; give a picture of at least "
                                          "two values", counts.begin()->first));
  constexpr std::size_t too_many = 8;
  if (counts.size() > too_many)
    throw InputError(file, 0, fmt::format("has {} values, {}: no phase map; a photograph must be segmented first, and grain labels are "
                                          "given with --labels beside a phase map", counts.size(), listed(counts, total)));
  if (counts.size() > 2)
    throw InputError(file, 0, fmt::format("has the values {}; say which phase each is, for example with --phases {}",
                                          listed(counts, total), proposal(counts)));
  notes.push_back(fmt::format("Values {}: the lower was taken as void, the higher as particle.", listed(counts, total)));
  return {{counts.begin()->first, Phase::empty}, {counts.rbegin()->first, Phase::particle}};
}

void refuse_unknown(const Counts& counts, const PhaseTable& table, std::size_t total, const std::string& file) {
  Counts unknown;
  for (const auto& [value, count] : counts)
    if (!table.contains(value)) unknown[value] = count;
  if (!unknown.empty())
    throw InputError(file, 0, fmt::format("has values whose phase is not given: {}; add them to --phases, or save the picture without "
                                          "smoothing", listed(unknown, total)));
}

void refuse_one_phase(const Counts& counts, const PhaseTable& table, bool several_grains, const std::string& file) {
  const Phase first = table.at(counts.begin()->first);
  if (std::any_of(counts.begin(), counts.end(), [&](const auto& c) { return table.at(c.first) != first; })) return;
  if (first == Phase::particle && several_grains) return;
  throw InputError(file, 0, fmt::format("is {} everywhere; give a map of at least two phases", name_of(first)));
}

}  // namespace

std::string_view name_of(Phase phase) { return names[static_cast<std::size_t>(phase)]; }

PhaseTable parse_phase_table(std::string_view text) {
  PhaseTable table;
  while (!text.empty()) {
    const std::string_view row = text.substr(0, text.find(','));
    text.remove_prefix(std::min(text.size(), row.size() + 1));
    const std::size_t at = row.find('=');
    std::int32_t value = 0;
    const auto number = row.substr(0, at);
    const auto end = std::from_chars(number.data(), number.data() + number.size(), value);
    if (at == std::string_view::npos || end.ec != std::errc{} || end.ptr != number.data() + number.size())
      throw InputError(fmt::format("\"{}\" says no phase of a value; {}", row, form));
    const std::string name(row.substr(at + 1));
    const auto* found = std::find(std::begin(names), std::end(names), name);
    if (found == std::end(names)) {
      const std::string near = nearest(name, {std::begin(names), std::end(names)});
      throw InputError(fmt::format("\"{}\" is no phase{}; phases are void, matrix and particle", name,
                                   near.empty() ? "" : "; did you mean \"" + near + "\"?"));
    }
    if (!table.emplace(value, static_cast<Phase>(found - std::begin(names))).second)
      throw InputError(fmt::format("the value {} is given a phase twice; leave one of them out", value));
  }
  if (table.empty()) throw InputError(fmt::format("no phase of any value is given; {}", form));
  return table;
}

std::vector<Phase> assign_phases(const Image& image, const PhaseTable& given, bool several_grains, const std::string& file,
                                 std::vector<std::string>& notes) {
  const Counts counts = count_values(image);
  if (counts.empty()) throw InputError(file, 0, "holds no pixels; give a picture with at least one");
  const PhaseTable table = given.empty() ? guess(counts, image.size(), file, notes) : given;
  refuse_unknown(counts, table, image.size(), file);
  refuse_one_phase(counts, table, several_grains, file);
  std::vector<Phase> phases(image.value.size());
  std::int32_t last = counts.begin()->first;
  Phase phase = table.at(last);
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (image.value[i] != last) phase = table.at(last = image.value[i]);
    phases[i] = phase;
  }
  return phases;
}

}  // namespace arenite::io
