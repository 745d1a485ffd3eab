#include "io/stage_file.hpp"

#include "io/sealed_file.hpp"
#include "io/stage_groups.hpp"

namespace arenite::io {

void write_stage(const std::filesystem::path& path, const StageResult& result) {
  const Hdf5Writer file;
  write_result(file, result);
  write_sealed(path, "result", file.bytes());
}

StageResult read_stage(const std::filesystem::path& path) {
  return read_result(Hdf5Reader(read_sealed(path, "result"), path.string()));
}

}  // namespace arenite::io
