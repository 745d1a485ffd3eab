#pragma once
#include <cmath>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"

namespace arenite::test {

/// The data of a written page but for its arrays by node, unpacked by Python.
inline nlohmann::json document_of_page(const std::filesystem::path& page) {
  const auto unpacked = shell(
      "/usr/bin/python3 -c \"import base64, re, zlib; "
      "print(zlib.decompress(base64.b64decode(re.search('id=.document.>([^<]*)', open('" +
      page.string() + "').read()).group(1))).decode())\"");
  return nlohmann::json::parse(unpacked.out);
}

/// A number of the key below a field's densities of stress, as the page has it in words: of a set, by its sign ("var").
inline std::string number_in_key(const nlohmann::json& field, const std::string& set, const std::string& sign) {
  for (const auto& entry : field["figures"]["stress-pdf"][0]["key"])
    if (entry["name"] == set)
      for (const auto& number : entry["numbers"])
        if (number[0] == sign) return number[1].get<std::string>();
  return {};
}

/// Half a unit of the last digit of a number in words.
inline double half_digit(const std::string& number) {
  const auto point = number.find('.');
  return 0.5 * std::pow(10.0, point == std::string::npos ? 0.0 : static_cast<double>(point) + 1 - std::ssize(number));
}

}  // namespace arenite::test
