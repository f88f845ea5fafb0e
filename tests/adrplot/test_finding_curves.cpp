#include "adrplot/finding_pages.hpp"
#include "adrplot/plot_window.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/findings_bar.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"
#include "support/synthetic_results.hpp"

#include <QListWidget>
#include <QTemporaryDir>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

using namespace adore;
using namespace adore::adrplot;
using results::SolKind;

namespace {

/// "Contact load, Inner race" of the thick curves of the page.
std::vector<std::string> thick_curves(PlotWindow& window) {
  std::vector<std::string> out;
  for (const desktop::ChartPanel& panel : window.view().chartScene().page().panels)
    for (const desktop::ChartCurve& curve : panel.curves)
      if (curve.heavy) out.push_back(panel.title + ", " + curve.name);
  return out;
}

int dark_pixels(PlotWindow& window) {
  const QImage picture = window.view().chartScene().image({900, 600});
  int out = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (QColor(picture.pixel(x, y)).lightness() < 150) ++out;
  return out;
}

}  // namespace

TEST_CASE("click on a finding → its page, with the curve of its quantity and race drawn thick",
          "[gui][adrplot][findings]") {
  test::use_qt();
  const QTemporaryDir folder;
  const std::filesystem::path base = folder.path().toStdString();
  test::write_text(base / "SOL1", test::sol_text(test::synthetic_sol(SolKind::Element)));
  test::write_text(base / "SOL3", test::sol_text(test::synthetic_sol(SolKind::Cage)));
  const std::vector<Finding> findings{
      make_finding("motion.yield", "Yield at the inner race.").of("ball 1, inner race").at(0.001),
      make_finding("cage.whirling", "The cage whirls.").of("cage"),
      make_finding("run.steps", "A remark without a page.")};
  test::write_text(base / "RUN.json", nlohmann::ordered_json{{"program", "Adore 1.0.0"},
                                                             {"findings", findings_json(findings)}}
                                          .dump(1));
  PlotWindow window;
  REQUIRE(window.openFile(base / "SOL1"));
  REQUIRE(window.openFile(base / "SOL3"));
  window.show();
  auto* bar = window.findChild<desktop::FindingsBar*>("findings");
  REQUIRE(bar != nullptr);
  const auto click = [&](const std::string& code) {
    for (int row = 0; row < bar->list().count(); ++row)
      if (bar->list().item(row)->toolTip().toStdString() == code)
        return emit bar->list().itemClicked(bar->list().item(row));
    FAIL("no row of " + code);
  };
  click("motion.yield");
  REQUIRE(thick_curves(window).size() == 1);
  const std::string load = thick_curves(window).front();
  CAPTURE(load);
  CHECK(load.find("Contact load") == 0);
  CHECK(load.find("nner") != std::string::npos);
  const int with = dark_pixels(window);
  desktop::ChartPage plain = window.view().chartScene().page();
  for (desktop::ChartPanel& panel : plain.panels)
    for (desktop::ChartCurve& curve : panel.curves) curve.heavy = false;
  window.view().chartScene().setPage(plain, true);
  CHECK(dark_pixels(window) < with);
  click("cage.whirling");
  REQUIRE_FALSE(thick_curves(window).empty());
  CHECK(thick_curves(window).front().find("Whirl ratio") == 0);
  click("run.steps");  // no page and no curve: the page stays, nothing is thick
  CHECK(thick_curves(window).empty());
}

TEST_CASE("concerned_curves(): panels of the quantity, curves of the race",
          "[unit][adrplot][findings]") {
  desktop::ChartPage page;
  page.panels.resize(2);
  page.panels[0].title = "Contact load";
  page.panels[0].curves = {{"outer race", {}, {}}, {"inner race", {}, {}}};
  page.panels[1].title = "Lubricant film";
  page.panels[1].curves = {{"outer race", {}, {}}, {"inner race", {}, {}}};
  using Curves = std::vector<std::pair<std::size_t, std::size_t>>;
  const Finding yield = make_finding("motion.yield", "x");
  CHECK(concerned_curves(page, yield) == Curves{{0, 0}, {0, 1}});
  CHECK(concerned_curves(page, Finding(yield).of("ball 2, outer race")) == Curves{{0, 0}});
  CHECK(concerned_curves(page, make_finding("film.thick", "x").of("inner race")) == Curves{{1, 1}});
  CHECK(concerned_curves(page, make_finding("run.steps", "x")).empty());
}
