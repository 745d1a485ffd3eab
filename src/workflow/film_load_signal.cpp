#include "workflow/film_load_signal.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/lock_in_line.hpp"
#include "thermal/thermography/frame_times.hpp"

namespace arenite::study {

std::optional<thermography::LoadSignal> load_signal_of(const std::filesystem::path& path, const FilmInfo& film, double told,
                                                       const std::function<void(const std::string&)>& notice) {
  const auto line = io::lock_in_line(path);
  if (line.empty()) return std::nullopt;
  const auto time = thermography::frame_times(film);
  const auto signal = thermography::fit_load_signal(time, line, told);
  if (!signal) {
    notice(fmt::format("the film's lock-in line shows no cycle near {:.6g} Hz; it is left aside", told));
  } else if (std::abs(signal->frequency - told) > 1 / (time.back() - time.front())) {
    notice(fmt::format("the film's lock-in line cycles at {:.6g} Hz, and not at the {:.6g} Hz that were told; it is taken", signal->frequency, told));
  }
  return signal;
}

}  // namespace arenite::study
