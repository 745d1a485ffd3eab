#include "io/film/other_recording.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "io/film/film.hpp"
#include "io/film/formats.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

using namespace std::string_literals;

TEST(OtherRecording, IsNamedByItsEndingOrItsFirstBytes) {
  const test::TemporaryFolder folder;
  struct Case {
    const char *name, *words;
    std::string bytes;
  };
  for (const auto& [name, words, bytes] :
       {Case{"a.seq", "FLIR sequence (.seq)", "FFF\0\0\0\1\2"s},
        Case{"b.bin", "FLIR sequence (.seq)", "FFF\0\0\0\1\2"s}, Case{"c.CSQ", "(.csq)", "x"s},
        Case{"d.ats", "(.ats)", "\1\2"s}, Case{"e.ravi", "Optris", "RIFF1234AVI "s},
        Case{"f.mp4", "is a video (MPEG-4)",
             "\0\0\0\x18"
             "ftypmp42"s},
        Case{"g", "is a video (MPEG-4)",
             "\0\0\0\x18"
             "ftypmp42"s},
        Case{"h.h264", "is a video (H.264)", "\0\0\0\1\x67\1"s}, Case{"i.irb", "IRBIS", "\xffIRB"s}}) {
    test::spill(folder / name, bytes);
    const std::string said = test::complaint([&, name = name] { open_film(folder / name); });
    EXPECT_NE(said.find(words), std::string::npos) << name << ": " << said;
    EXPECT_NE(said.find("export"), std::string::npos) << said;
  }
}

TEST(OtherRecording, AFilmOfAKnownFormatIsReadWhateverItsName) {
  const test::TemporaryFolder folder;
  test::spill(folder / "a.seq", test::ptw(test::counted()));
  EXPECT_EQ(open_film(folder / "a.seq")->info().format, "ptw");
  EXPECT_EQ(other_recording("a.txt", "1 2 3"), "");
}

}  // namespace
}  // namespace arenite::io
