#include "workflow/named_result.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "core/error.hpp"
#include "io/field_file.hpp"
#include "io/run_folder.hpp"
#include "io/sealed_file.hpp"
#include "io/stage_file.hpp"

namespace arenite::study {
namespace fs = std::filesystem;

std::optional<Packing> last_state(const fs::path& result, const std::string& stage) {
  for (const auto& file : io::stage_files(result)) {
    if (io::sealed_kind(file) != "result") continue;
    auto read = io::read_stage(file);
    if (read.name == stage && !read.frames.empty()) return std::move(read.frames.back().packing);
  }
  return std::nullopt;
}

std::optional<FieldResult> load_named(const fs::path& result, const std::string& name) {
  for (const auto& file : io::stage_files(result)) {
    if (io::sealed_kind(file) != "field") continue;
    auto field = io::read_field(file);
    if (field.name == name) return field;
  }
  return std::nullopt;
}

void refuse_stage(const fs::path& result, const std::string& name) {
  std::set<std::string> names;
  for (const auto& file : io::stage_files(result)) {
    if (io::sealed_kind(file) != "result") continue;
    const auto stage = io::read_stage(file);
    if (!stage.frames.empty()) names.insert(stage.name);
  }
  if (names.empty()) throw InputError(result.string(), 0, "holds no simulated states; give the folder of an `arenite run`");
  throw InputError(result.string(), 0, fmt::format("has no stage \"{}\"; those there are: {}", name, fmt::join(names, ", ")));
}

}  // namespace arenite::study
