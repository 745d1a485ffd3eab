#include "report/page.hpp"

#include <deque>
#include <stdexcept>
#include <variant>
#include <vector>

#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "report/page_document.hpp"
#include "report/page_template.hpp"
#include "workflow/run.hpp"
#include "workflow/run_film.hpp"

namespace arenite::report {
namespace {

/// With the texture of its states: of all of them in a small sample, of the last alone in a large one. `last`, if it is given, is that of the last.
void add_stage(PageData& data, const StageResult& stage, const texture::Options& options, const std::optional<texture::Texture>& last = {}) {
  constexpr std::size_t small = 10'000;
  for (std::size_t f = 0; f < stage.frames.size(); ++f) {
    const Packing& packing = stage.frames[f].packing;
    const bool is_last = f + 1 == stage.frames.size();
    if (is_last || packing.grains.size() <= small)
      data.textures.push_back({data.stages.size(), f, is_last && last ? *last : texture::measure(packing, options)});
  }
  data.stages.push_back(&stage);
}

/// Those that the stored statistics of stress were measured with.
stress::StressOptions statistics_of(const FieldResult& field) {
  stress::StressOptions options;
  const Numbers* said = field.numbers.at_path("/stress/options");
  if (!said) return options;
  options.clamp_rows = said->value("clamp_rows", options.clamp_rows);
  options.leave_out_surface = said->value("leave_out_surface", options.leave_out_surface);
  options.leave_out_unloaded = said->value("leave_out_unloaded", options.leave_out_unloaded);
  options.mean_over_area = said->value("sample_mean_over", std::string()) == "area";
  options.blocks = said->value("blocks", options.blocks);
  return options;
}

}  // namespace

void replace_once(std::string& text, std::string_view mark, const std::string& with) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) throw std::logic_error("the page's template lacks " + std::string(mark));
  text.replace(at, mark.size(), with);
}

std::string html_text(std::string_view plain) {
  std::string text;
  for (const char c : plain) {
    if (c == '<') text += "&lt;";
    else if (c == '&') text += "&amp;";
    else text += c;
  }
  return text;
}

std::string page(const PageData& data) {
  const PageDocument document = page_document(data);
  std::string text(page_template());
  replace_once(text, "__TITLE__", html_text(data.title));
  replace_once(text, "__DOCUMENT__", packed_text({reinterpret_cast<const std::uint8_t*>(document.json.data()), document.json.size()}));
  replace_once(text, "__NUMBERS__", document.numbers);
  return text;
}

void write_page(const std::filesystem::path& path, const ResultParts& result) {
  PageData data;
  data.title = result.title;
  std::deque<StageResult> measured;  // stays in place while the page points at it
  for (const FilmResult& film : result.films) {
    data.films.push_back({&film});
    if (film.packing.grains.size() == 0) continue;
    texture::Options options;
    options.grain_sigma_hyd = film.peak_to_peak.sigma_hyd;
    add_stage(data, measured.emplace_back(workflow::measured_stage(film)), options);
  }
  for (std::size_t s = 0; s < result.stages.size(); ++s)
    add_stage(data, result.stages[s], workflow::texture_options(result.stages[s].provenance), s < result.measured.size() ? result.measured[s] : std::nullopt);
  for (const FieldResult& field : result.fields) data.fields.push_back({&field, statistics_of(field)});
  write_page(path, data);
}

void write_page(const std::filesystem::path& path, const std::vector<std::filesystem::path>& files, const std::string& title) {
  std::vector<StageResult> stages;
  std::vector<FieldResult> fields;
  std::vector<FilmResult> films;
  for (const auto& file : files) {
    auto any = io::read_result(file);
    if (auto* stage = std::get_if<StageResult>(&any)) stages.push_back(std::move(*stage));
    else if (auto* field = std::get_if<FieldResult>(&any)) fields.push_back(std::move(*field));
    else films.push_back(std::move(std::get<FilmResult>(any)));
  }
  write_page(path, {.title = title, .stages = stages, .fields = fields, .films = films});
}

void write_page(const std::filesystem::path& path, const PageData& data) { io::write_atomically(path, page(data)); }

}  // namespace arenite::report
