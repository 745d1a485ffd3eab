#include <fmt/core.h>
#include <pybind11/stl.h>

#include <memory>
#include <utility>
#include <variant>

#include "arrays.hpp"
#include "core/problems.hpp"
#include "grains/dem/measure.hpp"
#include "module.hpp"
#include "running_stage.hpp"

/// A stage of loading on its way, as a function of Python sees it.
namespace arenite::python {
namespace {

/// What is handed to the function; it may outlive the call, but tells nothing then.
class RunningStage {
 public:
  template <int D> explicit RunningStage(workflow::StageUnderWayIn<D>& now) : now_(&now) {}
  void end() { now_ = std::monostate(); }
  /// Calls `see` for the stage, which is one of disks or of spheres.
  template <class See> auto seen_by(const See& see) const {
    if (const auto* disks = std::get_if<workflow::StageUnderWayIn<2>*>(&now_)) return see(**disks);
    if (const auto* spheres = std::get_if<workflow::StageUnderWayIn<3>*>(&now_)) return see(**spheres);
    throw InputError("the stage has gone on; a running stage can be used only in the function that got it");
  }

 private:
  std::variant<std::monostate, workflow::StageUnderWayIn<2>*, workflow::StageUnderWayIn<3>*> now_;
};

py::dict history_so_far(const RunningStage& stage) {
  return stage.seen_by([](const auto& now) {
    py::dict columns;
    for (const auto& column : now.run().result.history.columns)
      columns[py::str(column.name)] = taken_over(std::vector(column.values));
    return columns;
  });
}

std::variant<Packing, PackingIn<3>> packing_now(const RunningStage& stage) {
  return stage.seen_by(
      [](const auto& now) { return std::variant<Packing, PackingIn<3>>(dem::packing_of(now.engine())); });
}

}  // namespace

std::optional<workflow::StepFunction> step_function(Call& call, const OnStep& function, std::int64_t every) {
  if (function.is_none()) return std::nullopt;
  if (every < 1) throw refusal("every is {}; give a number of steps from 1", every);
  const auto show = [&call, &function](auto& now) {
    if (call.asked_to_stop()) return;
    const py::gil_scoped_acquire lock;
    const auto stage = std::make_shared<RunningStage>(now);
    try {
      function(stage);
    } catch (...) {
      stage->end();
      throw;
    }
    stage->end();
  };
  return workflow::StepFunction{show, every, show};
}

void bind_running_stage(py::module_& m) {
  py::class_<RunningStage, std::shared_ptr<RunningStage>>(
      m, "RunningStage", "A stage of loading on its way, which `load_stage` and `run` hand to `on_step`.")
      .def_property_readonly(
          "name", [](const RunningStage& s) { return s.seen_by([](const auto& now) { return now.stage().name; }); },
          "Name in the recipe.")
      .def_property_readonly(
          "time",
          [](const RunningStage& s) { return s.seen_by([](const auto& now) { return dem::time_of(now.engine()); }); },
          "s since the start of the run.")
      .def_property_readonly(
          "step", [](const RunningStage& s) { return s.seen_by([](const auto& now) { return now.engine().step; }); },
          "Time steps since the start of the run.")
      .def_property_readonly(
          "time_step", [](const RunningStage& s) { return s.seen_by([](const auto& now) { return now.engine().dt; }); },
          "Time step, s.")
      .def_property_readonly(
          "increment",
          [](const RunningStage& s) { return s.seen_by([](const auto& now) { return now.run().increment + 1; }); },
          "Increment under way, from 1.")
      .def_property_readonly(
          "unbalanced_ratio",
          [](const RunningStage& s) {
            return s.seen_by([](const auto& now) { return now.run().latest.unbalanced_ratio; });
          },
          "Mean resultant force on a grain over the mean contact force.")
      .def_property_readonly(
          "kinetic_ratio",
          [](const RunningStage& s) {
            return s.seen_by([](const auto& now) { return now.run().latest.kinetic_ratio; });
          },
          "Kinetic over elastic energy.")
      .def_property_readonly("packing", &packing_now, "Grains, walls and contacts now (a copy).")
      .def_property_readonly("history", &history_so_far, "Columns by name so far, as in Stage.history (copies).")
      .def(
          "stop",
          [](const RunningStage& s, const std::string& why) {
            s.seen_by([&](auto& now) { now.stop("stopped by on_step: " + why); });
          },
          py::arg("why") = "as asked", "Ends the stage with the state of now; `why` is told in its outcome.")
      .def(
          "store",
          [](const RunningStage& s, std::string label) { s.seen_by([&](auto& now) { now.store(std::move(label)); }); },
          py::arg("label") = "stored by on_step", "Keeps the state of now among the stage's snapshots.")
      .def(
          "change",
          [](const RunningStage& s, const py::dict& changes) {
            s.seen_by([&](auto& now) { now.change(overrides_of(changes)); });
          },
          py::arg("changes"),
          "Changes what drives the stage from the next step on: {\"top.pressure\": \"20 kPa\", \"gravity_angle\": \"5 "
          "deg\"}. Keys are those of the stage in the recipe: sides, slide, gravity, shear_rate, boundaries, friction, "
          "drag, critical_drag.")
      .def("__repr__", [](const RunningStage& s) {
        return s.seen_by([](const auto& now) {
          return fmt::format("<arenite.RunningStage \"{}\", step {}>", now.stage().name, now.engine().step);
        });
      });
}

}  // namespace arenite::python
