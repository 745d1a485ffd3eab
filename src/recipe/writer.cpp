#include "recipe/document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/mapped.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace arenite::recipe {

std::string toml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      result += std::string("\\") + c;
    } else if (static_cast<unsigned char>(c) < ' ' || c == 127) {
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    } else {
      result += c;
    }
  }
  return result + "\"";
}

namespace {

std::string number_literal(double value, std::string_view unit) {
  return unit.empty() ? format_quantity(value, unit) : toml_text(format_quantity(value, unit));
}

std::string number_form(std::string_view unit) { return unit.empty() ? "..." : fmt::format("\"... {}\"", unit); }

template <class Items, class Literal> std::string list_literal(const Items& items, Literal literal) {
  return fmt::format("[{}]", fmt::join(mapped(items, literal), ", "));
}

class Recorder : public ParameterVisitor {
 public:
  Recorder(RecordTable& table, bool every_key) : table_(table), every_key_(every_key) {}

  using ParameterVisitor::choice;
  using ParameterVisitor::integer;
  using ParameterVisitor::number;
  using ParameterVisitor::section;

  void number(const Key& key, std::optional<double>& value, std::string_view unit, const Range& range) override {
    Record& record = add(key, number_form(unit));
    record.allowed = to_string(range, unit);
    if (value) record.literal = number_literal(*value, unit);
  }
  void integer(const Key& key, std::optional<std::int64_t>& value, const IntegerRange& range) override {
    Record& record = add(key, "...");
    record.allowed = to_string(range);
    if (value) record.literal = std::to_string(*value);
  }
  void flag(const Key& key, bool& value) override { add(key, "...").literal = value ? "true" : "false"; }
  void text(const Key& key, std::string& value) override {
    Record& record = add(key, "\"...\"");
    if (!value.empty() || key.required) record.literal = toml_text(value);
  }
  void file(const Key& key, std::string& value) override { text(key, value); }
  void numbers(const Key& key, std::vector<double>& values, std::string_view unit, const Range& range) override {
    Record& record = add(key, fmt::format("[{}]", number_form(unit)));
    if (const std::string each = to_string(range, unit); !each.empty()) record.allowed = "each " + each;
    if (!values.empty()) record.literal = list_literal(values, [&](double value) { return number_literal(value, unit); });
  }
  void pairs(const Key& key, std::vector<std::pair<std::int32_t, std::int32_t>>& values) override {
    Record& record = add(key, "[[0, 1], ...]");
    if (!values.empty()) record.literal = list_literal(values, [](const auto& pair) { return fmt::format("[{}, {}]", pair.first, pair.second); });
  }
  void points(const Key& key, std::vector<Vec2>& values, std::string_view unit) override { add_pairs(key, values, unit, unit); }
  void series(const Key& key, std::vector<Vec2>& values, std::string_view unit) override { add_pairs(key, values, "s", unit); }
  void choice(const Key& key, int& index, const std::vector<Word>& words) override {
    Record& record = add(key, "\"...\"");
    for (const auto& word : words) record.words.emplace_back(toml_text(word.word), word.sentence);
    record.literal = record.words[static_cast<std::size_t>(index)].first;
  }
  void tagged(const Key& key, int& form, double& value, const std::vector<Form>& forms) override {
    Record& record = add(key, "...");
    for (const auto& each : forms) {
      record.words.emplace_back(each.unit.empty() ? toml_text(each.word) : fmt::format("{{ {} = {} }}", each.word, number_form(each.unit)), each.sentence);
    }
    const Form& chosen = forms[static_cast<std::size_t>(form)];
    record.literal = chosen.unit.empty() ? toml_text(chosen.word) : fmt::format("{{ {} = {} }}", chosen.word, number_literal(value, chosen.unit));
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
  Record& add(const Key& key, std::string form) {
    Record record;
    record.name = key.name;
    record.sentence = key.sentence;
    record.required = key.required;
    record.condition = condition_;
    record.form = std::move(form);
    table_.push_back(std::move(record));
    return table_.back();
  }

  void add_pairs(const Key& key, const std::vector<Vec2>& values, std::string_view unit_x, std::string_view unit_y) {
    Record& record = add(key, fmt::format("[[{}, {}], ...]", number_form(unit_x), number_form(unit_y)));
    const auto literal = [&](Vec2 pair) { return fmt::format("[{}, {}]", number_literal(pair.x, unit_x), number_literal(pair.y, unit_y)); };
    if (!values.empty()) record.literal = list_literal(values, literal);
  }

  RecordTable& table_;
  bool every_key_;
  std::string condition_;
};

std::string real_literal(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  std::string text = format_quantity(value, "");
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

}  // namespace

RecordTable record_of(const Visit& declare, bool every_key) {
  RecordTable table;
  Recorder recorder(table, every_key);
  declare(recorder);
  return table;
}

std::string toml_key(const std::string& name) { return is_plain_name(name) ? name : toml_text(name); }

std::string toml_literal(const Node& value) {
  switch (value.kind) {
    case Node::Kind::flag: return value.flag ? "true" : "false";
    case Node::Kind::integer: return std::to_string(value.integer);
    case Node::Kind::real: return real_literal(value.real);
    case Node::Kind::text: return toml_text(value.text);
    case Node::Kind::date: return "\"\"";
    case Node::Kind::array: return list_literal(value.items, toml_literal);
    case Node::Kind::table: {
      const auto literal = [](const Entry& entry) { return fmt::format("{} = {}", toml_key(entry.key), toml_literal(entry.value)); };
      return fmt::format("{{ {} }}", fmt::join(mapped(value.entries, literal), ", "));
    }
  }
  return {};
}

}  // namespace arenite::recipe
