#pragma once
#include <cstddef>
#include <cstdint>

namespace arenite::thermography {

/// Frames one after the other and what they are weighed with. Of every pixel, d = value - reference is taken, which is
/// small and, for digital levels, exact in single precision.
template <class T> struct WeighedFrames {
  const T* frames;         ///< first frame; the next is `pixels` further
  std::size_t pixels;      ///< of a frame
  std::size_t count;       ///< frames
  const float* weights;    ///< count x functions
  std::size_t functions;   ///< 2, 4, 6 or 8
  const float* reference;  ///< one a pixel
  std::size_t ahead =
      0;  ///< values from a frame to one that is summed after these, which is fetched meanwhile; 0: none
};

/// Frames whose share goes into sums that stay in registers; as many streams as a machine fetches ahead.
constexpr std::size_t group = 16;
/// Pixels whose sums stay in the second cache from group to group, in long runs of every frame.
constexpr std::size_t tile = 8192;

/// Sums are kept in chunks of so many pixels, all sums of a chunk one after the other.
constexpr std::size_t chunk = 32;

/// Sums of all segments of a film, chunk by chunk so that a fit reads them in one run.
struct SegmentView {
  const float* sums;
  std::size_t segments, planes;

  /// Where pixel p has plane k of segment s.
  std::size_t at(std::size_t p, std::size_t s, std::size_t k) const {
    return ((p / chunk * segments + s) * planes + k) * chunk + p % chunk;
  }
};

/// The passes over pixels that take the time, compiled once for each kind of machine. Pixels begin .. end - 1 are done,
/// where `begin` is a multiple of `chunk`.
struct Kernels {
  const char* name;
  /// Plane 0 += d, plane 1 + k += weight_k d, plane 1 + functions += d^2 over all frames, for the segment whose plane 0
  /// of pixel 0 is at `sums`; the next chunk is `stride` further.
  void (*add_levels)(const WeighedFrames<std::uint16_t>&, float* sums, std::size_t stride, std::size_t begin,
                     std::size_t end);
  void (*add_values)(const WeighedFrames<float>&, float* sums, std::size_t stride, std::size_t begin, std::size_t end);
  /// out[m apart + p - begin] = sum over segments and planes of coefficient[m][s][k] sums, for m = 0 .. rows - 1.
  void (*combine)(const SegmentView&, const double* coefficient, std::size_t rows, double* out, std::size_t apart,
                  std::size_t begin, std::size_t end);
  /// out[p - begin] = sum over all frames of (d + last plane)^2, where segment s has frames[s] frames, less what is
  /// fitted of it: the form `normal` (rows x rows) of the numbers that `combine` gave.
  void (*residual)(const SegmentView&, const double* frames, const double* normal, std::size_t rows,
                   const double* fitted, std::size_t apart, double* out, std::size_t begin, std::size_t end);
  /// step[i] = sum over k < reach of weight[k] times what pixel i, the first of whose values are at `frame`, has k
  /// frames later less what it had k + 1 frames earlier; frames are `pixels` values apart.
  void (*steps)(const double* frame, std::size_t pixels, const double* weight, std::size_t reach, double* step);
};

extern const Kernels avx2_kernels, avx512_kernels;

/// The kernels for this machine; "portable", "avx2" or "avx512" asks for one by name, nullptr if it cannot run here.
/// "avx2" and "avx512" give the same bits, "portable" rounds products and sums apart.
const Kernels& kernels();
const Kernels* kernels(const char* name);

}  // namespace arenite::thermography
