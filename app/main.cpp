#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>
#include <string>

#include "commands.hpp"
#include "print.hpp"
#include "statistics/numbers.hpp"

namespace {

using namespace arenite;

/// Whose sentence it is: "arenite run".
std::string speaker(int argc, char** argv) {
  for (const auto& command : app::commands())
    if (argc > 1 && std::string(argv[1]) == command.name) return std::string("arenite ") + command.name;
  return "arenite";
}

/// OpenBLAS starts its threads as it is loaded, and where address space is limited one of them may ask for memory for
/// ever, which the end of the program then waits for. It takes its number of threads from the environment only.
void start_anew_with_one_blas_thread(char** argv) {
  rlimit space{};
  if (std::getenv("OPENBLAS_NUM_THREADS") || ::getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY)
    return;
  if (::setenv("OPENBLAS_NUM_THREADS", "1", 0) == 0) ::execv("/proc/self/exe", argv);
}

}  // namespace

int main(int argc, char** argv) {
  start_anew_with_one_blas_thread(argv);
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the size limit is an error of its write, not the end of the program
  int status = app::other_failure;
  try {
    status = app::read_command_line(argc, argv);
  } catch (const InputError& error) {
    for (const auto& problem : error.problems()) {
      const std::string who = problem.file.empty() ? speaker(argc, argv) + ": " : "";  // a file speaks for itself
      app::print(stderr, "{}{}\n", who, to_string(problem));
    }
    status = app::bad_input;
  } catch (const CannotGoOn& error) {
    app::print(stderr, "{}: {}\n", speaker(argc, argv), error.what());
    status = app::not_converged;
  } catch (const NumbersError&) {  // in a file with a right seal: of another version, or written by another hand
    app::print(stderr,
               "{}: the numbers stored in the result are not those that this version writes; compute the result again "
               "with `arenite run`\n",
               speaker(argc, argv));
    status = app::bad_input;
  } catch (const std::filesystem::filesystem_error& error) {
    app::print(stderr, "{}: {}; check its permissions\n", error.path1().string(), error.code().message());
    status = app::bad_input;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: out of memory; request fewer grains, nodes or stored states\n",
                 speaker(argc, argv).c_str());
  } catch (const std::exception& error) { app::print(stderr, "{}: {}\n", speaker(argc, argv), error.what()); }
  // A full disk behind a redirected output shows only when the last bytes leave.
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
    app::print(stderr, "{}: the output could not be written ({}); make room or write elsewhere\n", speaker(argc, argv),
               std::strerror(errno));
    return app::bad_input;
  }
  return status;
}
