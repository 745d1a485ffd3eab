#include "io/image.hpp"

#include <iterator>
#include <string_view>
#include <utility>

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "io/file_marks.hpp"
#include "io/hdf5_image.hpp"
#include "io/jpeg_image.hpp"
#include "io/png_image.hpp"
#include "io/read_file.hpp"
#include "io/tiff_image.hpp"

namespace arenite::io {
namespace {

using namespace std::string_view_literals;

struct Format {
  bool (*is)(std::string_view bytes);
  Image (*read)(const std::string& bytes, const std::string& file, const ImageChoice& choice);
};

constexpr Format formats[] = {
    {[](std::string_view b) { return b.starts_with("\x89PNG\r\n\x1a\n"sv); }, read_png},
    {is_tiff, read_tiff},
    {[](std::string_view b) { return b.starts_with("\xff\xd8\xff"sv); }, read_jpeg},
    {is_hdf5, read_hdf5_image},
};

constexpr std::pair<const char*, Channel> channels[] = {{"red", Channel::red},   {"green", Channel::green}, {"blue", Channel::blue},
                                                        {"mean", Channel::mean}, {"grey", Channel::grey}};

}  // namespace

std::vector<std::string> channel_names() {
  std::vector<std::string> names;
  for (const auto& [name, channel] : channels) names.emplace_back(name);
  return names;
}

Channel parse_channel(const std::string& name) {
  for (const auto& [known, channel] : channels)
    if (name == known) return channel;
  const std::string near = nearest(name, channel_names());
  throw InputError("there is no channel \"" + name + "\"" +
                   (near.empty() ? "; choose red, green, blue, mean or grey" : "; did you mean \"" + near + "\"?"));
}

Image decode_image(const std::string& bytes, const std::string& file, const ImageChoice& choice) {
  for (const Format& format : formats)
    if (format.is(bytes)) return format.read(bytes, file, choice);
  if (bytes.empty()) throw InputError(file, 0, "is empty; copy it again");
  throw InputError(file, 0, "is neither PNG, TIFF, JPEG nor HDF5; save the picture as one of these");
}

Image read_image(const std::filesystem::path& path, const ImageChoice& choice) {
  return decode_image(read_file(path), path.string(), choice);
}

}  // namespace arenite::io
