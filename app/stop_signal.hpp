#pragma once

namespace arenite::app {

/// From now on SIGTERM and SIGINT ask for an orderly end.
void watch_for_signals();
bool stop_requested();

}  // namespace arenite::app
