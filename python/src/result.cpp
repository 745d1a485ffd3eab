#include "result.hpp"

#include <algorithm>
#include <tuple>

#include "core/version.hpp"
#include "io/disk/store_file.hpp"
#include "io/results/results.hpp"
#include "report/page.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::python {
namespace {

template <class Parts> bool all_converged(const Parts& parts) {
  return std::all_of(parts.begin(), parts.end(), [](const auto& part) { return part.converged; });
}

/// A packing as a stage of one state.
template <int D> StageResultIn<D> stage_of(const PackingIn<D>& packing) {
  StageResultIn<D> stage;
  stage.name = stage.provenance.stage = "packing";
  stage.provenance.version = version;
  stage.outcome = "a single packing";
  stage.snapshots.emplace_back();
  stage.snapshots.back().label = "packing";
  stage.snapshots.back().packing = packing;
  return stage;
}

/// What the parts' files are called in a folder.
std::vector<std::string> file_names(const Result& result) {
  std::vector<std::string> names;
  const auto name = [&](const auto& parts) {
    for (const auto& part : parts) {
      const std::string& hash = part.provenance.input_hash;
      names.push_back(io::stage_file_name(static_cast<int>(names.size()), part.name, hash.empty() ? "python" : hash));
    }
  };
  name(result.run.stages), name(result.run.spheres), name(result.run.fields), name(result.films),
      name(result.run.voxels);
  return names;
}

}  // namespace

Result result_of(std::vector<StageResult> stages, std::vector<FieldResult> fields, std::vector<FilmResult> films,
                 std::vector<VoxelResult> voxels, std::vector<SphereResult> spheres, std::string title) {
  Result r;
  r.run.stages = std::move(stages);
  r.run.spheres = std::move(spheres);
  r.run.fields = std::move(fields);
  r.films = std::move(films);
  r.run.voxels = std::move(voxels);
  r.run.converged = all_converged(r.run.stages) && all_converged(r.run.fields) && all_converged(r.films) &&
                    all_converged(r.run.voxels) && all_converged(r.run.spheres);
  for (const auto& name : file_names(r)) r.run.files.emplace_back(name);
  r.title = title.empty() ? report::title_of({.stages = r.run.stages,
                                              .fields = r.run.fields,
                                              .films = r.films,
                                              .voxels = r.run.voxels,
                                              .spheres = r.run.spheres})
                          : std::move(title);
  return r;
}

Result open_result(const Path& path) {
  std::tuple<std::vector<StageResult>, std::vector<FieldResult>, std::vector<FilmResult>, std::vector<VoxelResult>,
             std::vector<SphereResult>>
      parts;
  auto files = io::stage_files(path);
  for (const auto& file : files)
    std::visit([&]<class Part>(Part&& part) { std::get<std::vector<Part>>(parts).push_back(std::move(part)); },
               io::read_result(file));
  auto& [stages, fields, films, voxels, spheres] = parts;
  Result r =
      result_of(std::move(stages), std::move(fields), std::move(films), std::move(voxels), std::move(spheres), {});
  r.path = path.string();
  r.run.files = std::move(files);
  if (const Path simulation = path / "simulation";
      !r.films.empty() && !r.films.front().simulation.empty() && std::filesystem::is_directory(simulation))
    for (const auto& file : io::stage_files(simulation)) r.companion.push_back(io::read_stage(file));
  return r;
}

Result any_result(const py::object& what) {
  if (py::isinstance<Result>(what)) return what.cast<Result>();
  if (py::isinstance<StageResult>(what)) return result_of({what.cast<StageResult>()}, {}, {}, {}, {}, {});
  if (py::isinstance<FieldResult>(what)) return result_of({}, {what.cast<FieldResult>()}, {}, {}, {}, {});
  if (py::isinstance<FilmResult>(what)) return result_of({}, {}, {what.cast<FilmResult>()}, {}, {}, {});
  if (py::isinstance<VoxelResult>(what)) return result_of({}, {}, {}, {what.cast<VoxelResult>()}, {}, {});
  if (py::isinstance<SphereResult>(what)) return result_of({}, {}, {}, {}, {what.cast<SphereResult>()}, {});
  if (py::isinstance<Packing>(what)) return result_of({stage_of<2>(what.cast<Packing>())}, {}, {}, {}, {}, "packing");
  if (py::isinstance<PackingIn<3>>(what))
    return result_of({}, {}, {}, {}, {stage_of<3>(what.cast<PackingIn<3>>())}, "packing");
  if (py::isinstance<py::str>(what) || py::hasattr(what, "__fspath__")) return open_result(what.cast<Path>());
  throw InputError(
      "result is a folder or file of results, a Result, Stage, Field, FilmResult, VoxelResult, SphereStage, Packing or "
      "SpherePacking");
}

std::vector<Path> save(const Result& result, const Path& folder) {
  const auto names = file_names(result);
  if (names.empty())
    throw InputError(folder.string(), 0, "there is nothing to store; give a result with at least one part");
  const workflow::ResultFolder out(folder, names);
  std::vector<Path> files;
  const auto next = [&] { return files.emplace_back(out / names[files.size()]); };
  for (const auto& stage : result.run.stages) io::write_stage(next(), stage);
  for (const auto& stage : result.run.spheres) io::write_stage(next(), stage);
  for (const auto& field : result.run.fields) io::write_field(next(), field);
  for (const auto& film : result.films) io::write_film_result(next(), film);
  for (const auto& sample : result.run.voxels) io::write_voxels(next(), sample);
  return files;
}

}  // namespace arenite::python
