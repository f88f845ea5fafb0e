#include "cli/pictures/report.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/terminal_text.hpp"
#include "base/write_folder.hpp"
#include "cli/pictures/report_run.hpp"
#include "cli/pictures/report_template.hpp"
#include "cli/progress.hpp"
#include "desktop/bootstrap.hpp"
#include "desktop/image_export.hpp"

#include <QBuffer>
#include <QFont>
#include <QHashFunctions>
#include <QPageLayout>
#include <QPdfWriter>
#include <QTextDocument>
#include <QUrl>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace adore::cli {

namespace fs = std::filesystem;

namespace {

/// Key results of several runs side by side; "" for one run.
std::string comparison(const std::vector<ReportRun>& runs) {
  if (runs.size() < 2) return "";
  std::vector<std::string> header{"result"}, ids;
  std::vector<std::vector<std::string>> rows;
  for (const ReportRun& run : runs) {
    header.push_back(escape_html(run.name));
    for (const ReportRun::Value& value : run.values) {
      auto at = std::ranges::find(ids, value.id);
      if (at == ids.end()) {
        rows.emplace_back(runs.size() + 1, "not computed").front() = value.label;
        at = ids.insert(ids.end(), value.id);
      }
      rows[static_cast<std::size_t>(at - ids.begin())][header.size() - 1] = value.text;
    }
  }
  std::vector<bool> numeric(header.size(), true);
  numeric.front() = false;
  return "<h2>Runs compared</h2>\n" + html_table(header, rows, numeric);
}

QByteArray png(const QImage& image) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return bytes;
}

/// The file holds its pictures: no second file, no network.
std::string with_pictures(std::string html, const std::vector<ReportRun>& runs) {
  for (const ReportRun& run : runs)
    for (const ReportPicture& picture : run.pictures) {
      const std::string source = fmt::format("src=\"{}\"", picture.name);
      const std::string data =
          "src=\"data:image/png;base64," + png(picture.image).toBase64().toStdString() + "\"";
      for (std::size_t at = html.find(source); at != std::string::npos;
           at = html.find(source, at + data.size()))
        html.replace(at, source.size(), data);
    }
  return html;
}

/// Without the time of its making, so that the same runs give the same bytes. The table of the
/// file's parts counts bytes: the entry is replaced by blanks.
void remove_date(QByteArray& pdf) {
  const qsizetype from = pdf.indexOf("/CreationDate");
  const qsizetype to = from < 0 ? -1 : pdf.indexOf('\n', from);
  if (to > from) pdf.replace(from, to - from, QByteArray(to - from, ' '));
}

QByteArray render_pdf(const std::string& html, const std::vector<ReportRun>& runs,
                      const std::string& title) {
  QTextDocument document;
  document.setDefaultFont(QFont("DejaVu Sans", 9));  // headings are multiples of a size in points
  for (const ReportRun& run : runs)
    for (const ReportPicture& picture : run.pictures)
      document.addResource(QTextDocument::ImageResource, QUrl(QString::fromStdString(picture.name)),
                           picture.image);
  document.setHtml(QString::fromStdString(html));
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setTitle(QString::fromStdString(title));
    writer.setCreator("Adore");
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({0, 0, 0, 0}, QPageLayout::Millimeter);  // the document has 2 cm
    document.print(&writer);
  }
  remove_date(bytes);
  return bytes;
}

/// A report may replace a report, and nothing else.
void check_own_report(const WritePath& place) {
  check_writable_file(place);
  constexpr std::string_view kMark = "<meta name=\"generator\" content=\"Adore\">";
  if (is_plain_file(place.path()) && read_text_file(place.path()).find(kMark) == std::string::npos)
    throw InputError(
        place.path().string() +
        " exists and is not a report of this program; move it, or give another folder");
}

}  // namespace

void draw_report(const ReportRequest& request) {
  QHashSeed::setDeterministicGlobalSeed();  // the order of the fonts in the PDF
  desktop::ensure_headless_application();
  if (request.print_template) {
    print("{}", default_report_template());
    return;
  }
  const std::string text =
      request.file.empty() ? default_report_template() : read_text_file(request.file);
  const auto progress = make_count_progress("run", request.progress);
  std::vector<ReportRun> runs;
  for (const std::string& folder : request.runs) {
    runs.push_back(report_run(folder, runs.size() + 1,
                              request.charts == "all" ? ReportCharts::All : ReportCharts::Main));
    if (progress) progress(static_cast<long>(runs.size()), static_cast<long>(request.runs.size()));
  }
  std::string title = runs.front().name;
  if (runs.size() > 1) title += fmt::format(" and {} more", runs.size() - 1);
  std::vector<ReportParts> parts;
  for (const ReportRun& run : runs) parts.push_back(run.parts);
  const std::string html =
      fill_report(text, {{"title", escape_html(title)}, {"comparison", comparison(runs)}}, parts);
  desktop::make_folder(request.out);
  const WriteFolder folder((fs::path(request.out)));
  const WritePath page(folder, "report.html"), paper(folder, "report.pdf");
  check_own_report(page);
  check_writable_file(paper);
  write_file_atomically(page, with_pictures(html, runs));
  const QByteArray pdf = render_pdf(html, runs, title);
  write_file_atomically(paper, desktop::text_of(pdf));
  print("{}\n{}\n", page.path().string(), paper.path().string());
}

}  // namespace adore::cli
