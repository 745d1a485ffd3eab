#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "commands.hpp"
#include "statistics/numbers.hpp"

namespace {

using namespace arenite;

/// Whose sentence it is: "arenite run".
std::string speaker(int argc, char** argv) {
  for (const auto& command : app::commands())
    if (argc > 1 && std::string(argv[1]) == command.name) return std::string("arenite ") + command.name;
  return "arenite";
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the size limit is an error of its write, not the end of the program
  int status = app::other_failure;
  try {
    status = app::read_command_line(argc, argv);
  } catch (const InputError& error) {
    for (const auto& problem : error.problems()) {
      const std::string who = problem.file.empty() ? speaker(argc, argv) + ": " : "";  // a file speaks for itself
      std::fprintf(stderr, "%s%s\n", who.c_str(), to_string(problem).c_str());
    }
    status = app::bad_input;
  } catch (const CannotGoOn& error) {
    std::fprintf(stderr, "%s: %s\n", speaker(argc, argv).c_str(), error.what());
    status = app::not_converged;
  } catch (const NumbersError&) {  // in a file with a right seal: of another version, or written by another hand
    std::fprintf(stderr, "%s: the numbers stored in the result are not those that this version writes; compute the result again with `arenite run`\n",
                 speaker(argc, argv).c_str());
    status = app::bad_input;
  } catch (const std::filesystem::filesystem_error& error) {
    std::fprintf(stderr, "%s: %s; check its permissions\n", error.path1().c_str(), error.code().message().c_str());
    status = app::bad_input;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: out of memory; request fewer grains or fewer stored states\n", speaker(argc, argv).c_str());
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
