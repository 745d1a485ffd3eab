#pragma once
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "campaign/collect.hpp"

namespace arenite::validation {

/// Normal noise of variance 1 that numbers give, always the same: twelve even numbers less six.
inline double noise(std::initializer_list<double> of) {
  std::uint64_t state = 1;
  const auto next = [&state] {
    state += 0x9e3779b97f4a7c15u;
    std::uint64_t x = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
  };
  for (const double number : of) {
    std::uint64_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    state = next() ^ bits;
  }
  double sum = -6;
  for (int k = 0; k < 12; ++k) sum += static_cast<double>(next() >> 11) * 0x1p-53;
  return sum;
}

/// A run of a made-up study: swept values and numbers.
struct MadeUpRun {
  std::vector<std::string> values;
  std::vector<double> numbers;
  std::string status = "done";
};

inline campaign::CollectedTable made_up_table(const std::vector<std::string>& keys,
                                              const std::vector<std::string>& names,
                                              const std::vector<MadeUpRun>& runs) {
  campaign::CollectedTable table;
  for (const auto& key : keys) table.keys.push_back({key, ""});
  table.names = names;
  for (const auto& run : runs) {
    campaign::CollectedTable::Row row;
    row.status = run.status;
    row.values = run.values;
    for (std::size_t k = 0; k < names.size(); ++k)
      row.numbers.push_back(k < run.numbers.size() ? campaign::Estimate{run.numbers[k]} : campaign::Estimate());
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace arenite::validation
