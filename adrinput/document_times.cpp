#include "adrinput/document.hpp"
#include "adrinput/typed.hpp"
#include "deck/quantity.hpp"
#include "deck/units.hpp"

#include <algorithm>
#include <array>

/// Times of a run: dimensionless in the deck, seconds and turns for a person.
namespace adore::adrinput {
namespace {

/// Records that decide the scale of time: not the steps, nor the name.
std::vector<deck::RecordData> deciding(const deck::Deck& deck) {
  std::vector<deck::RecordData> out;
  for (const deck::RecordData& record : deck.records)
    if (record.id != "1" && record.id != "2.1" && record.id != "3.1") out.push_back(record);
  return out;
}

bool ends_with_letter(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t");
  if (last == std::string_view::npos) return false;
  const char c = text[last];
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

}  // namespace

void Document::set_scales(const deck::Deck& of, const std::optional<facade::RunScales>& scales) {
  scales_ = scales;
  scaled_ = deciding(of);
  notify();
}

std::optional<facade::RunScales> Document::scales() const {
  return scales_ && deciding(state_.deck) == scaled_ ? scales_ : std::nullopt;
}

Typed Document::parse(const Cell& cell, std::string_view text) const {
  const deck::VariableSpec& variable = *variable_of(cell);
  Typed plain = parse_typed(state_.deck, variable, text);
  if (!plain.problem || !is_run_time(variable) || !ends_with_letter(text)) return plain;
  double seconds = 0.0, angle = 0.0;
  const bool turns = !deck::parse_quantity(text, deck::unit::kRadian, deck::UnitSystem::SI, angle);
  if (!turns && deck::parse_quantity(text, deck::unit::kTime, deck::UnitSystem::SI, seconds))
    return plain;
  const std::optional<facade::RunScales> now = scales();
  if (!now || (turns && now->turns_per_second == 0.0))
    return {{},
            {turns && now ? "counts turns, but both races turn alike"
                          : "is a time whose scale is not known yet",
             turns && now ? "give it in s, or as a multiple of the time scale"
                          : "wait until the equilibrium is found, or give a multiple of the time "
                            "scale"}};
  if (turns) seconds = angle / (2.0 * deck::unit::kPi) / now->turns_per_second;
  double value = 0.0;
  const deck::NumberProblem problem = deck::parse_quantity(
      deck::format_real(seconds / now->time), deck::unit::kPure, deck::UnitSystem::SI, value);
  return {value, problem};
}

}  // namespace adore::adrinput
