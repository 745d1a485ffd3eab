#include "workflow/export_result.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/fields/coarse_grained.hpp"
#include "grains/fields/laboratory/curves_in_space.hpp"
#include "grains/fields/state_curves.hpp"
#include "io/disk/store_file.hpp"
#include "io/export/export_folder.hpp"
#include "io/results/results.hpp"
#include "model/matching.hpp"
#include "workflow/export_fields.hpp"
#include "workflow/film/run_film.hpp"

namespace arenite::workflow {
namespace fs = std::filesystem;

namespace {

std::vector<io::ExportCurves> curves_of(const SphereResult& stage) {
  auto along = fields::curves_in_space(stage, stage.asked.closes);
  if (!along) return {};
  return {{stage.name + "_curves", std::move(*along)}};
}

/// Of a stage that is a test: row by row of its history, and by its cycles.
std::vector<io::ExportCurves> curves_of(const fields::Test& test) {
  std::vector<io::ExportCurves> found;
  const std::string& name = test.stage.name;
  auto along = fields::loading_of(test);
  if (!along) return found;
  found.push_back({name + "_curves", std::move(along->curves)});
  if (const auto* cycle = test.stage.cycles.find("cycle"); cycle && cycle->size() > 1)
    found.push_back({name + "_cycles", fields::every_cycle(test)});
  return found;
}

/// Gives a format the states of a loading: each at once, or all at the end, which are kept for that.
class Loading {
 public:
  Loading(const io::ExportFormat& format, const fs::path& folder) : format_(format), folder_(folder) {}

  io::ExportFolder& out() {
    if (!out_) out_.emplace(folder_);  // after the first readable file, so that a bad one leaves no empty folder
    return *out_;
  }

  /// A stage begins with the state that the one before it ended with, which is there already.
  bool has(double time) const { return !times_.empty() && time == times_.back(); }

  void add(const std::string& stage, Snapshot snapshot, std::vector<io::GrainField> fields,
           std::vector<io::GrainField> of_contacts, double shear_rate = 0) {
    if (!format_.holds_disks())
      throw refusal("{} holds fields of nodes and voxels, and this result has grains; choose {}", format_.name,
                    list_of(io::words_of(io::exports::all, &io::ExportFormat::name,
                                         [](const auto& other) { return other.holds_disks(); }),
                            " or "));
    io::ExportSnapshot one = next(disks_, stage, std::move(snapshot), std::move(fields));
    one.of_contacts = std::move(of_contacts);
    if (format_.wants_grid) one.grid = grid_fields(one.snapshot->packing, shear_rate);
    give(std::move(one), disks_, format_.of_snapshot, format_.of_loading);
  }

  void add(const std::string& stage, SnapshotIn<3> snapshot, std::vector<io::GrainField> fields, double shear_rate) {
    io::ExportSpheres one = next(spheres_, stage, std::move(snapshot), std::move(fields));
    if (format_.wants_grid) one.grid = grid_fields(one.snapshot->packing, shear_rate);
    give(std::move(one), spheres_, format_.of_spheres, format_.of_sphere_loading);
  }

  void add(const std::vector<io::ExportCurves>& of_stage) {
    for (const io::ExportCurves& curves : of_stage) out().write(format_.of_curves(curves));
  }

  bool is_empty() const { return times_.empty(); }

  std::vector<fs::path> finish(const Provenance& last) {
    if (format_.of_loading && !disks_.all.empty()) out().add(format_.of_loading(disks_.all, last));
    if (format_.of_sphere_loading && !spheres_.all.empty()) out().add(format_.of_sphere_loading(spheres_.all, last));
    if (format_.index && !times_.empty()) out().add(format_.index(times_));
    return out().finish();
  }

 private:
  /// States of disks or of spheres: where their grains moved so far, and those that a format wants all at once.
  template <int D> struct States {
    std::vector<Vec<D>> displacement;
    GrainsIn<D> last;
    std::deque<SnapshotIn<D>> snapshots;  // which stay where they are
    std::vector<io::ExportStateIn<D>> all;

    /// Adds up displacements from state to state, so that a way across a periodic side is no leap.
    void move_to(const PackingIn<D>& now) {
      const GrainsIn<D>& g = now.grains;
      const std::vector<std::int32_t> places = places_in(last, g);
      std::vector<Vec<D>> moved(g.size());
      for (std::size_t i = 0; i < g.size(); ++i)
        if (places[i] >= 0) {
          const auto then = static_cast<std::size_t>(places[i]);
          moved[i] = displacement[then] + now.domain.nearest_image(g.position[i] - last.position[then]);
        }
      displacement = std::move(moved);
      last = g;
    }
  };

  template <int D>
  io::ExportStateIn<D> next(States<D>& states, const std::string& stage, SnapshotIn<D> snapshot,
                            std::vector<io::GrainField> fields) {
    times_.push_back(snapshot.time);
    states.move_to(snapshot.packing);
    states.snapshots.push_back(std::move(snapshot));
    io::ExportStateIn<D> one{static_cast<int>(times_.size()) - 1, stage, &states.snapshots.back(), std::move(fields)};
    if (times_.size() > 1) one.displacement = states.displacement;
    return one;
  }

  template <int D>
  void give(io::ExportStateIn<D> one, States<D>& states,
            std::vector<io::NamedBytes> (*of_state)(const io::ExportStateIn<D>&),
            std::vector<io::NamedBytes> (*of_all)(const std::vector<io::ExportStateIn<D>>&, const Provenance&)) {
    if (of_all) return states.all.push_back(std::move(one));
    out().add(of_state(one));
    states.snapshots.clear();
  }

  const io::ExportFormat& format_;
  fs::path folder_;
  std::optional<io::ExportFolder> out_;
  std::vector<double> times_;
  States<2> disks_;
  States<3> spheres_;
};

[[noreturn]] void refuse_spheres(const fs::path& file, const io::ExportFormat& format) {
  refuse(file.string(), "holds spheres, and {} does not; choose {}", format.name,
         list_of(io::words_of(io::exports::all, &io::ExportFormat::name,
                              [](const auto& other) { return other.holds_spheres(); }),
                 " or "));
}

/// The states of a stage of spheres that are not there yet.
void add_spheres(const fs::path& file, const io::ExportFormat& format, bool last_only, Loading& loading,
                 Provenance& last) {
  const SphereResult stage = io::read_stage<3>(file);
  last = stage.provenance;
  if (format.of_curves && !last_only) loading.add(curves_of(stage));
  for (const auto& snapshot : stage.snapshots)
    if (!loading.has(snapshot.time) && (!last_only || &snapshot == &stage.snapshots.back()))
      loading.add(stage.name, snapshot, derived_fields(snapshot.packing),
                  fields::shear_rate_at(stage.history, snapshot.time));
}

/// Writes a result on nodes or voxels; false where the format has no way to, which is refused where nothing else is
/// there.
template <class Write>
bool write_on_grid(const fs::path& file, const io::ExportFormat& format, Write io::ExportFormat::*of, const char* what,
                   bool alone, const std::function<std::vector<io::NamedBytes>()>& bytes, Loading& loading) {
  if (format.*of) {
    for (const auto& written : bytes()) loading.out().write(written);
    return true;
  }
  if (alone)
    refuse(file.string(), "holds {}, and {} holds grains only; choose {}", what, format.name,
           list_of(io::words_of(io::exports::all, &io::ExportFormat::name,
                                [&](const auto& other) { return other.*of != nullptr; }),
                   " or "));
  return false;
}

/// The same of a stored sample in space or of a field.
bool write_on_grid(const fs::path& file, const std::string& kind, const io::ExportFormat& format, bool alone,
                   Loading& loading) {
  const auto voxels = [&] { return format.of_voxels(io::read_voxels(file)); };
  const auto nodes = [&] {
    const FieldResult field = io::read_field(file);
    return format.of_field({&field, derived_fields(field)});
  };
  return kind == "voxels"
             ? write_on_grid(file, format, &io::ExportFormat::of_voxels, "a sample in space", alone, voxels, loading)
             : write_on_grid(file, format, &io::ExportFormat::of_field, "a field on nodes", alone, nodes, loading);
}

/// The states of a stage of disks that are not there yet; `before` is where the stage before ended, and then this one.
void add_disks(const fs::path& file, const io::ExportFormat& format, bool last_only, std::optional<Packing>& before,
               Loading& loading, Provenance& last) {
  StageResult stage = io::read_stage(file);
  last = stage.provenance;
  if (format.of_curves && !last_only) loading.add(curves_of(fields::Test{stage, before ? &*before : nullptr}));
  if (!stage.snapshots.empty()) before = stage.snapshots.back().packing;
  if (last_only && stage.snapshots.size() > 1)
    stage.snapshots.erase(stage.snapshots.begin(), stage.snapshots.end() - 1);
  for (Snapshot& snapshot : stage.snapshots) {
    if (loading.has(snapshot.time)) continue;
    const double rate = fields::shear_rate_at(stage.history, snapshot.time);
    auto fields = derived_fields(snapshot.packing);
    loading.add(stage.name, std::move(snapshot), std::move(fields), {}, rate);
  }
}

void add_film(const fs::path& file, Loading& loading, Provenance& last) {
  const FilmResult film = io::read_film_result(file);
  last = film.provenance;
  loading.add(film.name, std::move(measured_stage(film).snapshots.front()), derived_fields(film),
              fields_of_contacts(film));
}

}  // namespace

std::vector<fs::path> export_result(const fs::path& result, const io::ExportFormat& format, const fs::path& folder,
                                    bool last_only, std::vector<fs::path>* left_out) {
  auto files = io::stage_files(result);
  if (last_only) files.erase(files.begin(), files.end() - 1);
  Loading loading(format, folder);
  Provenance last;
  bool has_field = false;
  std::vector<fs::path> not_held;
  std::optional<fs::path> spheres_not_held;  // the first file of them
  std::optional<Packing> before;
  for (const auto& file : files) {
    const std::string kind = io::stored_kind(file);
    if (kind == "voxels" || kind == "field") {
      const bool written = write_on_grid(file, kind, format, files.size() == 1, loading);
      has_field = has_field || written;
      if (!written) not_held.push_back(file);
    } else if (kind == "spheres" && !format.holds_spheres()) {
      if (!spheres_not_held) spheres_not_held = file;
      not_held.push_back(file);
    } else if (kind == "spheres") {
      add_spheres(file, format, last_only, loading, last);
    } else if (kind == "film") {
      add_film(file, loading, last);
    } else {
      add_disks(file, format, last_only, before, loading, last);
    }
  }
  const bool is_empty = loading.is_empty() && !has_field;
  if (is_empty && spheres_not_held) refuse_spheres(*spheres_not_held, format);
  if (is_empty) throw InputError(result.string(), 0, "holds no state to export; run the recipe to its end first");
  if (left_out) *left_out = std::move(not_held);
  try {
    return loading.finish(last);
  } catch (const InputError& error) { throw in_file(error, result.string()); }
}

}  // namespace arenite::workflow
