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

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// By letters, and by value where both have a number: frame 9 before frame 10.
bool before(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    while (i < a.size() && a[i] == '0') ++i;
    while (j < b.size() && b[j] == '0') ++j;
    std::size_t m = i, n = j;
    while (m < a.size() && is_digit(a[m])) ++m;
    while (n < b.size() && is_digit(b[n])) ++n;
    if (m - i != n - j) return m - i < n - j;
    if (const int order = a.compare(i, m - i, b, j, n - j); order != 0) return order < 0;
    i = m, j = n;
  }
  return a.size() - i < b.size() - j;
}

std::vector<fs::path> members(const fs::path& pattern) {
  const bool folder = fs::is_directory(pattern);
  const fs::path where = folder ? pattern : pattern.has_parent_path() ? pattern.parent_path() : fs::path(".");
  if (!fs::is_directory(where)) refuse(where.string(), "there is no such folder; check its name");
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(where)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file() || name.starts_with('.')) continue;
    if (folder ? std::any_of(name.begin(), name.end(), is_digit) : fits(name, pattern.filename().string())) names.push_back(name);
  }
  std::sort(names.begin(), names.end(), before);
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

  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    prepare(info_, first, count, block);
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
    refuse(members_[member].string(), "holds {} frames of {} x {} pixels, but {} holds {} of {} x {}; a series must be all alike", it.frames, it.width,
           it.height, members_[0].filename().string(), each_, info_.width, info_.height);
  }

  std::vector<fs::path> members_;
  FilmChoice choice_;
  FilmPointer current_;
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

  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    film_->read(first, count, part_);
    block.prepare(info_, first, count);
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
