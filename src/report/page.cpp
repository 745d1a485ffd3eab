#include "report/page.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include "io/disk/file.hpp"
#include "io/results/results.hpp"
#include "report/page_document.hpp"
#include "report/page_template.hpp"

namespace arenite::report {

std::string filled(std::string_view page, const std::vector<Filling>& fillings) {
  std::string text;
  for (const auto& [mark, filling] : fillings) {
    const std::size_t at = page.find(mark);
    if (at == page.npos) throw std::logic_error("the page's template lacks " + std::string(mark));
    text.append(page.substr(0, at)).append(filling);
    page.remove_prefix(at + mark.size());
  }
  return text.append(page);
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

std::string title_of(const PageData& data) {
  const auto made_by = [](const Provenance& p, const char* file, const std::string& before) {
    const auto from = std::ranges::find(p.options, file, &std::pair<std::string, std::string>::first);
    return !p.title.empty() || from == p.options.end() ? p.title : before + from->second;
  };
  if (!data.films.empty()) return made_by(data.films.front().provenance, "film", "");
  if (!data.stages.empty()) return data.stages.front().provenance.title;
  if (!data.spheres.empty()) return data.spheres.front().provenance.title;
  if (!data.fields.empty()) return made_by(data.fields.front().provenance, "map", data.fields.front().name + " of ");
  if (!data.voxels.empty()) return made_by(data.voxels.front().provenance, "map", data.voxels.front().name + " of ");
  return {};
}

std::string page(const PageData& given) {
  PageData data = given;
  if (data.title.empty()) data.title = title_of(data);
  const PageDocument document = page_document(data);
  const auto* json = reinterpret_cast<const std::uint8_t*>(document.json.data());
  return filled(page_template(), {{"__TITLE__", html_text(data.title)},
                                  {"__DOCUMENT__", packed_text({json, document.json.size()})},
                                  {"__NUMBERS__", document.numbers}});
}

void write_page(const std::filesystem::path& path, const PageData& data) { io::write_atomically(path, page(data)); }

void write_page(const std::filesystem::path& path, const std::vector<std::filesystem::path>& files,
                const std::string& title) {
  std::vector<StageResult> stages;
  std::vector<FieldResult> fields;
  std::vector<FilmResult> films;
  std::vector<VoxelResult> voxels;
  std::vector<SphereResult> spheres;
  for (const auto& file : files) {
    auto any = io::read_result(file);
    if (auto* stage = std::get_if<StageResult>(&any)) stages.push_back(std::move(*stage));
    else if (auto* field = std::get_if<FieldResult>(&any)) fields.push_back(std::move(*field));
    else if (auto* sample = std::get_if<VoxelResult>(&any)) voxels.push_back(std::move(*sample));
    else if (auto* stage_in_space = std::get_if<SphereResult>(&any)) spheres.push_back(std::move(*stage_in_space));
    else films.push_back(std::move(std::get<FilmResult>(any)));
  }
  write_page(
      path, {.title = title, .stages = stages, .fields = fields, .films = films, .voxels = voxels, .spheres = spheres});
}

}  // namespace arenite::report
