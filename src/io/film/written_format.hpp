#pragma once
#include <string>

#include "core/parameters.hpp"

namespace arenite::io {

/// The format that films of digital levels are written in.
struct WrittenFilms {
  std::string format = "ptw";
};
/// The format that maps of temperatures are written in.
struct WrittenMaps {
  std::string format = "tiff";
};
void declare(ParameterVisitor& visitor, WrittenFilms& films);
void declare(ParameterVisitor& visitor, WrittenMaps& maps);

}  // namespace arenite::io
