#include "recipe/reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "core/problems.hpp"
#include "core/text.hpp"
#include "recipe/document.hpp"
#include "recipe/given.hpp"
#include "recipe/quantities.hpp"
#include "recipe/record.hpp"
#include "recipe/values.hpp"

namespace arenite::recipe {
namespace {

std::string below(const std::string& section, std::string_view key) {
  return section.empty() ? std::string(key) : fmt::format("{}.{}", section, key);
}

/// A sentence as a part of another.
std::string as_phrase(std::string_view sentence) {
  std::string phrase(sentence);
  if (phrase.size() > 1) phrase[0] = lower_case(phrase[0]);
  if (phrase.ends_with('.')) phrase.pop_back();
  return phrase;
}

std::string example_of(const Record& record) {
  if (!record.example.empty()) return record.example;
  std::string literal = record.choices.empty() ? record.form : record.choices.front().literal;
  if (const auto dots = literal.find("..."); dots != literal.npos && literal != "\"...\"")
    literal.replace(dots, 3, "1");
  return literal;
}

/// Reads one table of a recipe into what the declarations name; sub-tables get readers of their own. Problems are
/// collected; whatever is wrong keeps its default.
class Reader : public KeyVisitor {
 public:
  Reader(const Node& table, std::string path, Reading& reading)
      : table_(table),
        path_(std::move(path)),
        reading_(reading) {}

  void section(const Key& key, bool& present, const Visit& inside) override {
    const Entry* entry = find(key);
    const std::string path = path_of(key.name);
    present = entry != nullptr;
    if (!entry && key.required)
      return refuse(key, table_.place,
                    fmt::format("is missing; add the section [{}] ({})", path, as_phrase(key.sentence)));
    if (!entry) return;
    if (entry->value.kind != Node::Kind::table)
      return refuse(key, entry->value.place,
                    fmt::format("is {}, but must be a section [{}]", kind_name(entry->value), path));
    watch(key, [&] { read_table(entry->value, path, inside); });
  }

  void sections(const Key& key, const Elements& elements) override {
    const Entry* entry = find(key);
    const bool named = static_cast<bool>(elements.name);
    const std::string path = path_of(key.name),
                      heading = named ? fmt::format("[{}.NAME]", path) : fmt::format("[[{}]]", path);
    if (entry && entry->value.kind != (named ? Node::Kind::table : Node::Kind::array))
      return refuse(key, entry->value.place,
                    fmt::format("is {}, but must be sections {}", kind_name(entry->value), heading));
    std::vector<std::pair<std::string, const Node*>> nodes;
    if (entry && named)
      for (const Entry& each : entry->value.entries) nodes.emplace_back(each.key, &each.value);
    else if (entry)
      for (const Node& item : entry->value.items) nodes.emplace_back(std::to_string(nodes.size()), &item);
    if (nodes.empty() && key.required)
      refuse(key, entry ? entry->value.place : table_.place,
             fmt::format("is missing; add a section {} ({})", heading, as_phrase(key.sentence)));
    // Named sections have no order of their own: sorted, the same recipe gives the same indices however it is written.
    if (named) std::sort(nodes.begin(), nodes.end());
    elements.resize(nodes.size());
    watch(key, [&] {
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto& [name, node] = nodes[i];
        if (named) elements.name(i) = name;
        if (const Written at{*node, path + "." + name, reading_}; at.is_a(Node::Kind::table, "a section " + heading))
          read_table(*node, at.path, [&, i](ParameterVisitor& reader) { elements.visit(reader, i); });
      }
    });
  }

  void when(bool active, std::string_view condition, const Visit& inside) override {
    // Of a choice that could not be read, no form's keys are missing or out of place.
    const bool undecided =
        std::ranges::any_of(failed_, [&](const std::string& key) { return condition.starts_with(key + " = "); });
    if (active && !undecided) return inside(*this);
    // A reader of an empty table knows which keys there would be.
    const Node nothing;
    Reading unheard{};
    Reader reader(nothing, path_, unheard);
    inside(reader);
    for (const auto& [name, also] : reader.conditional_) reader.known_.insert(name);
    if (undecided) return known_.merge(reader.known_);
    for (const auto& name : reader.known_) {
      const auto [place, is_new] = conditional_.emplace(name, condition);
      if (!is_new) place->second += fmt::format(" or {}", condition);
    }
  }

  void require(bool holds, std::initializer_list<std::string_view> keys, std::string_view message) override {
    if (holds || std::ranges::any_of(keys, [&](std::string_view key) { return failed_.count(key) > 0; })) return;
    const Place* place = &table_.place;
    for (const auto key : keys)
      if (const Entry* entry = table_.find(key)) {
        place = &entry->value.place;
        break;
      }
    reading_.add(*place, keys.size() == 0 ? path_ : path_of(*keys.begin()), std::string(message));
  }

  /// A key that is read elsewhere.
  void know(const std::string& key) { known_.insert(key); }

  /// Call when all keys were visited: what is left over is unknown.
  void refuse_unknown_keys() {
    const std::vector<std::string> names(known_.begin(), known_.end());
    for (const auto& entry : table_.entries) {
      if (known_.count(entry.key) > 0) continue;
      const auto conditional = conditional_.find(entry.key);
      const std::string near = nearest(entry.key, names);
      if (conditional != conditional_.end() && reading_.leaves_idle_keys) {
        reading_.notices.push_back(left_aside(file_of(entry.place, reading_), conditional->second));
        continue;
      }
      reading_.add(entry.place, path_of(entry.key),
                   conditional != conditional_.end()
                       ? fmt::format("this key is only valid with {}; leave it out or change that", conditional->second)
                   : near.empty() ? fmt::format("unknown key; the keys here are: {}", list_of(names))
                                  : fmt::format("unknown key; did you mean {}?", near));
    }
  }

 private:
  void visit(Record record, const std::function<void(const Written&)>& read) override {
    const Key& key = record.key;
    if (const Entry* entry = find(key)) watch(key, [&] { read({entry->value, path_of(key.name), reading_}); });
    else if (key.required)
      refuse(key, table_.place, fmt::format("is missing; write for example {} = {}", key.name, example_of(record)));
  }

  const Entry* find(const Key& key) {
    known_.emplace(key.name);
    return table_.find(key.name);
  }

  std::string path_of(std::string_view name) const { return below(path_, name); }

  void refuse(const Key& key, const Place& place, const std::string& message) {
    failed_.emplace(key.name);
    reading_.add(place, path_of(key.name), message);
  }

  /// Notes whether what is read finds a problem.
  template <class Read> void watch(const Key& key, Read read) {
    const std::size_t before = reading_.problems.size();
    read();
    if (reading_.problems.size() > before) failed_.emplace(key.name);
  }

  void read_table(const Node& table, const std::string& path, const Visit& inside) {
    Reader reader(table, path, reading_);
    inside(reader);
    reader.refuse_unknown_keys();
  }

  const Node& table_;
  std::string path_;
  Reading& reading_;
  std::set<std::string, std::less<>> known_, failed_;
  std::map<std::string, std::string, std::less<>> conditional_;  ///< keys that do not exist now, and when they do
};

// Keys and words are still read by their names of before, which their records know.

/// What is declared of a key by its name of now or before; nothing where there is none.
const Record* declared(const RecordTable& keys, std::string_view name) {
  const auto at = std::ranges::find_if(keys, [&](const Record& record) {
    return record.key.name == name || (!name.empty() && record.key.former == name);
  });
  return at == keys.end() ? nullptr : &*at;
}

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

}  // namespace

void Reading::add(const Place& place, const std::string& path, const std::string& message) {
  problems.push_back(
      {file_of(place, *this), place.line, place.column, path.empty() ? message : fmt::format("{}: {}", path, message)});
}

const std::string& file_of(const Place& place, const Reading& reading) {
  return !place.override_text.empty() ? place.override_text : !place.file.empty() ? place.file : reading.file_name;
}

void add_problem(Reading& reading, const Place& place, const std::string& path, const std::string& message) {
  reading.add(place, path, message);
  const Problem& last = reading.problems.back();
  const auto same = std::ranges::count_if(reading.problems, [&](const Problem& p) {
    return p.message == last.message && p.line == last.line && p.file == last.file;
  });
  if (same > 1) reading.problems.pop_back();
}

void note_former_name(std::vector<std::string>& notices, std::string_view former, std::string_view now) {
  std::string sentence = fmt::format("{} is now called {}; the former name is still read", former, now);
  if (std::ranges::find(notices, sentence) == notices.end()) notices.push_back(std::move(sentence));
}

void rename_former_keys(Node& root, const RecordTable& keys, std::vector<std::string>& notices) {
  rename_in_table(root, keys, "", notices);
}

RecordTable under_former_names(RecordTable table) {
  for (Record& record : table) {
    if (!record.key.former.empty()) record.key.name = record.key.former;
    const auto chosen = std::ranges::find(record.choices, record.literal, &Record::Choice::literal);
    if (chosen != record.choices.end() && !chosen->word.former.empty()) record.literal = toml_text(chosen->word.former);
    for (RecordTable& inner : record.tables) inner = under_former_names(std::move(inner));
  }
  return table;
}

std::vector<std::string> set_value(Node& root, const std::string& key, Node value, const RecordTable& keys) {
  std::vector<std::string> parts = parts_of(key), unheard;
  const RecordTable* table = &keys;  // that the next part is a key of; none where it is an item or nothing is declared
  const Record* record = nullptr;    // what is declared of the last part
  for (auto& part : parts) {
    const RecordTable* const of_item =
        !table && record && record->kind == Record::Kind::sections ? &record->tables.front() : nullptr;
    record = table ? declared(*table, part) : nullptr;
    table = record && record->kind == Record::Kind::section ? &record->tables.front() : of_item;
    if (record) part = record->name();
  }
  if (record) rename_in_value(value, *record, "", unheard);
  else if (table) rename_in_table(value, *table, "", unheard);
  return put(root, parts, std::move(value));
}

void read_declared(const Node& root, Reading& reading, const Visit& declare) {
  read_variables(root, reading);
  Reader reader(root, "", reading);
  reader.know("variables");
  declare(reader);
  reader.refuse_unknown_keys();
  if (reading.problems.empty()) return;
  std::ranges::stable_sort(reading.problems, {}, [](const Problem& p) { return std::pair(p.line, p.column); });
  throw InputError(std::move(reading.problems));
}

}  // namespace arenite::recipe
