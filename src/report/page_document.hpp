#pragma once
#include <string>

#include "report/page.hpp"

namespace arenite::report {

/// The data of a page: a JSON text in which arrays of numbers by grain or contact are {"at": byte, "n": count, "as": type}
/// into the block `numbers` (NumberBlock::text).
struct PageDocument {
  std::string json;
  std::string numbers;
};

PageDocument page_document(const PageData& data);

}  // namespace arenite::report
