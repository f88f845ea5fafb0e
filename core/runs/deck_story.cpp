#include "runs/deck_story.hpp"

#include "base/counted.hpp"
#include "deck/schema.hpp"
#include "runs/check.hpp"
#include "setup/run_control.hpp"

#include <fmt/format.h>

#include <string_view>

namespace adore::runs {
namespace {

std::string join(const std::string& list, const std::string& more) {
  return list.empty() || more.empty() ? list + more : list + ", " + more;
}

std::string with_unit(const deck::Deck& deck, std::string_view name) {
  const auto found = deck::find_variable(name);
  const deck::UnitPair& unit = found.front().spec().unit;
  return fmt::format("{:g} {}", deck.real(name),
                     deck.units() == deck::UnitSystem::SI ? unit.si : unit.en);
}

std::string bearing_line(const deck::Deck& deck) {
  static constexpr const char* kTypes[] = {"ball", "cylindrical roller", "spherical roller",
                                           "tapered roller", "spherical tapered roller"};
  const auto type = static_cast<std::size_t>(deck.integer("kBrg"));
  std::string line = fmt::format(
      "bearing:    {} bearing with {} of {}", type >= 1 && type <= 5 ? kTypes[type - 1] : "rolling",
      counted(deck.integer("nRe"), "element"), with_unit(deck, "bReDia"));
  // Cones have no pitch diameter in the deck: it follows from their angles (N38).
  if (deck.has("pitchDia")) line += " on a pitch circle of " + with_unit(deck, "pitchDia");
  const long long segments = deck.integer("nCseg");
  return line + (segments == 0   ? ", no cage"
                 : segments == 1 ? ", one cage"
                                 : fmt::format(", a cage of {} segments", segments));
}

std::string operation_line(const deck::Deck& deck) {
  std::string loads, given;
  constexpr std::pair<const char*, std::pair<const char*, const char*>> kAxes[] = {
      {"kFS1", {"appLoadX", "appDispX"}},
      {"kFS2", {"appLoadY", "appDispY"}},
      {"kFS3", {"appLoadZ", "appDispZ"}},
      {"kFS4", {"appMomY", "appMis12"}},
      {"kFS5", {"appMomZ", "appMis22"}}};
  for (const auto& [flag, names] : kAxes) {
    const bool held = deck.integer(flag) == 1;
    const char* name = held ? names.second : names.first;
    if (deck.real(name) == 0.0) continue;
    (held ? given : loads) =
        join(held ? given : loads, fmt::format("{} = {}", name, with_unit(deck, name)));
  }
  std::string line = "operation:  ";
  line += loads.empty() && given.empty() ? "no load" : join(loads, given);
  for (const char* race : {"rpm1", "rpm2"})
    if (deck.real(race) != 0.0)
      line +=
          fmt::format(", {} race {}", race[3] == '1' ? "outer" : "inner", with_unit(deck, race));
  if (deck.real("rpm1") == 0.0 && deck.real("rpm2") == 0.0) line += ", no race rotates";
  return line;
}

std::string run_line(const deck::Deck& deck) {
  if (deck.integer("mode") < 0) {
    std::string line =
        "run:        quasi-static solution only (loads, displacements, stiffness, life)";
    if (deck.integer("kStif") > 0)
      line += "; stiffness at " + counted(deck.integer("kStif"), "speed");
    return line;
  }
  std::string line =
      "run:        motion over time, at most " + counted(deck.integer("maxStps"), "step");
  const long long inner = deck.integer("nStps");
  if (inner > 1) line += fmt::format(" of {} integration steps each", inner);
  line += fmt::format(", to a dimensionless time of {:g}", deck.real("fTime"));
  return line + ", from the quasi-static solution";
}

std::string output_line(const deck::Deck& deck) {
  if (deck.integer("mode") < 0) return "writes:     PRINT.txt, RUN.json";
  std::string line = "writes:     PRINT.txt, FINAL, MASTER, RUN.json, RESULTS.h5, SOL7";
  const long long bodies = deck.integer("kNumPltElem");
  if (bodies > 0) line += ", plots of " + counted(bodies, "body", "bodies") + " (SOL1 on)";
  if (deck.integer("kAGraf") > 0) line += ", the animation SOL8";
  return line;
}

}  // namespace

std::vector<std::string> deck_story(const deck::Deck& deck) {
  std::vector<std::string> lines{bearing_line(deck), operation_line(deck), run_line(deck),
                                 output_line(deck)};
  for (const Issue& issue : check_model(deck)) {
    // Features that only the dynamics lacks; the equilibrium of the same deck is available.
    if (issue.code != "deck.refused") continue;
    lines.push_back(
        fmt::format("problem:    {}; to compute only the quasi-static solution, use --set mode=-1",
                    issue.message));
    break;
  }
  return lines;
}

}  // namespace adore::runs
