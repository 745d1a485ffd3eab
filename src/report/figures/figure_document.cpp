#include "report/figures/figure_document.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mapped.hpp"

namespace arenite::report::figures {
namespace {

constexpr std::size_t inline_values = 6;  // fewer take less room in the document than a place in the block

const char* word_for(Line line) {
  return line == Line::solid ? "solid" : line == Line::dashed ? "dashed" : line == Line::dotted ? "dotted" : "";
}

const char* word_for(Choice::Print print) {
  return print == Choice::Print::files ? "files" : print == Choice::Print::first ? "first" : "together";
}

/// Members that say nothing are left out.
class Tree {
 public:
  Tree& text(const char* name, const std::string& value) {
    if (!value.empty()) out[name] = value;
    return *this;
  }
  Tree& flag(const char* name, bool value) {
    if (value) out[name] = true;
    return *this;
  }
  Tree& real(const char* name, double value, double usual) {
    if (std::isfinite(value) && value != usual) out[name] = value;
    return *this;
  }
  Tree& list(const char* name, const std::vector<double>& values, const WriteList& write) {
    if (!values.empty()) out[name] = write(values);
    return *this;
  }
  Numbers out = Numbers::tree();
};

Numbers numbers_of(const Axis& axis) {
  Tree tree;
  tree.text("label", axis.label).text("unit", axis.unit).text("brief", axis.brief).flag("log", axis.logarithmic);
  if (axis.low) tree.out["low"] = *axis.low;
  if (axis.high) tree.out["high"] = *axis.high;
  if (!axis.names.empty()) tree.out["names"] = axis.names;
  return tree.out;
}

Numbers numbers_of(const Series& series, const WriteList& write) {
  Tree tree;
  tree.text("name", series.name).text("colour", series.colour).text("line", word_for(series.line));
  tree.list("x", series.x, write).list("y", series.y, write);
  if (std::ranges::any_of(series.error, [](double e) { return e > 0; })) tree.list("error", series.error, write);
  tree.list("low", series.low, write).list("high", series.high, write).list("members", series.members, write);
  tree.flag("points", series.points)
      .text("mark", series.mark)
      .flag("steps", series.steps)
      .flag("silent", !series.is_read)
      .real("bars", series.bars, 0);
  return tree.real("weight", series.weight, 1).real("opacity", series.opacity, 1).text("each", series.each).out;
}

/// Every k-th point of a line that has more than a drawing is wide, and the last one.
Series thinned(const Series& series) {
  constexpr std::size_t most = 1000;
  const std::size_t n = series.x.size(), stride = (n + most - 1) / most;
  if (series.line == Line::none || stride < 2) return series;
  Series out = series;
  for (auto* values : {&out.x, &out.y, &out.error, &out.low, &out.high, &out.members}) {
    if (values->size() != n) continue;
    std::vector<double> kept;
    for (std::size_t k = 0; k < n; k += stride) kept.push_back((*values)[k]);
    if ((n - 1) % stride != 0) kept.push_back(values->back());
    *values = std::move(kept);
  }
  return out;
}

Numbers numbers_of(const Rose& rose, const WriteList& write) {
  Tree tree;
  tree.text("name", rose.name).text("colour", rose.colour).list("sectors", rose.sectors, write);
  tree.list("inner", rose.inner, write).list("line", rose.line, write).real("axis", rose.axis, NAN);
  tree.out["count"] = rose.count, tree.out["reach"] = rose.reach, tree.out["words"] = rose.words;
  return tree.out;
}

Numbers numbers_of(const Hemispheres& all, const WriteList& write) {
  Tree tree;
  tree.list("inner", all.inner, write).list("outer", all.outer, write).list("from", all.from, write);
  tree.list("to", all.to, write).text("measure", all.measure).out["reach"] = all.reach;
  tree.out["sets"] = mapped(all.sets, [&](const Hemisphere& one) {
    Numbers set{{"name", one.name}, {"count", one.count}, {"values", write(one.values)}, {"words", one.words}};
    if (!one.mark.empty()) set["mark"] = one.mark;
    return set;
  });
  return tree.out;
}

Numbers numbers_of(const Outlines& outlines, const WriteList& write) {
  Tree tree;
  tree.out["series"] = mapped(outlines.series, [&](const Series& series) { return numbers_of(series, write); });
  tree.list("rings", outlines.rings, write).real("reach", outlines.reach, NAN).text("corner", outlines.corner);
  return tree.flag("isotropic", outlines.isotropic).out;
}

Numbers numbers_of(const Cells& cells, const WriteList& write) {
  Tree tree;
  tree.out["x"] = numbers_of(cells.x), tree.out["y"] = numbers_of(cells.y);
  return tree.list("values", cells.values, write).list("error", cells.error, write).out;
}

Numbers numbers_of(const Scatter& scatter) {
  Numbers out{{"across", scatter.across}, {"up", scatter.up}, {"every", scatter.every}};
  out["axes"] = mapped(scatter.axes, [](const GrainAxis& one) {
    Numbers axis = numbers_of(one.axis);
    axis["quantity"] = one.quantity, axis["words"] = one.words, axis["factor"] = one.factor;
    return axis;
  });
  return out;
}

Numbers numbers_of(const KeyEntry& entry) {
  Tree tree;
  tree.text("name", entry.name).text("colour", entry.colour).text("mark", entry.mark);
  if (entry.line != Line::solid) tree.text("line", word_for(entry.line));
  if (entry.counts >= 0) tree.out["counts"] = entry.counts;
  if (!entry.numbers.empty())
    tree.out["numbers"] = mapped(entry.numbers, [](const Said& n) {
      return Numbers::list({n.symbol, n.value, n.error});
    });
  return tree.out;
}

}  // namespace

Numbers numbers_of(const Head& head) {
  Tree tree;
  tree.text("id", head.id)
      .text("name", head.name)
      .text("title", head.title)
      .text("caption", head.caption.whole())
      .text("shown", head.caption.details.empty() ? "" : head.caption.shown)
      .flag("wide", head.wide)
      .flag("nearest", head.nearest);
  if (!head.choices.empty())
    tree.out["choices"] = mapped(head.choices, [](const Choice& choice) {
      return Tree()
          .text("key", choice.key)
          .text("label", choice.label)
          .text("print", word_for(choice.print))
          .flag("silent", !choice.has_buttons)
          .out;
    });
  for (std::size_t k = 0; k < head.choices.size(); ++k)
    tree.out["choices"][k]["options"] = mapped(head.choices[k].options, [](const Option& option) {
      return Numbers::list({option.value, option.words, option.file});
    });
  return tree.out;
}

Numbers numbers_of(const Panel& panel, const WriteList& write) {
  Tree tree;
  tree.out["x"] = numbers_of(panel.x);
  tree.out["y"] = numbers_of(panel.y);
  tree.out["series"] = mapped(panel.series, [&](const Series& series) { return numbers_of(series, write); });
  if (!panel.references.empty())
    tree.out["references"] = mapped(panel.references, [](const Reference& r) {
      return Tree()
          .text("colour", r.colour)
          .text("line", word_for(r.line))
          .real("x", r.x.value_or(NAN), NAN)
          .real("y", r.y.value_or(NAN), NAN)
          .real("slope", r.slope.value_or(NAN), NAN)
          .text("label", r.label)
          .out;
    });
  if (!panel.corner.empty()) tree.out["corner"] = panel.corner;
  if (!panel.now.x.empty()) tree.out["now"] = Tree().list("x", panel.now.x, write).list("y", panel.now.y, write).out;
  return tree.text("selected", panel.selected)
      .text("click", panel.click)
      .flag("lying", panel.lying)
      .flag("near", panel.near)
      .flag("square", panel.square)
      .out;
}

Numbers numbers_of(const Drawing& drawing, const WriteList& write) {
  Numbers out = Numbers::tree();
  if (!drawing.chosen.empty()) {
    out["for"] = Numbers::tree();
    for (const auto& [key, value] : drawing.chosen) out["for"][key] = value;
  }
  if (!drawing.panels.empty())
    out["panels"] = mapped(drawing.panels, [&](const Panel& panel) { return numbers_of(panel, write); });
  if (!drawing.roses.empty())
    out["roses"] = mapped(drawing.roses, [&](const Rose& rose) { return numbers_of(rose, write); });
  if (drawing.hemispheres) out["hemispheres"] = numbers_of(*drawing.hemispheres, write);
  if (drawing.outlines) out["outlines"] = numbers_of(*drawing.outlines, write);
  if (drawing.cells) out["cells"] = numbers_of(*drawing.cells, write);
  if (drawing.scatter) out["scatter"] = numbers_of(*drawing.scatter);
  if (!drawing.key.empty()) out["key"] = mapped(drawing.key, [](const KeyEntry& entry) { return numbers_of(entry); });
  if (!drawing.note.empty()) out["note"] = drawing.note;
  return out;
}

Drawing thinned(Drawing drawing) {
  for (Panel& panel : drawing.panels)
    for (Series& series : panel.series) series = thinned(series);
  return drawing;
}

Numbers PageLists::operator()(const std::vector<double>& values) {
  if (values.size() < inline_values) return whole_list(values);
  const std::vector<float> narrow(values.begin(), values.end());
  const auto [at, is_new] =
      known_.try_emplace(std::string(reinterpret_cast<const char*>(narrow.data()), narrow.size() * sizeof(float)));
  if (is_new) at->second = block_.add_reals(values);
  return at->second;
}

Numbers whole_list(const std::vector<double>& values) { return values; }

}  // namespace arenite::report::figures
