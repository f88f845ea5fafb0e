#include "deck/schema.hpp"

#include "base/spelling.hpp"
#include "deck/schema_parts.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <string>

namespace adore::deck {
namespace {

std::vector<RecordSpec> make_schema() {
  std::vector<RecordSpec> records;
  add_control_records(records);
  add_geometry_records(records);
  add_imperfection_records(records);
  add_inertia_records(records);
  add_cage_records(records);
  add_material_records(records);
  add_operation_records(records);
  add_lubrication_records(records);
  add_final_records(records);
  add_extension_records(records);
  return records;
}

using Index = std::map<std::string_view, std::vector<VariableRef>>;

const Index& variable_index() {
  static const Index kIndex = [] {
    Index index;
    for (const RecordSpec& record : schema())
      for (std::size_t i = 0; i < record.variables.size(); ++i)
        if (record.variables[i].name != "recID")
          index[record.variables[i].name].push_back({&record, i});
    return index;
  }();
  return kIndex;
}

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool starts_alike(std::string_view name, std::string_view start) {
  return name.size() >= start.size() &&
         std::equal(start.begin(), start.end(), name.begin(),
                    [](char a, char b) { return lower(a) == lower(b); });
}

}  // namespace

std::span<const RecordSpec> schema() {
  static const std::vector<RecordSpec> kRecords = make_schema();
  return kRecords;
}

const RecordSpec* find_record(std::string_view id) {
  const std::span<const RecordSpec> records = schema();
  const auto found = std::find_if(records.begin(), records.end(),
                                  [&](const RecordSpec& record) { return record.id == id; });
  return found == records.end() ? nullptr : &*found;
}

std::span<const VariableRef> find_variable(std::string_view name) {
  const auto found = variable_index().find(name);
  if (found == variable_index().end()) return {};
  return found->second;
}

std::vector<std::string_view> similar_variables(std::string_view name) {
  name = name.substr(0, 40);
  std::vector<std::pair<std::size_t, std::string_view>> candidates;
  // Of names so short that two changes make any other, few are meant.
  const std::size_t limit = name.size() < 3 ? 1 : std::max<std::size_t>(2, name.size() / 3);
  for (const auto& [known, refs] : variable_index()) {
    std::size_t distance = edit_distance(name, known);
    if (name.size() >= 3 && starts_alike(known, name))
      distance = std::min<std::size_t>(distance, 1);
    if (distance <= limit) candidates.emplace_back(distance, known);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, candidates.size()); ++i)
    names.push_back(candidates[i].second);
  return names;
}

}  // namespace adore::deck
