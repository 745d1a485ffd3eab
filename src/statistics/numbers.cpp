#include "statistics/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text.hpp"

namespace arenite {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Numbers& numbers) {
  switch (numbers.kind()) {
    case Numbers::Kind::unknown: return nullptr;
    case Numbers::Kind::truth: return numbers.get<bool>();
    case Numbers::Kind::integer: return numbers.get<std::int64_t>();
    case Numbers::Kind::natural: return numbers.get<std::uint64_t>();
    case Numbers::Kind::real: return numbers.get<double>();
    case Numbers::Kind::text: return numbers.get<std::string>();
    case Numbers::Kind::list: break;
    case Numbers::Kind::tree: {
      Json out = Json::object();
      for (const auto& [name, value] : numbers.items()) out[name] = json_of(value);
      if (numbers.meaning() && numbers.meaning()->period > 0 && numbers.contains("value"))
        out["period"] = numbers.meaning()->period;
      return out;
    }
  }
  Json out = Json::array();
  for (const Numbers& item : numbers) out.push_back(json_of(item));
  return out;
}

void add_named(std::vector<NamedNumber>& all, const std::string& name, const Numbers& node, const Meaning* of_group) {
  const Meaning* meaning = node.meaning() ? node.meaning() : of_group;
  if (node.is_number() || node.is_truth() || (node.is_tree() && node.contains("value")))
    all.push_back({name, &node, meaning});
  else if (node.is_tree())
    for (const auto& [own, item] : node.items()) add_named(all, name.empty() ? own : name + "." + own, item, meaning);
}

template <class Node> auto beside(const std::vector<std::string>& names, auto& nodes) {
  std::vector<std::pair<const std::string&, Node&>> out;
  for (std::size_t i = 0; i < names.size(); ++i) out.emplace_back(names[i], nodes[i]);
  return out;
}

Numbers matrix(const Tensor2& t) { return {{t.xx, t.xy}, {t.yx, t.yy}}; }

bool is_pair(const Numbers& n) { return n.is_list() && n.size() == 2 && n.front().is_text(); }

}  // namespace

Numbers::Numbers(std::initializer_list<Numbers> of) : kind_(Kind::list) {
  if (std::all_of(of.begin(), of.end(), is_pair)) *this = tree(of);
  else items_ = of;
}

Numbers::Numbers(const Tensor2& t) {
  if (std::isfinite(t.xx)) *this = matrix(t);
}

Numbers::Numbers(const statistics::Estimate& e) {
  if (std::isfinite(e.value)) *this = Numbers{{"value", e.value}, {"error", e.error}};
}

Numbers::Numbers(const statistics::TensorEstimate& t) {
  if (std::isfinite(t.value.xx))
    *this = Numbers{{"value", matrix(t.value)}, {"error", std::isfinite(t.error.xx) ? matrix(t.error) : Numbers()}};
}

Numbers::Numbers(const statistics::Curve& c) : Numbers{{"x", c.x}, {"y", c.y}, {"error", c.error}} {}

Numbers::Numbers(const statistics::ByName<statistics::Estimate>& values) {
  for (const auto& [name, value] : values)
    if (Numbers known = value; known.is_known()) (*this)[name] = std::move(known);
}

Numbers Numbers::tree(std::initializer_list<Numbers> pairs) {
  Numbers out;
  out.kind_ = Kind::tree;
  for (const Numbers& pair : pairs) out[pair.front().text_] = pair.back();
  return out;
}

Numbers Numbers::list(std::initializer_list<Numbers> of) {
  Numbers out;
  out.kind_ = Kind::list;
  out.items_ = of;
  return out;
}

Numbers Numbers::real_of(double value) {
  Numbers out;
  if (!std::isfinite(value)) return out;
  out.kind_ = Kind::real;
  out.real_ = value;
  return out;
}

std::size_t Numbers::size() const {
  if (kind_ == Kind::unknown) return 0;
  return is_list() || is_tree() ? items_.size() : 1;
}

std::vector<std::pair<const std::string&, const Numbers&>> Numbers::items() const {
  return beside<const Numbers>(names_, items_);
}
std::vector<std::pair<const std::string&, Numbers&>> Numbers::items() { return beside<Numbers>(names_, items_); }

Numbers::Items::const_iterator Numbers::find(std::string_view name) const {
  const auto at = std::find(names_.begin(), names_.end(), name);
  return at == names_.end() ? items_.end() : items_.begin() + (at - names_.begin());
}

const Numbers& Numbers::at(std::string_view name) const {
  const auto found = find(name);
  if (found == end()) throw NumbersError("there is no \"" + std::string(name) + "\"");
  return *found;
}

const Numbers& Numbers::at(std::size_t i) const {
  if (i >= items_.size()) throw NumbersError("there is no item " + std::to_string(i));
  return items_[i];
}

Numbers& Numbers::operator[](std::string_view name) {
  if (kind_ == Kind::unknown) kind_ = Kind::tree;
  if (!is_tree()) throw NumbersError("this node has no named members, so no \"" + std::string(name) + "\"");
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) return items_[static_cast<std::size_t>(found - names_.begin())];
  names_.emplace_back(name);
  return items_.emplace_back();
}

const Numbers* Numbers::at_path(std::string_view path) const {
  const Numbers* node = this;
  while (!path.empty()) {
    path.remove_prefix(1);
    const std::string_view step = path.substr(0, path.find('/'));
    path.remove_prefix(step.size());
    if (node->is_list()) {
      const auto i = parse_number<std::size_t>(step);
      if (!i || *i >= node->items_.size()) return nullptr;
      node = &node->items_[*i];
      continue;
    }
    const auto found = node->find(step);
    if (found == node->end()) return nullptr;
    node = &*found;
  }
  return node;
}

void Numbers::push_back(Numbers value) {
  if (kind_ == Kind::unknown) kind_ = Kind::list;
  if (!is_list()) throw NumbersError("cannot append to something that is not a list");
  items_.push_back(std::move(value));
}

void Numbers::erase(std::string_view name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) return;
  items_.erase(items_.begin() + (found - names_.begin()));
  names_.erase(found);
}

void Numbers::update(const Numbers& other) {
  for (const auto& [name, value] : other.items()) (*this)[name] = value;
}

const Numbers& Numbers::expect(bool holds, const char* what) const {
  if (!holds) throw NumbersError(std::string("a value is ") + what);
  return *this;
}

bool operator==(const Numbers& a, const Numbers& b) {
  if (a.is_number() && b.is_number())
    return a.is_real() || b.is_real() ? a.get<double>() == b.get<double>() : a.integer_ == b.integer_;
  return a.kind_ == b.kind_ && a.integer_ == b.integer_ && a.text_ == b.text_ && a.names_ == b.names_ &&
         a.items_ == b.items_;
}

std::vector<NamedNumber> named_numbers(const Numbers& tree) {
  std::vector<NamedNumber> all;
  add_named(all, "", tree, nullptr);
  return all;
}

void erase_if(Numbers& tree, const std::function<bool(std::string_view, const Numbers&)>& which) {
  std::vector<std::string> names;
  for (const auto& [name, node] : tree.items())
    if (which(name, node)) names.push_back(name);
    else erase_if(node, which);
  for (const std::string& name : names) tree.erase(name);
}

void erase(Numbers& tree, Trait trait) {
  erase_if(tree, [trait](std::string_view, const Numbers& node) { return node.has(trait); });
}

std::string to_json(const Numbers& numbers, int indent) {
  return json_of(numbers).dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace arenite

namespace arenite::statistics {

Numbers described(Numbers value, const char* unit, const char* sentence) {
  value.means({.unit = unit, .sentence = sentence});
  return value;
}

void put(Numbers& to, const std::string& name, Numbers value, const char* unit, const char* sentence, Trait traits) {
  if (value.is_known()) to[name] = described(std::move(value), unit, sentence).mark(traits);
}

void put_angle(Numbers& to, const std::string& name, Numbers value, double period, const char* sentence, Trait traits) {
  if (!value.is_known()) return;
  value.means({.unit = "deg", .sentence = sentence, .period = period});
  to[name] = std::move(value.mark(traits));
}

}  // namespace arenite::statistics
