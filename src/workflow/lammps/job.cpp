#include "workflow/lammps/job.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

#include "core/error.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/disk/file.hpp"
#include "io/table/table.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;
namespace names = lammps::names;

namespace {

/// The name as Slurm shows it.
std::string job_name(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return !is_name_character(c); }, '_');
  return name;
}

std::string job_script(const std::string& name, const EngineOptions& options) {
  return fmt::format(
      "#!/bin/bash\n"
      "#SBATCH --job-name={0}\n"
      "#SBATCH --ntasks={1}\n"
      "#SBATCH --time=24:00:00\n"
      "#SBATCH --requeue\n"
      "#SBATCH --open-mode=append\n"
      "#SBATCH --output=slurm-%j.log\n"
      "# Carries the sample of this folder by LAMMPS, from its newest restart file where there is one; started again, "
      "it goes\n"
      "# on. On a cluster: cd to this folder, load LAMMPS, `sbatch job.sh`. LAMMPS=\"srun lmp\" in the environment "
      "starts it so.\n"
      "[ -e {5} ] || cd \"$(dirname \"$0\")\" || exit 1\n"
      "export OMP_NUM_THREADS=1\n"
      "for from in $(ls -t restart1 restart2 2>/dev/null) data; do\n"
      "  [ -e {2} ] && exit 0\n"
      "  rm -f {3}\n"
      "  ${{LAMMPS:-{4}}} -in {5} -log {6} -screen none -var from $from && continue\n"
      "  [ -e {3} ] && exit 1  # a restart file that could be read; one that was cut off cannot\n"
      "done\n"
      "[ -e {2} ]\n",
      name, options.ranks, names::ended, names::begun, options.line(), names::input, names::log);
}

bool has(const fs::path& file, const std::string& bytes) { return fs::exists(file) && io::read_file(file) == bytes; }

bool is_in_path(const std::string& program) {
  if (program.find('/') != std::string::npos) return ::access(program.c_str(), X_OK) == 0;
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  return false;
}

/// A process group that goes with this object.
class ProcessGroup {
 public:
  explicit ProcessGroup(const fs::path& folder) {
    const std::string place = folder.string();
    process_ = ::fork();
    if (process_ < 0) throw InputError("cannot start a new process for LAMMPS");
    if (process_ > 0) return;
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::chdir(place.c_str()) != 0) ::_exit(127);
    const int to = ::open("output", O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    const int from = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    ::dup2(from, 0);
    ::dup2(to, 1);
    ::dup2(to, 2);
    ::execlp("bash", "bash", "job.sh", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;
  ~ProcessGroup() {
    if (process_ < 0) return;
    ::kill(-process_, SIGTERM);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {}
  }
  /// Whether it has ended.
  bool is_over() {
    if (::waitpid(process_, nullptr, WNOHANG) != process_) return false;
    process_ = -1;
    return true;
  }

 private:
  pid_t process_ = -1;
};

/// The last bytes of a file.
std::string tail_of(const fs::path& path, std::streamoff most) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return {};
  const std::streamoff size = file.tellg(), begin = std::max<std::streamoff>(0, size - most);
  std::string text(static_cast<std::size_t>(size - begin), '\0');
  file.seekg(begin);
  file.read(text.data(), size - begin);
  return text;
}

}  // namespace

LammpsJob::LammpsJob(fs::path folder, const lammps::Deck& deck, const std::string& name, const EngineOptions& options)
    : folder_(std::move(folder)),
      line_(options.line()) {
  const std::pair<const char*, const std::string*> files[] = {
      {names::data, &deck.data}, {names::input, &deck.input}, {names::walls, &deck.walls}};
  const bool same = std::ranges::all_of(
      files, [&](const auto& file) { return file.second->empty() || has(folder_ / file.first, *file.second); });
  std::error_code ignored;
  if (!same) fs::remove_all(folder_, ignored);
  make_folder(folder_);
  for (const auto& [file, bytes] : files)
    if (!same && !bytes->empty()) io::write_atomically(folder_ / file, *bytes);
  io::write_atomically(folder_ / "job.sh", job_script(job_name(name), options));
}

bool LammpsJob::has_ended() const { return fs::exists(folder_ / names::ended); }

bool LammpsJob::can_start() const {
  std::istringstream words(line_);
  std::string first, last;
  words >> first;
  for (last = first; words >> last;) {}
  return is_in_path("bash") && is_in_path(first) && is_in_path(last);
}

bool LammpsJob::run(const std::function<bool()>& asked_to_stop, const std::function<void(std::int64_t)>& tell) const {
  ProcessGroup group(folder_);
  for (int turn = 0; !group.is_over(); ++turn) {
    if (asked_to_stop()) return false;
    if (turn % 25 == 0) tell(step_of_log());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  if (!has_ended())
    throw CannotGoOn(
        fmt::format("LAMMPS did not end its part: {}; its files are in {}", what_went_wrong(), folder_.string()));
  return true;
}

std::int64_t LammpsJob::step_of_log() const {
  std::istringstream lines(tail_of(folder_ / names::log, 4096));
  std::int64_t step = 0;
  for (std::string line; std::getline(lines, line);) {
    const auto words = split_blanks(line);
    if (words.size() != 2) continue;
    const auto first = io::to_integer(words[0]);
    if (first && io::to_integer(words[1])) step = *first;
  }
  return step;
}

std::string LammpsJob::what_went_wrong() const {
  for (const char* file : {names::log, "output"}) {
    std::istringstream lines(tail_of(folder_ / file, 8192));
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("ERROR")) return line;
  }
  const std::string said(trimmed(tail_of(folder_ / "output", 400)));
  return said.empty() ? "it was ended from outside" : said;
}

std::string LammpsJob::version() const {
  std::ifstream log(folder_ / names::log);
  std::string line;
  std::getline(log, line);
  return line.starts_with("LAMMPS") ? line : "LAMMPS";
}

}  // namespace arenite::workflow
