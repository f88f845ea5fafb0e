#pragma once

#include "adrinput/cell.hpp"

#include <map>
#include <string>
#include <string_view>

/// The run options of ADORE.json as one more page of the deck: a record that is built from the list
/// of run options, with a text per option. No Qt.
namespace adore::adrinput {

/// Its page and record id.
inline constexpr std::string_view kOptionsPage = "ADORE.json";

[[nodiscard]] const deck::RecordSpec& options_record();

/// A record of the schema, or the page of options; nullptr if there is no such page.
[[nodiscard]] const deck::RecordSpec* page_record(std::string_view id);

/// Content of the field of an option: its value, or the default.
[[nodiscard]] std::string option_text(const std::map<std::string, std::string>& given,
                                      const Cell& cell);

}  // namespace adore::adrinput
