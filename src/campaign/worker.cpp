#include "campaign/worker.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

#include "core/error.hpp"
#include "io/write_all.hpp"

namespace arenite::study {
Worker::Worker(const std::function<std::string()>& work) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw InputError(std::string("no pipe to a new process: ") + std::strerror(errno) + "; use fewer --jobs");
  std::fflush(nullptr);  // or the new process would write what waits here a second time
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) {
    const int error = errno;
    ::close(ends[0]);
    ::close(ends[1]);
    throw InputError(std::string("no new process: ") + std::strerror(error) + "; use fewer --jobs");
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

Worker::Worker(Worker&& other) noexcept
    : process_(std::exchange(other.process_, -1)), pipe_(std::exchange(other.pipe_, -1)), heard_(std::move(other.heard_)) {}

Worker& Worker::operator=(Worker&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(pipe_, other.pipe_);
  std::swap(heard_, other.heard_);
  return *this;
}

Worker::~Worker() {
  if (pipe_ >= 0) ::close(pipe_);
  if (process_ > 0) {
    ask_to_stop();
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

void Worker::ask_to_stop() const { ::kill(process_, SIGTERM); }

std::optional<Worker::End> Worker::end() {
  std::array<char, 4096> buffer{};
  ssize_t n = 0;
  while ((n = ::read(pipe_, buffer.data(), buffer.size())) > 0 || (n < 0 && errno == EINTR))
    if (n > 0) heard_.append(buffer.data(), static_cast<std::size_t>(n));
  if (n < 0) return std::nullopt;  // nothing more for now
  int raw = 0;
  while (::waitpid(process_, &raw, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  End end{heard_, WIFSIGNALED(raw) ? WTERMSIG(raw) : 0, WIFEXITED(raw) ? WEXITSTATUS(raw) : 0};
  return end;
}

}  // namespace arenite::study
