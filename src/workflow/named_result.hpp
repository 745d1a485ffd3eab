#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "model/field_result.hpp"
#include "model/packing.hpp"

namespace arenite::study {

/// The last state of the stage of that name in a run's folder; none if no stage has it.
std::optional<Packing> last_state(const std::filesystem::path& result, const std::string& stage);

/// The load of that name, where the run went on to nodes; none if no load has it.
std::optional<FieldResult> load_named(const std::filesystem::path& result, const std::string& name);

/// The sentence for a name that is not there, with the names of the stages that are.
[[noreturn]] void refuse_stage(const std::filesystem::path& result, const std::string& name);

}  // namespace arenite::study
