#include <fmt/core.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/text.hpp"
#include "core/units.hpp"
#include "recipe/document.hpp"

namespace arenite::recipe {
namespace {

std::string number_literal(double value, std::string_view unit) {
  return unit.empty() ? format_quantity(value, unit) : toml_text(format_quantity(value, unit));
}

std::string number_form(std::string_view unit) { return unit.empty() ? "..." : fmt::format("\"... {}\"", unit); }

/// In brackets; nothing without items.
template <class Items, class Literal> std::optional<std::string> list_literal(const Items& items, Literal literal) {
  if (items.empty()) return std::nullopt;
  return fmt::format("[{}]", list_of(mapped(items, literal)));
}

class Recorder : public ParameterVisitor {
 public:
  Recorder(RecordTable& table, bool every_key) : table_(table), every_key_(every_key) {}

  void number(const Key& key, std::optional<double>& value, std::string_view unit, const Range& range) override {
    Record& record = add(key, number_form(unit), to_string(range, unit));
    if (value) record.literal = number_literal(*value, unit);
  }
  void integer(const Key& key, std::optional<std::int64_t>& value, const IntegerRange& range) override {
    Record& record = add(key, "...", to_string(range));
    if (value) record.literal = std::to_string(*value);
  }
  void flag(const Key& key, bool& value) override { add(key, "...").literal = value ? "true" : "false"; }
  void text(const Key& key, std::string& value) override {
    Record& record = add(key, "\"...\"");
    if (!value.empty() || key.required) record.literal = toml_text(value);
  }
  void file(const Key& key, std::string& value) override { text(key, value); }
  void numbers(const Key& key, std::vector<double>& values, std::string_view unit, const Range& range) override {
    const std::string each = to_string(range, unit);
    add(key, fmt::format("[{}]", number_form(unit)), each.empty() ? "" : "each " + each).literal =
        list_literal(values, [&](double value) { return number_literal(value, unit); });
  }
  void pairs(const Key& key, std::vector<std::pair<std::int32_t, std::int32_t>>& values) override {
    add(key, "[[0, 1], ...]").literal = list_literal(values, [](const auto& pair) { return fmt::format("[{}, {}]", pair.first, pair.second); });
  }
  void points(const Key& key, std::vector<Vec2>& values, std::string_view unit) override { add_rows(key, values, unit, unit); }
  void series(const Key& key, std::vector<Vec2>& values, std::string_view unit) override { add_rows(key, values, "s", unit); }
  void choice(const Key& key, int& index, const std::vector<Word>& words) override {
    Record& record = add(key, "\"...\"");
    for (const auto& word : words) record.choices.push_back({toml_text(word.word), std::string(word.sentence), word});
    record.literal = record.choices[static_cast<std::size_t>(index)].literal;
  }
  void tagged(const Key& key, int& form, double& value, const std::vector<Form>& forms) override {
    Record& record = add(key, "...");
    const auto literal = [](const Form& each, const std::string& quantity) {
      return each.unit.empty() ? toml_text(each.word) : fmt::format("{{ {} = {} }}", each.word, quantity);
    };
    for (const auto& each : forms) record.choices.push_back({literal(each, number_form(each.unit)), std::string(each.sentence)});
    const Form& chosen = forms[static_cast<std::size_t>(form)];
    record.literal = literal(chosen, number_literal(value, chosen.unit));
  }
  void section(const Key& key, bool& present, const Visit& inside) override {
    Record& record = add(key, "{ ... }");
    record.kind = Record::Kind::section;
    record.present = present;
    record.tables.push_back(record_of(inside, every_key_));
  }
  void sections(const Key& key, const Elements& elements) override {
    Record& record = add(key, "...");
    record.kind = Record::Kind::sections;
    record.named = static_cast<bool>(elements.name);
    if (every_key_) elements.resize(1);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      record.tables.push_back(record_of([&](ParameterVisitor& recorder) { elements.visit(recorder, i); }, every_key_));
      if (record.named) record.table_names.push_back(every_key_ ? "NAME" : elements.name(i));
    }
  }
  void when(bool active, std::string_view condition, const Visit& inside) override {
    if (!active && !every_key_) return;
    condition_ = condition;
    inside(*this);
    condition_ = {};
  }

 private:
  Record& add(const Key& key, std::string form, std::string allowed = {}) {
    return table_.emplace_back(Record{.key = key, .condition = condition_, .form = std::move(form), .allowed = std::move(allowed)});
  }

  void add_rows(const Key& key, const std::vector<Vec2>& values, std::string_view unit_x, std::string_view unit_y) {
    add(key, fmt::format("[[{}, {}], ...]", number_form(unit_x), number_form(unit_y))).literal =
        list_literal(values, [&](Vec2 pair) { return fmt::format("[{}, {}]", number_literal(pair.x, unit_x), number_literal(pair.y, unit_y)); });
  }

  RecordTable& table_;
  bool every_key_;
  std::string condition_;
};

// Keys and words are still read by their names of before, which their records know.

/// What is declared of a key by its name of now or before; nothing where there is none.
const Record* declared(const RecordTable& keys, std::string_view name) {
  const auto at = std::ranges::find_if(keys, [&](const Record& record) { return record.key.name == name || (!name.empty() && record.key.former == name); });
  return at == keys.end() ? nullptr : &*at;
}

std::string below(const std::string& section, std::string_view key) { return section.empty() ? std::string(key) : fmt::format("{}.{}", section, key); }

void rename_in_table(Node& table, const RecordTable& keys, const std::string& path, std::vector<std::string>& notices);

/// A word that stands under its name of before, or what does in a section; an item of a list is `*`.
void rename_in_value(Node& value, const Record& record, const std::string& path, std::vector<std::string>& notices) {
  for (const auto& [literal, sentence, word] : record.choices) {
    if (value.kind != Node::Kind::text || word.former.empty() || value.text != word.former) continue;
    note_former_name(notices, fmt::format("{} = {}", path, toml_text(word.former)), literal);
    value.text = word.word;
  }
  if (record.kind == Record::Kind::section) rename_in_table(value, record.tables.front(), path, notices);
  if (record.kind != Record::Kind::sections) return;
  for (Node& item : value.items) rename_in_table(item, record.tables.front(), below(path, "*"), notices);
  for (Entry& entry : value.entries) rename_in_table(entry.value, record.tables.front(), below(path, "*"), notices);
}

void rename_in_table(Node& table, const RecordTable& keys, const std::string& path, std::vector<std::string>& notices) {
  for (Entry& entry : table.entries) {
    const Record* const record = declared(keys, entry.key);
    if (!record) continue;
    if (entry.key != record->key.name && !table.find(record->key.name)) {
      note_former_name(notices, below(path, entry.key), record->key.name);
      entry.key = record->key.name;
    }
    rename_in_value(entry.value, *record, below(path, entry.key), notices);
  }
}

/// The parts of a dotted key.
std::vector<std::string> words_of(const std::string& key) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    words.emplace_back(trimmed(std::string_view(key).substr(begin, end - begin)));
    if (words.back().empty()) throw InputError("a part of the key is empty");
    if (words.size() > deepest) throw InputError("no recipe key has that many parts");
    begin = end + 1;
  }
  return words;
}

std::size_t item_index(const std::string& word, const Node& array) {
  const auto index = parse_number<std::size_t>(word);
  if (!index || *index >= array.items.size()) throw InputError(fmt::format("\"{}\" is not one of the {} items, counted from 0", word, array.items.size()));
  return *index;
}

/// The value under `word`; made where there is none, and turned into a table where `word` needs one.
Node& step_into(Node& node, const std::string& word, const Place& place) {
  if (node.kind == Node::Kind::array) return node.items[item_index(word, node)];
  if (node.kind != Node::Kind::table) node = {.place = place};
  const auto at = std::ranges::find(node.entries, word, &Entry::key);
  return at != node.entries.end() ? at->value : node.entries.emplace_back(Entry{word, place, {.place = place}}).value;
}

}  // namespace

RecordTable record_of(const Visit& declare, bool every_key) {
  RecordTable table;
  Recorder recorder(table, every_key);
  declare(recorder);
  return table;
}

void note_former_name(std::vector<std::string>& notices, std::string_view former, std::string_view now) {
  std::string sentence = fmt::format("{} is now called {}; the former name is still read", former, now);
  if (std::ranges::find(notices, sentence) == notices.end()) notices.push_back(std::move(sentence));
}

void rename_former_keys(Node& root, const RecordTable& keys, std::vector<std::string>& notices) { rename_in_table(root, keys, "", notices); }

RecordTable under_former_names(RecordTable table) {
  for (Record& record : table) {
    if (!record.key.former.empty()) record.key.name = record.key.former;
    const auto chosen = std::ranges::find(record.choices, record.literal, &Record::Choice::literal);
    if (chosen != record.choices.end() && !chosen->word.former.empty()) record.literal = toml_text(chosen->word.former);
    for (RecordTable& inner : record.tables) inner = under_former_names(std::move(inner));
  }
  return table;
}

void set_value(Node& root, const std::string& key, Node value, const RecordTable& keys) {
  Place place = value.place;
  place.wins = true;
  Node* node = &root;
  const RecordTable* table = &keys;  // that the next word is a key of; none where it is an item or nothing is declared
  const Record* record = nullptr;    // what is declared of the node
  for (const auto& word : words_of(key)) {
    const bool is_item = !table && record && record->kind == Record::Kind::sections;
    const RecordTable* const of_item = is_item ? &record->tables.front() : nullptr;
    record = table ? declared(*table, word) : nullptr;
    table = record && record->kind == Record::Kind::section ? &record->tables.front() : of_item;
    node = &step_into(*node, record ? record->name() : word, place);
  }
  std::vector<std::string> unheard;
  if (record) rename_in_value(value, *record, "", unheard);
  else if (table) rename_in_table(value, *table, "", unheard);
  each_place(value, [&](Place& each) { each = place; });
  *node = std::move(value);
}

void apply_override(Node& root, const std::string& assignment, const RecordTable& keys) {
  const auto equals = assignment.find('=');
  try {
    if (equals == std::string::npos || equals == 0) throw InputError("write key=value, for example seed=7 or container.width=\"350 mm\"");
    Node value = parse_value(assignment.substr(equals + 1));
    value.place = {.override_text = "--set " + assignment};
    set_value(root, assignment.substr(0, equals), std::move(value), keys);
  } catch (const InputError& error) { throw InputError(fmt::format("--set {}: {}", assignment, error.what())); }
}

}  // namespace arenite::recipe
