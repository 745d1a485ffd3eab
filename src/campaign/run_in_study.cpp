#include "campaign/run_in_study.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <new>
#include <utility>

#include "campaign/run_study.hpp"
#include "core/error.hpp"
#include "core/option.hpp"
#include "io/disk/file.hpp"
#include "workflow/film/run_film.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::campaign {

Worker::Worker(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw InputError(std::string("cannot create a pipe to a new process: ") + std::strerror(errno) + "; use fewer " +
                     option("jobs"));
  std::fflush(nullptr);  // or the new process would write what waits here a second time
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) {
    const int error = errno;
    ::close(ends[0]);
    ::close(ends[1]);
    throw InputError(std::string("cannot start a new process: ") + std::strerror(error) + "; use fewer " +
                     option("jobs"));
  }
  if (process_ == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() != parent) ::_exit(1);
    ::_exit(io::write_all(ends[1], work()) == 0 ? 0 : 1);
  }
  ::close(ends[1]);
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  pipe_ = ends[0];
}

Worker::~Worker() {
  ::close(pipe_);
  if (process_ < 0) return;
  ask_to_stop();
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {}
}

void Worker::ask_to_stop() const { ::kill(process_, SIGTERM); }

std::optional<Worker::End> Worker::end() {
  std::array<char, 4096> buffer{};
  ssize_t n = 0;
  while ((n = ::read(pipe_, buffer.data(), buffer.size())) > 0 || (n < 0 && errno == EINTR))
    if (n > 0) heard_.append(buffer.data(), static_cast<std::size_t>(n));
  if (n < 0) return std::nullopt;  // nothing more for now
  int raw = 0;
  while (::waitpid(process_, &raw, 0) < 0 && errno == EINTR) {}
  process_ = -1;
  return End{heard_, WIFSIGNALED(raw) ? WTERMSIG(raw) : 0, WIFEXITED(raw) ? WEXITSTATUS(raw) : 0};
}

namespace {

using Kind = RunState::Kind;

/// The stage that ended the run, and how.
std::string why_unfinished(const workflow::RunOutcome& outcome) {
  for (const auto& stage : outcome.stages)
    if (!stage.converged) return stage.name + ": " + stage.outcome;
  for (const auto& stage : outcome.spheres)
    if (!stage.converged) return stage.name + ": " + stage.outcome;
  for (const auto& field : outcome.fields)
    if (!field.converged) return field.name + ": " + field.outcome;
  for (const auto& sample : outcome.voxels)
    if (!sample.converged) return sample.name + ": " + sample.outcome;
  return "it did not converge";
}

/// A film as the run's recipe measures it.
RunState measure(const recipe::FilmRecipe& recipe, const workflow::RunOptions& how, const StudyOptions& options) {
  const workflow::FilmOutcome outcome = workflow::run_film(recipe.film_named(), recipe, {how, options.threads});
  if (outcome.interrupted) return {};
  keep_numbers(how.out, options.film_numbers(outcome.result));
  if (outcome.result.converged) return {Kind::done, 0, {}};
  return {Kind::unfinished, 0, outcome.result.outcome};
}

RunState simulate(recipe::Recipe recipe, const workflow::RunOptions& how, const StudyOptions& options) {
  recipe.integration.threads = options.threads;
  const workflow::RunOutcome outcome = workflow::run(recipe, how);
  if (outcome.interrupted) return {};
  keep_numbers(how.out, options.numbers(outcome));
  if (outcome.converged) return {Kind::done, 0, {}};
  return {Kind::unfinished, 0, why_unfinished(outcome)};
}

RunState attempt(const Study& study, const StudyRun& run, const StudyFolder& folder, const workflow::Store& store,
                 const StudyOptions& options) {
  const workflow::RunOptions how{.out = folder.run(run.name),
                                 .notice = options.notice,
                                 .asked_to_stop = options.asked_to_stop,
                                 .checkpoint_seconds = options.checkpoint_seconds,
                                 .store = &store};
  return study.of_films ? measure(film_recipe_of(study, run), how, options)
                        : simulate(recipe_of(study, run), how, options);
}

RunState attempt_whatever_happens(const Study& study, const StudyRun& run, const StudyFolder& folder,
                                  const workflow::Store& store, const StudyOptions& options) {
  try {
    return attempt(study, run, folder, store, options);
  } catch (const std::bad_alloc&) {
    return {Kind::failed, 0, "out of memory; run fewer at a time (" + option("jobs") + ")"};
  } catch (const std::exception& error) { return {Kind::failed, 0, error.what()}; }
}

}  // namespace

bool is_wanted(const StudyRun& run, const RunState& state, const StudyOptions& options) {
  return !state.settled() || (state.kind != Kind::done && options.repeats(run));
}

std::optional<RunState> run_in_study(const Study& study, const StudyRun& run, const StudyFolder& folder,
                                     const workflow::Store& store, const io::AppendLog& journal,
                                     const StudyOptions& options) {
  const auto lock = io::FileLock::try_take(folder.lock(run.name));
  if (!lock) return std::nullopt;
  // Another process may have done it since it was chosen.
  if (const auto status = read_status(folder, run.name); status && !is_wanted(run, *status, options)) return status;
  note_state(journal, run.name, {Kind::running, 0, {}});
  const std::clock_t began = std::clock();
  RunState state = attempt_whatever_happens(study, run, folder, store, options);
  state.seconds = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  if (state.settled()) {
    workflow::make_folder(folder.run(run.name));
    write_status(folder, run.name, state);
  }
  note_state(journal, run.name, state);
  return state;
}

}  // namespace arenite::campaign
