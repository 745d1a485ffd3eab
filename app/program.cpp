#include "program.hpp"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "commands.hpp"
#include "print.hpp"
#include "statistics/numbers.hpp"

namespace arenite::app {
namespace {

/// Whose sentence it is: "arenite run".
std::string speaker(int argc, char** argv) {
  for (const auto& command : commands())
    if (argc > 1 && std::string(argv[1]) == command.name) return std::string("arenite ") + command.name;
  return "arenite";
}

/// Does the work of the command that the command line names.
int carry_out(int argc, char** argv) {
  int status = done;
  std::deque<Options> tables;  // what a table sets must stay where it is
  for (const Command& command : commands()) command.add(tables.emplace_back(), status);
  if (const Options* chosen = read_command_line(argc, argv, tables, status)) chosen->work();
  return status;
}

}  // namespace

void start_anew_with(const std::vector<Setting>& settings, char** argv) {
  bool anew = false;
  for (const auto& [name, value] : settings) anew |= !std::getenv(name) && ::setenv(name, value, 0) == 0;
  if (anew) ::execv("/proc/self/exe", argv);
}

int run_program(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the size limit is an error of its write, not the end of the program
  int status = other_failure;
  try {
    status = carry_out(argc, argv);
  } catch (const InputError& error) {
    for (const auto& problem : error.problems()) {
      const std::string who = problem.file.empty() ? speaker(argc, argv) + ": " : "";  // a file speaks for itself
      print(stderr, "{}{}\n", who, to_string(problem));
    }
    status = bad_input;
  } catch (const CannotGoOn& error) {
    print(stderr, "{}: {}\n", speaker(argc, argv), error.what());
    status = not_converged;
  } catch (const NumbersError&) {  // in a file with a right seal: of another version, or written by another hand
    print(stderr,
          "{}: the numbers stored in the result are not those that this version writes; compute the result again "
          "with `arenite run`\n",
          speaker(argc, argv));
    status = bad_input;
  } catch (const std::filesystem::filesystem_error& error) {
    print(stderr, "{}: {}; check its permissions\n", error.path1().string(), error.code().message());
    status = bad_input;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: out of memory; request fewer grains, nodes or stored states\n",
                 speaker(argc, argv).c_str());
  } catch (const std::exception& error) { print(stderr, "{}: {}\n", speaker(argc, argv), error.what()); }
  // A full disk behind a redirected output shows only when bytes leave: the last ones, or earlier ones, whose cause is
  // then known no more.
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
    const std::string cause = errno != 0 ? fmt::format(" ({})", std::strerror(errno)) : "";
    print(stderr, "{}: the output could not be written{}; make room or write elsewhere\n", speaker(argc, argv), cause);
    return bad_input;
  }
  return status;
}

}  // namespace arenite::app
