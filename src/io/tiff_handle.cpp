#include "io/tiff_handle.hpp"

#include <cstdarg>
#include <cstdio>

#include "core/error.hpp"

namespace arenite::io {
namespace {

tmsize_t read_bytes(thandle_t handle, void* to, tmsize_t count) {
  auto& source = *static_cast<TiffSource*>(handle);
  const std::size_t there = source.bytes->read(source.at, static_cast<std::size_t>(count), to);
  source.at += there;
  return static_cast<tmsize_t>(there);
}

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  auto& source = *static_cast<TiffSource*>(handle);
  source.at = offset + (whence == SEEK_CUR ? source.at : whence == SEEK_END ? source.bytes->size() : 0);
  return source.at;
}

int complain(TIFF*, void* user, const char*, const char* format, va_list arguments) {
  auto& source = *static_cast<TiffSource*>(user);
  char text[200] = {};
  std::vsnprintf(text, sizeof(text), format, arguments);
  if (source.complaint.empty()) source.complaint = text;
  return 1;
}

}  // namespace

void TiffSource::refuse(const std::string& message) const { throw InputError(file(), 0, message); }

void TiffSource::refuse_damaged() const {
  refuse("is a TIFF picture that is cut short or damaged" + (complaint.empty() ? "" : " (" + complaint + ")") + "; copy it again");
}

Tiff open_tiff(TiffSource& source, std::int64_t most_at_once) {
  const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
  TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), most_at_once);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), complain, &source);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), [](TIFF*, void*, const char*, const char*, va_list) { return 1; }, nullptr);
  // "m": no mapping into memory, for the bytes come through us.
  return {TIFFClientOpenExt(
              "picture", "rm", &source, read_bytes, [](thandle_t, void*, tmsize_t) -> tmsize_t { return 0; }, seek,
              [](thandle_t) { return 0; }, [](thandle_t h) -> toff_t { return static_cast<TiffSource*>(h)->bytes->size(); }, nullptr,
              nullptr, options.get()),
          TIFFClose};
}

}  // namespace arenite::io
