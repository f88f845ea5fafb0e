#include "assembly/new_assembly.hpp"

#include "assembly/assembly_file.hpp"
#include "base/errors.hpp"
#include "base/write_folder.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "runs/deck_request.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace adore::assembly {

namespace fs = std::filesystem;

namespace {

constexpr std::array<const char*, 5> kLoadVariables{"appLoadX", "appLoadY", "appLoadZ", "appMomY",
                                                    "appMomZ"};

void reject_loads(const std::vector<std::pair<std::string, std::string>>& sets) {
  for (const auto& [name, value] : sets)
    if (std::find(kLoadVariables.begin(), kLoadVariables.end(), name) != kLoadVariables.end())
      throw InputError(
          fmt::format("{} = {:.40}: loads belong to the set, not to its rows. Enter them as "
                      "\"load\" in ASSEMBLY.json",
                      name, value));
}

}  // namespace

std::string make_row_deck(const std::string& text,
                          const std::vector<std::pair<std::string, std::string>>& sets) {
  runs::DeckRequest request;
  request.text = text;
  request.deck = "deck of a row";
  request.in_memory = true;
  reject_loads(sets);
  request.sets = sets;
  const deck::Deck given = runs::load_deck(request).deck;
  if (given.integer("mode") >= 0) request.sets.emplace_back("mode", "-1");
  if (given.integer("kStif") > 0) request.sets.emplace_back("kStif", "0");
  for (const char* load : kLoadVariables)
    if (given.has(load) && given.si(load) != 0.0) request.sets.emplace_back(load, "0");
  return request.sets.empty() ? text : deck::with_deck(text, runs::load_deck(request).deck).text;
}

Assembly assembly_from_arrangement(const std::string& arrangement) {
  const std::vector<int> signs = orientations(arrangement);
  if (signs.empty()) {
    std::vector<std::string> names = arrangement_names();
    std::erase(names, "custom");
    throw InputError(fmt::format("arrangement \"{:.40}\": unknown; enter one of {}", arrangement,
                                 fmt::join(names, ", ")));
  }
  Assembly out;
  out.name = arrangement + " set";
  out.arrangement = arrangement;
  for (std::size_t k = 0; k < signs.size(); ++k) {
    RowPlacement row;
    row.deck = fmt::format("row-{}", k + 1);
    row.orientation = signs[k];
    out.rows.push_back(std::move(row));
  }
  return out;
}

std::vector<fs::path> write_assembly(const fs::path& folder, const Assembly& assembly,
                                     const std::vector<RowDeckText>& rows) {
  demand(rows.size() == assembly.rows.size(), "one deck for each row");
  std::vector<std::pair<fs::path, std::string>> files{{kFileName, assembly_text(assembly)}};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const fs::path row = fmt::format("row-{}", k + 1);
    files.emplace_back(row / "DATA.txt", rows[k].deck);
    if (!rows[k].extension.empty()) files.emplace_back(row / "ADORE.json", rows[k].extension);
  }
  std::error_code error;
  for (const auto& [name, text] : files)
    if (fs::exists(fs::symlink_status(folder / name, error)))
      throw InputError(
          fmt::format("{} exists already; give another folder with --out, or remove "
                      "this file first",
                      (folder / name).string()));
  (void)make_folders(folder);
  const WriteFolder open(folder);
  std::vector<fs::path> out;
  for (const auto& [name, text] : files) {
    const WriteFolder place = name.has_parent_path() ? open.folder(name.parent_path()) : open;
    write_file_atomically(WritePath(place, name.filename().string()), text);
    out.push_back(folder / name);
  }
  return out;
}

}  // namespace adore::assembly
