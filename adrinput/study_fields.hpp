#pragma once

#include "studies/study.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

/// Content of the form of a study: fields and tables over the keys of the file, and conversion of
/// typed values. Values are not checked here: texts that are not numbers are passed to the checker.
/// No Qt.
namespace adore::adrinput {

using StudyJson = nlohmann::ordered_json;

enum class StudyCellType : unsigned char {
  Text,
  Number,
  Numbers,   ///< "0.5, 1, 2"
  Texts,     ///< "A.txt; B.txt"
  Settings,  ///< "mode = -1, kReGeoImp = 2"
  Choice,    ///< a text of a list
  Truth
};

/// A set of studies::Kind; a field is shown for these, and for others if the file has its key.
using StudyKinds = unsigned;
[[nodiscard]] constexpr StudyKinds only(studies::Kind kind) {
  return 1U << static_cast<unsigned>(kind);
}
inline constexpr StudyKinds kAllKinds = (1U << studies::kKinds) - 1;

struct StudyField {
  std::string_view key;  ///< "until", "sampling.runs"
  std::string_view group, label, help;
  StudyCellType cell = StudyCellType::Text;
  StudyKinds kinds = kAllKinds;
  std::vector<std::string_view> choices = {};
};
/// In the order of the form.
[[nodiscard]] const std::vector<StudyField>& study_fields();
[[nodiscard]] const StudyField* find_study_field(std::string_view key);

/// Proposals of a cell while it is edited.
enum class Proposals : unsigned char { None, Variables, Results };

struct StudyColumn {
  std::string_view label, help;
  StudyKinds kinds = kAllKinds;
  std::vector<std::string_view> choices = {};
  Proposals proposals = Proposals::None;
};
struct StudyTableSpec {
  std::string_view key, title, help;
  StudyKinds kinds = kAllKinds;
  std::vector<StudyColumn> columns;
};
[[nodiscard]] const std::vector<StudyTableSpec>& study_tables();

/// Text of a field; empty for a missing value.
[[nodiscard]] std::string shown_value(const StudyJson& value);
/// Typed text as a value of the file; null for empty text.
[[nodiscard]] StudyJson typed_value(StudyCellType cell, const std::string& text);

/// A row of a table (a JSON value of its list) as cells, one for each column.
[[nodiscard]] std::vector<std::string> row_cells(std::string_view table, const StudyJson& row);
/// Back. Keys of `old` that the table does not show stay.
[[nodiscard]] StudyJson row_from_cells(std::string_view table,
                                       const std::vector<std::string>& cells, const StudyJson& old);

}  // namespace adore::adrinput
