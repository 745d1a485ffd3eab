#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string>

#include "io/sealed_file.hpp"
#include "study/run.hpp"

// What the parts of a run share.
namespace arenite::study {

/// What `read` gives; nothing, and a notice, if its file is damaged.
template <class Read>
auto unless_damaged(const std::filesystem::path& file, const RunOptions& options, const char* instead, Read read)
    -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const io::DamagedFile&) {
    options.notice(fmt::format("{}: is empty, cut short or changed; {}", file.string(), instead));
    return std::nullopt;
  }
}

Provenance provenance_of(const Recipe& recipe, const std::string& stage, const std::string& hash, const std::string& kernel);

}  // namespace arenite::study
