#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <variant>

#include "core/error.hpp"
#include "io/sample/formats.hpp"

namespace {

using namespace arenite;

/// What came through without an error must be a packing of spheres with all its invariants.
void examine(const PackingIn<3>& packing) {
  const GrainsIn<3>& grains = packing.grains;
  const ContactsIn<3>& contacts = packing.contacts;
  for (std::size_t g = 0; g < grains.size(); ++g)
    if (!is_finite(grains.position[g]) || !(grains.radius[g] > 0) || !std::isfinite(grains.radius[g])) std::abort();
  const auto n = static_cast<std::int32_t>(grains.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (contacts.i[c] < 0 || contacts.i[c] >= n || contacts.j[c] >= n) std::abort();
    if (contacts.is_wall(c) && contacts.wall_side(c) >= sides_in<3>) std::abort();
    if (!std::isfinite(contacts.fn[c]) || !is_finite(contacts.ft[c])) std::abort();
    if (!(std::abs(norm(contacts.normal[c]) - 1) < 1e-6)) std::abort();
  }
}

/// The text up to the next line of "=====", which is taken away.
std::string next_part(std::string_view& text) {
  constexpr std::string_view line = "\n=====\n";
  const std::size_t at = text.find(line);
  const std::string part(text.substr(0, at == text.npos ? at : at + 1));
  text.remove_prefix(at == text.npos ? text.size() : at + line.size());
  return part;
}

}  // namespace

/// Any bytes are spheres with contacts or an InputError. The first line is the name of a format, and "cell" behind it
/// gives the size of a periodic one; grains and contacts follow, with a line of "=====" between them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::string_view first = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(first.size() + 1, text.size()));
  io::SampleOptions options;
  options.dimension = 3;
  options.merge_doubled = true;
  for (const auto* format : io::samples::all)
    if (first.substr(0, first.find(' ')) == format->name) options.format = format->name;
  if (first.ends_with(" cell")) {
    options.box = {10, 10, 10};
    options.periodic = {true, true, true};
  }
  const io::SampleText grains{"grains", next_part(text)}, contacts{"contacts", next_part(text)};
  try {
    examine(std::get<io::SampleIn<3>>(io::sample_of(grains, contacts, options)).packing);
  } catch (const InputError& error) {
    if (error.problems().empty()) std::abort();
  }
  return 0;
}
