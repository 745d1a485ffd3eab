#include <fmt/format.h>
#include <pybind11/stl.h>

#include "calls.hpp"
#include "core/error.hpp"
#include "core/hash.hpp"
#include "core/version.hpp"
#include "grains/dem/run_stage.hpp"
#include "module.hpp"
#include "workflow/run.hpp"

namespace arenite::python {
namespace {

using study::Recipe;

std::size_t stage_number(const Recipe& recipe, const py::object& stage) {
  if (PyIndex_Check(stage.ptr())) {
    const auto k = PyNumber_AsSsize_t(stage.ptr(), nullptr);
    if (k >= 0 && static_cast<std::size_t>(k) < recipe.stages.size()) return static_cast<std::size_t>(k);
    throw InputError(fmt::format("there is no stage {}; the recipe has {}, counted from 0", k, recipe.stages.size()));
  }
  if (!py::isinstance<py::str>(stage)) throw InputError(fmt::format("stage is of type {}; give its name, or its number from 0", Py_TYPE(stage.ptr())->tp_name));
  const auto name = stage.cast<std::string>();
  for (std::size_t k = 0; k < recipe.stages.size(); ++k)
    if (recipe.stages[k].name == name) return k;
  std::string known;
  for (const auto& each : recipe.stages) known += (known.empty() ? "" : ", ") + each.name;
  throw InputError(fmt::format("the recipe has no stage \"{}\"; there are {}", name, known));
}

std::string text_of(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

StageResult load_stage(const Packing& packing, const Recipe& recipe, const py::object& stage, int threads, const Progress& progress) {
  const std::size_t number = stage_number(recipe, stage);
  auto integration = recipe.integration;
  integration.threads = threads;
  Call call;
  return call.without_lock([&] {
    dem::Engine engine(packing, recipe.contact, integration);
    const dem::Stage& what = recipe.stages[number];
    const std::string hash = HashBuilder().add("start", text_of(engine.save())).add("stage", what.name).add("recipe", study::to_toml(recipe)).hex();
    dem::StageRun run = dem::begin_stage(engine, what);
    while (!run.finished && !call.asked_to_stop()) {
      dem::continue_stage(engine, what, run);
      call.tell(progress, dem::share_done(what, run), what.name);
    }
    StageResult result = std::move(run.result);
    result.name = what.name;
    result.provenance = {version, what.name, hash, study::to_toml(recipe), recipe.seed, engine.kernel(), {}};
    if (!result.frames.empty()) result.texture = texture::numbers(texture::measure(result.frames.back().packing, study::texture_options(recipe, number + 1)));
    return result;
  });
}

}  // namespace

void bind_stages(py::module_& m) {
  m.def("pack", [](const Recipe& recipe) {
    Call call;
    return call.without_lock([&] { return study::make_packing(recipe).frames.back().packing; });
  }, py::arg("recipe"), "The grains in their box before any loading: drawn, placed and relaxed, or read from a file (recipe's [packing]).");
  m.def("load_stage", &load_stage, py::arg("packing"), py::arg("recipe"), py::arg("stage") = 0, py::kw_only(), py::arg("threads") = 1, py::arg("progress") = py::none(),
        "Takes a packing through one stage of the recipe, by number or name: compaction or loading by discrete elements. `progress(share, name)` is called meanwhile. Velocities are kept, "
        "the history of friction is not.");
}

}  // namespace arenite::python
