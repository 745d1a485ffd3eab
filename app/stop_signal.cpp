#include "stop_signal.hpp"

#include <csignal>

namespace arenite::app {
namespace {

volatile std::sig_atomic_t requested = 0;

void request_stop(int) { requested = 1; }

}  // namespace

void watch_for_signals() {
  std::signal(SIGTERM, request_stop);
  std::signal(SIGINT, request_stop);
}

bool stop_requested() { return requested != 0; }

}  // namespace arenite::app
