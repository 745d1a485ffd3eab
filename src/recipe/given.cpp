#include "recipe/given.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/text.hpp"
#include "recipe/reader.hpp"

namespace arenite::recipe {
namespace {

Node text_node(std::string_view text) { return {.kind = Node::Kind::text, .text = std::string(text), .entries = {}}; }

/// As a person would type it: without the quotes and brackets of TOML.
std::string as_typed(const Record& record) {
  std::string text = *record.literal;
  if (record.type == Record::Type::numbers)
    std::erase_if(text, [](char c) { return c == '[' || c == ']' || c == '"'; });
  return text.size() > 1 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2) : text;
}

/// The place of a problem says it; the key's own name in front of it would be a second one. A key that is missing
/// beside the one that is given keeps its name: "--cement: thickness: is missing".
void leave_key_out(Problem& problem, const std::vector<Given>& given) {
  const auto at = std::ranges::find(given, problem.file, &Given::label);
  const auto colon = problem.message.find(": ");
  if (at == given.end() || colon == std::string::npos || problem.message.find(' ') < colon) return;
  const std::string_view path = std::string_view(problem.message).substr(0, colon);
  if (path == at->key || problem.message.compare(colon, 12, ": is missing") != 0)
    return void(problem.message.erase(0, colon + 2));
  const std::string own = ": " + at->key.substr(at->key.rfind('.') + 1);
  if (problem.file.ends_with(own)) problem.file.resize(problem.file.size() - own.size());
  problem.message.erase(0, path.rfind('.') + 1);
}

}  // namespace

std::string left_aside(std::string_view key, std::string_view condition) {
  return fmt::format("{}: only has an effect with {}; it is left aside", key, condition);
}

const Record& record_at(const RecordTable& keys, std::string_view key) {
  const RecordTable* table = &keys;
  const Record* record = nullptr;
  for (const std::string& part : parts_of(key)) {
    const auto at = table ? std::ranges::find(*table, part, &Record::name) : keys.end();
    if (!table || at == table->end()) throw std::logic_error(fmt::format("no key \"{}\" is declared", key));
    record = &*at;
    table = record->tables.empty() ? nullptr : &record->tables.front();
  }
  return *record;
}

std::string help_of(const Record& record) {
  std::string text(record.key.sentence);
  if (text.ends_with('.')) text.pop_back();
  std::vector<std::string> more;
  const bool is_off = record.type == Record::Type::flag && record.literal == "false";
  if (record.literal && !record.key.required && !is_off) more.push_back("default " + as_typed(record));
  if (!record.allowed.empty()) more.push_back(record.allowed);
  return more.empty() ? text : fmt::format("{} ({})", text, list_of(more, "; "));
}

std::string help_of(const Record& record, std::string_view word) {
  const std::string_view sentence = record.key.sentence.substr(0, record.key.sentence.size() - 1);
  if (record.type == Record::Type::flag) return fmt::format("Off: {}", sentence);
  const auto choice = std::ranges::find(record.choices, word, [](const auto& each) { return each.word.word; });
  return fmt::format("{}: {}", sentence, choice->sentence);
}

namespace {

/// A number takes the unit that stands behind the last.
std::vector<std::string> value_and_error(const std::string& text) {
  const auto sign = text.find("+-");
  if (sign == std::string::npos) return {text};
  const std::string value(trimmed(text.substr(0, sign))), error(trimmed(text.substr(sign + 2)));
  const auto unit = error.find(' ');
  return {unit == std::string::npos || value.find(' ') != std::string::npos ? value : value + error.substr(unit),
          error};
}

}  // namespace

Node value_of(const Record& record, const std::string& text) {
  using Type = Record::Type;
  const bool is_quantity = record.type == Type::number && !record.unit.empty();
  if (is_quantity || record.type == Type::text || record.type == Type::choice) return text_node(trimmed(text));
  if (record.type != Type::numbers) return parse_value(text);
  Node list{.kind = Node::Kind::array, .entries = {}};
  for (const std::string& part : split_commas(text))
    for (const std::string& item : value_and_error(part))
      list.items.push_back(record.unit.empty() ? parse_value(item) : text_node(item));
  return list;
}

std::vector<std::string> read_given(const std::vector<Given>& given, const Visit& declare, bool in_si) {
  Reading reading{};
  reading.bare_numbers_are_si = in_si;
  reading.leaves_idle_keys = true;
  Node root;
  for (const Given& each : given) {
    Node value = each.value;
    value.place = {.override_text = each.label};
    put(root, parts_of(each.key), std::move(value));
  }
  try {
    read_declared(root, reading, declare);
  } catch (const InputError& error) {
    auto problems = error.problems();
    for (Problem& problem : problems) leave_key_out(problem, given);
    throw InputError(std::move(problems));
  }
  return reading.notices;
}

}  // namespace arenite::recipe
