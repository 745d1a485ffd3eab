#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "io/film/formats.hpp"
#include "io/film/other_statements.hpp"
#include "io/film/stated_times.hpp"
#include "io/table/table.hpp"

namespace arenite::io {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 24;

/// The lines of a file, read part by part.
class FileLines {
 public:
  FileLines(const ByteSource& bytes, std::uint64_t at, int line) : bytes_(bytes), next_(at), number_(line) {}

  /// False at the end. The line is valid until the next call.
  bool next(std::string_view& line) {
    std::size_t end = 0;
    while ((end = buffer_.find('\n', at_)) == std::string::npos && !done_) {
      if (buffer_.size() - at_ > longest_line)
        throw InputError(bytes_.name(), number_ + 1,
                         "is a line of more than 16 million characters, too long for a row of a frame; check the file");
      fill();
    }
    if (at_ == buffer_.size()) return false;
    begin_ = next_ - (buffer_.size() - at_);
    line = std::string_view(buffer_).substr(at_, std::min(end, buffer_.size()) - at_);
    at_ += line.size() + (end == std::string::npos ? 0 : 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++number_;
    return true;
  }
  std::uint64_t begin() const { return begin_; }  ///< of the last line, bytes
  int number() const { return number_; }

 private:
  void fill() {
    buffer_.erase(0, at_);
    at_ = 0;
    const std::string more = bytes_.text(next_, std::size_t{1} << 18);
    done_ = more.empty();
    next_ += more.size();
    buffer_ += more;
  }

  const ByteSource& bytes_;
  std::uint64_t next_, begin_ = 0;
  std::string buffer_;
  std::size_t at_ = 0;
  int number_;
  bool done_ = false;
};

/// How the numbers of a row are parted. Where that is no comma, a comma may stand for the decimal point.
char separator_of(std::string_view line) {
  for (const char c : {';', '\t', ','})
    if (line.find(c) != std::string_view::npos) return c;
  return ' ';
}

std::optional<float> number_of(std::string_view cell, bool decimal_comma) {
  char text[64];
  while (!cell.empty() && (cell.front() == ' ' || cell.front() == '+')) cell.remove_prefix(1);
  while (!cell.empty() && cell.back() == ' ') cell.remove_suffix(1);
  if (cell.empty() || cell.size() > sizeof(text)) return std::nullopt;
  std::copy(cell.begin(), cell.end(), text);
  if (decimal_comma) std::replace(text, text + cell.size(), ',', '.');
  const auto value = parse_number<float>({text, cell.size()});
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Calls `take` with each cell of a row; a separator at the end of a line ends it. False if `take` says so.
template <class Take> bool each_cell(std::string_view line, char separator, Take&& take) {
  std::size_t at = 0;
  while (at < line.size()) {
    if (separator == ' ') {
      at = line.find_first_not_of(" \t", at);
      if (at == std::string_view::npos) return true;
    }
    const std::size_t end =
        std::min(separator == ' ' ? line.find_first_of(" \t", at) : line.find(separator, at), line.size());
    if (!take(line.substr(at, end - at))) return false;
    at = end + 1;
  }
  return true;
}

bool begins_with_number(std::string_view line, char separator) {
  bool number = false;
  each_cell(line, separator, [&](std::string_view cell) {
    number = number_of(cell, separator != ',').has_value();
    return false;
  });
  return number;
}

/// What a cell says that stands for a number which is not there: a dead pixel.
bool is_no_value(std::string_view cell) {
  const std::string word = lower_case(trimmed(cell));
  const std::string_view bare = std::string_view(word).substr(word.starts_with('-') || word.starts_with('+') ? 1 : 0);
  return bare == "nan" || bare == "inf" || bare == "infinity";
}

/// A line of as many cells as a row has, most of which hold a number's place, is a row whose first cell is wrong. Were
/// it taken for what parts frames, all rows below would be one too high.
bool is_spoilt_row(std::string_view line, char separator, int width) {
  int cells = 0, numbers = 0;
  each_cell(line, separator, [&](std::string_view cell) {
    numbers += number_of(cell, separator != ',') || is_no_value(cell) ? 1 : 0;
    return ++cells <= width;
  });
  return cells == width && 2 * numbers > cells && lower_case(line).find("frame") == std::string::npos &&
         line.find('=') == std::string_view::npos;
}

struct Place {
  std::uint64_t at = 0;  ///< bytes
  int line = 0;          ///< lines before it
};

/// Frames found in one pass; their numbers are read when they are asked for.
class TextFilm : public KnownFilm {
 public:
  TextFilm(Bytes bytes, const FilmChoice& choice) : bytes_(std::move(bytes)) {
    info_.floating = true;
    take_form();
    FileLines lines(*bytes_, 0, 0);
    int rows = 0;
    for (std::string_view line; separator_ != 0 && lines.next(line);) {
      if (!begins_with_number(line, separator_) && !is_spoilt_row(line, separator_, info_.width)) {
        end_frame(rows, lines.number());
        note(line, lines.number());
        continue;
      }
      if (rows++ == 0) begin_frame({lines.begin(), lines.number() - 1});
      if (info_.frames == 0 && std::int64_t{rows} * info_.width > choice.most_pixels)
        check_film_size(bytes_->name(), info_.width, rows, 1, choice);
    }
    end_frame(rows, lines.number() + 1);
    if (info_.frames == 0)
      refuse(bytes_->name(), "holds no rows of numbers, as frames in text would; give a film or a result");
    check_film_size(bytes_->name(), std::max(info_.width, 1), std::max(info_.height, 1), info_.frames, choice);
    take_words(info_, words_, choice.frame_rate.has_value());
    if (zero_) info_.quantity = FilmQuantity::kelvin;
    others_.tell(info_);
    if (choice.gives_temperatures()) zero_ = std::nullopt;
    take_choice(info_, choice);
  }

  void fill(std::int64_t first, std::size_t count, FrameBlock& block) override {
    for (std::size_t i = 0; i < count; ++i)
      read_frame(places_[static_cast<std::size_t>(first) + i], block.value.data() + i * info_.pixels());
  }

 private:
  /// How numbers are parted, and how many a row has, of the first line that begins with a number.
  void take_form() {
    FileLines lines(*bytes_, 0, 0);
    for (std::string_view line; separator_ == 0 && lines.next(line);) {
      if (!begins_with_number(line, separator_of(line))) continue;
      separator_ = separator_of(line);
      info_.width = cells_of(line);
    }
  }

  /// What a line between frames says of the next, and of all numbers.
  void note(std::string_view line, int number) {
    if (const auto zero = zero_stated_in(line); zero && zero_.value_or(*zero) != *zero)
      throw refusal_at(bytes_->name(), number,
                       "states another unit of temperature than a line before; give one to all");
    else if (zero) zero_ = zero;
    const FrameWords said = words_of_frame(line);
    if (!std::isnan(said.time) || !said.not_understood.empty())
      next_.time = said.time, next_.not_understood = said.not_understood;
    if (said.number >= 0) next_.number = said.number;
    if (said.rate > 0) info_.frame_rate = said.rate;
    if (!said.unknown_rate.empty()) next_.unknown_rate = said.unknown_rate;
    const std::string low = lower_case(line);
    const bool in_fahrenheit =
        low.find("\u00b0f") != low.npos || low.find("fahrenheit") != low.npos || low.find("degf") != low.npos;
    if (!zero_stated_in(line) && !said.says_anything() && !in_fahrenheit) others_.note(line, separator_, info_);
    if (!told_ && in_fahrenheit) {
      told_ = true;
      info_.remarks.push_back(
          fmt::format("Line {} states degrees Fahrenheit, which are not used: numbers are taken as a signal; give "
                      "temperatures in K or \u00b0C.",
                      number));
    }
  }

  void begin_frame(const Place& place) {
    places_.push_back(place);
    words_.push_back(std::exchange(next_, {}));
  }

  void end_frame(int& rows, int line) {
    if (rows == 0) return;
    if (info_.height == 0) info_.height = rows;
    if (rows != info_.height)
      throw refusal_at(bytes_->name(), line, "ends a frame of {} rows, but the first has {}; complete or remove it",
                       rows, info_.height);
    ++info_.frames;
    rows = 0;
  }

  int cells_of(std::string_view line) const {
    int cells = 0;
    each_cell(line, separator_, [&](std::string_view) { return ++cells < 10'000'000; });
    return cells;
  }

  void read_frame(const Place& place, float* value) const {
    FileLines lines(*bytes_, place.at, place.line);
    std::string_view line;
    for (int row = 0; row < info_.height; ++row) {
      if (!lines.next(line)) refuse(bytes_->name(), "became shorter while it was read; copy it again");
      int column = 0;
      float* to = value + static_cast<std::size_t>(row) * static_cast<std::size_t>(info_.width);
      const bool whole = each_cell(line, separator_, [&](std::string_view cell) {
        const auto number = number_of(cell, separator_ != ',');
        if (!number)
          throw refusal_at(bytes_->name(), lines.number(),
                           "holds \"{}\" in column {}, which is not a number; correct it", cell.substr(0, 40),
                           column + 1);
        if (column == info_.width) return false;
        to[column++] = zero_ ? static_cast<float>(*number + *zero_) : *number;
        return true;
      });
      if (!whole || column != info_.width)
        throw refusal_at(bytes_->name(), lines.number(), "is a row of {} numbers, but the first has {}; complete it",
                         cells_of(line), info_.width);
    }
  }

  Bytes bytes_;
  char separator_ = 0;
  std::vector<Place> places_;
  std::vector<FrameWords> words_;  ///< as stated before each frame
  std::optional<double> zero_;     ///< where its temperatures count from, K; nothing where it states no unit
  FrameWords next_;
  OtherStatements others_;
  bool told_ = false;  ///< of degrees Fahrenheit
};

bool is_text_film(std::string_view head) {
  std::size_t numbers = 0;
  for (const char c : head) {
    if (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t') return false;
    numbers += c >= '0' && c <= '9' ? 1 : 0;
  }
  return numbers > 0;
}

}  // namespace

/// Numbers as text, a line a row; frames are parted by empty lines or lines that are no numbers.
const FilmFormat films::text{
    .name = "text",
    .sentence = "frames of numbers as text",
    .states = {{"\"Frame N\" between frames", "numbers that are missing give gaps in time"},
               {"\"time = 33.3 ms\", \"Time [ms]: 33.3\", \"# Time: 0.033 s\", \"t=12:00:03.25\" between frames",
                "used, without a unit in s; told where a time is not understood, or where "
                "not all frames state one"},
               {"a unit in a line above frames, \"Temperature [°C]\", \"unit = K\"",
                "used: temperatures, of degrees Celsius counted from absolute zero"},
               {"\"frame rate = 0.1 kHz\", \"fps: 30\", \"Frame interval [ms]: 33\" in a line of words",
                "used where frames state no times and no rate is given; told where it is not understood"},
               {"\"Camera: ...\" in a line of words", "shown"},
               {"other statements in lines of words, \"Date: ...\", \"Emissivity: 0.95\"", "told, not used"},
               {"degrees Fahrenheit", "told, not used: numbers are a signal"},
               {"cells that are no numbers", "refused with line and column"}},
    .is = is_text_film,
    .open = [](const Bytes& bytes, const FilmChoice& choice) -> FilmPointer {
      return std::make_unique<TextFilm>(bytes, choice);
    }};

}  // namespace arenite::io
