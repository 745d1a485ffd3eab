#include <fmt/format.h>

#include "recipe/recipe_record.hpp"

namespace arenite::study {
namespace {

/// Text in a cell of a Markdown table.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

std::string in_code(const std::string& text) { return "`" + cell(text) + "`"; }

std::string default_of(const Record& record) {
  if (record.required) return "*required*";
  return record.literal && record.words.empty() ? in_code(*record.literal) : record.literal ? in_code(*record.literal) : "-";
}

std::string meaning_of(const Record& record) {
  std::string text = cell(record.sentence);
  if (!record.condition.empty()) text += " With " + in_code(record.condition) + ".";
  if (!record.allowed.empty()) text += fmt::format(" Allowed: {}.", cell(record.allowed));
  for (const auto& [word, meaning] : record.words) {
    text += "<br>" + in_code(word) + (meaning.empty() ? "" : ": " + cell(meaning));
  }
  return text;
}

void write_rows(std::string& text, const RecordTable& table) {
  text += "| key | written as | default | meaning |\n|---|---|---|---|\n";
  for (const auto& record : table) {
    if (record.kind == Record::Kind::sections) continue;
    if (record.kind == Record::Kind::section) {
      text += fmt::format("| `{}` | `{{ ... }}` | {} | {} See below. |\n", record.name, record.present ? "its keys' defaults" : "-",
                          cell(record.sentence));
      continue;
    }
    const std::string form = record.words.empty() ? (record.literal && !record.required ? *record.literal : record.form == "..." ? std::string("1") : record.form)
                                                  : record.words.front().first;
    text += fmt::format("| `{}` | {} | {} | {} |\n", record.name, in_code(form), default_of(record), meaning_of(record));
  }
}

void write_section(std::string& text, const Record& record, const std::string& parent) {
  const std::string path = parent.empty() ? record.name : parent + "." + record.name;
  const bool is_list = record.kind == Record::Kind::sections;
  const std::string heading = !is_list ? fmt::format("[{}]", path) : record.named ? fmt::format("[{}.NAME]", path) : fmt::format("[[{}]]", path);
  text += fmt::format("\n## `{}`\n\n{}{}\n\n", heading, record.sentence,
                      record.required ? " Required." : is_list || record.present ? "" : " Optional.");
  write_rows(text, record.tables.front());
  for (const auto& inner : record.tables.front()) {
    if (inner.kind != Record::Kind::value) write_section(text, inner, path);
  }
}

}  // namespace

std::string write_key_tables(const RecordTable& all) {
  std::string text = "## Top of the file\n\n";
  RecordTable values;
  for (const auto& record : all) {
    if (record.kind == Record::Kind::value) values.push_back(record);
  }
  write_rows(text, values);
  for (const auto& record : all) {
    if (record.kind != Record::Kind::value) write_section(text, record, "");
  }
  return text;
}

}  // namespace arenite::study
