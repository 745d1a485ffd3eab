#include <fnmatch.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "core/problems.hpp"
#include "io/film/formats.hpp"

namespace arenite::io {

namespace fs = std::filesystem;
namespace {

/// Whether a name fits a pattern in which * stands for anything, and nothing else for what it is not.
bool fits(const std::string& name, std::string_view pattern) {
  std::string exact;
  for (const char c : pattern) exact += c == '*' ? "*" : std::string("\\") + c;
  return ::fnmatch(exact.c_str(), name.c_str(), 0) == 0;
}

constexpr const char* digits = "0123456789";

/// A name as it is sorted: numbers in it by value (frame 9 before frame 10), as if all had as many digits.
std::string sorting_key(const std::string& name) {
  constexpr std::size_t most_digits = 255;  // no name is longer
  std::string key;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t number = std::min(name.find_first_of(digits, at), name.size()), end = std::min(name.find_first_not_of(digits, number), name.size());
    const std::size_t first = std::min(name.find_first_not_of('0', number), end);
    key += name.substr(at, number - at) + std::string(number < end ? most_digits - (end - first) : 0, '0') + name.substr(first, end - first);
    at = end;
  }
  return key;
}

std::vector<fs::path> members(const fs::path& pattern) {
  const bool folder = fs::is_directory(pattern);
  const fs::path where = folder ? pattern : pattern.has_parent_path() ? pattern.parent_path() : fs::path(".");
  if (!fs::is_directory(where)) refuse(where.string(), "there is no such folder; check its name");
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(where)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name.starts_with('.')) continue;
    if (folder ? name.find_first_of(digits) != std::string::npos : fits(name, pattern.filename().string())) names.push_back(name);
  }
  std::ranges::sort(names, {}, sorting_key);
  std::vector<fs::path> paths;
  for (const std::string& name : names) paths.push_back(where / name);
  return paths;
}

/// All files have as many frames as the first, which is checked when they are read.
class Series : public KnownFilm {
 public:
  Series(std::vector<fs::path> members, const FilmChoice& choice) : members_(std::move(members)), choice_(choice) {
    choice_.scale = choice_.offset = std::nullopt;  // what all files together are made of
    open(0);
    info_ = current_->info();
    each_ = info_.frames;
    info_.frames *= static_cast<std::int64_t>(members_.size());
    info_.time.clear();
  }

  void fill(std::int64_t first, std::size_t count, FrameBlock& block) override {
    for (std::size_t i = 0; i < count;) {
      const std::int64_t frame = first + static_cast<std::int64_t>(i), within = frame % each_;
      open(static_cast<std::size_t>(frame / each_));
      const std::size_t n = std::min(count - i, static_cast<std::size_t>(each_ - within));
      current_->read(within, n, part_);
      std::copy(part_.level.begin(), part_.level.end(), block.level.begin() + static_cast<std::ptrdiff_t>(info_.floating ? 0 : i * info_.pixels()));
      std::copy(part_.value.begin(), part_.value.end(), block.value.begin() + static_cast<std::ptrdiff_t>(info_.floating ? i * info_.pixels() : 0));
      i += n;
    }
  }

 private:
  void open(std::size_t member) {
    if (current_ && member == number_) return;
    current_ = open_film(open_bytes(members_[member]), choice_);
    number_ = member;
    const FilmInfo& it = current_->info();
    if (each_ == 0 || (it.width == info_.width && it.height == info_.height && it.frames == each_ && it.floating == info_.floating)) return;
    refuse(members_[member].string(), "holds {} frames of {} x {} pixels, but {} holds {} of {} x {}; all frames of a series must be alike", it.frames,
           it.width, it.height, members_[0].filename().string(), each_, info_.width, info_.height);
  }

  std::vector<fs::path> members_;
  FilmChoice choice_;
  std::unique_ptr<FilmSource> current_;
  std::size_t number_ = 0;
  std::int64_t each_ = 0;
  FrameBlock part_;
};

class ScaledFilm : public KnownFilm {
 public:
  ScaledFilm(FilmPointer film, double scale, double offset) : film_(std::move(film)), scale_(scale), offset_(offset) {
    info_ = film_->info();
    info_.floating = true;
    info_.bits = 0;
    info_.quantity = FilmQuantity::kelvin;
  }

  void fill(std::int64_t first, std::size_t count, FrameBlock& block) override {
    film_->read(first, count, part_);
    const auto kelvin = [&](auto v) { return static_cast<float>(scale_ * static_cast<double>(v) + offset_); };
    std::transform(part_.level.begin(), part_.level.end(), block.value.begin(), kelvin);
    std::transform(part_.value.begin(), part_.value.end(), block.value.begin(), kelvin);
  }

 private:
  FilmPointer film_;
  double scale_, offset_;
  FrameBlock part_;
};

}  // namespace

FilmPointer open_series(const fs::path& pattern, const FilmChoice& choice) {
  auto found = members(pattern);
  if (found.empty()) refuse(pattern.string(), "holds no files with numbers in their names, which would be the frames of a film; check the name");
  return std::make_unique<Series>(std::move(found), choice);
}

FilmPointer scaled_film(FilmPointer film, const FilmChoice& choice) {
  if (!choice.scale && !choice.offset) return film;
  return std::make_unique<ScaledFilm>(std::move(film), choice.scale.value_or(1), choice.offset.value_or(0));
}

}  // namespace arenite::io
