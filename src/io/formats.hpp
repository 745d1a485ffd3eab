#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// All file formats that are read or written, but for our own (io/results): a word a format, in the order in which a
// file is tried. Each is one file of its name in its family's folder (film, image, volume, sample,
// export), which ends with its
// record: name, sentence, how a file is recognised, what reads and writes it, what it states and what is done with
// that. Choices by name, ending and content, messages, help texts, docs/formats.md and fuzz targets follow from these
// lists.
#define ARENITE_FILM_FORMATS(each) each(tiff) each(npy) each(hdf5) each(sfmov) each(ptw) each(hcc) each(raw) each(text)
#define ARENITE_PICTURE_FORMATS(each) each(png) each(tiff) each(jpeg) each(hdf5)
#define ARENITE_VOLUME_FORMATS(each) each(nrrd) each(meta_image) each(nifti) each(npy) each(npz) each(stack)
#define ARENITE_SAMPLE_FORMATS(each) \
  each(lammps) each(lammps_data) each(yade) each(lbpm) each(vtk) each(extxyz) each(mercury) each(csv)
#define ARENITE_EXPORT_FORMATS(each) each(vtk) each(fields) each(lammps) each(extxyz) each(netcdf) each(csv) each(npy)

/// Declares the records of a family, and `all` of them in the order of its list.
#define ARENITE_FORMAT_DECLARED(name) extern const Known name;
#define ARENITE_FORMAT_ADDRESS(name) &name,
#define ARENITE_FAMILY(Record, formats) \
  using Known = Record;                 \
  formats(ARENITE_FORMAT_DECLARED) inline constexpr const Known* all[] = {formats(ARENITE_FORMAT_ADDRESS)};

namespace arenite::io {

/// Something that files of a format may state (or an export carries), and what is done with it: used, refused or told.
/// Both are phrases without a full stop; a row of docs/formats.md each.
struct Stated {
  std::string_view what, done;
};

/// All that a format states, in its record: .states = {{"time", "taken from .."}, {"units", "told in a note"}}.
class Statements {
 public:
  constexpr Statements() = default;
  constexpr Statements(std::initializer_list<Stated> list) : count_(list.size()) {
    if (list.size() > most) throw std::length_error("a format states more than there is room for");
    std::copy(list.begin(), list.end(), all_.begin());
  }
  constexpr const Stated* begin() const { return all_.data(); }
  constexpr const Stated* end() const { return all_.data() + count_; }

 private:
  static constexpr std::size_t most = 24;
  std::array<Stated, most> all_{};
  std::size_t count_ = 0;
};

/// The first format of a family for which something holds, or null.
template <class Family, class Fits> auto first_format(const Family& all, Fits fits) {
  const auto found = std::find_if(std::begin(all), std::end(all), [&](const auto* format) { return fits(*format); });
  return found != std::end(all) ? *found : nullptr;
}
template <class Family> auto format_named(const Family& all, std::string_view name) {
  return first_format(all, [&](const auto& format) { return format.name == name; });
}
template <class Family> auto format_ending(const Family& all, const std::filesystem::path& path) {
  const std::string ending = path.extension().string();
  return first_format(
      all, [&](const auto& format) { return !ending.empty() && std::ranges::count(format.endings, ending) > 0; });
}

struct Any {
  bool operator()(const auto&) const { return true; }
};
/// Names or sentences of all formats of a family, or of those that fit.
template <class Family, class Word, class Fits = Any>
std::vector<std::string> words_of(const Family& all, Word word, Fits fits = {}) {
  std::vector<std::string> words;
  for (const auto* format : all)
    if (fits(*format)) words.emplace_back(std::invoke(word, *format));
  return words;
}

}  // namespace arenite::io
