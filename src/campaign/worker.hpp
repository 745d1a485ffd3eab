#pragma once
#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

namespace arenite::study {

/// A process of its own that does one thing and says one word. It is asked to stop (SIGTERM) when this process dies.
class Worker {
 public:
  /// `work` gives the word; it must let no exception out.
  explicit Worker(const std::function<std::string()>& work);
  Worker(Worker&& other) noexcept;
  Worker& operator=(Worker&& other) noexcept;
  ~Worker();

  int descriptor() const { return pipe_; }  ///< readable when there is something to hear
  void ask_to_stop() const;
  /// How it ended: its word, or, where it died without one, the signal or status that it died of.
  struct End {
    std::string word;
    int signal = 0, status = 0;
  };
  /// Nothing while it is at work.
  std::optional<End> end();

 private:
  pid_t process_ = -1;
  int pipe_ = -1;
  std::string heard_;
};

}  // namespace arenite::study
