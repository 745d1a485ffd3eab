#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grains/texture/texture.hpp"
#include "io/disk/file.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"
#include "statistics/numbers.hpp"
#include "workflow/stage_keys.hpp"

namespace arenite::workflow {

/// Creates a folder and those above it; refuses with the system's reason.
void make_folder(const std::filesystem::path& folder);

/// Files of results in a folder that have none of these names; HDF5 files of other programs are none.
std::vector<std::filesystem::path> other_results(const std::filesystem::path& folder,
                                                 const std::vector<std::string>& names);

/// A run's folder: result files of this recipe on top, those of other versions of it under earlier/, from where they
/// come back when they are wanted again. One writer at a time has it: another is refused. A folder that was made for it
/// and stays empty goes with it.
class ResultFolder {
 public:
  /// Files of results of every kind, or of one (io/disk/store_file.hpp).
  ResultFolder(std::filesystem::path out, const std::vector<std::string>& names, std::string_view only = {});
  ~ResultFolder();
  ResultFolder(const ResultFolder&) = delete;
  ResultFolder& operator=(const ResultFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return out_ / name; }
  /// What was put aside now, and which exports in the folder show it still; empty if nothing was.
  std::string what_was_put_aside() const;

 private:
  void put_aside(const std::filesystem::path& path);
  std::filesystem::path out_;
  bool was_there_;
  std::optional<io::FileLock> lock_;
  std::vector<std::string> put_aside_;
};

/// The last state of the stage of that name in a run's folder; none if no stage has it.
std::optional<Packing> last_state(const std::filesystem::path& result, const std::string& stage);

/// The load of that name, where the run went on to nodes; none if no load has it.
std::optional<FieldResult> load_named(const std::filesystem::path& result, const std::string& name);

/// The sentence for a name that is not there, with the names of the stages that are.
[[noreturn]] void refuse_stage(const std::filesystem::path& result, const std::string& name);

/// The last state of a run, measured as its recipe asks.
struct FinalState {
  Packing packing;
  texture::Texture texture;
};
/// Which state, and how it is measured where its recipe does not say.
struct StateOptions {
  std::string stage = {};             ///< at whose end it is; empty: the last
  bool rev = false;                   ///< the REV study is wanted, which takes longest
  int sectors = 18;                   ///< into which contact orientations are counted
  std::optional<double> border = {};  ///< another strip left out along the walls, in mean diameters
};
/// From the file of a stage of the run. Throws InputError if the run's files are not there, or none is of that stage.
FinalState final_state(const std::filesystem::path& run, const StateOptions& options = {});

/// Its texture without values by grain; `curves` adds histograms and distributions.
Numbers numbers(FinalState state, bool curves);

/// The cemented sample of a run, or with `load` the load of that name ("*": its first). Where its file was dropped it
/// is made again from the packing that was kept: the same recipe gives the same bytes, after as long as the load took.
/// Throws InputError for a run without its packing or without such a load.
FieldResult field_of(const std::filesystem::path& run, const std::string& load = "");

}  // namespace arenite::workflow
