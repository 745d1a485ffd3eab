#include <gtest/gtest.h>

#include "study/run.hpp"
#include "support/small_study.hpp"

namespace arenite::study {
namespace {

texture::Options options_with(const std::string& contact) {
  return texture_options(parse_recipe(test::small_packing_recipe + "[contact]\n" + contact + "[[stages]]\nname = \"load\"\ngravity = true\ntop = { force = \"1 kN\" }\n", "r.toml"), 1);
}

TEST(TextureOptions, TellWhatMayPull) {
  EXPECT_EQ(options_with("").pull, texture::Pull::unknown);
  EXPECT_EQ(options_with("attractive_dashpot = true\n").pull, texture::Pull::dashpots);
  EXPECT_EQ(options_with("attractive_dashpot = true\nadhesion = \"geometrical\"\nsurface_energy = \"1 kN/mm\"\n").pull, texture::Pull::adhesion);
  EXPECT_EQ(options_with("").gravity.y, -dem::standard_gravity);
}

}  // namespace
}  // namespace arenite::study
