#pragma once
#include <initializer_list>
#include <string>
#include <string_view>

#include "grains/texture/texture.hpp"
#include "model/result.hpp"

/// Results as lines for people.
namespace arenite::report {

/// A number of a result as people read it, "0.842 +- 0.003"; empty where it is not known.
std::string shown(const Numbers& number);

/// Lines "name  value" under headings, the values in one column; or, explained, with what each means in a third. What has no value is left out.
class TextLines {
 public:
  enum class Layout { plain, explained };
  explicit TextLines(Layout layout = Layout::plain) : layout_(layout) {}
  /// With the numbers that `number` looks at, which must outlive the lines.
  explicit TextLines(const Numbers& root, Layout layout = Layout::plain) : layout_(layout), root_(&root) {}

  void heading(const std::string& text) { text_ += "\n" + text + "\n"; }
  void add(const std::string& name, const std::string& value, const std::string& meaning = "");
  /// The number at a path such as "/phases/particle", if it is there.
  void number(const std::string& name, const std::string& path, const char* unit = "", const char* meaning = "");
  struct Row {
    const char *name, *path, *unit = "", *meaning = "";
  };
  void numbers(std::initializer_list<Row> rows);
  void section(const std::string& text, std::initializer_list<Row> rows);
  void raw(const std::string& line) { text_ += line + "\n"; }
  /// Lines that are laid out already, shifted as the others are.
  void block(std::string_view lines);
  bool has(const std::string& path) const { return root_->at_path(path) != nullptr; }
  std::string text() && { return std::move(text_); }

 private:
  Layout layout_;
  const Numbers* root_ = nullptr;
  std::string text_;
};

// What `arenite show` prints unless it is asked for everything: a dozen numbers, each with its symbol and its meaning.

/// The last state of a stage.
std::string headlines(const StageResult& last, const texture::Texture& texture);
/// What flows under its weight, from the numbers of its stage: rate of discharge, free surface. Empty where nothing does.
std::string flow_text(const Numbers& numbers);
/// A result on nodes, from its numbers (FieldResult::numbers).
std::string field_headlines(const Numbers& numbers);

/// Every number on a line: its name in files and tables, its value with error and unit, and what it is.
std::string described(const Numbers& numbers);

/// All numbers of a result on nodes.
std::string field_text(const Numbers& numbers);

}  // namespace arenite::report
