#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/film.hpp"

// When frames were taken, as other programs name and write it.
namespace arenite::io {

/// The unit at the end of a name that, in any case, is one of the times of frames: "ms" of "time_ms", "" of
/// "Timestamps"; nothing for a name of anything else, as T, a temperature.
std::optional<std::string> unit_of_time_name(std::string_view name);

/// Whether a name, in any case, is one of the numbers of frames: "frame_number", "FrameID".
bool names_frame_numbers(std::string_view name);
/// The same of an array with a number for each frame, which may be called no more than "frame" or "index".
bool names_array_of_numbers(std::string_view name);

/// What a text beside a frame says of it.
struct FrameWords {
  double time = std::numeric_limits<double>::quiet_NaN();  ///< s; NaN: not stated, or not understood
  std::int64_t number = -1;                                ///< -1: not stated
  double rate = 0;                                         ///< frames a second; 0: not stated
  std::string not_understood;                              ///< what stands for a time and is none that is known
  std::string unknown_rate;                                ///< the same of a rate: "fps = fast"
  bool says_anything() const;
};

/// Of "time = 33.3 ms", "# Time: 12:00:03.25", "Frame #12, t=0.4 s" or {"frame": 12, "timestamp_s": 0.4}: the first
/// time and the first number. Without a unit a time is in that of its name, or in seconds; of a date the hour counts.
FrameWords words_of_frame(std::string_view text);

/// Takes the times of all frames, or else their numbers (take_stamps_and_numbers); a remark says what is left aside.
void take_words(FilmInfo& info, const std::vector<FrameWords>& frames, bool rate_given);

}  // namespace arenite::io
