#pragma once

#include "deck/condition.hpp"
#include "deck/deck.hpp"

#include <string>
#include <string_view>

/// How the deck's own code finds its way between schema and data.
namespace adore::deck {

/// Records X of the extension file (ADORE.json). A deck has them only if they are given, after all
/// others, and their values may be missing (std::monostate: not given).
constexpr bool is_extension(std::string_view id) { return id.starts_with('X'); }

/// Does the record have a value besides its label?
bool has_values(const RecordData& record);

/// nullptr when the record is absent.
const RecordData* find_record_data(const Deck& deck, std::string_view id, int instance = 1);

/// A declaration of `name` whose record is present (that instance of it), or one with nullptr
/// record.
VariableRef find_present_variable(const Deck& deck, std::string_view name, int instance = 1);

/// nullptr when no present record has that element. Not entered in the deck's ReadLog.
const Value* find_value(const Deck& deck, std::string_view name, int instance = 1, int index = 1);

/// Conditions evaluated on what the deck holds; not entered in the deck's ReadLog.
ConditionScope condition_scope(const Deck& deck);

/// Number of elements of an array variable; never below 0, and bounded for any deck.
int array_length(const Deck& deck, const VariableSpec& variable);

/// How often a record has to occur when its condition holds; bounded like array_length.
int repeat_count(const Deck& deck, const RecordSpec& record);

/// A value as the writer writes it, strings quoted; "" for a missing value.
std::string value_text(const Value& value);

/// Is an integer one of the variable's codes? True for a variable without codes.
bool is_valid_code(const VariableSpec& variable, long long code);

/// Smallest and largest valid value in the deck's own unit.
Range range_in_deck_units(const Deck& deck, const VariableSpec& variable);

bool is_in_range(const Range& range, double value);

/// A scalar integer that conditions may rely on: present, a valid code, in range.
bool is_reliable_integer(const VariableSpec& variable, const Value& value);

/// "0 (no cage), 1 (one-piece cage)"; only the codes of a long list.
std::string describe_codes(const VariableSpec& variable);

/// "above 0.5 m and at most 1.0 m", "0 to 4"; empty for any number
std::string describe_range(const Range& range, std::string_view unit);

/// "a value from 0 to 4", "a value of at least 0", "a value above 0 m"
std::string describe_value_in_range(std::string_view what, const Range& range,
                                    std::string_view unit);

/// Value that complete() writes if the user gave none.
Value default_value(const VariableSpec& variable);

/// "Rec 5A", "Rec 7.2.1"
std::string default_label(const RecordSpec& spec, int instance);

/// Gives the record at that position of the deck all values that it should have: missing ones
/// become defaults, surplus array elements go.
void fill_with_defaults(Deck& deck, std::size_t position);

}  // namespace adore::deck
