#include "listing/report.hpp"

#include "base/errors.hpp"
#include "base/version.hpp"
#include "listing/cell_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace adore::listing {
namespace {

constexpr std::size_t kCell = 12;

std::string_view without_trailing_blanks(std::string_view line) {
  const std::size_t last = line.find_last_not_of(' ');
  return last == std::string_view::npos ? std::string_view() : line.substr(0, last + 1);
}

}  // namespace

std::string Report::number(double value) {
  return std::isnan(value) ? std::string("-") : fmt::format("{:.7g}", value + 0.0);
}

void Report::put(std::string_view line) {
  if (lines_used_ >= kLines) new_page(title_);
  out_ += without_trailing_blanks(line.substr(0, kColumns));
  out_ += '\n';
  ++lines_used_;
}

void Report::ensure_lines(int lines) {
  if (lines_used_ + lines > kLines) new_page(title_);
}

void Report::new_page(std::string_view title) {
  const std::string text(title);  // may be title_ itself
  const bool again = text == title_ && !title_.empty();
  title_ = text;
  out_ += '\f';
  lines_used_ = 0;
  put(fmt::format("{:<20}{:<44}{}{}", kProgramVersion, run_id_.substr(0, 40), text,
                  again ? kContinued : ""));
  put("");
}

void Report::resume(std::string_view text) {
  const std::size_t page = text.rfind('\f');
  if (page == std::string_view::npos) return;  // the next line begins a page
  text.remove_prefix(page + 1);
  lines_used_ = static_cast<int>(
      std::min<std::ptrdiff_t>(std::count(text.begin(), text.end(), '\n'), kLines));
  // The heading: version in 20 columns, run code in 44, title; columns are characters, not bytes.
  std::string_view heading = text.substr(0, text.find('\n'));
  for (std::size_t column = 0; !heading.empty() && column < kTitleColumn; ++column) {
    heading.remove_prefix(1);
    while (!heading.empty() && (static_cast<unsigned char>(heading.front()) & 0xC0U) == 0x80U)
      heading.remove_prefix(1);
  }
  if (heading.ends_with(kContinued)) heading.remove_suffix(kContinued.size());
  title_ = heading;
}

void Report::heading(std::string_view title) {
  ensure_lines(10);
  if (lines_used_ > 2) put("");
  put(fmt::format("  {}", title));
  put(fmt::format("  {}", std::string(title.size(), '-')));
}

void Report::blank() { put(""); }

void Report::text(std::string_view line, int indent) {
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  const std::size_t width = kColumns - margin.size() - 4;
  std::string_view rest = line;
  for (bool first = true; first || !rest.empty(); first = false) {
    std::size_t taken = rest.size();
    if (taken > width) {
      const std::size_t space = rest.rfind(' ', width);
      taken = space == std::string_view::npos || space == 0 ? width : space;
    }
    put(margin + (first ? "" : "    ") + std::string(rest.substr(0, taken)));
    rest.remove_prefix(taken);
    while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
  }
}

void Report::item(std::string_view label, double si, const UnitPair& unit) {
  const std::string_view name =
      &unit == &unit::kPure ? std::string_view() : unit_name(unit, units_);
  put(fmt::format("  {:<62} {:>16}  {}", label, number(from_si(si, unit, units_)), name));
}

void Report::item(std::string_view label, long value) {
  put(fmt::format("  {:<62} {:>16}", label, value));
}

void Report::item(std::string_view label, std::string_view value) {
  if (value.size() <= 16)
    put(fmt::format("  {:<62} {:>16}", label, value));
  else
    text(fmt::format("{:<62} {}", label, value));
}

void Report::table(std::string_view name_title, const std::vector<Column>& columns,
                   const std::vector<Row>& rows, std::size_t name_width) {
  demand(2 + name_width + kCell * columns.size() <= kColumns,
         "a printed table is wider than the page");
  std::string titles = fmt::format("  {:<{}}", name_title, name_width),
              unit_line(2 + name_width, ' ');
  for (const Column& column : columns) {
    demand(column.title.size() < kCell, "a column title of a printed table is too long");
    titles += fmt::format("{:>{}}", column.title, kCell);
    const std::string unit = column.unit == nullptr || column.unit == &unit::kPure
                                 ? std::string()
                                 : fmt::format("[{}]", unit_name(*column.unit, units_));
    unit_line += fmt::format("{:>{}}", unit, kCell);
  }
  const auto header = [&] {
    put(titles);
    put(unit_line);
  };
  ensure_lines(rows.size() <= 12 ? static_cast<int>(rows.size()) + 2
                                 : 6);  // short tables stay whole
  header();
  for (const Row& row : rows) {
    if (lines_used_ >= kLines) {
      new_page(title_);
      header();
    }
    demand(row.values.size() == columns.size(),
           "the number of values in a printed row differs from the number of columns");
    std::string line = fmt::format("  {:<{}}", row.name, name_width);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const double value = columns[k].unit == nullptr
                               ? row.values[k]
                               : from_si(row.values[k], *columns[k].unit, units_);
      append_cell(line, value, kCell);
    }
    put(line);
  }
}

void Report::text_table(const std::vector<std::pair<std::string, std::size_t>>& columns,
                        const std::vector<std::vector<std::string>>& rows) {
  const auto print = [&](const auto& cell_of) {
    std::string line = "  ";
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::string cell = cell_of(k);
      line += fmt::format("{:<{}}  ", cell.substr(0, columns[k].second), columns[k].second);
    }
    put(line);
  };
  const auto header = [&] { print([&](std::size_t k) { return columns[k].first; }); };
  ensure_lines(rows.size() <= 12 ? static_cast<int>(rows.size()) + 2
                                 : 6);  // short tables stay whole
  header();
  for (const auto& row : rows) {
    if (lines_used_ >= kLines) {
      new_page(title_);
      header();
    }
    print([&](std::size_t k) { return row[k]; });
  }
}

std::string Report::take() { return std::exchange(out_, {}); }

}  // namespace adore::listing
