#include "python_module.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>

#include "core/error.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

/// The module's Python files may be there without what is compiled of it.
bool is_built(const fs::path& module) {
  std::error_code error;
  for (fs::directory_iterator entry(module, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().filename().string().starts_with("_core.") && entry->path().extension() == ".so")
      return fs::exists(module / "figures/__main__.py", error);
  return false;
}

/// A folder of Python's that holds the module, and the Python to run it with.
struct Module {
  fs::path folder;
  std::string interpreter;
};

/// Of pip's folders lib/python3.N/{site,dist}-packages: the Python of that version beside the program (a virtual
/// environment's), else the distribution's.
std::optional<Module> installed_by_pip(const fs::path& program) {
  std::error_code error;
  for (fs::directory_iterator entry(program.parent_path() / "lib", error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string version = entry->path().filename().string();
    if (!version.starts_with("python3.")) continue;
    for (const char* packages : {"site-packages", "dist-packages"})
      if (is_built(entry->path() / packages / "arenite")) {
        for (const fs::path& bin : {program, fs::path("/usr/bin")})
          if (fs::exists(bin / version)) return Module{entry->path() / packages, bin / version};
        return Module{entry->path() / packages, version};
      }
  }
  return {};
}

/// The Python module beside the program where it was built, or where it was installed with it. These are built for the
/// distribution's Python.
Module find_module(const char* what) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& folder : {program / "python", program.parent_path() / "lib/python3/dist-packages"})
    if (is_built(folder / "arenite")) return {folder, fs::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3"};
  if (const auto found = installed_by_pip(program)) return *found;
  throw InputError(
      fmt::format("{} need the Python module, which has not been built beside this program; `make build` in the source "
                  "folder builds it (`make demo` does not)",
                  what));
}

}  // namespace

namespace {

/// Without the empty entries of a PYTHONPATH, by which Python means the current folder, whose files are not ours to
/// run.
std::string folders_of(const char* path) {
  std::string folders;
  std::istringstream entries(path ? path : "");
  for (std::string folder; std::getline(entries, folder, ':');)
    if (!folder.empty()) folders += ":" + folder;
  return folders;
}

}  // namespace

void continue_in_python(const char* what, const char* module, const Numbers& options) {
  const Module found = find_module(what);
  const std::string folders = found.folder.string() + folders_of(std::getenv("PYTHONPATH"));
  setenv("PYTHONPATH", folders.c_str(), 1);
  // `python3 -m` would look for modules in the current folder first, whose files are not ours to run.
  constexpr const char* start =
      "import sys; sys.path[:] = [p for p in sys.path if p]; import runpy; runpy.run_module(sys.argv.pop(1), "
      "run_name='__main__', alter_sys=True)";
  std::vector<std::string> line{found.interpreter, "-c", start, module, to_json(options)};
  std::vector<char*> arguments;
  for (auto& word : line) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::fflush(nullptr);
  execvp(arguments[0], arguments.data());
  throw InputError(
      "python3 was not found; install it with NumPy and Matplotlib (Debian: apt-get install python3-matplotlib)");
}

}  // namespace arenite::app
