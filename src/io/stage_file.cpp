#include "io/stage_file.hpp"

#include "io/sealed_file.hpp"
#include "io/stage_groups.hpp"

namespace arenite::io {

void write_stage(const std::filesystem::path& path, const StageResult& result) {
  const Hdf5Builder file;
  write_result(file.root(), result);
  write_sealed(path, "result", file.bytes());
}

StageResult read_stage(const std::filesystem::path& path) {
  return read_result(open_hdf5(read_sealed(path, "result"), path.string()));
}

}  // namespace arenite::io
