// Films that are cut short, damaged or contradict themselves: one sentence that names the file and says what to do.
#include <gtest/gtest.h>
#include <hdf5.h>
#include <unistd.h>

#include <fstream>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "io/film/film.hpp"
#include "support/films.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

using test::counted;

std::string refusal(const std::string& bytes, const FilmChoice& choice = {}) {
  return test::complaint([&] {
    const auto film = open_film(bytes_in_memory(bytes, "x.film"), choice);
    test::all_of(*film);
  });
}

void expect_refusal(const std::string& bytes, const std::string& words) {
  const std::string text = refusal(bytes);
  EXPECT_TRUE(text.starts_with("x.film:")) << text;
  EXPECT_NE(text.find(words), std::string::npos) << text;
  EXPECT_NE(text.find(';'), std::string::npos) << "no mend: " << text;
}

TEST(BadFilm, EveryFormatCutShortIsRefused) {
  const test::TemporaryFolder folder;
  for (const char* ending : {".tif", ".npy", ".h5", ".sfmov", ".ptw"}) {
    Film film = counted(16, 16, 8);
    const auto path = folder / (std::string("film") + ending);
    write_film(path, film);
    const std::string whole = open_bytes(path)->text(0, 1 << 20);
    ASSERT_EQ(refusal(whole), "") << ending;
    for (const double part : {0.999, 0.9, 0.6, 0.3, 0.1, 0.02}) {
      const std::string text =
          refusal(whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size()))));
      EXPECT_NE(text, "") << ending << " to " << part;
      EXPECT_NE(text.find("; "), std::string::npos) << text;
    }
  }
  expect_refusal(test::hcc(counted(16, 16, 8)).substr(0, 4000), "cut short");
}

TEST(BadFilm, NothingAndNonsense) {
  expect_refusal("", "is empty");
  expect_refusal(std::string("\0\1\2\3", 4), "is not a film in a known format");
  expect_refusal("no numbers here\n", "is not a film in a known format");
  EXPECT_NE(test::complaint([] { open_film(std::filesystem::path("/nowhere/film.ptw")); }).find("no such file"),
            std::string::npos);
  const test::TemporaryFolder folder;
  EXPECT_NE(test::complaint([&] { open_film(folder.path()); }).find("no files"), std::string::npos);
}

TEST(BadFilm, PtwThatContradictsItself) {
  const std::string good = test::ptw(counted());
  const auto with = [&](std::size_t at, auto value) {
    std::string bytes = good;
    test::set(bytes, at, value);
    return bytes;
  };
  expect_refusal(with(23, std::int32_t{21}), "disagree");
  expect_refusal(with(377, std::int16_t{-5}), "disagree");
  expect_refusal(with(27, std::int32_t{0}), "holds no frame");
  expect_refusal(with(27, std::int32_t{4}), "declares 4 frames of 5 x 4 pixels and holds 3");
  expect_refusal(with(27, std::int32_t{2000000000}), "cut short");
  expect_refusal(with(11, std::int32_t{-1}), "headers");
  expect_refusal(with(15, std::int32_t{0x7fffffff}), "headers");
  expect_refusal(good.substr(0, 200), "header");
}

TEST(BadFilm, SfmovThatContradictsItself) {
  const std::string good = test::sfmov(counted());
  const auto with = [&](const std::string& from, const std::string& to) {
    return std::string(good).replace(good.find(from), from.size(), to);
  };
  expect_refusal(with("NumDPs 3", "NumDPs 4"), "declares 4");
  expect_refusal(with("NumDPs 3", "NumDPs x"), "does not state NumDPs");
  expect_refusal(with("xPixls 5", "xPixls 99999999999"), "pixels");
  expect_refusal(with("UINT16", "Complex"), "complex");
  expect_refusal(with("DATA", "DUTA"), "ends within its header");
}

TEST(BadFilm, NpyThatIsNoFilm) {
  const std::string data(120, '\1');
  expect_refusal(test::npy("<u2", "(3, 4, 5)", data, "True"), "column order");
  expect_refusal(test::npy("<c8", "(3, 4, 5)", data), "unsupported type");
  expect_refusal(test::npy("<u2", "(60,)", data), "dimensions");
  expect_refusal(test::npy("<u2", "(4, 4, 5)", data), "cut short");
  expect_refusal(test::npy("<u2", "(3, 4, 99999999999999999999)", data), "more data than any file");
  expect_refusal(test::npy("<u2", "(99999999999, 100000, 100000)", data), "at most");
}

TEST(BadFilm, MoreNumbersThanTheShapeOfAnArraySaysAreTold) {
  const auto remarks = [](std::size_t bytes) {
    const std::string array = test::npy("<u2", "(3, 4, 5)", std::string(bytes, '\1'));
    return open_film(bytes_in_memory(array, "x.npy"))->info().remarks;
  };
  EXPECT_TRUE(remarks(120).empty());
  ASSERT_EQ(remarks(160).size(), 1u);
  EXPECT_NE(remarks(160)[0].find("than 3 frames of 5 x 4 pixels have"), std::string::npos);
}

TEST(BadFilm, HccWhoseFramesDiffer) {
  const Film film = counted(8, 4, 3);
  std::string bytes = test::hcc(film);
  const std::size_t frame = bytes.size() / 3;
  test::set(bytes, frame + 34, std::uint16_t{5});
  expect_refusal(bytes, "another size from frame 1 on");
  bytes = test::hcc(film);
  bytes[2 * frame + 16] = 3;
  expect_refusal(bytes, "another scale from frame 2 on");
  bytes = test::hcc(film);
  bytes[frame] = 'X';
  expect_refusal(bytes, "no header before frame 1");
}

TEST(BadFilm, TextWithRaggedRowsAndWords) {
  expect_refusal("1 2 3\n4 5\n", "row of 2 numbers, but the first has 3");
  expect_refusal("1 2 3\n4 x 6\n", "\"x\" in column 2");
  expect_refusal("1 2\n3 4\n\n5 6\n", "1 rows, but the first has 2");
  expect_refusal("1;2\n3;nan\n", "\"nan\" in column 2, which is not a number");
}

/// Taken for what parts frames, such a row would be lost, and all others would be one too high.
TEST(BadFilm, ARowOfTextWhoseFirstCellIsNoNumberIsARow) {
  for (const char* dead : {"nan", "NaN", "-", "x1"}) {
    const std::string row = std::string(dead) + " 2 3\n", told = std::string("\"") + dead + "\" in column 1";
    const std::string first = "Frame 1\n" + row + "4 5 6\nFrame 2\n" + row + "4 5 6\n",
                      last = "Frame 1\n4 5 6\n" + row + "Frame 2\n4 5 6\n" + row;
    for (const auto& [text, line] : {std::pair(first, ":2:"), std::pair(last, ":3:")}) {
      expect_refusal(text, told);
      EXPECT_NE(refusal(text).find(line), std::string::npos) << refusal(text);
    }
    expect_refusal("4 5 6\n" + row + "7 8 9\n", told);
  }
  expect_refusal("nan nan nan\n4 5 6\n\nnan nan nan\n4 5 6\n", "\"nan\" in column 1");
}

TEST(BadFilm, WordsBetweenFramesOfTextArePartsOfNoFrame) {
  const std::string text = "Frame 1 0.02\n1 2 3\n4 5 6\nFrame 2 0.04\n1 2 3\n4 5 6\ntime = 0.06\n1 2 3\n4 5 6\n";
  const auto film = open_film(bytes_in_memory(text, "x.film"));
  EXPECT_EQ(film->info().frames, 3);
  EXPECT_EQ(film->info().height, 2);
}

TEST(BadFilm, PackedByAnotherProgramIsSaidSo) {
  for (const char* packed : {"\x1f\x8b\x08", "\x28\xb5\x2f\xfd", "BZh9\1"}) expect_refusal(packed, "is compressed (");
  expect_refusal("\x1f\x8b\x08", "gzip); unpack it (gunzip)");
}

/// -30 Hz is stated: that the film states no rate would be wrong.
TEST(BadFilm, AFrameRateThatIsNoneIsNamed) {
  const test::TemporaryFolder folder;
  const std::vector<hsize_t> shape{3, 4, 5};
  const std::vector<float> values(60, 300);
  const double rate = -30;
  const hid_t file = H5Fcreate((folder / "a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
              space = H5Screate_simple(3, shape.data(), nullptr), one = H5Screate(H5S_SCALAR),
              set = H5Dcreate2(file, "film", H5T_IEEE_F32LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
              attribute = H5Acreate2(set, "frame_rate", H5T_NATIVE_DOUBLE, one, H5P_DEFAULT, H5P_DEFAULT);
  H5Dwrite(set, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Awrite(attribute, H5T_NATIVE_DOUBLE, &rate);
  H5Aclose(attribute), H5Dclose(set), H5Sclose(one), H5Sclose(space), H5Fclose(file);
  const std::string said = test::complaint([&] { open_film(folder / "a.h5"); });
  EXPECT_NE(said.find("a.h5: states a frame rate of -30 Hz, which is none; give the right one"), std::string::npos)
      << said;
  EXPECT_DOUBLE_EQ(open_film(folder / "a.h5", {.frame_rate = 30})->info().frame_rate, 30);
}

TEST(BadFilm, SidecarWithEveryMistake) {
  expect_refusal("width = 5\nheight = 4\n", "type of a pixel");
  expect_refusal("width = 5\nheight = 4\ntype = \"uint16\"\nframerate = 3\n", "did you mean \"frame_rate\"");
  expect_refusal("width = 5\nheight = 4\ntype = \"uint16\"\nframe_rate = \"3 mm\"\n", "frame_rate");
  expect_refusal("width = five\nheight = 4\ntype = \"uint16\"\n", "whole number");
  expect_refusal("width = 5\nwidth = 5\nheight = 4\ntype = \"uint16\"\n", "second time");
  expect_refusal("width = 50\nheight = 4\ntype = \"uint16\"\n", "not a whole number of frames");
}

TEST(BadFilm, TooLargeAFrameIsRefusedBeforeMemoryIsAskedFor) {
  Film film = counted(20, 20, 1);
  const test::TemporaryFolder folder;
  for (const char* ending : {".tif", ".npy", ".h5", ".sfmov", ".ptw"}) {
    write_film(folder / (std::string("film") + ending), film);
    const std::string text =
        test::complaint([&] { open_film(folder / (std::string("film") + ending), {.most_pixels = 399}); });
    EXPECT_NE(text.find("at most 399 pixels"), std::string::npos) << ending << text;
  }
  EXPECT_NE(refusal("1 2 3\n4 5 6\n", {.most_pixels = 5}).find("at most 5"), std::string::npos);
}

double resident_megabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

/// 20 GB of frames, of which the disk holds only the last: read in blocks, the film needs the memory of a block.
TEST(BadFilm, AFilmLargerThanMemoryIsReadInBlocks) {
  const test::TemporaryFolder folder;
  const auto path = folder / "large.npy";
  const std::int64_t frames = 130000;
  const Film last = counted(320, 240, 1);
  std::string head = test::npy("<u2", "(130000, 240, 320)", "");
  test::spill(path, head);
  std::filesystem::resize_file(path, head.size() + static_cast<std::uint64_t>(frames) * 320 * 240 * 2);
  {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(-static_cast<std::streamoff>(320 * 240 * 2), std::ios::end);
    file.write(reinterpret_cast<const char*>(last.level.data()), 320 * 240 * 2);
  }
  const auto film = open_film(path);
  ASSERT_EQ(film->info().frames, frames);
  const double before = resident_megabytes();
  FrameBlock block;
  for (std::int64_t f = frames - 1; f >= 0; f -= 5200) {
    film->read(std::max<std::int64_t>(f - 31, 0), static_cast<std::size_t>(std::min<std::int64_t>(f + 1, 32)), block);
    if (f < frames - 1) continue;
    EXPECT_TRUE(std::equal(last.level.begin(), last.level.end(), block.level.end() - 320 * 240));
  }
  EXPECT_LT(resident_megabytes() - before, 32);  // a block is 4.9 MB
}

}  // namespace
}  // namespace arenite::io
