#include "adrplot/plot_document.hpp"
#include "adrplot/plot_window.hpp"
#include "adrplot/render.hpp"
#include "adrplot/study_document.hpp"
#include "base/errors.hpp"
#include "deck/templates.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/page_export.hpp"
#include "desktop/study_chart.hpp"
#include "desktop/theme.hpp"
#include "studies/campaign.hpp"
#include "studies/report.hpp"
#include "studies/study_table_read.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"

#include <QDialog>
#include <QImage>
#include <QPainter>
#include <QPlainTextEdit>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

using namespace adore;
using namespace adore::adrplot;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A small study of two grids and a tolerance, whole; made once.
const fs::path& study_folder() {
  static const QTemporaryDir folder;
  static const fs::path made = [] {
    const fs::path root = folder.path().toStdString();
    std::ofstream(root / "DATA.txt") << deck::template_text("ball");
    std::ofstream(root / "small.json")
        << R"({"adore_study": 1, "kind": "tolerance", "deck": "DATA.txt",
      "set": {"mode": -1},
      "variables": [{"name": "appLoadX", "grid": [500, 1500, 3]}, {"name": "freeConAng", "list": [15, 25]},
                    {"name": "raceCurFac1", "uniform": [0.515, 0.525]}],
      "sampling": {"runs": 4, "seed": 1}, "quantities": ["largest_contact_load_N", "stiffness_x_N_per_m"]})";
    studies::CampaignRequest request;
    request.study = studies::open_study(root / "small.json");
    request.program = test::program("adore");
    (void)studies::run_campaign(request, nullptr, {});
    (void)studies::write_report(request.study);
    return root / "small.study";
  }();
  return made;
}

/// A point of the page that has runs behind it.
QPointF point_with_runs(const desktop::StudyChart& chart, QSizeF size) {
  for (double y = 0; y < size.height(); y += 4)
    for (double x = 0; x < size.width(); x += 4)
      if (!runs_at(chart, size, {x, y}).empty()) return {x, y};
  return {-1, -1};
}

}  // namespace

TEST_CASE("a study's folder opens as the pictures of its report", "[gui][adrplot][studies]") {
  test::use_qt();
  const PlotDocument document = open_document(study_folder());
  const auto charts = desktop::read_study_charts(study_folder() / "CHARTS.json");
  REQUIRE(document.pages.size() == charts.size());
  CHECK(document.subject == "study small");
  bool curves = false, map = false, lines = false, bars = false;
  for (int number = 1; number <= static_cast<int>(document.pages.size()); ++number) {
    const desktop::ChartPage page = document.build(number, {});
    REQUIRE(page.study);
    curves = curves || std::holds_alternative<desktop::BandCurves>(page.study->of);
    map = map || std::holds_alternative<desktop::HeatMap>(page.study->of);
    lines = lines || std::holds_alternative<desktop::ParallelLines>(page.study->of);
    bars = bars || std::holds_alternative<desktop::Tornado>(page.study->of);
    CHECK(desktop::page_csv(page).size() > 20);
  }
  CHECK((curves && map && lines && bars));
  CHECK_THROWS_AS(document.build(99, {}), InputError);
}

TEST_CASE("maps: values over several decades → a color for each decade, with a note",
          "[gui][adrplot][studies]") {
  test::use_qt();
  const auto colours = [](std::vector<double> values) {
    desktop::HeatMap map;
    map.title = map.legend = "life";
    map.x = {1, 2, 3, 4};
    map.y = {1};
    map.values = {std::move(values)};
    const QSize size(1280, 800);
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    desktop::paint_study({"map", map}, painter, size, desktop::current_theme());
    painter.end();
    // Cells along a line above the numbers: wide stretches of one color.
    std::vector<QColor> out;
    constexpr int kRow = 150, kWide = 100;
    for (int x = 1, since = 0; x < image.width(); ++x) {
      if (image.pixel(x, kRow) != image.pixel(x - 1, kRow)) since = x;
      const QColor here = image.pixelColor(x, kRow);
      if (x - since == kWide && here.saturation() > 40) out.push_back(here);
    }
    return out;
  };
  const auto apart = [](const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
           std::abs(a.blue() - b.blue());
  };
  const std::vector<QColor> decades = colours({1e3, 1e4, 1e5, 1e6});
  REQUIRE(decades.size() == 4);
  for (std::size_t k = 1; k < 4; ++k) CHECK(apart(decades[k - 1], decades[k]) > 60);
  // Of a narrow range, and of one with 0, equal steps are equal steps.
  for (const std::vector<double>& even : {std::vector{1.0, 2.0, 3.0, 4.0}, {0.0, 1e3, 2e3, 3e3}}) {
    const std::vector<QColor> steps = colours(even);
    REQUIRE(steps.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) CHECK(apart(steps[k], decades[k]) <= 6);
  }
}

TEST_CASE("pages of a study are drawn headless, in every size and theme, as the command line does",
          "[gui][adrplot][studies]") {
  test::use_qt();
  const QTemporaryDir out;
  for (const bool dark : {false, true})
    for (const QSize size : {QSize(1280, 800), QSize(700, 450)}) {
      RenderOptions options;
      options.folder = fs::path(out.path().toStdString()) /
                       (std::to_string(size.width()) + (dark ? "dark" : "light"));
      options.width = size.width();
      options.height = size.height();
      options.dark = dark;
      const auto pages = render_plots({study_folder()}, options);
      CHECK(pages.size() == open_document(study_folder()).pages.size());
      for (const fs::path& page : pages)
        CHECK(QImage(QString::fromStdString(page.string())).size() == size);
    }
  // The same picture as the report's.
  const auto charts = desktop::read_study_charts(study_folder() / "CHARTS.json");
  const fs::path picture = fs::path(out.path().toStdString()) / "one.png";
  REQUIRE(save_picture(charts.front(), picture));
  const fs::path page =
      fs::path(out.path().toStdString()) / "1280light" / "small.study-page-01.png";
  CHECK(QImage(QString::fromStdString(page.string())).convertToFormat(QImage::Format_RGB32) ==
        QImage(QString::fromStdString(picture.string())).convertToFormat(QImage::Format_RGB32));
}

TEST_CASE("a click on a point of a study shows its run", "[gui][adrplot][studies]") {
  test::use_qt();
  PlotWindow window;
  window.resize(1280, 800);
  window.show();
  window.openFolder(QString::fromStdString(study_folder().string()));
  REQUIRE(window.fileCount() == 1);
  int shown = 0;
  for (int page = 1; page <= window.pageCount(); ++page) {
    window.showPage(page);
    const desktop::StudyChart& chart = *window.view().chartScene().page().study;
    const QSizeF size = window.view().viewport()->size();
    const QPointF at = point_with_runs(chart, size);
    INFO(chart.name);
    if (std::holds_alternative<desktop::Tornado>(chart.of)) {
      CHECK(at.x() < 0);
      continue;
    }
    REQUIRE(at.x() >= 0);
    const auto runs = runs_at(chart, size, at);
    QTest::mouseClick(window.view().viewport(), Qt::LeftButton, {}, at.toPoint());
    auto* dialog = window.findChild<QDialog*>("runs");
    REQUIRE(dialog != nullptr);
    const std::string text =
        dialog->findChild<QPlainTextEdit*>("run-text")->toPlainText().toStdString();
    CHECK_THAT(text, Contains("Run " + std::to_string(runs.front()) + ": done") &&
                         Contains("largest_contact_load_N") && Contains("adore run ") &&
                         Contains("--set 'appLoadX="));
    delete dialog;
    ++shown;
  }
  CHECK(shown > 4);
}

TEST_CASE("damaged STUDY.h5: read or rejected with a message, no crash", "[adrplot][studies][h5]") {
  const std::string good = test::bytes_of(study_folder() / "STUDY.h5");
  REQUIRE(good.size() > 2000);
  const QTemporaryDir folder;
  const fs::path file = fs::path(folder.path().toStdString()) / "STUDY.h5";
  std::mt19937 random(17);
  int read = 0, refused = 0;
  constexpr int kFiles = 400;
  for (int i = 0; i < kFiles; ++i) {
    std::string bytes = good;
    for (unsigned change = 0; change <= random() % 3; ++change) {
      const std::size_t at = random() % bytes.size();
      switch (random() % 3) {
        case 0:
          bytes[at] = static_cast<char>(random());
          break;
        case 1:
          for (std::size_t k = at; k < std::min(at + 8, bytes.size()); ++k) bytes[k] = '\xff';
          break;
        default:
          bytes.resize(at + 1);
      }
    }
    std::ofstream(file, std::ios::binary) << bytes;
    try {
      const studies::StudyTable table = studies::read_study_table(file);
      for (const studies::TableColumn& column : table.quantities)
        REQUIRE(column.values.size() == table.rows());
      ++read;
    } catch (const InputError& error) {
      REQUIRE_THAT(error.what(), Catch::StartsWith(file.string() + ": "));
      ++refused;
    }
  }
  CHECK(read > 20);
  CHECK(refused > 20);
}

TEST_CASE("a study's tables in another place still open", "[gui][adrplot][studies]") {
  test::use_qt();
  const QTemporaryDir other;
  const fs::path there = other.path().toStdString();
  const studies::StudyTable whole = studies::read_study_table(study_folder() / "RUNS.csv");
  CHECK(whole.rows() == 24);
  for (const char* name : {"RUNS.csv", "STUDY.h5"}) {
    INFO(name);
    fs::copy_file(study_folder() / name, there / name);
    const studies::StudyTable table = studies::read_study_table(there / name);
    CHECK(table.run == whole.run);
    CHECK(table.exit == whole.exit);
    REQUIRE(table.variables.size() == 3);
    REQUIRE(table.quantities.size() == 2);
    for (const studies::TableColumn& column : whole.quantities) {
      CHECK(table.find(column.name)->values == column.values);
      CHECK(table.find(column.name)->unit == column.unit);
    }
    const PlotDocument document = open_document(there / name);
    CHECK(document.pages.size() > 3);
    CHECK_THAT(document.about_run(2), Contains("Run 2: done"));
    CHECK(document.files_of_run(2).empty());
  }
  std::ofstream(there / "broken.csv") << "run,exit,a,message\n1,0\n";
  CHECK_THROWS_WITH(open_document(there / "broken.csv"), Contains("line 2 does not have 4 fields"));
  std::ofstream(there / "broken.h5") << "no HDF5";
  CHECK_THROWS_WITH(open_document(there / "broken.h5"), Contains("it is not an HDF5 file"));
  fs::create_directory(there / "new.study");
  std::ofstream(there / "new.study" / "tasks.jsonl") << "";
  CHECK_THROWS_WITH(open_document(there / "new.study"), Contains("adore study report"));
}
