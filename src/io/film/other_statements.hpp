#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "model/film.hpp"

namespace arenite::io {

/// What lines of words beside frames state that no reader uses, "Date: ..": told in one sentence.
class OtherStatements {
 public:
  /// Of a line that states nothing else; the name of a camera is taken. A separator of rows may part name and value,
  /// too, unless it is a blank.
  void note(std::string_view line, char separator, FilmInfo& info);
  void tell(FilmInfo& info) const;

 private:
  static constexpr std::size_t most_told = 8;
  std::vector<std::string> names_;  ///< each once; one more than are told, if there are more
};

}  // namespace arenite::io
