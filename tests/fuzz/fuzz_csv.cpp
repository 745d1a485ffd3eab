#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/error.hpp"
#include "io/sample/assemble.hpp"
#include "io/sample/formats.hpp"
#include "io/sample/layout.hpp"

namespace {

using namespace arenite;

/// Two files in one: the text before and after a line of "=====".
struct Files {
  std::string_view grains, contacts;
};
Files cut(std::string_view text) {
  constexpr std::string_view line = "\n=====\n";
  const std::size_t at = text.find(line);
  if (at == std::string_view::npos) return {text, {}};
  return {text.substr(0, at + 1), text.substr(at + line.size())};
}

/// What came through without an error must be a packing with all its invariants.
void examine(const Packing& packing) {
  const Grains& grains = packing.grains;
  const Contacts& contacts = packing.contacts;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    if (!std::isfinite(grains.position[g].x) || !std::isfinite(grains.position[g].y) || !(grains.radius[g] > 0))
      std::abort();
  }
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto n = static_cast<std::int32_t>(grains.size());
    if (contacts.i[c] < 0 || contacts.i[c] >= n || contacts.j[c] >= n) std::abort();
    if (is_boundary(contacts.j[c]) && contacts.element(c) >= packing.domain.elements()) std::abort();
    if (!std::isfinite(contacts.fn[c]) || !std::isfinite(contacts.ft[c])) std::abort();
    if (!(std::abs(std::hypot(contacts.normal[c].x, contacts.normal[c].y) - 1) < 1e-6)) std::abort();
  }
}

void read(char format, const Files& files) {
  Problems grain_problems("grains"), contact_problems("contacts");
  const bool bare = format == 'h';  // without header
  io::SampleOptions options;
  options.merge_doubled = true;
  if (bare) options.grain_columns = "id,x,y,radius", options.contact_columns = "i,j,fn,ft";
  const auto* known =
      io::first_format(io::samples::all, [&](const io::SampleFormat& one) { return one.name.front() == format; });
  const io::SampleFormat& of = bare || known == nullptr ? io::samples::csv : *known;
  io::RawGrains grains = of.grains({files.grains, 0, options, grain_problems});
  if (!grain_problems.any()) io::lay_out(grains, 2, grain_problems);
  io::RawContacts contacts;
  if (!grain_problems.any()) contacts = of.contacts({files.contacts, 0, options, contact_problems}, grains);
  io::Sample sample;
  io::place_box(grains, grain_problems);
  io::assemble(grains, grains.plane, contacts, options, sample, grain_problems, contact_problems);
  examine(sample.packing);
}

}  // namespace

/// Any bytes are grains and contacts or an InputError. The first letter says the format by its name's, or h: table
/// without header.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    read(text.front(), cut(text.substr(1)));
  } catch (const InputError& error) {
    if (error.problems().empty()) std::abort();
  }
  return 0;
}
