#include "adrplot/channel_tree.hpp"
#include "adrplot/csv_document.hpp"
#include "adrplot/formula_dialog.hpp"
#include "adrplot/h5_document.hpp"
#include "adrplot/plot_window.hpp"
#include "adrplot/session.hpp"
#include "adrplot/statistics_table.hpp"
#include "base/errors.hpp"
#include "core/results/synthetic.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/page_export.hpp"
#include "desktop/run_link.hpp"
#include "results/results_h5.hpp"
#include "support/bytes.hpp"
#include "support/qt_app.hpp"
#include "support/synthetic_results.hpp"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QTableView>
#include <QTest>
#include <QTreeView>
#include <QTreeWidget>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>

/// All channels of a run: files, tree, user-defined charts, formulas, statistics, sessions.
using namespace adore;
using namespace adore::adrplot;
using namespace adore::testing;
using Catch::Contains;
using desktop::ChartView;

namespace {

constexpr long kSteps = 400;

/// A run with all channels in a folder.
struct H5Run {
  H5Run() {
    results::ChannelRecorder recorder(bearing, deck::UnitSystem::SI, channel_table());
    results::H5Writer h5 =
        results::H5Writer::create(folder / "RESULTS.h5", bearing, channel_table());
    for (long step = 0; step <= kSteps; ++step) {
      scene::Snapshot snapshot = make_snapshot(bearing, step);
      snapshot.time = 1e-5 * static_cast<double>(step);
      for (std::size_t i = 0; i < snapshot.elements.size(); ++i) {
        auto& element = snapshot.elements[i];
        element.theta_dot = 100.0 + static_cast<double>(i);
        element.race[0].load = 50.0 * static_cast<double>(i + 1) + static_cast<double>(step);
        element.race[1].load = 1000.0 + static_cast<double>(i);
      }
      h5.write(recorder.record(snapshot));
    }
    h5.close();
  }
  [[nodiscard]] std::filesystem::path path() const { return folder / "RESULTS.h5"; }
  TemporaryFolder folder;
  bearing::Bearing bearing = make_bearing();
};

int page_titled(const PlotDocument& document, const std::string& title) {
  for (std::size_t p = 0; p < document.pages.size(); ++p)
    if (document.pages[p].title == title) return static_cast<int>(p) + 1;
  FAIL("no page " << title);
  return 0;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

/// Channels of the tree whose path contains all words.
std::vector<QModelIndex> leaves(QTreeView& tree, const QModelIndex& parent = {}) {
  std::vector<QModelIndex> out;
  const QAbstractItemModel& model = *tree.model();
  for (int row = 0; row < model.rowCount(parent); ++row) {
    const QModelIndex index = model.index(row, 0, parent);
    if (ChannelModel::refOf(index)) out.push_back(index);
    for (const QModelIndex& more : leaves(tree, index)) out.push_back(more);
  }
  return out;
}

QModelIndex find_leaf(QTreeView& tree, const QString& page, const QString& name) {
  for (const QModelIndex& index : leaves(tree))
    if (index.data().toString() == name && index.parent().data().toString() == page) return index;
  FAIL("no channel " << page.toStdString() << ": " << name.toStdString());
  return {};
}

struct Shown {
  Shown() {
    window.resize(1280, 800);
    window.show();
  }
  PlotWindow window;
  ChartView& view = window.view();
  QTreeView& tree = *window.findChild<QTreeView*>("channels");
  QLineEdit& filter = *window.findChild<QLineEdit*>("channelFilter");

  [[nodiscard]] const desktop::ChartPage& page() { return view.chartScene().page(); }
  [[nodiscard]] QString message() const {
    const auto* box = window.findChild<QMessageBox*>("message");
    return box != nullptr ? box->text() : QString();
  }
  /// A channel by the title of its page and its own name.
  QModelIndex find(const QString& page, const QString& name) {
    filter.setText(page);
    return find_leaf(tree, page, name);
  }
  void drop(QMimeData* data, std::optional<std::size_t> panel) {
    const std::unique_ptr<QMimeData> owned(data);
    const QPointF place =
        panel ? view.chartScene().plotAreas().at(*panel).center() : QPointF(5.0, 5.0);
    const QPoint at = view.mapFromScene(place);
    QDragEnterEvent enter(at, Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view.viewport(), &enter);
    REQUIRE(enter.isAccepted());
    QDropEvent event(at, Qt::CopyAction, data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view.viewport(), &event);
  }
  void dropChannel(const QString& page, const QString& name, std::optional<std::size_t> panel) {
    drop(tree.model()->mimeData({find(page, name)}), panel);
  }
  void dropCurve(std::size_t panel, int curve, std::optional<std::size_t> target) {
    auto* data = new QMimeData;
    data->setData(ChartView::kCurveMime, QByteArray::number(static_cast<qulonglong>(panel)) + ' ' +
                                             QByteArray::number(curve));
    drop(data, target);
  }
};

}  // namespace

TEST_CASE("h5_document: every channel of the file → a page with its values", "[unit][h5]") {
  const H5Run run;
  const results::H5Reader reader(run.path());
  const PlotDocument document = open_h5(run.path(), {}, kMostValues);
  std::size_t curves = 0, expected = 0;
  for (const auto& info : reader.channels()) expected += info.size();
  for (const auto& page : document.pages) {
    REQUIRE(page.curves.size() == page.panels.size());
    CHECK(page.panels.size() <= 3);
    CHECK_FALSE(page.group.empty());
    for (const auto& panel : page.curves) curves += panel.size();
  }
  CHECK(curves == expected);

  const int number = page_titled(document, "Contact load");
  const desktop::ChartPage page = document.build(number, {Abscissa::Time, {}});
  REQUIRE(page.panels.size() == 2);
  CHECK(page.panels[0].title == "Contact load, outer race");
  CHECK(page.panels[0].unit == "N");
  REQUIRE(page.panels[0].curves.size() == static_cast<std::size_t>(run.bearing.balls().count));
  CHECK(page.panels[0].curves[2].name == "element 3");
  CHECK(page.panels[0].curves[2].y.at(10) == Approx(160.0));
  CHECK(page.panels[1].curves[2].y.at(10) == Approx(1002.0));
  REQUIRE(page.x.size() == kSteps + 1);
  CHECK(page.x.at(10) == Approx(1e-4));
  // Speeds are in rpm as in the classic files.
  const desktop::ChartPage speed =
      document.build(page_titled(document, "Orbital velocity"), {Abscissa::Time, {}});
  CHECK(speed.panels[0].unit == "rpm");
  CHECK(speed.panels[0].curves[1].y.at(0) == Approx(101.0 * 60.0 / (2.0 * 3.14159265358979)));
}

TEST_CASE("h5_document: more values than fit → every n-th step, with a note", "[unit][h5]") {
  const H5Run run;
  const PlotDocument document = open_h5(run.path(), {}, 2000);
  const desktop::ChartPage page =
      document.build(page_titled(document, "Contact load"), {Abscissa::Step, {}});
  CHECK(page.x.size() < kSteps / 2);
  CHECK_THAT(page.note, Contains("one of every"));
  CHECK(page.panels[0].curves[0].y.back() == Approx(50.0 + page.x.back()));
  const desktop::ChartPage part =
      open_h5(run.path(), {11, 20, 2}, kMostValues)
          .build(page_titled(document, "Contact load"), {Abscissa::Step, {}});
  CHECK(part.x == std::vector<double>{10.0, 12.0, 14.0, 16.0, 18.0});
  CHECK_THROWS_WITH(open_h5(run.path(), {5000, 6000, 1}, kMostValues), Contains("401 stored"));
}

TEST_CASE("h5_document: damaged file → message, open files stay", "[gui][h5]") {
  test::use_qt();
  const H5Run run;
  Shown shown;
  REQUIRE(shown.window.openFile(run.path()));
  const auto damaged = run.folder / "damaged.h5";
  write(damaged, "not HDF5 at all");
  CHECK_FALSE(shown.window.openFile(damaged));
  CHECK(shown.message().contains("damaged.h5"));
  CHECK(shown.window.fileCount() == 1);
  CHECK_FALSE(shown.page().panels.empty());
}

TEST_CASE("csv_document: separators, units, time axis, damaged rows", "[unit]") {
  const TemporaryFolder folder;
  const auto path = folder / "signal.csv";
  std::string text = "Index;time [s];\"force, radial [N]\";note\r\n";
  for (int i = 0; i < 200; ++i)
    text += std::to_string(i) + ";" + std::to_string(i * 1e-3) + ";" +
            std::to_string(std::sin(2.0 * 3.14159265358979 * 0.1 * i)) + ";ok\r\n";
  write(path, text + "cut;1\n");
  const PlotDocument document = open_csv(path);
  CHECK(document.pages.size() == 3);
  CHECK_THAT(document.note, Contains("row"));
  const int number = page_titled(document, "force, radial");
  const desktop::ChartPage page = document.build(number, {});
  CHECK(page.x_title == "Time");
  CHECK(page.x_unit == "s");
  CHECK(page.panels[0].unit == "N");
  CHECK(page.panels[0].curves[0].y.size() == 200);
  PageOptions spectrum;
  spectrum.domain = Domain::Spectrum;
  const desktop::ChartPage lines = document.build(number, spectrum);
  const auto& y = lines.panels.at(0).curves.at(0).y;
  CHECK(lines.x[static_cast<std::size_t>(std::max_element(y.begin(), y.end()) - y.begin())] ==
        Approx(100.0));
  CHECK(document.build(page_titled(document, "note"), {}).panels[0].message.find("no numbers") !=
        std::string::npos);

  const auto plain = folder / "plain.csv";
  write(plain, "1,2\n2,4\n3,9\n");
  CHECK(open_csv(plain).build(1, {}).panels[0].curves[0].y == std::vector<double>{2.0, 4.0, 9.0});
  const auto bad = folder / "bad.csv";
  write(bad, "only text\nand more\n");
  CHECK_THROWS_WITH(open_csv(bad), Contains("bad.csv") && Contains("one column"));
}

TEST_CASE("csv_document: exported page → the same values again", "[unit]") {
  const TemporaryFolder folder;
  const PlotDocument document = make_document(test::synthetic_sol(results::SolKind::Element));
  const desktop::ChartPage page = document.build(6, {Abscissa::Time, {}});
  const auto path = folder / "page.csv";
  write(path, desktop::page_csv(page));
  const desktop::ChartPage again = open_csv(path).build(1, {});
  CHECK(again.x == page.x);
  CHECK(again.panels[0].curves[0].y == page.panels[0].curves[0].y);
}

TEST_CASE("channel tree: filter → channels with all words, of any file", "[gui][h5]") {
  test::use_qt();
  const H5Run run;
  Shown shown;
  REQUIRE(shown.window.openFile(run.path()));
  shown.window.addFile(test::synthetic_sol(results::SolKind::Element));
  const std::size_t all = leaves(shown.tree).size();
  CHECK(all > 200);
  shown.filter.setText("contact load outer \"no such\"");
  CHECK(leaves(shown.tree).empty());
  shown.filter.setText("h5 LOAD outer");
  CHECK_FALSE(leaves(shown.tree).empty());
  for (const QModelIndex& index : leaves(shown.tree)) {
    const QString path = index.data(ChannelModel::kPathRole).toString();
    for (const char* word : {"h5", "load", "outer"})
      CHECK(path.contains(word, Qt::CaseInsensitive));
  }
  CHECK(leaves(shown.tree).size() < all / 2);
  shown.filter.clear();
  CHECK(leaves(shown.tree).size() == all);
  // A channel that is activated becomes a chart.
  const QModelIndex load = shown.find("Contact load", "Contact load, outer race, element 3");
  shown.tree.setCurrentIndex(load);
  emit shown.tree.activated(load);
  REQUIRE(shown.page().panels.size() == 1);
  CHECK(shown.page().panels[0].curves[0].y.at(10) == Approx(160.0));
}

TEST_CASE("channel tree: drop on a panel → its curve there; other units → panel of its own",
          "[gui][h5]") {
  test::use_qt();
  const H5Run run;
  Shown shown;
  REQUIRE(shown.window.openFile(run.path()));
  shown.dropChannel("Contact load", "Contact load, outer race, element 1", std::nullopt);
  REQUIRE(shown.page().panels.size() == 1);
  shown.dropChannel("Contact load", "Contact load, inner race, element 1", 0);
  REQUIRE(shown.page().panels.size() == 1);
  CHECK(shown.page().panels[0].curves.size() == 2);
  shown.dropChannel("Orbital velocity", "element 2", 0);
  REQUIRE(shown.page().panels.size() == 2);
  CHECK(shown.page().panels[1].unit == "rpm");
  // On a page of a file: a new chart with the curves of the page.
  shown.window.findChild<QTreeWidget*>("pages")->setCurrentItem(
      shown.window.findChild<QTreeWidget*>("pages")->topLevelItem(0)->child(0));
  const std::size_t panels = shown.page().panels.size();
  shown.dropChannel("Contact load", "Contact load, outer race, element 1", 0);
  CHECK(shown.window.fileCount() == 3);
  CHECK(shown.page().panels.size() == panels + 1);
}

TEST_CASE("chart: curve dragged to another panel → drawn there; other unit → refused", "[gui]") {
  test::use_qt();
  Shown shown;
  shown.window.addFile(test::synthetic_sol(results::SolKind::Race));
  shown.window.showPage(2);  // applied forces x, y, z
  REQUIRE(shown.page().panels.size() == 3);
  const std::vector<double> x = shown.page().panels[0].curves[0].y;
  shown.dropCurve(0, -1, 1);
  CHECK(shown.window.fileCount() == 2);
  REQUIRE(shown.page().panels.size() == 2);
  REQUIRE(shown.page().panels[0].curves.size() == 2);
  CHECK(shown.page().panels[0].curves[0].y == x);
  // Within a user-defined chart, and to a new panel.
  shown.dropCurve(0, 0, 1);
  CHECK(shown.window.fileCount() == 2);
  CHECK(shown.page().panels.size() == 2);
  shown.dropCurve(shown.page().panels[0].curves.size() > 1 ? 0 : 1, 0, std::nullopt);
  CHECK(shown.page().panels.size() == 3);
  shown.window.addFile(test::synthetic_sol(results::SolKind::Element));
  shown.window.showPage(6);  // load, angle
  const std::size_t before = shown.page().panels.size();
  REQUIRE(shown.page().panels[0].unit != shown.page().panels[2].unit);
  shown.dropCurve(0, 0, 2);
  CHECK(shown.page().panels.size() == before);
  CHECK(shown.window.fileCount() == 3);
}

TEST_CASE("formula channel: dialog → computed curve with spectrum, in the tree", "[gui][h5]") {
  test::use_qt();
  const H5Run run;
  Shown shown;
  REQUIRE(shown.window.openFile(run.path()));
  shown.tree.setCurrentIndex(shown.find("Contact load", "Contact load, outer race, element 1"));
  shown.window.askForFormula();
  auto* dialog = shown.window.findChild<FormulaDialog*>("formulaDialog");
  REQUIRE(dialog);
  auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  CHECK_FALSE(ok->isEnabled());
  dialog->findChild<QLineEdit*>("formula")->setText("sqrt(a^2 + b^2)");
  CHECK(dialog->findChild<QLabel*>("result")->text().contains("\"b\""));
  dialog->findChild<QLineEdit*>("channelFilter")->setText("Contact load inner element");
  auto* tree = dialog->findChild<QTreeView*>("channels");
  const QModelIndex inner = find_leaf(*tree, "Contact load", "Contact load, inner race, element 1");
  tree->setCurrentIndex(inner);
  emit tree->activated(inner);
  dialog->findChild<QLineEdit*>("title")->setText("Both loads");
  dialog->findChild<QLineEdit*>("unit")->setText("N");
  REQUIRE(ok->isEnabled());
  ok->click();
  REQUIRE(shown.page().panels.size() == 1);
  CHECK(shown.page().panels[0].title == "Both loads");
  CHECK(shown.page().panels[0].unit == "N");
  for (const std::size_t i : {0U, 7U, 300U})
    CHECK(shown.page().panels[0].curves[0].y.at(i) ==
          Approx(std::hypot(50.0 + static_cast<double>(i), 1000.0)));
  CHECK_FALSE(shown.find("Both loads", "Both loads").data().toString().isEmpty());
  shown.window.setDomain(Domain::Spectrum);
  CHECK(shown.page().x_unit == "Hz");
}

TEST_CASE("statistics table: values of the visible range, copied and as CSV", "[gui]") {
  test::use_qt();
  Shown shown;
  shown.window.addFile(test::synthetic_sol(results::SolKind::Element));
  shown.window.showPage(6);
  shown.window.showStatistics(true);
  CHECK(shown.window.findChild<QDockWidget*>("statisticsDock")->toggleViewAction()->text() ==
        "&Statistics Table");
  QCoreApplication::processEvents();
  auto* table = shown.window.findChild<QTableView*>("statistics");
  const auto& page = shown.page();
  const auto rows = statistics_rows(page, page.x.front(), page.x.back());
  REQUIRE(table->model()->rowCount() == static_cast<int>(rows.size()));
  const auto& load = page.panels[0].curves[0].y;
  double mean = 0.0, low = load[0], high = load[0];
  for (const double v : load) mean += v / static_cast<double>(load.size());
  for (const double v : load) low = std::min(low, v), high = std::max(high, v);
  const double factor = rows[0].unit == "kN" ? 1e3 : 1.0;
  CHECK(rows[0].values.lowest * factor == Approx(low));
  CHECK(rows[0].values.highest * factor == Approx(high));
  CHECK(rows[0].values.mean * factor == Approx(mean).epsilon(0.01));
  for (QAction* action : table->actions())
    if (action->text().contains("Copy")) action->trigger();
  const QStringList lines = QGuiApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
  REQUIRE(lines.size() == static_cast<int>(rows.size()) + 1);
  CHECK(lines[1].split('\t').size() == lines[0].split('\t').size());
  CHECK(lines[1].split('\t')[3].toDouble() == Approx(rows[0].values.lowest).epsilon(1e-12));
  CHECK(statistics_text(rows, ',').find("\"Contact load, outer race\"") != std::string::npos);
  // Between cursors.
  shown.view.setCursorAbscissa(0, page.x[10]);
  shown.view.setCursorAbscissa(1, page.x[20]);
  CHECK(table->model()->index(0, 2).data().toString() == "11");
  // A hidden curve has no row.
  shown.view.toggleCurve(0, 0);
  CHECK(table->model()->rowCount() < static_cast<int>(rows.size()));
}

TEST_CASE("statistics_rows: sine → closed forms", "[unit]") {
  desktop::ChartPage page;
  for (int i = 0; i <= 1000; ++i) page.x.push_back(i * 1e-3);
  desktop::ChartCurve wave{"", {}, {}};
  for (const double t : page.x) wave.y.push_back(5.0 + 2.0 * std::sin(2.0 * M_PI * 10.0 * t));
  page.panels.push_back({"Load", "N", {wave}, false});
  const StatisticsRow row = statistics_rows(page, 0.0, 1.0).at(0);
  CHECK(row.values.mean == Approx(5.0));
  CHECK(row.deviation == Approx(std::sqrt(2.0)).epsilon(1e-3));
  CHECK(row.values.rms == Approx(std::sqrt(27.0)).epsilon(1e-3));
  CHECK(row.values.highest - row.values.lowest == Approx(4.0).epsilon(1e-3));
}

TEST_CASE("session: window → file → the same charts, formulas and view", "[gui][h5]") {
  test::use_qt();
  const H5Run run;
  const auto path = run.folder / "work.adrplot";
  desktop::ChartPage chart, formula;
  {
    Shown shown;
    REQUIRE(shown.window.openFile(run.path(), {}));
    FormulaChannel channel{"Twice", "2*x", "N", {}};
    const PlotDocument document = open_h5(run.path(), {}, kMostValues);
    channel.inputs.push_back({"x", std::make_shared<PlotDocument>(document),
                              page_titled(document, "Contact load"), 0, "element 2"});
    shown.window.addFormula(channel);
    formula = shown.page();
    shown.dropChannel("Contact load", "Contact load, outer race, element 1", std::nullopt);
    shown.dropChannel("Contact load", "Contact load, inner race, element 3", std::nullopt);
    shown.dropChannel("Twice", "Twice", 0);
    shown.window.setAbscissa(Abscissa::Time);
    chart = shown.page();
    REQUIRE(chart.panels.size() == 2);
    REQUIRE(shown.window.saveSession(QString::fromStdString(path.string())));
  }
  Shown shown;
  REQUIRE(shown.window.openFile(path));
  CHECK(shown.message().isEmpty());
  CHECK(shown.window.fileCount() == 3);
  const desktop::ChartPage& again = shown.page();
  CHECK(again.x == chart.x);
  CHECK(again.x_unit == "s");
  REQUIRE(again.panels.size() == chart.panels.size());
  for (std::size_t p = 0; p < chart.panels.size(); ++p) {
    REQUIRE(again.panels[p].curves.size() == chart.panels[p].curves.size());
    for (std::size_t c = 0; c < chart.panels[p].curves.size(); ++c)
      CHECK(again.panels[p].curves[c].y == chart.panels[p].curves[c].y);
  }
  // Paths are relative: the folder can be moved.
  const std::string text = test::bytes_of(path);
  CHECK_THAT(text,
             Contains("\"RESULTS.h5\"") && !Contains((run.folder / "").parent_path().string()));
}

TEST_CASE("session: missing, damaged and newer files → message, nothing lost", "[gui][h5]") {
  test::use_qt();
  const H5Run run;
  const auto path = run.folder / "work.adrplot";
  {
    Shown shown;
    REQUIRE(shown.window.openFile(run.path()));
    shown.dropChannel("Contact load", "Contact load, outer race, element 1", std::nullopt);
    REQUIRE(shown.window.saveSession(QString::fromStdString(path.string())));
  }
  const std::string text = test::bytes_of(path);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string out = text;
    REQUIRE(out.find(from) != std::string::npos);
    out.replace(out.find(from), from.size(), to);
    return out;
  };
  struct Case {
    std::string text, message;
    bool opens;
  };
  for (const Case& one :
       {Case{with("\"adrplot_session\": 1", "\"adrplot_session\": 9"), "newer version", false},
        Case{text.substr(0, text.size() / 2), "not valid JSON", false},
        Case{"{}", "not a session", false}, Case{with("RESULTS.h5", "GONE.h5"), "GONE.h5", true},
        Case{with("\"page\": ", "\"page\": 9"), "left out", true}}) {
    INFO(one.message);
    Shown shown;
    shown.window.addFile(test::synthetic_sol(results::SolKind::Element));
    const auto changed = run.folder / "changed.adrplot";
    write(changed, one.text);
    CHECK(shown.window.openFile(changed) == one.opens);
    CHECK(shown.message().contains(QString::fromStdString(one.message)));
    CHECK(shown.window.fileCount() >= 1);
    CHECK(test::bytes_of(changed) == one.text);
  }
}

TEST_CASE("axes: nearly constant values → base value for positions alone, on all pages", "[gui]") {
  test::use_qt();
  int positions = 0, others = 0;
  for (const results::SolKind kind : {results::SolKind::Element, results::SolKind::Cage,
                                      results::SolKind::Race, results::SolKind::Power}) {
    results::SolFile file = test::synthetic_sol(kind);
    for (std::size_t i = 0; i < file.steps.size(); ++i)
      for (double& v : file.steps[i].values)
        v = 123.456 * (1.0 + 1e-4 * std::sin(0.1 * static_cast<double>(i)));
    const PlotDocument document = make_document(std::move(file));
    for (std::size_t p = 0; p < document.pages.size(); ++p) {
      if (document.pages[p].kind != PageKind::History) continue;
      const desktop::ChartPage page = document.build(static_cast<int>(p) + 1, {});
      for (const desktop::ChartPanel& panel : page.panels) {
        desktop::Extent extent;
        for (const auto& curve : panel.curves)
          for (const double v : curve.y) extent.include(v);
        if (extent.empty()) continue;
        const desktop::AxisScale axis = desktop::value_axis(extent.low, extent.high, panel.unit, 4);
        const bool position = panel.unit == "m" || panel.unit == "deg";
        INFO(page.title << ", " << panel.title << " [" << panel.unit << "]");
        CHECK(axis.offset_text.empty() != position);
        (position ? positions : others) += 1;
        // The values use the axis, and numbers fit next to the panel.
        const double used =
            (axis.shown(extent.high) - axis.shown(extent.low)) / (axis.max - axis.min);
        CHECK(used > 0.35);
        for (const desktop::AxisTick& tick : desktop::axis_ticks(axis))
          CHECK(tick.text.size() <= 9);
      }
    }
  }
  CHECK(positions > 5);
  CHECK(others > 20);
}

TEST_CASE("explorer: element selected in another window → its curves are shown and thick",
          "[gui][adrplot]") {
  test::use_qt();
  const H5Run run;
  Shown shown;
  REQUIRE(shown.window.openFile(run.path()));
  shown.window.showPage(page_titled(open_document(run.path()), "Contact load"));
  const auto thick = [&] {
    std::vector<std::string> out;
    for (const desktop::ChartPanel& panel : shown.page().panels)
      for (const desktop::ChartCurve& curve : panel.curves)
        if (curve.heavy && !curve.hidden) out.push_back(curve.name);
    return out;
  };
  CHECK(thick().empty());
  desktop::RunLink other(nullptr);
  other.join(QString::fromStdString(run_folder(run.path()).string()));
  const int last = run.bearing.balls().count;
  for (const int element : {2, last}) {
    other.tell({{}, element});
    const std::string name = "element " + std::to_string(element);
    REQUIRE(QTest::qWaitFor([&] { return !thick().empty() && thick().front() == name; }, 10000));
    for (const std::string& curve : thick()) CHECK(curve == name);
  }
  // Also on the next page.
  const std::vector<std::string> before = thick();
  shown.window.nextPage();
  shown.window.previousPage();
  CHECK(thick() == before);
}
