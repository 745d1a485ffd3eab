#pragma once
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>

namespace arenite::app {

/// Serves the status page of a run's folder on the loopback address until `is_over` says so; a port of 0 takes a free
/// one. `tell` is given the address, which holds a token that every request needs. Throws InputError where the port
/// cannot be had.
void serve_watch(const std::filesystem::path& folder, int port, const std::function<void(const std::string& url)>& tell,
                 const std::function<bool()>& is_over);

/// A process of its own that serves the page of a run, so that the run shares neither threads nor HDF5 with it, and
/// ends a few seconds after this.
class Watcher {
 public:
  explicit Watcher(const std::filesystem::path& folder);
  ~Watcher();
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;

 private:
  int tie_ = -1;  ///< the write end of a pipe: it closes with this process, however that ends
};

}  // namespace arenite::app
