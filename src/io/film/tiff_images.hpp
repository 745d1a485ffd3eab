#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/image/tiff.hpp"
#include "io/image/tiff_stack.hpp"

namespace arenite::io {

/// Which images of a TIFF file are the frames of a film, and where they are: as its description says, or page by page.
class TiffImages {
 public:
  /// `channel` is the name of the one that is wanted of several. InputError for a description that the file
  /// contradicts, and for several channels or slices of which none is chosen.
  TiffImages(TIFF* tiff, const TiffSource& source, TiffStack stack, std::uint64_t bytes_an_image,
             const std::string& channel);

  std::int64_t frames() const { return stack_.by.empty() ? static_cast<std::int64_t>(places_.size()) : stack_.frames; }
  /// Number of a frame's image.
  std::int64_t image(std::int64_t frame) const { return stack_.by.empty() ? frame : stack_.image(channel_, frame); }
  std::uint64_t directory(std::int64_t image) const { return places_[static_cast<std::size_t>(image)]; }
  /// Where the first image begins of a file that has one directory for all of them, as ImageJ writes more than 4 GB; 0:
  /// each has its own.
  std::uint64_t behind() const { return behind_; }
  const std::vector<std::string>& remarks() const { return remarks_; }
  /// Stated times of the frames, s; empty without.
  std::vector<double> times() const;

 private:
  void find_places(TIFF* tiff, const TiffSource& source, std::uint64_t bytes_an_image);
  void choose(const TiffSource& source, const std::string& channel);

  TiffStack stack_;  ///< without `by` where pages are simply frames
  std::vector<std::uint64_t> places_;
  std::uint64_t behind_ = 0;
  std::int64_t channel_ = 0;
  std::vector<std::string> remarks_;
};

}  // namespace arenite::io
