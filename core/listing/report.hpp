#pragma once

#include "results/quantities.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Text of printed pages: headings, named values with units, tables; at most 132 columns, 60 lines
/// a page. Every page starts with a form feed and carries the program version and the run code.
namespace adore::listing {

using namespace results;  // NOLINT(google-build-using-namespace): quantities, tables, run summaries

class Report {
 public:
  static constexpr std::size_t kColumns = 132;
  static constexpr int kLines = 60;

  Report(std::string run_id, UnitSystem units) : run_id_(std::move(run_id)), units_(units) {}
  [[nodiscard]] UnitSystem units() const noexcept { return units_; }
  /// Lines that the present page still has room for.
  [[nodiscard]] int lines_left() const noexcept { return kLines - lines_used_; }

  void new_page(std::string_view title);
  /// Continues the last page of `text`, which was printed earlier.
  void resume(std::string_view text);
  /// Underlined heading within a page; keeps a few of the following lines with it.
  void heading(std::string_view title);
  void blank();
  /// One line, or more where it is longer than a page is wide (broken between words, continued
  /// indented).
  void text(std::string_view line, int indent = 2);
  /// "  label . . . .   value unit": an SI value in the deck's unit. Not-a-number is shown as "-".
  void item(std::string_view label, double si, const UnitPair& unit);
  void item(std::string_view label, long value);
  void item(std::string_view label, std::string_view value);

  struct Column {
    std::string title;
    const UnitPair* unit = nullptr;
  };
  struct Row {
    std::string name;
    std::vector<double> values;  ///< SI
  };
  /// Rows of values under titles and units; the header is repeated on every page it runs over. At
  /// most ten columns when names have up to 8 characters, fewer with longer ones.
  void table(std::string_view name_title, const std::vector<Column>& columns,
             const std::vector<Row>& rows, std::size_t name_width = 8);
  /// The same for texts of given widths, cut where they do not fit.
  void text_table(const std::vector<std::pair<std::string, std::size_t>>& columns,
                  const std::vector<std::vector<std::string>>& rows);

  /// Text written since the last call.
  [[nodiscard]] std::string take();

  /// Seven significant digits; "-" for not-a-number.
  [[nodiscard]] static std::string number(double value);

 private:
  static constexpr std::size_t kTitleColumn = 64;
  static constexpr std::string_view kContinued = " (continued)";
  void put(std::string_view line);
  void ensure_lines(int lines);
  std::string run_id_;
  UnitSystem units_;
  std::string out_, title_;
  int lines_used_ = kLines;
};

}  // namespace adore::listing
