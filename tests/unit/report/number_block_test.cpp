#include "report/number_block.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <cstring>

using namespace arenite::report;

namespace {

std::vector<std::uint8_t> from_base64(const std::string& text) {
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
    held += 6;
    if (held >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (held -= 8)));
  }
  return bytes;
}

std::vector<std::uint8_t> unpacked(const NumberBlock& block) {
  const auto packed = from_base64(block.text());
  std::vector<std::uint8_t> bytes(block.size());
  uLongf length = bytes.size();
  EXPECT_EQ(uncompress(bytes.data(), &length, packed.data(), packed.size()), Z_OK);
  EXPECT_EQ(length, block.size());
  return bytes;
}

float real_at(const std::vector<std::uint8_t>& bytes, const NumberRef& ref, std::size_t k) {
  std::uint8_t four[4];
  for (std::size_t rank = 0; rank < 4; ++rank) four[rank] = bytes[ref.offset + rank * ref.count + k];
  float value;
  std::memcpy(&value, four, 4);
  return value;
}

}  // namespace

TEST(NumberBlock, BringsRealsBackAsFloat32) {
  NumberBlock block;
  const std::vector<double> first{0.1, -2.5e7, 0}, second{1e-20, 3};
  block.add_reals(first);
  const NumberRef ref = block.add_reals(second);
  const auto bytes = unpacked(block);
  EXPECT_EQ(ref.offset, 12u);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(real_at(bytes, ref, k), static_cast<float>(second[k]));
}

TEST(NumberBlock, TakesTheNarrowestTypeThatHoldsEveryIndex) {
  NumberBlock block;
  const std::vector<std::uint32_t> narrow{0, 255}, middle{0, 65535}, wide{65536};
  EXPECT_STREQ(block.add_indices(narrow).type, "u1");
  EXPECT_STREQ(block.add_indices(middle).type, "u2");
  EXPECT_STREQ(block.add_indices(wide).type, "u4");
  EXPECT_STREQ(block.add_indices({}).type, "u1");
  EXPECT_EQ(block.size(), 2u + 4u + 4u);
}

TEST(Base64, AgreesWithTheExamplesOfItsStandard) {
  const auto text = [](std::string_view plain) {
    return base64({reinterpret_cast<const std::uint8_t*>(plain.data()), plain.size()});
  };
  EXPECT_EQ(text(""), "");
  EXPECT_EQ(text("f"), "Zg==");
  EXPECT_EQ(text("fo"), "Zm8=");
  EXPECT_EQ(text("foo"), "Zm9v");
  EXPECT_EQ(text("foobar"), "Zm9vYmFy");
}
