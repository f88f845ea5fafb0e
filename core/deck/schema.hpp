#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The record schema, said once: reader, writer, checks, unit conversion, `adore schema`, forms and
/// help are walks over it. Adding a variable is one edit in schema_*.cpp.
namespace adore::deck {

enum class VarType : unsigned char { Integer, Real, String };
enum class UnitSystem : unsigned char { SI = 1, English = 2 };  ///< kUnit

/// One quantity in the deck's two unit systems. to_si factors turn a deck value into coherent SI
/// with radians: deg -> rad, rpm -> rad/s, in -> m, R -> K ...
struct UnitPair {
  std::string_view si;  ///< as printed, e.g. "m"; "-" dimensionless; "" not applicable
  std::string_view en;
  double si_factor = 1.0;  ///< SI-deck value times this is coherent SI
  double en_factor = 1.0;  ///< English-deck value times this is coherent SI
};

struct Range {  ///< in the deck's SI unit; inclusive unless said otherwise
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool min_exclusive = false;
  bool max_exclusive = false;
};

struct OptionSpec {
  std::string_view code;  ///< "0", "-1"; "n" for any larger integer, "-n" for any smaller one
  std::string_view meaning;
};

struct VariableSpec {
  std::string_view name;
  VarType type = VarType::Real;
  std::string_view length = "1";  ///< "1", a number, or the name of an integer variable
  UnitPair unit;
  std::string_view unitless_when;   ///< condition under which the value is always a pure number
                                    ///< `unit` says; mostly empty
  std::vector<OptionSpec> options;  ///< empty, or the codes that are valid
  std::string_view
      option_table;  ///< "@materials", "@lubricants", "@coolants", "@churning" or empty
  std::string_view default_value;  ///< as text; empty when there is none
  Range range;
  int max_length = 0;     ///< strings: most characters, 0 = any
  std::string_view help;  ///< in our words
};

struct RecordSpec {
  std::string_view id;  ///< "1", "2.1", "5G.2.1A", "7.2.i"
  std::string_view title;
  std::string_view condition;  ///< grammar of condition.hpp, e.g. "mode >= 0 && kReIP in (1,2)"
  std::string_view repeat;     ///< empty (once), or the integer variable with the number of records
  std::vector<VariableSpec> variables;  ///< recID first
};

/// All records in deck order.
std::span<const RecordSpec> schema();

/// nullptr when there is no such record.
const RecordSpec* find_record(std::string_view id);

/// Place of a variable's declaration. The same name may be in several records, of which a deck has
/// at most one.
struct VariableRef {
  const RecordSpec* record = nullptr;
  std::size_t position = 0;  ///< index in record->variables
  [[nodiscard]] const VariableSpec& spec() const { return record->variables[position]; }
};

/// Every declaration of a name in deck order (recID excluded); empty for an unknown name.
std::span<const VariableRef> find_variable(std::string_view name);

/// Known names that resemble a mistyped one, best first, at most three.
std::vector<std::string_view> similar_variables(std::string_view name);

/// The manual's code tables (@materials ...), code and meaning. @throws InternalError for an
/// unknown table.
std::span<const OptionSpec> option_table(std::string_view name);

/// The schema as text; tsv has the columns of the manual's records.tsv.
std::string schema_tsv();
std::string schema_json();
std::string schema_markdown();

}  // namespace adore::deck
