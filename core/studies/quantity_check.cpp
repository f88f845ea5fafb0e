#include "studies/quantity_check.hpp"

#include "results/key_results.hpp"
#include "runs/unused_request.hpp"
#include "studies/cage_whirl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace adore::studies {
namespace {

bool starts_with_one_of(std::string_view name, std::initializer_list<std::string_view> stems) {
  return std::any_of(stems.begin(), stems.end(),
                     [&](std::string_view stem) { return name.starts_with(stem); });
}

std::string no_cage(const deck::Deck& deck) {
  return deck.integer("nCseg") > 0 ? "" : "the bearing has no cage (nCseg = 0)";
}

std::string no_motion(const deck::Deck& deck, std::string_view lacks) {
  const long long mode = deck.integer("mode");
  return mode >= 0 ? "" : fmt::format("a quasi-static run (mode = {}) {}", mode, lacks);
}

std::string no_steps(const deck::Deck& deck, const std::string& until) {
  const std::string why = until.empty() ? runs::why_no_step(deck) : "";
  return why.empty() ? "" : fmt::format("the run makes no step ({})", why);
}

/// The first reason that there is.
std::string first(std::initializer_list<std::string> reasons) {
  for (const std::string& reason : reasons)
    if (!reason.empty()) return reason;
  return {};
}

/// Of a channel of RESULTS.h5.
std::string of_channel(std::string_view id, const deck::Deck& deck) {
  std::string not_there;
  if (starts_with_one_of(id, {"cage.", "pocket.", "land."})) not_there = no_cage(deck);
  if (id.starts_with("land.") && not_there.empty() && deck.integer("nGL") == 0)
    not_there = "the cage has no guide land (nGL = 0)";
  if (id.starts_with("flange.") && deck.integer("kBrg") == 1)
    not_there = "a ball bearing has no roller flanges";
  const auto split = [&deck](const char* shim) { return deck.has(shim) && deck.si(shim) > 0.0; };
  if (id.starts_with("second_contact.") && !split("shimThickness1") && !split("shimThickness2"))
    not_there = "no race is split (shimThickness1 and shimThickness2 are 0)";
  if (id.starts_with("neighbour.") && deck.integer("nCseg") > 0)
    not_there = "the cage separates the elements";
  if (id.starts_with("thermal.") && deck.integer("kTherm") == 0)
    not_there = "there is no thermal analysis (kTherm = 0)";
  return first({no_motion(deck, "stores no channels"), not_there});
}

/// Of a key result or a figure of whirl.
std::string of_result(const std::string& id, const deck::Deck& deck, const std::string& until) {
  const bool figure =
      std::find(kWhirlFigures.begin(), kWhirlFigures.end(), id) != kWhirlFigures.end();
  if (figure)
    return first({no_motion(deck, "stores no cage motion"), no_cage(deck),
                  deck.integer("nCseg") > 1 ? "whirl results need a one-piece cage" : ""});
  if (starts_with_one_of(id, {"life_", "largest_contact_load_N"}) || id.ends_with("_nominal_Hz"))
    return {};
  if (id.starts_with("variable_compliance_")) return "only `adore find` computes this result";
  const bool balls = deck.integer("kBrg") == 1;
  if (id == "gyroscopic_ratio" && !balls)
    return "the gyroscopic friction ratio is computed only for ball bearings";
  const bool oil_by_grade = deck.has("oilGrade") || deck.has("oilVisc1");
  if (id == "viscosity_ratio" && oil_by_grade) return {};
  if (id == "viscosity_ratio" && deck.integer("kTrac") <= 0)
    return "the deck has no lubricant (kTrac = 0) and no oil specified by grade (record X2 in "
           "ADORE.json)";
  if (starts_with_one_of(id, {"bpfo_", "bpfi_", "ftf_"}) && deck.integer("mode") < 0) return {};
  const bool of_start = starts_with_one_of(id, {"displacement_",
                                                "load_x",
                                                "load_y",
                                                "load_z",
                                                "load_about_",
                                                "largest_pressure_",
                                                "stiffness_",
                                                "friction_",
                                                "least_element_load_",
                                                "largest_approach_",
                                                "gyroscopic_ratio",
                                                "bsf_",
                                                "viscosity_ratio",
                                                "outer_race_temperature",
                                                "inner_race_temperature",
                                                "element_temperature",
                                                "coolant_exit_",
                                                "operating_",
                                                "outer_fit_",
                                                "inner_fit_"});
  if (of_start)
    return deck.integer("mode") < 0
               ? ""
               : fmt::format(
                     "only a quasi-static run (mode below 0) has this result, but mode is {}",
                     deck.integer("mode"));
  const bool of_cage = starts_with_one_of(id, {"mean_cage_", "mean_whirl_", "mean_swept_whirl_"});
  const bool of_steps = starts_with_one_of(
      id, {"mean_", "load_departure", "energy_residual", "bpfo_", "bpfi_", "ftf_"});
  return first({no_motion(deck, "has no motion"), of_cage ? no_cage(deck) : "",
                of_steps ? no_steps(deck, until) : ""});
}

}  // namespace

std::string missing_quantity_reason(const Quantity& quantity, const deck::Deck& deck,
                                    const std::string& until) {
  return quantity.channel.empty() ? of_result(quantity.name, deck, until)
                                  : of_channel(quantity.channel, deck);
}

std::string missing_quantities_message(const std::vector<Quantity>& quantities,
                                       const deck::Deck& deck, const std::string& until) {
  std::string out;
  bool lacks_result = false;
  for (const Quantity& quantity : quantities) {
    const std::string why = missing_quantity_reason(quantity, deck, until);
    if (why.empty()) continue;
    out += fmt::format("{}{}: {}", out.empty() ? "" : "; ", quantity.name, why);
    lacks_result = lacks_result || quantity.channel.empty();
  }
  if (!lacks_result) return out;
  std::string has;
  for (const results::KeyResultSpec& spec : results::key_result_specs()) {
    if (spec.id.starts_with("life_") && spec.id != "life_lp_hours") continue;  // by run options
    if (of_result(std::string(spec.id), deck, until).empty())
      has += fmt::format("{}{}", has.empty() ? "" : ", ", spec.id);
  }
  return out + "; possible key results are " + has;
}

}  // namespace adore::studies
