#include "recipe/writer.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/text.hpp"
#include "recipe/document.hpp"
#include "recipe/record.hpp"
#include "recipe/values.hpp"

namespace arenite::recipe {
namespace {

/// Notes the keys that a declaration visits.
class Recorder : public KeyVisitor {
 public:
  explicit Recorder(bool every_key) : every_key_(every_key) {}
  RecordTable table;

  void section(const Key& key, bool& present, const Visit& inside) override {
    add({.key = key,
         .form = "{ ... }",
         .kind = Record::Kind::section,
         .present = present,
         .tables = {record_of(inside, every_key_)}});
  }
  void sections(const Key& key, const Elements& elements) override {
    Record record{.key = key, .form = "...", .kind = Record::Kind::sections, .named = static_cast<bool>(elements.name)};
    if (every_key_) elements.resize(1);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      record.tables.push_back(record_of([&](ParameterVisitor& recorder) { elements.visit(recorder, i); }, every_key_));
      if (record.named) record.table_names.push_back(every_key_ ? "NAME" : elements.name(i));
    }
    add(std::move(record));
  }
  void when(bool active, std::string_view condition, const Visit& inside) override {
    if (!active && !every_key_) return;
    condition_ = condition;
    inside(*this);
    condition_ = {};
  }

 private:
  void visit(Record record, const std::function<void(const Written&)>&) override { add(std::move(record)); }
  void add(Record record) {
    record.condition = condition_;
    table.push_back(std::move(record));
  }

  bool every_key_;
  std::string condition_;
};

std::optional<std::string> value_of(const Record& record);

/// a = 1, b = 2: the keys that are set.
std::vector<std::string> assignments(const RecordTable& table) {
  std::vector<std::string> items;
  for (const auto& record : table)
    if (const auto value = value_of(record)) items.push_back(fmt::format("{} = {}", record.key.name, *value));
  return items;
}

std::string inline_table(const RecordTable& table) { return fmt::format("{{ {} }}", list_of(assignments(table))); }

/// { a = 1, b = "... mm" } with a form to fill in for each required key, and for every key where none has a value of
/// its own.
std::string inline_form(const RecordTable& table) {
  const bool bare = std::none_of(table.begin(), table.end(),
                                 [](const Record& record) { return record.key.required || record.literal; });
  std::vector<std::string> items;
  for (const auto& record : table)
    if (bare || record.key.required || record.literal)
      items.push_back(
          fmt::format("{} = {}", record.key.name, bare || record.key.required ? record.form : *record.literal));
  return fmt::format("{{ {} }}", list_of(items));
}

/// On one line, [{ a = 1 }, { a = 2 }] of a list; nothing if it is not set.
std::optional<std::string> value_of(const Record& record) {
  if (record.kind == Record::Kind::value) return record.literal;
  if (!record.present || record.tables.empty()) return std::nullopt;
  return record.kind == Record::Kind::section ? inline_table(record.tables.front())
                                              : fmt::format("[{}]", list_of(mapped(record.tables, inline_table)));
}

void write_table(std::string& text, const RecordTable& table) {
  for (const auto& line : assignments(table)) text += line + "\n";
}

/// Above table `i` of a section or a list that lies at `path`.
std::string heading(const Record& record, const std::string& path, std::size_t i) {
  if (record.kind == Record::Kind::section) return fmt::format("[{}]", path);
  return record.named ? fmt::format("[{}.{}]", path, toml_key(record.table_names[i])) : fmt::format("[[{}]]", path);
}

RecordTable values_in(RecordTable table) {
  std::erase_if(table, [](const Record& record) { return record.kind != Record::Kind::value; });
  return table;
}

/// The record of the same key. Tables that have another form in space have their name twice, with two sentences; values
/// that have theirs twice are held against the first, by which stored results are named.
const Record& same_of(const Record& record, const RecordTable& table) {
  const auto same = [&](const Record& other) {
    return other.key.name == record.key.name &&
           (record.kind == Record::Kind::value || other.key.sentence == record.key.sentence);
  };
  const auto found = std::ranges::find_if(table, same);
  if (found == table.end()) throw std::logic_error(fmt::format("key {} is declared in one of two ways", record.name()));
  return *found;
}

/// Whether a key is to be seen because it is set, and not to its default.
bool is_changed(const Record& record, const RecordTable& defaults) {
  return record.literal && (record.key.required || record.literal != same_of(record, defaults).literal);
}

RecordTable changed(RecordTable table, const RecordTable& defaults) {
  std::erase_if(table, [&](const Record& record) { return !is_changed(record, defaults); });
  return table;
}

std::string explanation(const Record& record) {
  if (record.choices.empty()) return std::string(record.key.sentence);
  return fmt::format("{} One of: {}", record.key.sentence, list_of(mapped(record.choices, &Record::Choice::literal)));
}

/// The lines of one table; keys at their default are comments, and appear only if `explain`.
void write_commented_table(std::string& text, const RecordTable& table, const RecordTable& defaults, bool explain,
                           bool active) {
  for (const auto& record : table) {
    const Record& standard = same_of(record, defaults);
    const auto differences =
        mapped(record.tables, [&](const RecordTable& inner) { return changed(inner, standard.tables.front()); });
    bool set = active;
    std::string value;
    if (record.kind == Record::Kind::section) {
      set = set && record.present && !differences.front().empty();
      value = set ? inline_table(differences.front()) : inline_form(record.tables.front());
    } else if (record.kind == Record::Kind::sections) {
      set = set && !differences.empty();
      value = set ? fmt::format("[{}]", list_of(mapped(differences, inline_table)))
                  : fmt::format("[{}]", inline_form(standard.tables.front()));
    } else {
      set = set && is_changed(record, defaults);
      value = record.literal && !(record.key.required && !active) ? *record.literal : record.form;
    }
    const std::string line = fmt::format("{}{} = {}", set ? "" : "# ", record.key.name, value);
    if (explain) text += fmt::format("{:<38} # {}\n", line, explanation(record));
    else if (set) text += line + "\n";
  }
}

/// The keys that are set against their default, below `path`.
void add_changes(std::string& text, const std::string& path, const RecordTable& table, const RecordTable& defaults) {
  for (const auto& record : table) {
    const Record& standard = same_of(record, defaults);
    const std::string key = path + toml_key(record.name());
    if (record.kind == Record::Kind::value) {
      if (record.key.required || record.literal != standard.literal)
        text += fmt::format("{} = {}\n", key, record.literal.value_or("not set"));
      continue;
    }
    const bool is_list = record.kind == Record::Kind::sections;
    if (!record.present && standard.present) text += fmt::format("{} = not set\n", key);
    for (std::size_t i = 0; record.present && i < record.tables.size(); ++i) {
      const std::string inner =
          !is_list ? key
                   : fmt::format("{}.{}", key, record.named ? toml_key(record.table_names[i]) : std::to_string(i));
      if (is_list || !standard.present) text += fmt::format("[{}]\n", inner);
      add_changes(text, inner + ".", record.tables[i], standard.tables.front());
    }
  }
}

/// Text in a cell of a Markdown table.
std::string cell(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string in_code(std::string_view text) { return "`" + cell(text) + "`"; }

std::string meaning_of(const Record& record) {
  std::string text = cell(record.key.sentence);
  if (!record.condition.empty()) text += " With " + in_code(record.condition) + ".";
  if (!record.allowed.empty()) text += fmt::format(" Allowed: {}.", cell(record.allowed));
  for (const auto& [literal, meaning, word] : record.choices)
    text += "<br>" + in_code(literal) + (meaning.empty() ? "" : ": " + cell(meaning));
  return text;
}

void write_rows(std::string& text, const RecordTable& table) {
  text += "| key | written as | default | meaning |\n|---|---|---|---|\n";
  for (const auto& record : table) {
    if (record.kind == Record::Kind::sections) continue;
    if (record.kind == Record::Kind::section) {
      text += fmt::format("| `{}` | `{{ ... }}` | {} | {} See below. |\n", record.key.name,
                          record.present ? "its keys' defaults" : "-", cell(record.key.sentence));
      continue;
    }
    const std::string form = !record.choices.empty()                  ? record.choices.front().literal
                             : record.literal && !record.key.required ? *record.literal
                             : record.form == "..."                   ? std::string("1")
                                                                      : record.form;
    const std::string standard = record.key.required ? "*required*" : record.literal ? in_code(*record.literal) : "-";
    text += fmt::format("| `{}` | {} | {} | {} |\n", record.key.name, in_code(form), standard, meaning_of(record));
  }
}

/// The sections and lists of a table, each under a heading; that of a second one of a name tells with what it goes.
void write_sections(std::string& text, const RecordTable& table, const std::string& parent) {
  for (const auto& record : table) {
    if (record.kind == Record::Kind::value) continue;
    const std::string path = parent.empty() ? record.name() : parent + "." + record.name();
    const bool second = std::ranges::find(table, record.key.name, [](const Record& r) {
                          return r.key.name;
                        })->key.sentence != record.key.sentence;
    text += fmt::format("\n## `{}`{}\n\n{}{}\n\n", heading(record, path, 0),
                        second ? fmt::format(" with `{}`", record.condition) : "", record.key.sentence,
                        record.key.required ? " Required."
                        : record.present    ? ""
                                            : " Optional.");
    write_rows(text, record.tables.front());
    write_sections(text, record.tables.front(), path);
  }
}

}  // namespace

RecordTable record_of(const Visit& declare, bool every_key) {
  Recorder recorder(every_key);
  declare(recorder);
  return std::move(recorder.table);
}

std::string write_toml(const RecordTable& root) {
  std::string text;
  write_table(text, values_in(root));
  for (const auto& record : root) {
    for (std::size_t i = 0; record.present && i < record.tables.size(); ++i) {
      text += "\n" + heading(record, record.name(), i) + "\n";
      write_table(text, record.tables[i]);
    }
  }
  return text;
}

std::string write_changes(const RecordTable& root, const RecordTable& all) {
  std::string text;
  add_changes(text, "", root, all);
  return text;
}

std::string write_commented_toml(const RecordTable& root, const RecordTable& all) {
  std::string text;
  write_commented_table(text, values_in(root), all, true, true);
  for (const auto& record : root) {
    if (record.kind == Record::Kind::value || record.tables.empty()) continue;
    text += fmt::format("\n# {}\n", record.key.sentence);
    for (std::size_t i = 0; i < record.tables.size(); ++i) {
      if (i > 0) text += "\n";
      text += (record.present ? "" : "# ") + heading(record, record.name(), i) + "\n";
      write_commented_table(text, record.tables[i], same_of(record, all).tables.front(), i == 0, record.present);
    }
  }
  return text;
}

std::string write_key_tables(const RecordTable& all) {
  std::string text;
  if (const RecordTable top = values_in(all); !top.empty()) {
    text = "## Top of the file\n\n";
    write_rows(text, top);
  }
  write_sections(text, all, "");
  return text;
}

}  // namespace arenite::recipe
