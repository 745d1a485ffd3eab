#include <sys/resource.h>
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
#include <vector>

#include "commands.hpp"
#include "print.hpp"
#include "statistics/numbers.hpp"

using namespace arenite;

const std::vector<app::Command>& app::commands() {
  static const std::vector<Command> list{
      {"run", "Run a recipe: packing, loading stage by stage, results and page", app::add_run},
      {"watch", "Follow a run on a live page for browsers on this machine, with a button to stop it", app::add_watch},
      {"study", "Run a study: a recipe with [sweep], on all cores or on a cluster", app::add_study},
      {"verify", "Check the claims of the thesis or the paper by running their studies", app::add_verify},
      {"init", "Write a commented recipe to start from", app::add_init},
      {"check", "Check a recipe, print it as interpreted, and predict the cost and regime of its run", app::add_check},
      {"load", "Load any phase map by peridynamics: moduli, stresses by phase, failure", app::add_load},
      {"lockin",
       "Lock-in analysis of a film of a cyclically loaded sample: signed amplitude and error of every pixel, with "
       "warnings",
       app::add_lockin},
      {"step", "Measure the temperature jump at a step of the load, in every pixel of a film", app::add_step},
      {"grains", "Find grains in a picture: a table of centres, radii and materials to measure or simulate",
       app::add_grains},
      {"show", "Summarise a result (provenance, outcome, walls, energies, fabric and forces) or a film", app::add_show},
      {"export", "Export a result for ParaView, OVITO, LAMMPS tools, or as tables", app::add_export},
      {"measure", "Measure fabric, coordination, forces and stresses of grains and contacts from any program's files",
       app::add_measure},
      {"identify", "Identify contact stiffness, thermoelastic factor or surface energy from laboratory records",
       app::add_identify},
      {"film", "Infer grain stresses and contact forces from an infrared film of a loaded packing", app::add_film},
      {"camera", "Film simulated states with a virtual infrared camera", app::add_camera},
      {"figures", "Draw journal figures of a result: PDF, SVG, PNG in column width", app::add_figures},
      {"animate", "Animate a run along its loading: MP4 or GIF, grains coloured by stress, motion or friction",
       app::add_animate},
      {"compare", "Compare two results: numbers that differ beyond their errors, curves, a page", app::add_compare},
      {"doctor", "Report the installation: versions, kernels, threads, helper programs", app::add_doctor},
      {"completion", "Print the completion script of a shell", app::add_completion},
      {"man", "Print the manual page, or the reference of all recipe keys", app::add_man},
  };
  return list;
}

namespace {

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

/// Does the work of the command that the command line names.
int carry_out(int argc, char** argv) {
  int status = app::done;
  std::deque<app::Options> tables;  // what a table sets must stay where it is
  for (const app::Command& command : app::commands()) command.add(tables.emplace_back(), status);
  if (const app::Options* chosen = app::read_command_line(argc, argv, tables, status)) chosen->work();
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  start_anew_with_one_blas_thread(argv);
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the size limit is an error of its write, not the end of the program
  int status = app::other_failure;
  try {
    status = carry_out(argc, argv);
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
