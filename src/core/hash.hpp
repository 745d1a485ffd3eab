#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arenite {

/// 128 bits of content as 32 hexadecimal digits (XXH3): the same on every machine and in every version.
std::string content_hash(std::string_view bytes);

/// Hash of key = value parts in the order they were added: what a result depends on, so that its file can be named by
/// it. Lengths are hashed too, so ("ab", "c") and ("a", "bc") differ; doubles are hashed by their bits.
class HashBuilder {
 public:
  HashBuilder& add(std::string_view key, std::string_view value);
  HashBuilder& add(std::string_view key, const char* value) { return add(key, std::string_view(value)); }
  HashBuilder& add(std::string_view key, double value);
  HashBuilder& add(std::string_view key, std::int64_t value);
  HashBuilder& add(std::string_view key, const std::vector<double>& values);
  std::string hex() const { return content_hash(text_); }

 private:
  HashBuilder& add_part(char type, std::string_view key, std::string_view bytes);
  std::string text_;
};

}  // namespace arenite
