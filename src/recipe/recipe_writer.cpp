#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "recipe/recipe_record.hpp"

namespace arenite::study {
namespace {

/// { a = 1, b = 2 } of the keys that are set.
std::string inline_table(const RecordTable& table) {
  std::vector<std::string> items;
  for (const auto& record : table) {
    if (record.literal) items.push_back(fmt::format("{} = {}", record.name, *record.literal));
  }
  return fmt::format("{{ {} }}", fmt::join(items, ", "));
}

/// { a = 1, b = "... mm" } with a form to fill in for each required key.
std::string inline_form(const RecordTable& table) {
  std::vector<std::string> items;
  for (const auto& record : table) {
    if (record.required || record.literal) {
      items.push_back(fmt::format("{} = {}", record.name, record.required ? record.form : *record.literal));
    }
  }
  return fmt::format("{{ {} }}", fmt::join(items, ", "));
}

void write_table(std::string& text, const RecordTable& table) {
  for (const auto& record : table) {
    if (record.kind == Record::Kind::section) {
      if (record.present) text += fmt::format("{} = {}\n", record.name, inline_table(record.tables.front()));
    } else if (record.literal) {
      text += fmt::format("{} = {}\n", record.name, *record.literal);
    }
  }
}

std::string heading(const Record& record, std::size_t i) {
  if (record.kind == Record::Kind::section) return fmt::format("[{}]", record.name);
  return record.named ? fmt::format("[{}.{}]", record.name, toml_key(record.table_names[i])) : fmt::format("[[{}]]", record.name);
}

const Record& find(const RecordTable& table, const std::string& name) {
  return *std::find_if(table.begin(), table.end(), [&](const Record& record) { return record.name == name; });
}

/// Keys of an inline section that are not at their default.
RecordTable changed(const RecordTable& table, const RecordTable& defaults) {
  RecordTable result;
  for (const auto& record : table) {
    if (record.literal && (record.required || record.literal != find(defaults, record.name).literal)) result.push_back(record);
  }
  return result;
}

std::string explanation(const Record& record) {
  std::vector<std::string> words;
  for (const auto& [word, meaning] : record.words) words.push_back(word);
  return words.empty() ? record.sentence : fmt::format("{} One of: {}", record.sentence, fmt::join(words, ", "));
}

void write_line(std::string& text, bool active, const std::string& assignment, const std::string& comment) {
  const std::string start = active ? assignment : "# " + assignment;
  if (comment.empty()) text += start + "\n";
  else text += fmt::format("{:<38} # {}\n", start, comment);
}

/// The lines of one table; keys at their default are comments, and appear only if `explain`.
void write_commented_table(std::string& text, const RecordTable& table, const RecordTable& defaults, bool explain, bool active) {
  for (const auto& record : table) {
    const Record& standard = find(defaults, record.name);
    const std::string comment = explain ? explanation(record) : "";
    if (record.kind == Record::Kind::section) {
      const RecordTable differences = changed(record.tables.front(), standard.tables.front());
      const bool set = active && record.present && !differences.empty();
      const std::string value = set ? inline_table(differences) : inline_form(record.tables.front());
      if (set || explain) write_line(text, set, fmt::format("{} = {}", record.name, value), comment);
      continue;
    }
    const bool set = active && record.literal && (record.required || record.literal != standard.literal);
    const std::string value = record.literal && !(record.required && !active) ? *record.literal : record.form;
    if (set || explain) write_line(text, set, fmt::format("{} = {}", record.name, value), comment);
  }
}

}  // namespace

std::string write_toml(const RecordTable& root) {
  std::string text;
  for (const auto& record : root) {
    if (record.kind == Record::Kind::value) {
      if (record.literal) text += fmt::format("{} = {}\n", record.name, *record.literal);
      continue;
    }
    for (std::size_t i = 0; record.present && i < record.tables.size(); ++i) {
      text += "\n" + heading(record, i) + "\n";
      write_table(text, record.tables[i]);
    }
  }
  return text;
}

std::string write_commented_toml(const RecordTable& root, const RecordTable& all) {
  std::string text;
  RecordTable values;
  for (const auto& record : root) {
    if (record.kind == Record::Kind::value) values.push_back(record);
  }
  write_commented_table(text, values, all, true, true);
  for (const auto& record : root) {
    if (record.kind == Record::Kind::value || record.tables.empty()) continue;
    text += "\n# " + record.sentence + "\n";
    for (std::size_t i = 0; i < record.tables.size(); ++i) {
      if (i > 0) text += "\n";
      text += (record.present ? "" : "# ") + heading(record, i) + "\n";
      write_commented_table(text, record.tables[i], find(all, record.name).tables.front(), i == 0, record.present);
    }
  }
  return text;
}

}  // namespace arenite::study
