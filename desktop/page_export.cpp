#include "desktop/page_export.hpp"

#include "base/errors.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/pdf_pages.hpp"
#include "desktop/study_chart.hpp"
#include "desktop/svg_writer.hpp"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::desktop {
namespace {

/// A field of a table: quoted if it contains separators.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

std::string field_with_unit(const std::string& name, const std::string& unit) {
  return field(unit.empty() ? name : name + " [" + unit + "]");
}

}  // namespace

std::string page_csv(const ChartPage& page) {
  if (page.study) return study_chart_csv(*page.study);
  struct Column {
    std::string head;
    const std::vector<double>* values;
    const std::vector<bool>* stored = nullptr;  ///< 1 or 0 instead of the values
  };
  std::vector<Column> columns;
  if (!page.equal_axes) columns.push_back({field_with_unit(page.x_title, page.x_unit), &page.x});
  for (const ChartPanel& panel : page.panels)
    for (const ChartCurve& curve : panel.curves) {
      std::string name = curve.name.empty() ? panel.title : panel.title + ", " + curve.name;
      // A column needs its full name without the page.
      if (!page.about.empty())
        name = page.about + ": " + (page.title == panel.title ? "" : page.title + ": ") + name;
      if (page.equal_axes)
        columns.push_back(
            {field_with_unit(page.x_title + ", " + curve.name, panel.unit), &curve.x});
      columns.push_back({field_with_unit(name, panel.unit), &curve.y});
      if (!curve.stored.empty())
        columns.push_back(
            {field(name + ": stored (1) or interpolated (0)"), &curve.y, &curve.stored});
      if (curve.low.empty()) continue;
      columns.push_back(
          {field_with_unit(name + ", lowest since the last", panel.unit), &curve.low});
      columns.push_back(
          {field_with_unit(name + ", highest since the last", panel.unit), &curve.high});
    }
  std::string out;
  std::size_t rows = 0;
  for (const Column& column : columns) {
    out += (out.empty() ? "" : ",") + column.head;
    rows = std::max(rows, column.values->size());
  }
  out += '\n';
  for (std::size_t i = 0; i < rows; ++i) {
    bool first = true;
    for (const Column& column : columns) {
      if (!first) out += ',';
      first = false;
      if (i >= column.values->size() || !std::isfinite((*column.values)[i])) continue;
      if (column.stored != nullptr)
        out += (*column.stored)[i] ? '1' : '0';
      else
        fmt::format_to(std::back_inserter(out), "{:.17g}", (*column.values)[i]);
    }
    out += '\n';
  }
  return out;
}

ChartPage visible_part(const ChartScene& scene) {
  ChartPage page = scene.page();
  const auto keep = [](auto& values, const std::vector<bool>& seen) {
    std::size_t to = 0;
    for (std::size_t i = 0; i < std::min(values.size(), seen.size()); ++i)
      if (seen[i]) values[to++] = values[i];
    values.resize(std::min(to, values.size()));
  };
  std::vector<bool> rows;
  for (const double x : page.x) rows.push_back(x >= scene.viewLow() && x <= scene.viewHigh());
  for (ChartPanel& panel : page.panels) {
    std::erase_if(panel.curves, [](const ChartCurve& curve) { return curve.hidden; });
    for (ChartCurve& curve : panel.curves) {
      if (page.equal_axes) {
        rows.clear();
        for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i)
          rows.push_back(scene.planePosition(curve.x[i], curve.y[i]).has_value());
      }
      for (auto* values : {&curve.x, &curve.y, &curve.low, &curve.high}) keep(*values, rows);
      keep(curve.stored, rows);
    }
  }
  if (!page.equal_axes) keep(page.x, rows);
  return page;
}

void paint_vector(ChartScene& scene, QPainter& painter, const QRectF& target, QSizeF page) {
  const QSizeF before = scene.sceneRect().size();
  const bool interactive = scene.interactive();
  scene.setInteractive(false);
  scene.setPageSize(page);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::TextAntialiasing);
  scene.render(&painter, target, scene.sceneRect(), Qt::KeepAspectRatio);
  painter.restore();
  scene.setPageSize(before);
  scene.setInteractive(interactive);
}

void save_pdf(ChartScene& scene, const std::filesystem::path& path, std::size_t pages, QSizeF size,
              const std::function<void(std::size_t)>& show) {
  check_writable_file(path);  // before minutes of drawing
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  const auto draw = [&](QPainter& painter, const QRectF& paper, std::size_t page) {
    show(page);
    paint_vector(scene, painter, paper, size);
  };
  // Of several pages no title is that of the document.
  const std::string title = pages == 1 ? scene.page().title : path.stem().string();
  write_pdf(buffer, size, pages, draw, {QString::fromStdString(title), {}});
  buffer.close();
  save_bytes(bytes, path);
}

void save_page(ChartScene& scene, const std::filesystem::path& path, QSizeF size, Replace replace) {
  if (replace == Replace::OwnPictures) check_replaceable(path);
  const QString suffix = QFileInfo(QString::fromStdString(path.string())).suffix().toLower();
  if (suffix == "csv") return save_bytes(QByteArray::fromStdString(page_csv(scene.page())), path);
  if (suffix == "pdf") return save_pdf(scene, path, 1, size, [](std::size_t) {});
  if (suffix == "svg")
    return save_bytes(render_svg(size,
                                 [&](QPainter& painter) {
                                   paint_vector(scene, painter, QRectF(QPointF(0, 0), size), size);
                                 },
                                 {QString::fromStdString(scene.page().title), {}}),
                      path);
  if (suffix != "png" && suffix != "jpg" && suffix != "jpeg")
    throw InputError("a page cannot be saved as " + path.string() +
                     "; give a name that ends in .png, .jpg, .svg, .pdf or .csv");
  const QSizeF before = scene.sceneRect().size();
  const QImage image = scene.image(size.toSize());
  scene.setPageSize(before);
  save_image(image, path, replace);
}

}  // namespace adore::desktop
