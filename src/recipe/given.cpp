#include "recipe/given.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

#include "core/text.hpp"
#include "recipe/reader.hpp"

namespace arenite::recipe {
namespace {

Node text_node(std::string_view text) { return {.kind = Node::Kind::text, .text = std::string(text), .entries = {}}; }

std::string without_quotes(std::string text) {
  return text.size() > 1 && text.front() == '"' && text.back() == '"' ? text.substr(1, text.size() - 2) : text;
}

/// The place of a problem says it; the key's own name in front of it would be a second one.
void leave_key_out(Problem& problem, const std::vector<Given>& given) {
  const auto at = std::ranges::find(given, problem.file, &Given::label);
  const auto colon = problem.message.find(": ");
  if (at != given.end() && colon != std::string::npos && problem.message.find(' ') > colon)
    problem.message.erase(0, colon + 2);
}

}  // namespace

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
  if (record.literal && !record.key.required && !is_off) more.push_back("default " + without_quotes(*record.literal));
  if (!record.allowed.empty()) more.push_back(record.allowed);
  return more.empty() ? text : fmt::format("{} ({})", text, list_of(more, "; "));
}

Node value_of(const Record& record, const std::string& text) {
  using Type = Record::Type;
  const bool is_quantity = record.type == Type::number && !record.unit.empty();
  if (is_quantity || record.type == Type::text || record.type == Type::choice) return text_node(trimmed(text));
  if (record.type != Type::numbers) return parse_value(text);
  Node list{.kind = Node::Kind::array, .entries = {}};
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    list.items.push_back(parse_value(text.substr(from, comma - from)));
    from = comma + 1;
  }
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
