#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "core/units.hpp"

namespace arenite::app {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string result, out, width;
  std::vector<std::string> formats{"pdf"}, only;
};

/// The module's Python files may be there without what is compiled of it.
bool is_built(const fs::path& module) {
  std::error_code error;
  for (fs::directory_iterator entry(module, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().filename().string().starts_with("_core.") && entry->path().extension() == ".so") return fs::exists(module / "figures/__main__.py", error);
  return false;
}

/// A folder of Python's that holds the module, and the Python to draw with.
struct Module {
  fs::path folder;
  std::string interpreter;
};

/// Of pip's folders lib/python3.N/{site,dist}-packages: the Python of that version beside the program (a virtual environment's), else the distribution's.
std::optional<Module> installed_by_pip(const fs::path& program) {
  std::error_code error;
  for (fs::directory_iterator entry(program.parent_path() / "lib", error), end; !error && entry != end; entry.increment(error)) {
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

/// The Python module beside the program where it was built, or where it was installed with it. These are built for the distribution's Python.
Module find_module() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& folder : {program / "python", program.parent_path() / "lib/python3/dist-packages"})
    if (is_built(folder / "arenite")) return {folder, fs::exists("/usr/bin/python3") ? "/usr/bin/python3" : "python3"};
  if (const auto found = installed_by_pip(program)) return *found;
  throw InputError("figures need the Python module, which is not built beside this program; `make build` in the source folder builds it (`make demo` does not)");
}

void draw(const Arguments& a) {
  refuse_neither_result_nor_study(a.result);
  const char* path = std::getenv("PYTHONPATH");
  const Module module = find_module();
  const std::string folders = module.folder.string() + (path && *path ? ":" + std::string(path) : "");
  setenv("PYTHONPATH", folders.c_str(), 1);
  std::vector<std::string> words{module.interpreter, "-m", "arenite.figures", a.result, "--format"};
  words.insert(words.end(), a.formats.begin(), a.formats.end());
  if (!a.only.empty()) {
    words.emplace_back("--only");
    words.insert(words.end(), a.only.begin(), a.only.end());
  }
  if (!a.out.empty()) words.insert(words.end(), {"--out", a.out});
  if (!a.width.empty()) words.insert(words.end(), {"--width", fmt::format("{}", 1e3 * option_value("--width", [&] { return parse_si(a.width, dimension::length, "mm"); }))});
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::fflush(nullptr);
  execvp(arguments[0], arguments.data());
  throw InputError("python3 was not found; install it with NumPy and Matplotlib (Debian: apt-get install python3-matplotlib)");
}

}  // namespace

void add_figures(Options& command, int&) {
  const auto a = std::make_shared<Arguments>();
  command.add("result", a->result, "Folder of a run, a film's result or a study, or a file of it").required().type("RESULT");
  command.add("--out", a->out, "Folder to write to (default: figures in the result's folder)").type("DIR");
  command.add("--format", a->formats, "pdf, svg, png; may be several").among({"pdf", "svg", "png"}).type("FORMAT");
  command.add("--only", a->only, "Names of figures; all if not given").type("NAME");
  command.add("--width", a->width, "Width, e.g. \"85 mm\" (default: 85 mm for one column, 175 mm for two)").type("LENGTH");
  command.work = [a] { draw(*a); };
}

}  // namespace arenite::app
