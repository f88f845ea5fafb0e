#include "adrplot/plot_document.hpp"
#include "adrplot/render.hpp"
#include "base/errors.hpp"
#include "base/write_folder.hpp"
#include "desktop/chart_scene.hpp"
#include "desktop/static_pages.hpp"
#include "desktop/theme.hpp"
#include "support/qt_app.hpp"

#include <QGraphicsEllipseItem>
#include <QImage>
#include <QTemporaryDir>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

using namespace adore;
namespace unit = results::unit;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Four elements, the last without inner load, and a stiffness table of three speeds.
results::StaticTables four_elements(results::UnitSystem units) {
  results::StaticTables out{"four", "ball", units, {}};
  results::StaticTable elements{"elements", {}};
  const double quarter = 0.5 * std::numbers::pi;
  elements.add("azimuth", unit::kAngle, {0.0, quarter, 2.0 * quarter, 3.0 * quarter});
  for (const std::string race : {"outer ", "inner "}) {
    elements.add(race + "load", unit::kForce, {400.0, 300.0, 200.0, 300.0});
    elements.add(race + "contact angle", unit::kAngle, {0.5, 0.45, 0.4, kNone});
    elements.add(race + "pressure", unit::kPressure, {1.2e9, 1.1e9, 1e9, 0.0});
  }
  out.tables.push_back(std::move(elements));
  results::StaticTable stiffness{"stiffness over speed", {}};
  stiffness.add("inner speed", unit::kRotation, {0.0, 500.0, 1000.0});
  for (const char* const k : {"Fx/x", "Fy/y", "Fz/z"}) {
    stiffness.add(k, unit::kStiffness, {1e8, 1.1e8, 1.2e8});
    stiffness.add(std::string(k) + " by difference", unit::kStiffness, {1.01e8, 1.11e8, 1.21e8});
  }
  out.tables.push_back(std::move(stiffness));
  return out;
}

std::filesystem::path write_run(const QTemporaryDir& folder, const results::StaticTables& tables) {
  nlohmann::ordered_json run;
  run["run"] = tables.run_id;
  run["quasi_static"] = results::to_json(tables);
  const std::filesystem::path path = folder.filePath("RUN.json").toStdString();
  write_file_atomically(path, run.dump(1));
  return path;
}

}  // namespace

TEST_CASE("quasi-static tables: written to RUN.json and read → unchanged", "[unit]") {
  const QTemporaryDir folder;
  const results::StaticTables written = four_elements(results::UnitSystem::English);
  const results::StaticTables read = results::read_static_tables(write_run(folder, written));
  CHECK(read.units == results::UnitSystem::English);
  CHECK(read.bearing == "ball");
  REQUIRE(read.tables.size() == 2);
  for (std::size_t t = 0; t < 2; ++t) {
    REQUIRE(read.tables[t].columns.size() == written.tables[t].columns.size());
    for (std::size_t c = 0; c < read.tables[t].columns.size(); ++c) {
      const auto& a = read.tables[t].columns[c];
      const auto& b = written.tables[t].columns[c];
      CHECK(a.name == b.name);
      CHECK(a.unit == b.unit);
      REQUIRE(a.values.size() == b.values.size());
      for (std::size_t i = 0; i < a.values.size(); ++i) {
        INFO(a.name << " " << i);
        // Degrees and back cost a rounding.
        if (std::isnan(b.values[i]))
          CHECK(std::isnan(a.values[i]));
        else
          CHECK(a.values[i] == Approx(b.values[i]).epsilon(1e-15));
      }
    }
  }
}

TEST_CASE("static pages: RUN.json without a quasi-static solution → rejected with its name",
          "[unit]") {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("RUN.json").toStdString();
  write_file_atomically(path, "{\"run\": \"x\"}");
  CHECK_THROWS_WITH(results::read_static_tables(path), Catch::Contains("mode -1"));
  write_file_atomically(path, "not json");
  CHECK_THROWS_AS(results::read_static_tables(path), InputError);
}

TEST_CASE("load rose: loads in the directions of their elements", "[unit]") {
  const auto pages = desktop::static_pages(four_elements(results::UnitSystem::SI));
  REQUIRE(pages.size() == 3);
  const auto& outer = pages[0].panels.at(0).curves.at(0);
  REQUIRE(outer.x.size() == 4);  // a value for each element, and none between them
  // Azimuth 0 is up, 90 degrees is towards -y.
  double up = -1e9, left = 1e9;
  for (std::size_t i = 0; i < outer.x.size(); ++i) {
    up = std::max(up, outer.y[i]);
    left = std::min(left, outer.x[i]);
  }
  CHECK(up == Approx(400.0));
  CHECK(left == Approx(-300.0));
  // Rows are sorted by azimuth; the element at 180 degrees stands at both ends of the turn.
  CHECK(pages[1].x == std::vector<double>{-180.0, -90.0, 0.0, 90.0, 180.0});
  const auto& load = pages[1].panels[0].curves[0].y;
  CHECK(load == std::vector<double>{200.0, 300.0, 400.0, 300.0, 200.0});
  CHECK(pages[1].points);
  // The differences do not hide the exact curve.
  CHECK_FALSE(pages[2].panels[0].curves[0].dashed);
  CHECK(pages[2].panels[0].curves[1].dashed);
}

TEST_CASE("English decks are drawn in English units", "[unit]") {
  const auto pages = desktop::static_pages(four_elements(results::UnitSystem::English));
  CHECK(pages[1].panels[0].unit == "lbf");
  CHECK(pages[1].panels[0].curves[0].y[2] == Approx(400.0 / 4.4482216152605).epsilon(1e-12));
  CHECK(pages[2].x_unit == "rpm");
}

TEST_CASE("sweep pages: quantities of one kind share a panel, missing runs → gaps", "[unit]") {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("SWEEP.csv").toStdString();
  write_file_atomically(path,
                        "appLoadX [lbf],exit,displacement_x_m,displacement_y_m,"
                        "displacement_about_y_rad,largest_pressure_Pa,life_gz_hours,message\n"
                        "500,0,1e-6,2e-6,1e-5,1e9,100,\"\"\n"
                        "750,3,,,,,,\"no equilibrium, because\"\n"
                        "1000,0,3e-6,4e-6,2e-5,1.5e9,50,\"\"\n");
  const results::SweepTable sweep = results::read_sweep(path);
  CHECK(sweep.values == std::vector<double>{500.0, 750.0, 1000.0});
  CHECK(sweep.failed == 1);
  const auto pages = desktop::sweep_pages(sweep);
  REQUIRE(pages.size() == 2);
  CHECK(pages[0].title != pages[1].title);
  CHECK(pages[1].title == "Life, Gupta-Zaretsky type over appLoadX");
  CHECK(pages[0].points);  // three runs, not a line
  CHECK(pages[0].x_title == "appLoadX");
  CHECK(pages[0].x_unit == "lbf");
  CHECK(pages[1].panels.at(0).title == "Life, Gupta-Zaretsky type");
  CHECK(pages[1].panels[0].unit == "hr");
  REQUIRE(pages[0].panels.size() == 3);
  CHECK(pages[0].panels[0].curves.size() == 2);
  CHECK(pages[0].panels[0].unit == "m");
  CHECK(pages[0].panels[2].unit == "Pa");
  CHECK(std::isnan(pages[0].panels[0].curves[1].y[1]));
  CHECK(pages[0].panels[0].curves[1].y[2] == 4e-6);
  write_file_atomically(path, "a,b\n");
  CHECK_THROWS_AS(results::read_sweep(path), InputError);
}

TEST_CASE("load rose: marks at the elements, and nothing between them", "[gui]") {
  test::use_qt();
  results::StaticTables tables = four_elements(results::UnitSystem::SI);
  for (const char* const race : {"outer load", "inner load"})
    for (results::StaticColumn& column : tables.tables[0].columns)
      if (column.name == race) column.values = {400.0, 400.0, 0.0, 0.0};
  desktop::ChartScene scene;
  scene.setPage(desktop::static_pages(tables)[0]);
  // Marks of both races at the four elements, two of them in the center.
  std::set<std::pair<int, int>> places;
  int marks = 0;
  for (const QGraphicsItem* item : scene.items())
    if (const auto* mark = dynamic_cast<const QGraphicsEllipseItem*>(item)) {
      ++marks;
      const QPointF at = mark->rect().center();
      places.emplace(static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y())));
    }
  CHECK(marks == 8);
  REQUIRE(places.size() == 3);
  // With two loaded elements nothing connects them: four values per race, none between.
  for (const desktop::ChartCurve& curve : scene.page().panels[0].curves) CHECK(curve.x.size() == 4);
}

TEST_CASE("load rose: a spoke goes from the center to each load, and nowhere else", "[gui]") {
  test::use_qt();
  results::StaticTables tables = four_elements(results::UnitSystem::SI);
  // Elements at different angles, one of them without load; the other race has no load.
  const std::vector<double> azimuth{0.2, 1.9, 3.0, 5.1}, load{400.0, 250.0, 0.0, 310.0};
  for (results::StaticColumn& column : tables.tables[0].columns) {
    if (column.name == "azimuth") column.values = azimuth;
    if (column.name == "outer load") column.values = load;
    if (column.name == "inner load") column.values = {0.0, 0.0, 0.0, 0.0};
  }
  for (const QSize size : {QSize(700, 450), QSize(1280, 800)}) {
    desktop::ChartScene scene;
    scene.setTheme(desktop::theme(desktop::ThemeKind::Light));
    scene.setPageSize(size);
    scene.setPage(desktop::static_pages(tables)[0]);
    const QImage image = scene.image(size);
    const QColor colour = desktop::theme(desktop::ThemeKind::Light).curves[0];
    const auto inked = [&](QPointF at) {  // within a pixel of it
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y) {
          const QColor seen = image.pixelColor(at.toPoint() + QPoint(x, y));
          if (std::abs(seen.red() - colour.red()) + std::abs(seen.green() - colour.green()) +
                  std::abs(seen.blue() - colour.blue()) <
              120)
            return true;
        }
      return false;
    };
    // Scale and center from the axes.
    const auto centre = scene.planePosition(0.0, 0.0), right = scene.planePosition(100.0, 0.0);
    REQUIRE(centre);
    REQUIRE(right);
    const double pixels = (right->x() - centre->x()) / 100.0;  // per newton
    REQUIRE(pixels > 0.1);
    const auto place = [&](double angle, double newtons) {
      return *centre + pixels * newtons * QPointF(-std::sin(angle), -std::cos(angle));
    };
    for (std::size_t i = 0; i < load.size(); ++i)
      for (double part = 0.15; load[i] > 0.0 && part <= 1.0; part += 0.05) {
        INFO("element " << i << " at " << part << " of its load, " << size.width() << " wide");
        CHECK(inked(place(azimuth[i], part * load[i])));
      }
    // Around the center and farther out there are as many spokes as there are loads so large.
    for (const double newtons : {100.0, 280.0, 350.0, 450.0}) {
      int spokes = 0;
      bool before = inked(place(-0.5, newtons));
      for (double angle = -0.5; angle < 5.78; angle += 0.5 / (pixels * newtons)) {
        const bool now = inked(place(angle, newtons));
        spokes += now && !before ? 1 : 0;
        before = now;
      }
      INFO(newtons << " N, " << size.width() << " wide");
      CHECK(spokes ==
            std::count_if(load.begin(), load.end(), [newtons](double q) { return q > newtons; }));
    }
  }
}

TEST_CASE("sweep pages: runs without steps → note", "[unit]") {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("SWEEP.csv").toStdString();
  const auto note = [&](const char* first, const char* second) {
    write_file_atomically(path, std::string("appLoadZ [N],exit,time_s,largest_contact_load_N,"
                                            "mean_cage_ratio,peak_load_N,message\n500,0,") +
                                    first + ",100,,100,\"\"\n1000,0," + second +
                                    ",200,,200,\"\"\n");
    return desktop::sweep_pages(results::read_sweep(path)).front().note;
  };
  CHECK_THAT(note("0", "0"), Catch::Contains("2 of 2 runs had no motion"));
  CHECK_THAT(note("0", "0.1"), Catch::Contains("1 of 2 runs had no motion"));
  CHECK(note("0.2", "0.1").empty());
}

namespace {

/// A small cut: straight lines for races, one contact over the edge, one edge not given.
results::StaticTables with_cut(results::UnitSystem units) {
  results::StaticTables out = four_elements(units);
  results::StaticTable row{"cut", {}};
  row.add("element", unit::kPure, {3.0});
  row.add("azimuth", unit::kAngle, {1.0});
  row.add("outer load", unit::kForce, {1234.0});
  row.add("inner load", unit::kForce, {1200.0});
  row.add("outer -x margin", unit::kLength, {0.0015});
  row.add("outer +x margin", unit::kLength, {-0.0002});
  row.add("inner -x margin", unit::kLength, {kNone});
  row.add("inner +x margin", unit::kLength, {0.0});
  out.tables.push_back(std::move(row));
  const auto line = [&](const char* name, std::vector<double> x, std::vector<double> r) {
    results::StaticTable table{name, {}};
    table.add("x", unit::kLength, std::move(x));
    table.add("r", unit::kLength, std::move(r));
    out.tables.push_back(std::move(table));
  };
  line("cut outer race", {-0.006, 0.006}, {0.024, 0.024});
  line("cut inner race", {-0.006, 0.006}, {0.016, 0.016});
  line("cut element", {-0.004, 0.0, 0.004, 0.0, -0.004}, {0.02, 0.024, 0.02, 0.016, 0.02});
  line("cut outer contact", {-0.001, 0.001}, {0.024, 0.024});
  line("cut inner contact", {-0.001, 0.001}, {0.016, 0.016});
  return out;
}

}  // namespace

TEST_CASE("the cut page labels every edge of the contacts with its distance", "[unit]") {
  const auto pages = desktop::static_pages(with_cut(results::UnitSystem::SI));
  const auto page = std::find_if(pages.begin(), pages.end(), [](const auto& p) {
    return p.title == "Contact ellipses and groove edges";
  });
  REQUIRE(page != pages.end());
  CHECK(page->equal_axes);
  REQUIRE(page->panels.size() == 1);
  CHECK(page->panels[0].curves.size() == 5);
  CHECK(page->panels[0].curves[0].x == std::vector<double>{-0.006, 0.006});
  REQUIRE(page->labels.size() == 4);
  CHECK(page->labels[0].text == "1.5 mm to the edge");
  CHECK(page->labels[0].x == -0.001);
  CHECK(page->labels[1].text == "200 µm beyond the edge");
  CHECK(page->labels[2].text == "groove edge not given");
  CHECK(page->labels[3].text == "reaches the edge");
  CHECK_THAT(page->note, Catch::Contains("number 3") && Catch::Contains("1.234 kN"));
  // English decks in inches.
  for (const auto& p : desktop::static_pages(with_cut(results::UnitSystem::English)))
    if (!p.labels.empty()) {
      CHECK(p.panels[0].unit == "in");
      CHECK(p.panels[0].curves[0].x[1] == Approx(0.006 / 0.0254));
    }
}

TEST_CASE("the cut is drawn with equal scales both ways", "[gui]") {
  test::use_qt();
  const QTemporaryDir folder;
  const auto file = write_run(folder, with_cut(results::UnitSystem::SI));
  adrplot::RenderOptions options;
  options.folder = folder.filePath("pictures").toStdString();
  options.page = 3;
  const auto pictures = adrplot::render_plots({file}, options);
  REQUIRE(pictures.size() == 1);
  const QImage image(QString::fromStdString(pictures[0].string()));
  // The thick contacts are 2 mm long and 8 mm apart.
  const auto& theme = desktop::theme(desktop::ThemeKind::Light);
  const auto box = [&](const QColor& colour) {
    QRect out;
    for (int y = 115; y < image.height(); ++y)  // below the legend
      for (int x = 0; x < image.width(); ++x)
        if (image.pixel(x, y) == colour.rgb()) out |= QRect(x, y, 1, 1);
    return out;
  };
  const QRect outer = box(theme.curves[3]), inner = box(theme.curves[4]);
  REQUIRE_FALSE(outer.isEmpty());
  REQUIRE_FALSE(inner.isEmpty());
  const double apart = inner.center().y() - outer.center().y();
  CHECK(apart > 300.0);
  // Two pixels of round caps and dots at the ends.
  CHECK(outer.width() == Approx(apart / 4.0).margin(8.0));
}

TEST_CASE("quasi-static pages become pictures with curves in them", "[gui]") {
  test::use_qt();
  const QTemporaryDir folder;
  const auto file = write_run(folder, four_elements(results::UnitSystem::SI));
  adrplot::RenderOptions options;
  options.folder = folder.filePath("pictures").toStdString();
  const auto pictures = adrplot::render_plots({file}, options);
  REQUIRE(pictures.size() == 3);
  for (const auto& picture : pictures) {
    const QImage image(QString::fromStdString(picture.string()));
    REQUIRE_FALSE(image.isNull());
    std::set<QRgb> colours;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) colours.insert(image.pixel(x, y));
    // Both curves in their own colors.
    const auto& theme = desktop::theme(desktop::ThemeKind::Light);
    CHECK(colours.count(theme.curves[0].rgb()) == 1);
    CHECK(colours.count(theme.curves[1].rgb()) == 1);
  }
  options.page = 9;
  CHECK_THROWS_WITH(adrplot::render_plots({file}, options), Catch::Contains("pages are 1 to 3"));
}

TEST_CASE("a value between gaps is drawn as a point, and every element of a bearing is", "[gui]") {
  test::use_qt();
  const auto points = [](const desktop::ChartPage& page) {
    desktop::ChartScene scene;
    scene.setPage(page);
    int count = 0;
    for (const QGraphicsItem* item : scene.items())
      count += dynamic_cast<const QGraphicsEllipseItem*>(item) != nullptr ? 1 : 0;
    return count;
  };
  desktop::ChartPage page;
  page.x = {0.0, 1.0, 2.0, 3.0, 4.0};
  page.panels = {{"Angle", "deg", {{"inner race", {kNone, 5.0, kNone, 6.0, 7.0}, {}}}}};
  CHECK(points(page) == 1);  // 6 and 7 make a line
  page.points = true;
  CHECK(points(page) == 3);
  page.panels[0].curves[0].y = {kNone, kNone, kNone, kNone, kNone};
  CHECK(points(page) == 0);
}
