#include <fmt/core.h>
#include <hdf5.h>
#include <zlib.h>
#include <CLI/Version.hpp>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>

#include "commands.hpp"
#include "core/version.hpp"
#include "grains/dem/kernels/kernel.hpp"
#include "print.hpp"

namespace arenite::app {
namespace {

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

/// Where a program is on the PATH; empty if nowhere.
std::string find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const auto candidate = std::filesystem::path(folder) / name;
    std::error_code error;
    if (!folder.empty() && std::filesystem::is_regular_file(candidate, error)) return candidate.string();
  }
  return {};
}

/// The kernels that run here, and which of them "auto" means.
std::string kernels() {
  std::string found;
  for (const char* name : {"portable", "avx2", "avx512"}) {
    try {
      found += fmt::format("{}{}", found.empty() ? "" : ", ", dem::find_kernel<2>(name).name);
    } catch (const InputError&) {
      // Not on this processor.
    }
  }
  return fmt::format("{} (auto: {})", found, dem::find_kernel<2>("auto").name);
}

void report(const char* what, const std::string& state) { print("{:<12} {}\n", what, state); }

void report_program(const char* name, const char* purpose) {
  const std::string place = find_program(name);
  report(name, place.empty() ? fmt::format("not found (only needed {})", purpose) : place);
}

}  // namespace

void add_doctor(Options& command, int&) {
  command.work = [] {
    report("arenite", version);
    report("compiler", __VERSION__);
    report("kernels", kernels());
    report("threads", std::to_string(std::thread::hardware_concurrency()));
    report("HDF5", hdf5_version());
    report("zlib", zlibVersion());
    report("fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100));
    report("CLI11", CLI11_VERSION);
    report_program("chromium", "to test the page; any browser opens it");
    report_program("paraview", "to view exports of --to vtk");
    report_program("ovito", "to view exports of --to lammps and extxyz");
    report_program("lmp", "to compare with LAMMPS: make peers");
    report_program("yade", "to compare with YADE: make peers");
  };
}

}  // namespace arenite::app
