#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <string>

#include "commands.hpp"
#include "core/cannot_go_on.hpp"
#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/version.hpp"

namespace {

using namespace arenite;

void overview() {
  std::puts("Arenite: micromechanics of composite and cemented granular materials\n\nusage: arenite COMMAND [...]\n");
  for (const auto& command : app::commands()) std::printf("  %-11s %s\n", command.name, command.sentence);
  std::puts("\nFour roads:\n"
            "  composite packings       arenite init composite r.toml, then arenite run r.toml\n"
            "  cemented packings        arenite init cemented r.toml, then arenite run r.toml; a map of your own: arenite load MAP\n"
            "  a loaded packing's film  arenite init film r.toml, then arenite film FILM --recipe r.toml\n"
            "  many runs                arenite init study r.toml, then arenite study run r.toml\n"
            "\nA result ends in a page, report.html in its folder; a study in study.html, where a figures.toml beside its recipe says\n"
            "what to draw. In Python: `import arenite`, where every step is a function. `arenite COMMAND --help` tells more.");
}

/// Refuses an unknown first word with the nearest command, which CLI11 does not offer.
bool unknown_command(const std::string& word) {
  if (word.starts_with('-')) return false;
  std::vector<std::string> names;
  for (const auto& command : app::commands()) {
    if (word == command.name) return false;
    names.emplace_back(command.name);
  }
  const std::string near = nearest(word, names);
  std::fprintf(stderr, "arenite: unknown command \"%s\"; %s\n", word.c_str(),
               near.empty() ? "`arenite` lists the commands" : ("did you mean `arenite " + near + "`?").c_str());
  return true;
}

/// Whose sentence it is: "arenite run".
std::string speaker(int argc, char** argv) {
  for (const auto& command : app::commands())
    if (argc > 1 && std::string(argv[1]) == command.name) return std::string("arenite ") + command.name;
  return "arenite";
}

/// What is wrong with the command line, as one sentence; CLI11 adds a second one.
std::string complaint(const CLI::App& program, const CLI::Error& error) {
  const auto used = program.get_subcommands();
  const std::string command = used.empty() ? "arenite" : "arenite " + used.front()->get_name();
  return command + ": " + error.what() + "; `" + command + " --help` tells what it takes";
}

int run(int argc, char** argv) {
  int status = app::done;
  CLI::App program("Micromechanics of composite and cemented granular materials", "arenite");
  program.set_version_flag("--version", std::string("arenite ") + version);
  program.require_subcommand(0, 1);
  for (const auto& command : app::commands()) {
    command.add(*program.add_subcommand(command.name, command.sentence), status);
  }
  if (argc > 1 && unknown_command(argv[1])) return app::bad_input;
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);
    std::fprintf(stderr, "%s\n", complaint(program, error).c_str());
    return app::bad_input;
  }
  if (program.get_subcommands().empty()) overview();
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the size limit is an error of its write, not the end of the program
  int status = app::other_failure;
  try {
    status = run(argc, argv);
  } catch (const InputError& error) {
    for (const auto& problem : error.problems()) {
      const std::string who = problem.file.empty() ? speaker(argc, argv) + ": " : "";  // a file speaks for itself
      std::fprintf(stderr, "%s%s\n", who.c_str(), to_string(problem).c_str());
    }
    status = app::bad_input;
  } catch (const CannotGoOn& error) {
    std::fprintf(stderr, "%s: %s\n", speaker(argc, argv).c_str(), error.what());
    status = app::not_converged;
  } catch (const nlohmann::json::exception&) {  // in a file with a right seal: of another version, or written by another hand
    std::fprintf(stderr, "%s: the numbers stored in the result are not those that this version writes; make the result again with `arenite run`\n",
                 speaker(argc, argv).c_str());
    status = app::bad_input;
  } catch (const std::filesystem::filesystem_error& error) {
    std::fprintf(stderr, "%s: %s; check its permissions\n", error.path1().c_str(), error.code().message().c_str());
    status = app::bad_input;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: the memory does not suffice; ask for fewer grains or stored states\n", speaker(argc, argv).c_str());
  } catch (const std::exception& error) {
    // fmt throws where stdio would only note that stdout cannot be written; that is told below.
    if (!std::ferror(stdout)) std::fprintf(stderr, "%s: %s\n", speaker(argc, argv).c_str(), error.what());
  }
  // A full disk behind a redirected output shows only when the last bytes leave.
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
    std::fprintf(stderr, "%s: the output could not be written (%s); make room or write elsewhere\n", speaker(argc, argv).c_str(), std::strerror(errno));
    return app::bad_input;
  }
  return status;
}
