#pragma once
#include <cstdint>
#include <vector>

#include "model/film.hpp"

namespace arenite::io {

/// Makes the moments at which frames were taken, s from any time on, the film's times; stamps that do not run forwards,
/// or none but zeros, are left aside with a remark. A step back of nearly a day is midnight. The frame rate that the
/// film states is there already: a remark says where stamps are others.
void take_stamps(FilmInfo& info, std::vector<double> stamp);

/// Makes numbers of frames, counted from anywhere, those of the film where some are missing, with a remark.
void take_numbers(FilmInfo& info, std::vector<std::int64_t> number);

/// Both of one film, each empty where it is not stated. Stamps are the times where they can be used, with a remark
/// where the numbers say otherwise; the numbers count without them, and where the frame rate is given.
void take_stamps_and_numbers(FilmInfo& info, std::vector<double> stamp, std::vector<std::int64_t> number,
                             bool rate_given);

}  // namespace arenite::io
