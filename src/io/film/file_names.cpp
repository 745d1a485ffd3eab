#include "io/film/file_names.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "core/mapped.hpp"
#include "io/table/table.hpp"

namespace arenite::io {

namespace fs = std::filesystem;
namespace {

constexpr const char* digits_of_names = "0123456789";

/// A name parted into its numbers and what stands between them.
struct NameParts {
  std::vector<std::string> words, numbers;  ///< a word before each number and one behind the last, maybe empty
  explicit NameParts(const std::string& name) {
    for (std::size_t at = 0; at <= name.size();) {
      const std::size_t number = std::min(name.find_first_of(digits_of_names, at), name.size()),
                        end = std::min(name.find_first_not_of(digits_of_names, number), name.size());
      words.push_back(name.substr(at, number - at));
      if (number == name.size()) return;
      numbers.push_back(name.substr(number, end - number));
      at = end;
    }
  }
};

std::vector<NameParts> parts_of(const std::vector<fs::path>& files) {
  return mapped(files, [](const fs::path& file) { return NameParts(file.filename().string()); });
}

/// Which numbers differ from name to name; nothing where the words do.
std::vector<std::size_t> differing(const std::vector<NameParts>& parts) {
  const NameParts& first = parts.front();
  if (!std::ranges::all_of(parts, [&](const NameParts& p) { return p.words == first.words; })) return {};
  std::vector<std::size_t> differ;
  for (std::size_t k = 0; k < first.numbers.size(); ++k)
    if (std::ranges::any_of(parts, [&](const NameParts& p) { return p.numbers[k] != first.numbers[k]; }))
      differ.push_back(k);
  return differ;
}

/// Where a date and time stands among the numbers of a name.
struct DateTime {
  std::size_t first = 0, end = 0;  ///< of year to second
  std::int64_t second = 0;         ///< since 1970
};

/// Of the fourteen digits yyyymmddhhmmss.
std::optional<std::int64_t> second_of(std::string_view text) {
  const auto number = [&](std::size_t at, std::size_t count) {
    return static_cast<int>(to_integer(text.substr(at, count)).value_or(-1));
  };
  const auto part = [&](std::size_t at) { return static_cast<unsigned>(number(at, 2)); };
  const std::chrono::year_month_day day{std::chrono::year(number(0, 4)), std::chrono::month(part(4)),
                                        std::chrono::day(part(6))};
  const int hour = number(8, 2), minute = number(10, 2), second = number(12, 2);
  if (!day.ok() || number(0, 4) < 1900 || number(0, 4) > 2200 || hour > 23 || minute > 59 || second > 60)
    return std::nullopt;
  const auto days = std::chrono::sys_days(day).time_since_epoch().count();
  return ((static_cast<std::int64_t>(days) * 24 + hour) * 60 + minute) * 60 + second;
}

/// Numbers of 4, 2, 2, 2, 2 and 2 digits, with neighbours written as one, a character or two between them.
std::optional<DateTime> date_time_of(const NameParts& name) {
  for (std::size_t first = 0; first < name.numbers.size(); ++first) {
    std::string all;
    for (std::size_t k = first; k < name.numbers.size() && all.size() < 14; ++k) {
      if (k > first && name.words[k].size() > 2) break;
      all += name.numbers[k];
      const bool ends_a_part = all.size() == 4 || (all.size() > 4 && all.size() % 2 == 0);
      if (!ends_a_part || all.size() > 14) break;
      if (all.size() < 14) continue;
      if (const auto second = second_of(all)) return DateTime{first, k + 1, *second};
    }
  }
  return std::nullopt;
}

/// Whether the numbers behind the seconds are fractions of them, as many digits in every name, of milli- or
/// microseconds where no point says so: what rises by one from file to file, or begins anew before half a second is
/// over, counts.
bool is_fraction(const std::vector<NameParts>& parts, std::size_t at) {
  const std::string &word = parts.front().words[at], &digits = parts.front().numbers[at];
  const bool has_point = word == "." || word == ",", is_plain = digits.size() == 3 || digits.size() == 6;
  if (!has_point && !((word == "-" || word == "_") && is_plain)) return false;
  bool counts = true;
  char most = '0';
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string& number = parts[i].numbers[at];
    if (number.size() != digits.size()) return false;
    most = std::max(most, number.front());
    counts = counts && (i == 0 || to_integer(number) == to_integer(parts[i - 1].numbers[at]).value_or(0) + 1);
  }
  const auto begin = date_time_of(parts.front()), end = date_time_of(parts.back());
  const bool is_long = begin && end && end->second > begin->second + 1;
  return !counts && (most >= '5' || !is_long);
}

}  // namespace

std::string sorting_key(const std::string& name) {
  constexpr std::size_t most_digits = 255;  // no name is longer
  const NameParts parts(name);
  std::string key;
  for (std::size_t k = 0; k < parts.numbers.size(); ++k) {
    const std::string& number = parts.numbers[k];
    const std::size_t zeros = std::min(number.find_first_not_of('0'), number.size());
    key += parts.words[k] + std::string(most_digits - (number.size() - zeros), '0') + number.substr(zeros);
  }
  return key + parts.words.back();
}

std::vector<std::int64_t> numbers_in_names(const std::vector<fs::path>& files) {
  const auto parts = parts_of(files);
  const auto differ = differing(parts);
  if (differ.size() != 1) return {};
  std::vector<std::int64_t> numbers;
  for (const NameParts& p : parts) {
    const auto number = to_integer(p.numbers[differ.front()]);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::vector<double> times_in_names(const std::vector<fs::path>& files) {
  const auto parts = parts_of(files);
  const auto differ = differing(parts);
  const auto first = date_time_of(parts.front());
  if (!first || differ.empty() || files.size() < 2) return {};
  std::size_t end = first->end;
  const NameParts& name = parts.front();
  const bool has_fraction = end < name.numbers.size() && is_fraction(parts, end);
  end += has_fraction ? 1 : 0;
  if (differ.front() < first->first || differ.back() >= end) return {};
  std::vector<double> times;
  for (const NameParts& p : parts) {
    const auto at = date_time_of(p);
    if (!at || at->first != first->first || at->end != first->end) return {};
    const std::string fraction = has_fraction ? p.numbers[end - 1] : "";
    times.push_back(static_cast<double>(at->second - first->second) + to_number("0." + fraction + "0").value_or(0));
  }
  const double start = times.front();
  for (double& time : times) time -= start;
  return std::ranges::adjacent_find(times, std::greater_equal()) == times.end() ? times : std::vector<double>{};
}

}  // namespace arenite::io
