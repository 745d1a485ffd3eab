#include "io/volume/volume.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "io/disk/file.hpp"
#include "io/volume/voxel_map.hpp"
#include "support/pictures.hpp"
#include "support/temporary_folder.hpp"

namespace arenite::io {
namespace {

using test::complaint;

/// A block of 3 x 2 x 2 voxels whose numbers say where they are: 100 z + 10 y + x.
constexpr int wide = 3, high = 2, deep = 2;
int at(int x, int y, int z) { return 100 * z + 10 * y + x; }

/// The numbers as bytes of some type, x fastest or z fastest.
template <class T> std::string stored(bool big_endian = false, bool z_fastest = false) {
  std::string bytes;
  const auto add = [&](int value) {
    std::string one(sizeof(T), '\0');
    const T number = static_cast<T>(value);
    std::memcpy(one.data(), &number, sizeof(T));
    bytes += big_endian ? std::string(one.rbegin(), one.rend()) : one;
  };
  if (z_fastest)
    for (int x = 0; x < wide; ++x)
      for (int y = 0; y < high; ++y)
        for (int z = 0; z < deep; ++z) add(at(x, y, z));
  else
    for (int z = 0; z < deep; ++z)
      for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) add(at(x, y, z));
  return bytes;
}

std::string packed(const std::string& plain) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY);
  std::string bytes(compressBound(static_cast<uLong>(plain.size())) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(plain.data()));
  stream.avail_in = static_cast<uInt>(plain.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

std::string numpy(const std::string& type, const std::string& numbers, bool fortran = false,
                  const std::string& shape = "(2, 2, 3)") {
  std::string header =
      "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }\n";
  return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header + numbers;
}

template <class T> std::string bytes_of_number(T value) { return {reinterpret_cast<const char*>(&value), sizeof(T)}; }

/// A zip archive of one stored member, as numpy.savez writes it.
std::string npz(const std::string& name, const std::string& array) {
  const auto u16 = [](std::size_t v) { return bytes_of_number(static_cast<std::uint16_t>(v)); };
  const auto u32 = [](std::size_t v) { return bytes_of_number(static_cast<std::uint32_t>(v)); };
  const std::string sizes = u32(0) + u32(array.size()) + u32(array.size());
  const std::string local = "PK\3\4" + u16(20) + u16(0) + u16(0) + u32(0) + sizes + u16(name.size()) + u16(0) + name;
  const std::string list = "PK\1\2" + u16(20) + u16(20) + u16(0) + u16(0) + u32(0) + sizes + u16(name.size()) + u16(0) +
                           u16(0) + u16(0) + u16(0) + u32(0) + u32(0) + name;
  return local + array + list + "PK\5\6" + u16(0) + u16(0) + u16(1) + u16(1) + u32(list.size()) +
         u32(local.size() + array.size()) + u16(0);
}

std::string nifti(const std::string& numbers, std::int16_t type, char units = 3, float pixel = 2.5f) {
  std::string head(352, '\0');
  const auto set = [&](std::size_t place, const std::string& bytes) { head.replace(place, bytes.size(), bytes); };
  set(0, bytes_of_number(std::int32_t{348}));
  for (const auto& [k, n] : {std::pair{0, 3}, {1, wide}, {2, high}, {3, deep}})
    set(40 + 2 * static_cast<std::size_t>(k), bytes_of_number(static_cast<std::int16_t>(n)));
  set(70, bytes_of_number(type));
  for (std::size_t k = 1; k <= 3; ++k) set(76 + 4 * k, bytes_of_number(pixel));
  set(108, bytes_of_number(352.0f));
  head[123] = units;
  set(344, std::string("n+1\0", 4));
  return head + numbers;
}

class Volumes : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& bytes) {
    write_atomically(folder / name, bytes);
    return folder / name;
  }
  /// Reads a file and asks for the numbers at their places.
  VolumeFacts expect_places(const std::filesystem::path& path) {
    const VolumePointer volume = open_volume(path);
    const VolumeFacts facts = volume->facts();
    EXPECT_EQ(facts.width, wide);
    EXPECT_EQ(facts.height, high);
    EXPECT_EQ(facts.depth, deep);
    std::vector<std::int32_t> layer(facts.slice());
    for (int z = deep; z-- > 0;) {
      volume->read(z, layer);
      for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) EXPECT_EQ(layer[static_cast<std::size_t>(x + wide * y)], at(x, y, z)) << path;
    }
    return facts;
  }
  test::TemporaryFolder folder;
};

TEST_F(Volumes, NumpyArraysOfEveryOrderAndType) {
  expect_places(file("a.npy", numpy("|u1", stored<std::uint8_t>())));
  expect_places(file("b.npy", numpy(">i2", stored<std::int16_t>(true))));
  expect_places(file("c.npy", numpy("<i8", stored<std::int64_t>())));
  expect_places(file("d.npy", numpy("<f8", stored<double>())));
  expect_places(file("e.npy", numpy("<u4", stored<std::uint32_t>(false, true), true)));
  expect_places(file("f.npz", npz("im.npy", numpy("<u2", stored<std::uint16_t>()))));
}

TEST_F(Volumes, NrrdRawPackedAndDetached) {
  const std::string head = "NRRD0004\ntype: unsigned short\ndimension: 3\nsizes: 3 2 2\n";
  expect_places(file("a.nrrd", head + "encoding: raw\nendian: big\n\n" + stored<std::uint16_t>(true)));
  expect_places(file("b.nrrd", head + "encoding: gzip\nendian: little\n\n" + packed(stored<std::uint16_t>())));
  file("c.raw", "skipped" + stored<std::uint16_t>());
  expect_places(file("c.nhdr", head + "encoding: raw\nendian: little\nbyte skip: -1\ndata file: c.raw\n\n"));
}

TEST_F(Volumes, NrrdStatesTheSideOfItsVoxels) {
  const std::string head = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 2 2\nencoding: raw\n";
  const auto side = [&](const std::string& lines) {
    return expect_places(file("a.nrrd", head + lines + "\n" + stored<std::uint8_t>()));
  };
  EXPECT_DOUBLE_EQ(side("space units: \"um\" \"um\" \"um\"\nspace directions: (0,4,3) (5,0,0) (0,-3,4)\n").dx.value(),
                   5e-6);
  const VolumeFacts bare = side("spacings: 2 2 2\n");
  EXPECT_FALSE(bare.dx);
  ASSERT_EQ(bare.remarks.size(), 1u);
  EXPECT_NE(bare.remarks[0].find("--dx"), std::string::npos);
  EXPECT_NE(complaint([&] { side("spacings: 2 2 3\n"); }).find("no cubes"), std::string::npos);
  EXPECT_DOUBLE_EQ(side("space units: \"mm\" \"um\" \"m\"\nspacings: 0.002 2 2e-6\n").dx.value(), 2e-6);
  EXPECT_NE(complaint([&] { side("space units: \"mm\" \"mm\" \"um\"\nspacings: 2 2 2\n"); }).find("no cubes"),
            std::string::npos);
  EXPECT_NE(complaint([&] { side("space units: \"mm\" \"mm\" \"s\"\nspacings: 2 2 2\n"); }).find("\"s\" is no length"),
            std::string::npos);
  EXPECT_NE(complaint([&] { side("space directions: (5,0,0) (3,4,0) (0,0,5)\n"); }).find("axes that lean"),
            std::string::npos);
}

bool remarks_say(const VolumeFacts& facts, const std::string& part) {
  return std::ranges::any_of(facts.remarks, [&](const auto& remark) { return remark.find(part) != remark.npos; });
}

TEST_F(Volumes, AHeaderThatNamesItsNumbersMayEndWithoutAnEmptyLine) {
  const std::string head = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 2 2\nencoding: raw\n";
  file("a.raw", stored<std::uint8_t>());
  expect_places(file("a.nhdr", head + "data file: a.raw\n"));
  expect_places(file("b.nhdr", head + "data file: a.raw"));
  EXPECT_NE(complaint([&] { open_volume(file("c.nrrd", head)); }).find("header that does not end"), std::string::npos);
}

TEST_F(Volumes, AxesThatAFileTurnsAreLeftAsideAndTold) {
  const auto nrrd = [&](const std::string& directions) {
    const std::string head = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 2 2\nencoding: raw\nspace directions: ";
    return expect_places(file("a.nrrd", head + directions + "\n\n" + stored<std::uint8_t>()));
  };
  const auto meta = [&](const std::string& matrix) {
    return expect_places(file("a.mha",
                              "ObjectType = Image\nNDims = 3\nDimSize = 3 2 2\nElementType = MET_UCHAR\n"
                              "TransformMatrix = " +
                                  matrix + "\nElementDataFile = LOCAL\n" + stored<std::uint8_t>()));
  };
  EXPECT_FALSE(remarks_say(nrrd("(5,0,0) (0,5,0) (0,0,5)"), "turn or mirror"));
  for (const char* turned : {"(0,0,5) (0,5,0) (5,0,0)", "(5,0,0) (0,-5,0) (0,0,5)", "(4,3,0) (-3,4,0) (0,0,5)"})
    EXPECT_TRUE(remarks_say(nrrd(turned), "its space directions turn or mirror the axes")) << turned;
  EXPECT_FALSE(remarks_say(meta("1 0 0 0 1 0 0 0 1"), "turn or mirror"));
  EXPECT_TRUE(remarks_say(meta("0 1 0 1 0 0 0 0 1"), "TransformMatrix turn or mirror"));
}

TEST_F(Volumes, MoreNumbersThanTheHeaderSaysAreTold) {
  const std::string bytes = stored<std::uint8_t>(), more = bytes + "\1";
  const std::string nrrd = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 2 2\nencoding: ";
  for (const bool whole : {true, false}) {
    const std::string& numbers = whole ? bytes : more;
    EXPECT_EQ(remarks_say(expect_places(file("a.npy", numpy("|u1", numbers))), "more numbers follow"), !whole);
    EXPECT_EQ(remarks_say(expect_places(file("a.nrrd", nrrd + "raw\n\n" + numbers)), "more numbers follow"), !whole);
    EXPECT_EQ(remarks_say(expect_places(file("b.nrrd", nrrd + "gzip\n\n" + packed(numbers))), "more numbers"), !whole);
    EXPECT_EQ(remarks_say(expect_places(file("a.nii", nifti(numbers, 2))), "check these sizes"), !whole);
    EXPECT_EQ(remarks_say(expect_places(file("a.nii.gz", packed(nifti(numbers, 2)))), "check these sizes"), !whole);
  }
}

TEST_F(Volumes, MetaImageOfSizesAloneHasThemForItsSpacing) {
  const auto of = [&](const std::string& lines) {
    const std::string head = "ObjectType = Image\nNDims = 3\nDimSize = 3 2 2\nElementType = MET_UCHAR\n";
    return expect_places(file("a.mha", head + lines + "ElementDataFile = LOCAL\n" + stored<std::uint8_t>()));
  };
  EXPECT_DOUBLE_EQ(of("ElementSize = 2 2 2\n").dx.value(), 2e-3);
  EXPECT_DOUBLE_EQ(of("ElementSize = 1 1 2\nElementSpacing = 1 1 1\n").dx.value(), 1e-3);
  EXPECT_NE(complaint([&] { of("ElementSize = 1 1 2\n"); }).find("voxels of 1 x 1 x 2, which are no cubes"),
            std::string::npos);
}

TEST_F(Volumes, MetaImageLocalAndBeside) {
  const std::string head = "ObjectType = Image\nNDims = 3\nDimSize = 3 2 2\nElementType = MET_INT\n";
  EXPECT_DOUBLE_EQ(expect_places(file("a.mha", head + "ElementSpacing = 0.5 0.5 0.5\nElementDataFile = LOCAL\n" +
                                                   stored<std::int32_t>()))
                       .dx.value(),
                   5e-4);
  file("b.raw", stored<std::int32_t>(true));
  expect_places(file("b.mhd", head + "BinaryDataByteOrderMSB = True\nElementDataFile = b.raw\n"));
  file("c.zraw", packed(stored<std::int32_t>()));
  expect_places(file("c.mhd", head + "CompressedData = True\nElementDataFile = c.zraw\n"));
}

TEST_F(Volumes, NiftiPlainAndPacked) {
  EXPECT_DOUBLE_EQ(expect_places(file("a.nii", nifti(stored<std::int16_t>(), 4))).dx.value(), 2.5e-6);
  const std::string plain = nifti(stored<float>(), 16);
  expect_places(file("b.nii.gz", packed(plain)));
  expect_places(
      file("b.nii.gz", packed(plain.substr(0, 200)) + packed(plain.substr(200, 170)) + packed(plain.substr(370))));
  EXPECT_DOUBLE_EQ(expect_places(file("c.nii", nifti(stored<std::uint8_t>(), 2, 2))).dx.value(), 2.5e-3);
}

TEST_F(Volumes, WhatIsDamagedIsRefusedWithItsMend) {
  const auto says = [&](const std::string& name, const std::string& bytes) {
    return complaint([&] { expect_places(file(name, bytes)); });
  };
  const std::string numbers = stored<std::uint8_t>();
  EXPECT_NE(says("a.npy", numpy("|u1", numbers.substr(1))).find("copy it again"), std::string::npos);
  EXPECT_NE(says("b.npy", numpy("|u1", numbers, false, "(4, 3)")).find("three"), std::string::npos);
  EXPECT_NE(says("c.npy", numpy("<c8", numbers)).find("<c8"), std::string::npos);
  EXPECT_NE(says("d.npy", numpy("|u1", numbers, false, "(99999999, 99999999, 3)")).find("2^31"), std::string::npos);
  EXPECT_NE(says("e.nii", nifti(numbers, 32)).find("type 32"), std::string::npos);
  const std::string broken = packed(nifti(numbers, 2));
  EXPECT_NE(says("f.nii.gz", broken.substr(0, broken.size() / 2)).find("copy it again"), std::string::npos);
  std::string last = broken;
  last[last.size() - 8] ^= 1;  // of the checksum
  EXPECT_NE(says("g.nii.gz", last).find("copy it again"), std::string::npos);
  EXPECT_NE(says("g.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 2 2\nencoding: bzip2\n\n" + numbers)
                .find("raw or gzip"),
            std::string::npos);
  EXPECT_NE(says("h.npy", numpy("<f4", bytes_of_number(0.5f) + stored<float>().substr(4))).find("0.5"),
            std::string::npos);
  EXPECT_NE(says("j.mhd",
                 "ObjectType = Image\nNDims = 3\nDimSize = 3 2 2\nElementType = MET_UCHAR\n"
                 "ElementDataFile = gone.raw\n")
                .find("j.mhd: names the file \"gone.raw\""),
            std::string::npos);
  EXPECT_NE(says("l.npy.gz", packed(numpy("|u1", numbers))).find("is compressed (gzip); unpack it"), std::string::npos);
  EXPECT_NE(says("k.raw", numbers).find(".mhd"), std::string::npos);
  EXPECT_NE(says("i.npz", npz("im.npy", numpy("|u1", numbers, false, "(12,)"))).find("im"), std::string::npos);
}

TEST_F(Volumes, APhaseTableMakesThemAMap) {
  const auto volume = file("a.npy", numpy("|b1", std::string("\1\0\1\1\0\0\1\1\1\0\0\0", 12)));
  const ForeignVoxels guessed = read_voxel_map(volume, {});
  EXPECT_EQ(guessed.map.phase[0], Phase::particle);
  EXPECT_EQ(guessed.map.phase[1], Phase::empty);
  ASSERT_EQ(guessed.notes.size(), 1u);
  VoxelMapOptions options;
  options.phases = parse_phase_table("0=matrix,1=void");
  options.dx = 2e-6;
  const ForeignVoxels told = read_voxel_map(volume, options);
  EXPECT_EQ(told.map.phase[0], Phase::empty);
  EXPECT_EQ(told.map.phase[1], Phase::matrix);
  EXPECT_EQ(told.map.dx, 2e-6);
  const auto one = file("c.npy", numpy("|u1", std::string(12, '\7')));
  EXPECT_NE(complaint([&] { read_voxel_map(one, {}); }).find("7 everywhere"), std::string::npos);
  options.phases = parse_phase_table("0=matrix");
  EXPECT_NE(complaint([&] { read_voxel_map(volume, options); }).find("value 1"), std::string::npos);
  EXPECT_NE(
      complaint([&] { read_voxel_map(file("b.npy", numpy("|u1", stored<std::uint8_t>())), {}); }).find("--phases"),
      std::string::npos);
}

TEST_F(Volumes, LabelsNumberTheGrains) {
  const auto volume = file("a.npy", numpy("|u1", std::string("\1\0\1\1\0\0\1\1\1\0\0\0", 12)));
  VoxelMapOptions options;
  options.labels = file("l.npy", numpy("|u1", std::string("\7\0\5\7\0\0\7\7\5\0\0\0", 12)));
  const VoxelMap map = read_voxel_map(volume, options).map;
  EXPECT_EQ(map.grain, (std::vector<std::int32_t>{0, -1, 1, 0, -1, -1, 0, 0, 1, -1, -1, -1}));
  EXPECT_EQ(map.grain_class.size(), 2u);
  options.labels = file("m.npy", numpy("|u1", std::string("\7\1\5\7\0\0\7\7\5\0\0\0", 12)));
  EXPECT_NE(complaint([&] { read_voxel_map(volume, options); }).find("(1, 0, 0)"), std::string::npos);
}

}  // namespace
}  // namespace arenite::io
