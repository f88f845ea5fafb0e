#include "adrplot/statistics_table.hpp"

#include "adrplot/spectrogram_page.hpp"
#include "desktop/axis_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace adore::adrplot {
namespace {

struct Column {
  const char* title;
  double (*value)(const StatisticsRow&);
};
constexpr std::array<Column, 7> kColumns{
    {{"Values", [](const StatisticsRow& r) { return static_cast<double>(r.values.count); }},
     {"Minimum", [](const StatisticsRow& r) { return r.values.lowest; }},
     {"Maximum", [](const StatisticsRow& r) { return r.values.highest; }},
     {"Mean", [](const StatisticsRow& r) { return r.values.mean; }},
     {"RMS", [](const StatisticsRow& r) { return r.values.rms; }},
     {"Standard deviation", [](const StatisticsRow& r) { return r.deviation; }},
     {"Peak to peak", [](const StatisticsRow& r) { return r.values.highest - r.values.lowest; }}}};

std::string quoted(const std::string& text, char separator) {
  if (text.find(separator) == std::string::npos && text.find('"') == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

}  // namespace

std::vector<StatisticsRow> statistics_rows(const desktop::ChartPage& page, double from, double to) {
  std::vector<StatisticsRow> out;
  if (page.equal_axes || page.study) return out;
  for (const desktop::ChartPanel& panel : page.panels) {
    if (panel.rows) continue;
    for (const desktop::ChartCurve& curve : panel.curves) {
      if (curve.hidden) continue;
      StatisticsRow row{curve.brief.empty() ? curve_name(panel, curve) : curve.brief, "",
                        desktop::statistics_between(page.x, curve.y, from, to), 0.0};
      if (row.values.count == 0) continue;
      const double size = std::max(std::abs(row.values.lowest), std::abs(row.values.highest));
      const desktop::AxisScale scale = desktop::tight_axis(0.0, size, panel.unit, 4);
      row.unit = scale.unit;
      for (double* value :
           {&row.values.lowest, &row.values.highest, &row.values.mean, &row.values.rms})
        *value /= scale.factor;
      const double square = row.values.rms * row.values.rms - row.values.mean * row.values.mean;
      row.deviation = std::sqrt(std::max(0.0, square));
      out.push_back(std::move(row));
    }
  }
  return out;
}

std::string statistics_text(const std::vector<StatisticsRow>& rows, char separator) {
  std::string out = fmt::format("Curve{}Unit", separator);
  for (const Column& column : kColumns) out += separator + std::string(column.title);
  for (const StatisticsRow& row : rows) {
    out += '\n' + quoted(row.curve, separator) + separator + quoted(row.unit, separator);
    for (const Column& column : kColumns)
      out += fmt::format("{}{:.15g}", separator, column.value(row));
  }
  return out + '\n';
}

void StatisticsModel::setRows(std::vector<StatisticsRow> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int StatisticsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int StatisticsModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(kColumns.size()) + 2;
}

QVariant StatisticsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const StatisticsRow& row = rows_.at(static_cast<std::size_t>(index.row()));
  if (role == Qt::TextAlignmentRole && index.column() > 1)
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  if (index.column() == 0) return QString::fromStdString(row.curve);
  if (index.column() == 1) return QString::fromStdString(row.unit);
  constexpr int kDigits = 5;
  const double value = kColumns.at(static_cast<std::size_t>(index.column() - 2)).value(row);
  return index.column() == 2 ? QString::number(row.values.count)
                             : QString::fromStdString(desktop::pretty_number(value, kDigits));
}

QVariant StatisticsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal) return {};
  if (section == 0) return tr("Curve");
  if (section == 1) return tr("Unit");
  return tr(kColumns.at(static_cast<std::size_t>(section - 2)).title);
}

}  // namespace adore::adrplot
