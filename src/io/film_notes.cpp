#include "io/film_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/table.hpp"

namespace arenite::io {
namespace {

template <class Take>
void each_note(std::string_view text, Take&& take) {
  Lines lines(text);
  std::string_view line;
  while (lines.next(line))
    if (const auto equals = line.find('='); equals != std::string_view::npos) take(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
}

/// One line of text, whatever a camera's name holds.
std::string in_one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text;
}

}  // namespace

std::string film_notes(const FilmInfo& info) {
  std::string text;
  const auto number = [&](const char* key, double value) {
    if (value > 0) text += fmt::format("{} = {}\n", key, value);
  };
  const auto words = [&](const char* key, const std::string& value) {
    if (!value.empty()) text += fmt::format("{} = {}\n", key, in_one_line(value));
  };
  number("frame_rate", info.frame_rate);
  number("integration", info.integration);
  number("bits", info.bits);
  if (info.quantity != FilmQuantity::unknown) words("quantity", info.quantity == FilmQuantity::kelvin ? "K" : "DL");
  words("camera", info.camera);
  words("lens", info.lens);
  words("filter", info.filter);
  number("emissivity", info.emissivity);
  number("ambient", info.ambient);
  number("band_low", info.band_low);
  number("band_high", info.band_high);
  return text;
}

void take_notes(std::string_view text, FilmInfo& info) {
  each_note(text, [&](std::string_view key, std::string_view value) {
    const auto number = to_number(value);
    const double positive = number && *number > 0 ? *number : 0;
    if (key == "frame_rate") info.frame_rate = positive;
    if (key == "integration") info.integration = positive;
    if (key == "bits") info.bits = static_cast<int>(std::min(positive, 16.0));
    if (key == "quantity" && value == "K") info.quantity = FilmQuantity::kelvin;
    if (key == "quantity" && value == "DL") info.quantity = FilmQuantity::digital_level;
    if (key == "camera") info.camera = value;
    if (key == "lens") info.lens = value;
    if (key == "filter") info.filter = value;
    if (key == "emissivity") info.emissivity = positive;
    if (key == "ambient") info.ambient = positive;
    if (key == "band_low") info.band_low = positive;
    if (key == "band_high") info.band_high = positive;
  });
}

double noted_time(std::string_view text) {
  double time = std::numeric_limits<double>::quiet_NaN();
  each_note(text, [&](std::string_view key, std::string_view value) {
    if (const auto number = to_number(value); key == "time" && number) time = *number;
  });
  return time;
}

}  // namespace arenite::io
