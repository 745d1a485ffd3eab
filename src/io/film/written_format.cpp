#include "io/film/written_format.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "core/mapped.hpp"
#include "io/film/film.hpp"

namespace arenite::io {
namespace {

template <bool of_temperatures>
void declare_format(ParameterVisitor& v, std::string_view sentence, std::string& format) {
  static const std::vector<std::string> names = film_formats_to_write(of_temperatures);  // words refer to them
  int index = static_cast<int>(std::ranges::find(names, format) - names.begin());
  v.choice({"format", sentence}, index, mapped(names, [](const std::string& name) { return Word{name, ""}; }));
  format = names[static_cast<std::size_t>(index)];
}

}  // namespace

void declare(ParameterVisitor& v, WrittenFilms& films) {
  declare_format<false>(v, "Format of the films.", films.format);
}

void declare(ParameterVisitor& v, WrittenMaps& maps) { declare_format<true>(v, "Format of the maps.", maps.format); }

}  // namespace arenite::io
