#pragma once
#include <string>
#include <vector>

#include "arguments.hpp"
#include "model/film_result.hpp"
#include "workflow/run.hpp"

namespace arenite::python {

/// What a folder or a file of results holds, or what was put together in Python.
struct Result {
  std::string path, title;
  workflow::RunOutcome run;
  std::vector<FilmResult> films;
  std::vector<StageResult> companion{};  ///< stages of the simulation beside a film, which its page shows
};

/// Reads a run's folder, or one file of it.
Result open_result(const Path& path);
/// Parts that were computed one by one. `title` is that of their recipe if it is empty.
Result result_of(std::vector<StageResult> stages, std::vector<FieldResult> fields, std::vector<FilmResult> films,
                 std::vector<VoxelResult> voxels, std::vector<SphereResult> spheres, std::string title);
/// A Result as it is; a Stage, Field, FilmResult, VoxelResult, SphereStage or Packing as its only part; a path opened.
/// Throws InputError for anything else.
Result any_result(const py::object& what);

/// Writes every part as a file of the store into `folder`, which is made; gives the files in their order. Other results
/// that lie there are put aside, under earlier/.
std::vector<Path> save(const Result& result, const Path& folder);

}  // namespace arenite::python
