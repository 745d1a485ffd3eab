#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>

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

}  // namespace arenite::test
