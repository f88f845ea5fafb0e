#include "adrinput/cell.hpp"

#include "adrinput/options_page.hpp"
#include "deck/lookup.hpp"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

namespace adore::adrinput {
namespace {

/// "cageGcPos[2][3]" -> "cageGcPos" and {2, 3}
std::vector<int> indices_in(std::string_view& name) {
  std::vector<int> indices;
  const std::size_t first = name.find('[');
  std::string_view rest = first == std::string_view::npos ? std::string_view() : name.substr(first);
  name = name.substr(0, first);
  while (rest.starts_with('[')) {
    int index = 0;
    const auto [end, error] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), index);
    if (error != std::errc() || index < 1) break;
    indices.push_back(index);
    rest.remove_prefix(std::min(rest.size(), static_cast<std::size_t>(end - rest.data()) + 1));
  }
  return indices;
}

}  // namespace

const deck::Value* value_at(const deck::Deck& deck, const Cell& cell) {
  const deck::RecordData* record = deck::find_record_data(deck, cell.record, cell.instance);
  if (record == nullptr || cell.variable >= record->values.size()) return nullptr;
  const std::vector<deck::Value>& elements = record->values[cell.variable];
  return cell.element < elements.size() ? &elements[cell.element] : nullptr;
}

deck::RecordData* record_at(deck::Deck& deck, const std::string& id, int instance) {
  const auto found = std::find_if(
      deck.records.begin(), deck.records.end(),
      [&](const deck::RecordData& data) { return data.instance == instance && data.id == id; });
  return found == deck.records.end() ? nullptr : &*found;
}

const deck::VariableSpec* variable_of(const Cell& cell) {
  const deck::RecordSpec* spec = page_record(cell.record);
  return spec == nullptr || cell.variable >= spec->variables.size()
             ? nullptr
             : &spec->variables[cell.variable];
}

std::optional<Issue> issue_of_finding(const deck::Deck& deck, const Finding& finding) {
  if (!finding.variable.empty()) return finding;
  const FindingKind* kind = find_finding_kind(finding.code);
  if (kind == nullptr) return std::nullopt;
  std::string name = kind->field;
  // "shoulderDia1" is of the outer race.
  if (name.ends_with('1') && finding.body.find("inner race") != std::string::npos)
    name.back() = '2';
  for (const deck::VariableRef& one : deck::find_variable(name)) {
    if (deck::find_record_data(deck, std::string(one.record->id)) == nullptr) continue;
    Issue out;
    out.record = one.record->id;
    out.variable = name;
    return out;
  }
  return std::nullopt;
}

std::optional<Cell> cell_of(const Issue& issue) {
  const deck::RecordSpec* spec = page_record(issue.record);
  if (spec == nullptr || issue.variable.empty()) return std::nullopt;
  std::string_view name = issue.variable;
  std::vector<int> indices = indices_in(name);
  const auto found =
      std::find_if(spec->variables.begin(), spec->variables.end(),
                   [&](const deck::VariableSpec& variable) { return variable.name == name; });
  if (found == spec->variables.end()) return std::nullopt;
  Cell cell;
  cell.record = spec->id;
  cell.variable = static_cast<std::size_t>(found - spec->variables.begin());
  if (!spec->repeat.empty() && !indices.empty()) {
    cell.instance = indices.front();
    indices.erase(indices.begin());
  }
  if (!indices.empty()) cell.element = static_cast<std::size_t>(indices.front()) - 1;
  return cell;
}

}  // namespace adore::adrinput
