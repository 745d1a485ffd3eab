#include "film_source.hpp"

#include "arrays.hpp"
#include "file_notes.hpp"
#include "io/film/film.hpp"

namespace arenite::python {
namespace {

/// Frames in an array of Python's, which is looked at and not copied.
class ArrayFilm : public FilmSource {
 public:
  ArrayFilm(const py::array& frames, double rate, std::vector<double> time) {
    if (frames.ndim() != 3 || frames.size() == 0)
      throw InputError("a film is an array (frames, height, width) with at least one pixel");
    if (py::isinstance<py::array_t<std::uint16_t>>(frames))
      held_ = py::array_t<std::uint16_t, py::array::c_style>::ensure(frames);
    else held_ = floats(ArrayLike(frames), 3, "film");
    info_.floating = held_.itemsize() == 4;
    info_.frames = held_.shape(0);
    info_.height = static_cast<int>(held_.shape(1));
    info_.width = static_cast<int>(held_.shape(2));
    info_.frame_rate = rate;
    info_.time = std::move(time);
    info_.format = "array";
    data_ = held_.data();
  }
  const FilmInfo& info() const override { return info_; }
  void read(std::int64_t first, std::size_t count, FrameBlock& block) override {
    const std::size_t begin = static_cast<std::size_t>(first) * info_.pixels(), end = begin + count * info_.pixels();
    block.first = first;
    block.frames = count;
    if (info_.floating) block.value.assign(values_in_memory() + begin, values_in_memory() + end);
    else block.level.assign(levels_in_memory() + begin, levels_in_memory() + end);
  }
  const std::uint16_t* levels_in_memory() const override {
    return info_.floating ? nullptr : static_cast<const std::uint16_t*>(data_);
  }
  const float* values_in_memory() const override { return info_.floating ? static_cast<const float*>(data_) : nullptr; }

 private:
  py::array held_;
  const void* data_ = nullptr;
  FilmInfo info_;
};

Path path_of(const FilmLike& film) {
  if (!py::isinstance<py::str>(film) && !py::hasattr(film, "__fspath__"))
    throw InputError("a film is a file, or an array (frames, height, width)");
  return film.cast<Path>();
}

}  // namespace

std::vector<Keyword> with_film_keywords(std::vector<Keyword> own) {
  own.insert(own.end(), {{"frame_rate", "film.frame_rate"},
                         {"scale", "film.scale"},
                         {"offset", "film.offset"},
                         {"dataset", "film.dataset"}});
  return own;
}

const Keywords& film_keywords() {
  static const Keywords keywords(recipe::every_key<recipe::FilmSection>(), with_film_keywords());
  return keywords;
}

recipe::FilmSection film_said(const char* function, const py::kwargs& more) {
  recipe::FilmSection said;
  read_keywords(said, film_keywords().given(function, more));
  return said;
}

std::unique_ptr<FilmSource> film_of(const FilmLike& film, const recipe::FilmSection& said,
                                    const std::optional<ArrayLike>& time) {
  const io::FilmChoice choice = said.film.value_or(io::FilmChoice{});
  if (py::isinstance<py::array>(film)) {
    if (choice.scale || choice.offset || !choice.dataset.empty())
      throw InputError("scale, offset and dataset are for films in files; an array is taken as it is");
    return std::make_unique<ArrayFilm>(py::array(unmasked(film)), choice.frame_rate.value_or(0),
                                       time ? to_vector(*time, "time") : std::vector<double>{});
  }
  if (time) throw InputError("the time of frames is for arrays; a file has its own times, or give its frame_rate");
  auto source = io::open_film(path_of(film), choice);
  warn_of_notes(source->info().remarks);
  return source;
}

}  // namespace arenite::python
