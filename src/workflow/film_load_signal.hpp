#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "model/film.hpp"
#include "thermal/thermography/load_signal.hpp"

namespace arenite::study {

/// The load's cycle from the lock-in line of a .ptw film; nothing for films without. `notice` is called where the line shows no cycle near the
/// frequency that was told, or another one.
std::optional<thermography::LoadSignal> load_signal_of(const std::filesystem::path& path, const FilmInfo& film, double told,
                                                       const std::function<void(const std::string&)>& notice);

}  // namespace arenite::study
