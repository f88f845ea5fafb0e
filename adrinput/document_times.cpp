#include "adrinput/document.hpp"
#include "adrinput/run_times.hpp"
#include "adrinput/typed.hpp"
#include "base/constants.hpp"
#include "deck/quantity.hpp"
#include "deck/units.hpp"

#include <algorithm>
#include <array>
#include <utility>

/// Times of a run: dimensionless in the deck, displayed in seconds and revolutions.
namespace adore::adrinput {
namespace {

constexpr std::string_view kTimeVariation = "3.4";

/// Variables without effect on the time scale: steps, names, and selection of stored bodies.
bool is_beside_the_scale(std::string_view record, std::string_view variable) {
  return record == "1" || record == "2.1" || record == "2.3" || record == "3.1" ||
         (record == kTimeVariation && (variable == "kNumPltElem" || variable == "kPltElemInd"));
}

/// Records that determine the time scale, with these values.
std::vector<deck::RecordData> deciding(const deck::Deck& deck) {
  std::vector<deck::RecordData> out;
  for (const deck::RecordData& record : deck.records) {
    if (is_beside_the_scale(record.id, "")) continue;
    out.push_back(record);
    if (record.id != kTimeVariation) continue;
    const deck::RecordSpec& spec = *deck::find_record(record.id);
    for (std::size_t v = 0; v < spec.variables.size(); ++v)
      if (is_beside_the_scale(record.id, spec.variables[v].name)) out.back().values[v].clear();
  }
  return out;
}

bool ends_with_letter(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t");
  if (last == std::string_view::npos) return false;
  const char c = text[last];
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Texts in time fields in seconds or revolutions that are not values yet.
std::vector<std::pair<Cell, std::string>> typed_times(const Document& document) {
  std::vector<std::pair<Cell, std::string>> out;
  if (document.instances("2.1") == 0) return out;
  const deck::RecordSpec& spec = *deck::find_record("2.1");
  for (std::size_t v = 0; v < spec.variables.size(); ++v) {
    const Cell cell{std::string(spec.id), 1, v, 0};
    if (is_run_time(spec.variables[v]) && document.has_unparsed_text(cell) &&
        ends_with_letter(document.text(cell)))
      out.emplace_back(cell, document.text(cell));
  }
  return out;
}

}  // namespace

bool has_pending_times(const Document& document) {
  return !document.cell_being_typed() && !typed_times(document).empty();
}

bool apply_pending_times(Document& document) {
  if (document.cell_being_typed() || !document.scales()) return false;
  bool any = false;
  for (const auto& [cell, typed] : typed_times(document)) {
    if (document.parse(cell, typed).problem) continue;
    document.edit(cell, typed);
    any = true;
  }
  return any;
}

std::optional<deck::Deck> deck_without_scales(const Document& document) {
  if (document.cell_being_typed() || document.scales()) return std::nullopt;
  for (const Problem& problem : document.problems()) {
    if (problem.issue.severity != Severity::Error) continue;
    // For a text that is not a value the deck keeps the previous value.
    const bool kept =
        problem.cell && document.has_unparsed_text(*problem.cell) && problem.page == "2.1";
    const std::string_view named =
        std::string_view(problem.issue.variable).substr(0, problem.issue.variable.find('['));
    if (!kept && (problem.page != kTimeVariation || !is_beside_the_scale(problem.page, named)))
      return std::nullopt;
  }
  deck::Deck out = document.deck();
  if (out.has_record(kTimeVariation)) {
    out.set("kNumPltElem", "0");
    out.complete();
  }
  return out;
}

void Document::set_scales(const deck::Deck& of, const std::optional<runs::RunScales>& scales) {
  scales_ = scales;
  scale_records_ = deciding(of);
  notify();
}

std::optional<runs::RunScales> Document::scales() const {
  return scales_ && deciding(state_.deck) == scale_records_ ? scales_ : std::nullopt;
}

TypedValue Document::parse(const Cell& cell, std::string_view text) const {
  const deck::VariableSpec& variable = *variable_of(cell);
  if (variable.type == deck::VarType::Real) {
    std::size_t values = 0;  // from this one on
    for (Cell at = cell; value_at(state_.deck, at) != nullptr; ++at.element) ++values;
    if (deck::NumberProblem problem = check_product_ambiguity(text, values))
      return {{}, std::move(problem)};
  }
  TypedValue plain = parse_typed_text(state_.deck, variable, text);
  if (!plain.problem || !is_run_time(variable) || !ends_with_letter(text)) return plain;
  double seconds = 0.0, angle = 0.0;
  const bool turns = !deck::parse_quantity(text, deck::unit::kRadian, deck::UnitSystem::SI, angle);
  if (!turns && deck::parse_quantity(text, deck::unit::kTime, deck::UnitSystem::SI, seconds))
    return plain;
  const std::optional<runs::RunScales> now = scales();
  if (!now)
    return {{},
            {"is a time, but the time scale is not known yet",
             "correct the other errors first (the time scale is computed from the equilibrium), or "
             "enter a multiple of the time scale"}};
  if (turns && now->turns_per_second == 0.0)
    return {{},
            {"is in revolutions, but both races rotate at the same speed",
             "enter the value in s or as a multiple of the time scale"}};
  if (turns) seconds = angle / (2.0 * kPi) / now->turns_per_second;
  double value = 0.0;
  const deck::NumberProblem problem = deck::parse_quantity(
      deck::format_real(seconds / now->time), deck::unit::kPure, deck::UnitSystem::SI, value);
  return {value, problem};
}

}  // namespace adore::adrinput
