#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/parameters.hpp"
#include "recipe/document.hpp"
#include "recipe/reader.hpp"
#include "recipe/record.hpp"

namespace arenite::recipe {

/// A value of a key as it is written, on its way into what the declaration names.
struct Written {
  const Node& node;
  std::string path;
  Reading& reading;
  /// Adds a problem; nothing is what has been read.
  std::nullopt_t refuse(const std::string& message) const { return refuse(node.place, message); }
  std::nullopt_t refuse(const Place& place, const std::string& message) const {
    return reading.add(place, path, message), std::nullopt;
  }
  /// Whether it is what is wanted; a problem says so where it is not.
  bool is(bool what, const std::string& wanted) const {
    if (!what) refuse(std::string("is ") + kind_name(node) + ", but must be " + wanted);
    return what;
  }
  bool is_a(Node::Kind kind, const std::string& wanted) const { return is(node.kind == kind, wanted); }
  Written item(std::size_t i) const { return {node.items[i], path + "." + std::to_string(i), reading}; }
};

/// Knows of every kind of value how it is written and how it is read, both in one place; what is done with the two is
/// up to those that inherit it.
class KeyVisitor : public ParameterVisitor {
 public:
  void number(const Key& key, std::optional<double>& value, std::string_view unit, const Range& range) override;
  void integer(const Key& key, std::optional<std::int64_t>& value, const IntegerRange& range) override;
  void flag(const Key& key, bool& value) override;
  void text(const Key& key, std::string& value) override;
  void file(const Key& key, std::string& value) override;
  void numbers(const Key& key, std::vector<double>& values, std::string_view unit, const Range& range) override;
  void texts(const Key& key, std::vector<std::string>& values) override;
  void wanted(const Key& key, Wanted& values) override;
  void pairs(const Key& key, std::vector<std::pair<std::int32_t, std::int32_t>>& values) override;
  void points(const Key& key, std::vector<Vec2>& values, std::string_view unit) override;
  void points(const Key& key, std::vector<Vec3>& values, std::string_view unit) override;
  void series(const Key& key, std::vector<Vec2>& values, std::string_view unit) override;
  void choice(const Key& key, int& index, const std::vector<Word>& words) override;
  void tagged(const Key& key, int& form, double& value, const std::vector<Form>& forms) override;

 protected:
  void visit_text(const Key& key, std::string& value, bool names_file);
  /// One key that holds a value: `record` says what is there now, and `read` takes over what is written, or adds what
  /// is wrong with it.
  virtual void visit(Record record, const std::function<void(const Written&)>& read) = 0;
};

}  // namespace arenite::recipe
