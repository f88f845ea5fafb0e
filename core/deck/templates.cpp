#include "deck/templates.hpp"

#include "base/errors.hpp"
#include "base/resources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace adore::deck {
namespace {

constexpr std::array<TemplateInfo, 15> kTemplates = {{
    {"ball",
     "7208-size angular contact ball bearing, thrust and radial load, 10000 rpm, guided cage"},
    {"cylindrical",
     "NU208-size cylindrical roller bearing, radial load, flanges on the outer race"},
    {"spherical", "22208-size spherical roller bearing, one radially loaded row"},
    {"tapered", "30208-size tapered roller bearing, thrust and radial load"},
    {"spherical-tapered", "tapered roller bearing with barrel-shaped rollers"},
    {"ball-thrust", "bearing of the example `ball` under pure thrust, cage without guide lands"},
    {"ball-english", "bearing of the example `ball` in English units"},
    {"ball-18", "7014-size angular contact bearing with 18 balls and two-slope traction"},
    {"four-point-qj208",
     "QJ 208-size four-point contact bearing: arched grooves, thrust and radial load, 6000 rpm"},
    {"lox-turbopump",
     "hybrid bearing (bore 57 mm) of a turbopump in liquid oxygen, 30000 rpm, solid lubrication"},
    {"angular-218",
     "quasi-static: angular contact bearing 218 of textbooks, stiffness versus speed"},
    {"deep-groove-6205",
     "quasi-static: 6205-size deep groove bearing with a shaft fit, radial load"},
    {"cylindrical-nu209", "quasi-static: NU 209 cylindrical roller bearing, crowned rollers"},
    {"tapered-30208", "quasi-static: 30208-size tapered roller bearing with rib"},
    {"spherical-22210", "quasi-static: one row of a 22210-size spherical roller bearing"},
}};

}  // namespace

std::span<const TemplateInfo> templates() { return kTemplates; }

std::string_view template_text(std::string_view name) {
  const bool known = std::any_of(kTemplates.begin(), kTemplates.end(),
                                 [&](const TemplateInfo& info) { return info.name == name; });
  if (known) return resources::get(fmt::format("decks/{}.txt", name));
  std::string list;
  for (const TemplateInfo& info : kTemplates)
    list += (list.empty() ? "" : ", ") + std::string(info.name);
  throw InputError(
      fmt::format("there is no example deck named '{}'; choose one of {}", name, list));
}

Deck new_deck(std::string_view name) {
  ReadResult result = read_deck_text(template_text(name), fmt::format("{}.txt", name));
  demand(result.issues.empty(),
         "example deck " + std::string(name) + ": " + to_text(result.issues));
  result.deck.file.clear();
  for (RecordData& record : result.deck.records) record.line = 0;
  return std::move(result.deck);
}

}  // namespace adore::deck
