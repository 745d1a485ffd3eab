#include "io/formats.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "io/disk/file.hpp"
#include "io/export/export.hpp"
#include "io/film/formats.hpp"
#include "io/image/image.hpp"
#include "io/sample/formats.hpp"
#include "io/volume/volume.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

namespace fs = std::filesystem;

/// The formats that files of a folder define, by the record at their end: "const FilmFormat films::ptw".
std::set<std::string> defined_in(const std::string& folder, const std::string& family) {
  std::set<std::string> names;
  for (const auto& file : fs::directory_iterator(fs::path(ARENITE_SOURCE_DIR) / "src/io" / folder)) {
    const std::string text = read_file(file.path()), record = "Format " + family + "::";
    const std::size_t at = text.find(record);
    if (at == std::string::npos) continue;
    EXPECT_EQ(text.find(record, at + 1), std::string::npos) << file.path() << " holds two formats";
    const std::string name = text.substr(at + record.size(), text.find('{', at) - at - record.size());
    EXPECT_EQ(file.path().stem(), name);
    names.insert(name);
  }
  return names;
}

template <class Family> std::set<std::string> named_in(const Family& all) {
  const auto names = words_of(all, [](const auto& format) { return format.name; });
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  return {names.begin(), names.end()};
}

TEST(Formats, EachIsOneFileOfItsNameAndOneWordInItsList) {
  EXPECT_EQ(defined_in("film", "films"), named_in(films::all));
  EXPECT_EQ(defined_in("image", "pictures"), named_in(pictures::all));
  EXPECT_EQ(defined_in("volume", "volumes"), named_in(volumes::all));
  EXPECT_EQ(defined_in("sample", "samples"), named_in(samples::all));
  EXPECT_EQ(defined_in("export", "exports"), named_in(exports::all));
}

TEST(Formats, EveryFilmFormatHasACorpusForFuzzing) {
  for (const auto* format : films::all)
    EXPECT_TRUE(
        fs::is_directory(fs::path(ARENITE_SOURCE_DIR) / "tests/fuzz/corpus" / ("film_" + std::string(format->name))));
}

/// Whether a format says what it does with a thing, by one of these words in what it states.
template <class Format> bool has_words(const Format& format, const std::vector<std::string_view>& words) {
  return std::ranges::any_of(format.states, [&](const Stated& stated) {
    return !stated.done.empty() &&
           std::ranges::any_of(words, [&](auto word) { return stated.what.find(word) != stated.what.npos; });
  });
}

TEST(Formats, EachOfGrainsAndContactsSaysWhatItStatesAndWhatIsDoneWithIt) {
  const std::vector<std::string_view> topics[] = {{"units"},      {"step", "time"}, {"cell", "box"},
                                                  {"third", "z"}, {"columns"},      {"force", "overlap"}};
  for (const auto* format : samples::all)
    for (const auto& topic : topics)
      EXPECT_TRUE(has_words(*format, topic)) << format->name << " says nothing of " << topic.front();
  for (const auto* format : exports::all)
    for (const std::string_view topic : {"grains", "contacts"})
      EXPECT_TRUE(has_words(*format, {topic})) << format->name << " says nothing of " << topic;
}

TEST(Formats, NoTwoExportsAreAskedForByTheSameName) {
  const auto names = export_names();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  for (const auto& name : names) EXPECT_NE(export_named(name), nullptr);
  EXPECT_EQ(export_named("povray"), nullptr);
  EXPECT_EQ(export_named(""), nullptr);
}

void expect_words(const std::string& text, const std::vector<std::string>& words) {
  EXPECT_FALSE(words.empty());
  for (const auto& word : words)
    EXPECT_NE(text.find(word), std::string::npos) << "\"" << word << "\" is not in: " << text;
}

TEST(Formats, MessagesSayWhatTheFormatsSayOfThemselves) {
  const std::string no_film = test::complaint([] { open_film(bytes_in_memory("no film\n", "x"), {}); });
  expect_words(no_film, words_of(films::all, &FilmFormat::sentence));
  expect_words(no_film, {std::string(films::raw.sidecar)});
  const std::string no_picture = test::complaint([] { decode_image("no picture", "x"); });
  expect_words(no_picture, words_of(pictures::all, &PictureFormat::sentence));
  const test::TemporaryFolder volume_folder;
  write_atomically(volume_folder / "x", "no volume\n");
  const std::string no_volume = test::complaint([&] { open_volume(volume_folder / "x"); });
  expect_words(no_volume, words_of(volumes::all, &VolumeFormat::sentence));
  const std::string set_of_png = test::complaint([] { decode_image("\x89PNG\r\n\x1a\n", "x", {.dataset = "a"}); });
  EXPECT_NE(set_of_png.find("PNG, which holds no datasets"), std::string::npos) << set_of_png;
  const test::TemporaryFolder folder;
  Film film = test::counted(3, 3, 2, true);
  const std::string no_ending = test::complaint([&] { write_film(folder / "a.b", film); });
  for (const auto* format : films::all)
    if (format->create != nullptr)
      expect_words(no_ending, {std::string(format->name), std::string(format->endings[0])});
  const std::string no_place = test::complaint([&] { write_film(folder / "a.ptw", film); });
  expect_words(no_place, film_endings_to_write(true));
}

TEST(Formats, AFilmHasTheNameOfItsFormatByWhicheverEndingItWasWritten) {
  const test::TemporaryFolder folder;
  for (const auto* format : films::all) {
    if (format->create == nullptr) continue;
    Film film = test::counted(5, 4, 3);
    for (const std::string_view ending : format->endings) {
      if (ending.empty()) continue;
      EXPECT_EQ(format_ending(films::all, "a" + std::string(ending)), format);
      write_film(folder / ("a" + std::string(ending)), film);
      EXPECT_EQ(open_film(folder / ("a" + std::string(ending)))->info().format, format->name);
    }
  }
}

}  // namespace
}  // namespace arenite::io
