#include "watch_server.hpp"

// Debian compiles httplib into a library: its classes are as large as here only under the same definitions. No TLS is
// spoken.
#define CPPHTTPLIB_OPENSSL_SUPPORT
#define CPPHTTPLIB_ZLIB_SUPPORT
#define CPPHTTPLIB_BROTLI_SUPPORT
#include <fcntl.h>
#include <fmt/core.h>
#include <httplib.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <mutex>
#include <random>
#include <thread>

#include "core/error.hpp"
#include "print.hpp"
#include "watch_state.hpp"

namespace arenite::app {
namespace {

constexpr const char* loopback = "127.0.0.1";

/// 128 bits that nobody guesses, as 32 digits.
std::string new_token() {
  std::random_device source;  // getrandom
  std::string token;
  for (int word = 0; word < 4; ++word) token += fmt::format("{:08x}", source());
  return token;
}

/// Takes as long wherever they differ.
bool same(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t k = 0; k < a.size() && k < b.size(); ++k)
    difference |= static_cast<unsigned char>(a[k]) ^ static_cast<unsigned char>(b[k]);
  return difference == 0;
}

/// The name that a browser was led here by must be this machine's own, or a page from elsewhere could have its name
/// point here.
bool is_own_host(const std::string& host, int port) {
  return host == fmt::format("{}:{}", loopback, port) || host == fmt::format("localhost:{}", port);
}

void harden(httplib::Response& response) {
  response.set_header("Cache-Control", "no-store");
  response.set_header("Referrer-Policy", "no-referrer");  // the address holds the token
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("X-Frame-Options", "DENY");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
}

/// A page may run what stands in it and speak to `to` alone; that of a result compiles a function of its own.
void send_page(httplib::Response& response, const std::string& page, const char* scripts, const char* to) {
  response.set_header(
      "Content-Security-Policy",
      fmt::format(
          "default-src 'none'; script-src 'unsafe-inline'{}; style-src 'unsafe-inline'; img-src data: blob:; font-src "
          "data:; worker-src blob:; connect-src {}; form-action 'none'; base-uri 'none'; frame-ancestors 'none'",
          scripts, to));
  response.set_content(page, "text/html; charset=utf-8");
}

void refuse(httplib::Response& response, int status) {
  response.status = status;
  response.set_content(fmt::format("{}\n", status), "text/plain");
}

/// Answers requests for one folder, one at a time: HDF5 is not made for threads.
class Answers {
 public:
  Answers(const std::filesystem::path& folder, std::string token) : state_(folder), token_(std::move(token)) {}
  int port = 0;

  void answer(const httplib::Request& request, httplib::Response& response) {
    harden(response);
    const std::size_t slash = request.path.find('/', 1);
    const std::string given =
        request.path.substr(request.path.empty() ? 0 : 1, slash == std::string::npos ? slash : slash - 1);
    if (!is_own_host(request.get_header_value("Host"), port) || !same(given, token_)) return refuse(response, 403);
    const std::string what = slash == std::string::npos ? "?" : request.path.substr(slash + 1);
    try {
      if (request.method == "POST" && what == "stop") return stop(request, response);
      if (request.method == "GET") return show(what, response);
      refuse(response, 405);
    } catch (const std::exception& error) {  // a file that has just been moved: the next request finds it
      response.status = 503;
      response.set_content(std::string(error.what()) + "\n", "text/plain");
    }
  }

 private:
  void show(const std::string& what, httplib::Response& response) {
    const std::lock_guard lock(mutex_);
    if (what.empty()) return send_page(response, watch_page(), "", "'self'");
    if (what == "state") return response.set_content(to_json(state_.numbers()), "application/json");
    if (what != "page") return refuse(response, 404);
    const std::string page = state_.page();
    if (page.empty()) return refuse(response, 404);
    send_page(response, page, " 'unsafe-eval'", "data: blob:");
  }

  void stop(const httplib::Request& request, httplib::Response& response) {
    const std::string origin = request.get_header_value("Origin");
    if (!origin.empty() && !(origin.starts_with("http://") && is_own_host(origin.substr(7), port)))
      return refuse(response, 403);
    const std::lock_guard lock(mutex_);
    if (!state_.stop()) return refuse(response, 409);
    response.set_content("{\"stopping\":true}", "application/json");
  }

  WatchState state_;
  std::string token_;
  std::mutex mutex_;
};

}  // namespace

void serve_watch(const std::filesystem::path& folder, int port, const std::function<void(const std::string& url)>& tell,
                 const std::function<bool()>& is_over) {
  httplib::Server server;
  // Connections that send nothing take a thread each, so there are many, and for a second only.
  server.new_task_queue = [] { return new httplib::ThreadPool(64); };
  server.set_read_timeout(1);
  server.set_keep_alive_timeout(1);
  server.set_keep_alive_max_count(1);
  server.set_socket_options([](int socket) {  // a port that somebody has is not shared, which httplib would allow
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  server.set_payload_max_length(1024);
  const std::string token = new_token();
  Answers answers(folder, token);
  server.set_pre_routing_handler([&](const httplib::Request& request, httplib::Response& response) {
    // Answers are whole: hundreds of ranges of one page would be hundreds of pages. The request is the server's own,
    // which cuts what is answered by these.
    const_cast<httplib::Request&>(request).ranges.clear();
    answers.answer(request, response);
    return httplib::Server::HandlerResponse::Handled;
  });
  answers.port = port == 0 ? server.bind_to_any_port(loopback) : server.bind_to_port(loopback, port) ? port : -1;
  if (answers.port <= 0)
    throw InputError(
        fmt::format("--port {}: not available on this machine; leave the option out to use a free port", port));
  std::thread listener([&] { server.listen_after_bind(); });
  tell(fmt::format("http://{}:{}/{}/", loopback, answers.port, token));
  while (!is_over()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  server.stop();
  listener.join();
}

namespace {

/// Until the other end of the pipe is gone for some seconds: a browser asks once more, and sees how the run ended.
std::function<bool()> after_end_of(int tie) {
  using clock = std::chrono::steady_clock;
  return [tie, end = clock::time_point::max()]() mutable {
    pollfd other{tie, POLLIN, 0};
    if (end == clock::time_point::max() && ::poll(&other, 1, 0) > 0) end = clock::now() + std::chrono::seconds(3);
    return clock::now() >= end;
  };
}

/// The output of the process that serves goes nowhere, lest whoever waits for the run's output wait for it, too.
void let_go_of_output() {
  const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
}

}  // namespace

Watcher::Watcher(const std::filesystem::path& folder) {
  int ends[2];
  std::fflush(nullptr);
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw InputError("--watch: the system cannot create a pipe; run `arenite watch` separately");
  const pid_t child = ::fork();
  if (child < 0) throw InputError("--watch: the system cannot create a process; run `arenite watch` separately");
  if (child > 0) {
    ::close(ends[0]);
    tie_ = ends[1];
    return;
  }
  ::close(ends[1]);
  std::signal(SIGINT, SIG_IGN);  // of a terminal, meant for the run
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGCHLD, SIG_DFL);
  try {
    const auto tell = [](const std::string& url) {
      print(stderr, "watch: {}\n", url);
      let_go_of_output();
    };
    serve_watch(folder, 0, tell, after_end_of(ends[0]));
  } catch (const std::exception& error) { print(stderr, "--watch: {}; the run continues\n", error.what()); }
  ::_exit(0);
}

Watcher::~Watcher() { ::close(tie_); }

}  // namespace arenite::app
