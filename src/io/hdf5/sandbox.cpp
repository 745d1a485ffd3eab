#include "io/hdf5/sandbox.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <exception>
#include <fstream>
#include <string_view>

#include "core/problems.hpp"

namespace arenite::io {
namespace {

constexpr rlim_t more_memory = rlim_t{1} << 30, most_seconds = 60;
constexpr unsigned longest_wait = 600;  // s, for whoever waits for what never comes and needs no processor for it
constexpr std::size_t longest_refusal = 65536;
constexpr char is_made = 'm', is_refused = 'r', has_failed = 'f';

void limit(int what, rlim_t most) {
  rlimit limits{};
  if (getrlimit(static_cast<__rlimit_resource>(what), &limits) != 0) return;
  limits.rlim_cur = limits.rlim_max == RLIM_INFINITY || most < limits.rlim_max ? most : limits.rlim_max;
  setrlimit(static_cast<__rlimit_resource>(what), &limits);
}

/// `parent` is the process that waits: this one ends with it, and whatever would end that ends this one, too.
void confine(std::size_t room, pid_t parent) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGALRM, SIGPIPE, SIGINT, SIGTERM, SIGHUP})
    std::signal(signal, SIG_DFL);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  if (pages > 0) limit(RLIMIT_AS, pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + more_memory + room);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, most_seconds);
  alarm(longest_wait);
}

/// What the process made, and at its end a letter that says what it is.
[[noreturn]] void answer(int to, const std::function<std::string()>& work) {
  std::string result;
  char kind = is_made;
  try {
    result = work();
  } catch (const InputError& error) {
    kind = is_refused;
    result = error.problems().empty() ? std::string() : error.problems().front().message;
  } catch (...) { kind = has_failed; }
  write_all(to, result);  // who reads finds by the letter's absence what did not get through
  write_all(to, std::string_view(&kind, 1));
  _exit(0);
}

/// The process uses HDF5, whose lock must not be another thread's at the fork: that thread is not there to give it
/// back. What HDF5 calls back has its lock, whoever else in this process (h5py) uses the library; so the fork happens
/// there, and `child`, which does not return, goes on there. Below 0: no process.
pid_t fork_with_hdf5(const std::function<void()>& child) {
  struct Fork {
    const std::function<void()>& child;
    pid_t process = -1;
  } both{child};
  const auto split = [](hid_t, const char*, void* given) -> herr_t {
    auto& f = *static_cast<Fork*>(given);
    f.process = fork();
    if (f.process == 0) f.child();
    return 1;  // once is enough
  };
  const Hdf5Turn turn;
  H5Piterate(H5P_FILE_CREATE, nullptr, split, &both);
  return both.process;
}

std::string receive(int from, std::size_t most) {
  std::string bytes;
  std::array<char, 1 << 16> part{};
  while (bytes.size() <= most) {
    const ssize_t n = read(from, part.data(), part.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return bytes;
    bytes.append(part.data(), static_cast<std::size_t>(n));
  }
  return {};
}

}  // namespace

std::string in_sandbox(const std::string& file, const std::function<std::string()>& work, std::size_t most,
                       std::size_t room) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    refuse(file, "cannot be read: the system cannot create a pipe; close other programs");
  const pid_t parent = getpid(), process = fork_with_hdf5([&] {
                                   close(ends[0]);
                                   confine(2 * most + room, parent);
                                   answer(ends[1], work);
                                 });
  if (process < 0) {
    close(ends[0]);
    close(ends[1]);
    refuse(file, "cannot be read: the system cannot create a process; close other programs");
  }
  close(ends[1]);
  std::string bytes;
  std::exception_ptr error;
  try {
    bytes = receive(ends[0], std::max(most, longest_refusal) + 1);
  } catch (...) { error = std::current_exception(); }
  close(ends[0]);
  if (bytes.empty()) kill(process, SIGKILL);
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {}
  if (error) std::rethrow_exception(error);
  if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM || WTERMSIG(status) == SIGHUP))
    refuse(file, "was not read: its reading was stopped; start it again");
  const char kind = bytes.empty() ? has_failed : bytes.back();
  if (!bytes.empty()) bytes.pop_back();
  if (kind == is_refused && !bytes.empty()) throw InputError(file, 0, bytes);
  if (kind != is_made || bytes.size() > most) refuse(file, "is damaged; copy it again");
  return bytes;
}

}  // namespace arenite::io
