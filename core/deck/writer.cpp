#include "base/write_folder.hpp"
#include "deck/deck.hpp"
#include "deck/lookup.hpp"
#include "deck/orbit_records.hpp"

#include <algorithm>
#include <string>

namespace adore::deck {
namespace {

/// One line. Missing values are left out between commas; missing values at the end are cut by a
/// slash.
std::string record_line(const RecordData& record) {
  std::vector<const Value*> values;
  for (const std::vector<Value>& elements : record.values)
    for (const Value& value : elements) values.push_back(&value);
  const std::size_t all = values.size();
  while (!values.empty() && std::holds_alternative<std::monostate>(*values.back()))
    values.pop_back();
  std::string line;
  for (std::size_t i = 0; i < values.size(); ++i)
    line += (i > 0 ? ", " : "") + value_text(*values[i]);
  if (values.size() < all) line += line.empty() ? "/" : " /";
  return line;
}

}  // namespace

std::string write_deck(const Deck& deck) {
  std::string text;
  for (const RecordData& record : with_orbit_records(deck).records)
    if (!is_extension(record.id) || has_values(record)) text += record_line(record) + "\n";
  for (const std::string& line : deck.user_lines) text += line + "\n";
  return text;
}

void write_deck(const Deck& deck, const std::filesystem::path& path) {
  write_file_atomically(path, write_deck(deck));
}

}  // namespace adore::deck
