#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/image.hpp"

namespace arenite::io {

/// What of a coloured pixel is its value. `none` insists on grey; otherwise a grey pixel is taken as it is.
enum class Channel : std::uint8_t { none, red, green, blue, mean, grey };  ///< grey: 0.299 red + 0.587 green + 0.114 blue

/// Names of the channels that can be chosen, "red" to "grey"; and the channel of a name (InputError for any other).
std::vector<std::string> channel_names();
Channel parse_channel(const std::string& name);

/// Which picture of a file is meant, and how large it may be.
struct ImageChoice {
  std::optional<std::int64_t> slice = {};       ///< of a stack, from 0; a file with one slice needs none
  std::string dataset = {};                     ///< of an HDF5 file; empty: the only one that can be meant
  Channel channel = Channel::none;
  std::int64_t most_pixels = 100'000'000;  ///< larger ones are refused before memory is asked for
};

/// A grey picture with 1 to 32 bits a pixel, its stored values unchanged. Without a channel, colour is accepted where
/// red, green and blue are equal, a palette where its entries are grey (the pixel is then what it shows), and JPEG not at
/// all, as it blurs values across edges; with one, any colour. Transparency is accepted where there is none; otherwise
/// InputError, as for a file that is no picture, is cut short or too large.
Image read_image(const std::filesystem::path& path, const ImageChoice& choice = {});

/// The same from the bytes of a file of this name.
Image decode_image(const std::string& bytes, const std::string& file, const ImageChoice& choice = {});

}  // namespace arenite::io
