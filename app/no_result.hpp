#pragma once
#include <string>

namespace arenite::app {

/// Throws InputError with what stands at `path`, and the command for it, where that is plainly no result: a recipe, the
/// folder of a study or of maps, a study that comes with the program, a folder without results. Films pass.
void refuse_no_result(const std::string& path);
/// As that, but a study's folder passes.
void refuse_neither_result_nor_study(const std::string& path);

}  // namespace arenite::app
