#include "adrinput/deck_window.hpp"
#include "adrinput/lubricant_panel.hpp"
#include "calculators/deck_lubricant.hpp"
#include "deck/templates.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/lubricant_pages.hpp"
#include "support/qt_app.hpp"
#include "tribology/lubricant.hpp"
#include "tribology/lubricant_range.hpp"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMainWindow>
#include <QTest>
#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

using namespace adore;

namespace {

deck::Deck in_oil(const char* code) {
  deck::Deck deck = deck::new_deck("ball");
  deck.set("kTrac", code);
  deck.complete();
  if (deck.has("reRaceFilm")) deck.set("reRaceFilm", "1.0e-8");
  if (deck.has("strParam")) deck.set("strParam", "10.0");
  return deck;
}

}  // namespace

TEST_CASE("lubricant panel: contact of record 10 → that of the deck", "[gui][film]") {
  deck::Deck deck = in_oil("4");
  deck.set("raceTemp2", "360.0");
  deck.set("reTemp", "370.0");
  deck.set("rmsAspHt2", "2.0e-7");
  const auto contact = calculators::lubricant_contact(deck);
  REQUIRE(contact);
  CHECK(contact->code == 4);
  CHECK(contact->temperature == Approx(365.0));
  CHECK(contact->roughness == Approx(2e-7));
  CHECK(contact->critical_film == Approx(1e-8));
  CHECK(contact->metal[1] == Approx(0.06));  // record 10.1C of the example
  CHECK(contact->metal_type == 1);
  deck.set("kTracType", "0");  // two slopes where the film breaks down
  deck.complete();
  deck.set("reRaceTC2", "0.07");
  const auto other = calculators::lubricant_contact(deck);
  REQUIRE(other);
  CHECK(other->metal_type == 0);
  CHECK(other->metal[1] == Approx(0.07));
  CHECK_FALSE(calculators::lubricant_contact(deck::new_deck("ball")));
}

TEST_CASE("lubricant panel: dock closed at first → draws the selected chart when opened",
          "[gui][film]") {
  test::use_qt();
  QMainWindow window;
  adrinput::LubricantPanel* panel = adrinput::LubricantPanel::createInDock(&window);
  auto* dock = window.findChild<QDockWidget*>("lubricant-dock");
  REQUIRE(dock != nullptr);
  window.resize(900, 600);
  window.show();
  CHECK_FALSE(dock->isVisible());
  panel->setDeck(in_oil("4"));
  panel->drawNow();
  CHECK(panel->chart().chartScene().page().panels.empty());  // hidden: nothing is computed
  dock->show();
  panel->drawNow();
  CHECK(panel->chart().chartScene().page().panels.size() == 2);
  CHECK(panel->chart().chartScene().page().panels[0].curves.size() == 4);
  const std::string lubricant = panel->chart().chartScene().page().title;
  const auto whole = desktop::lubricant_pages(*calculators::lubricant_contact(in_oil("4")));
  CHECK(whole.front().title.starts_with(lubricant + ": "));  // the list has the drawn values
  panel->findChild<QComboBox*>("lubricant-page")->setCurrentIndex(2);
  CHECK(panel->chart().chartScene().page().panels.size() == 2);
  panel->setDeck(deck::new_deck("ball"));
  panel->drawNow();
  CHECK(panel->chart().chartScene().page().panels.empty());
  CHECK(panel->chart().chartScene().page().note.find("kTrac") != std::string::npos);
}

TEST_CASE(
    "lubricant panel: traction and viscosity charts → measured range of the lubricant is given",
    "[gui][film]") {
  for (const int code : tribology::lubricant_codes()) {
    CAPTURE(code);
    calculators::LubricantContact contact;
    contact.code = code;
    const auto pages = desktop::lubricant_pages(contact);
    REQUIRE(pages.size() == 3);
    const std::optional<double> end = tribology::pressure_range(code).measured_to;
    const std::string said =
        end ? fmt::format("extrapolated beyond {:g} GPa, the highest measured pressure",
                          1e-9 * *end)
            : "measured up to an unknown pressure";
    CHECK_THAT(pages[0].note, Catch::Contains(said));
    CHECK_THAT(pages[1].note, Catch::Contains(said));
    CHECK_THAT(pages[2].note, !Catch::Contains("measure"));  // films are made at low pressure
  }
}

TEST_CASE(
    "lubricant panel: lubricant of record 10.4 → same charts as a table lubricant, or missing data "
    "named",
    "[gui][film]") {
  test::use_qt();
  deck::Deck deck = in_oil("9");
  for (const auto& [name, value] :
       {std::pair{"raceTemp2", "350.0"}, std::pair{"reTemp", "350.0"}, std::pair{"lubName", "mine"},
        std::pair{"refTemp", "313.0"}, std::pair{"refVis", "0.03"},
        std::pair{"prVisCoeff", "1.5e-8"}, std::pair{"tempVisCoeff", "4000.0"},
        std::pair{"lubTherCond", "0.14"}, std::pair{"lubDen", "900.0"},
        std::pair{"lubSpHeat", "2000.0"}, std::pair{"refTracVis", "0.2"},
        std::pair{"tracVisCoeff1", "2.0e-8"}, std::pair{"tracVisCoeff2", "0.03"}})
    deck.set(name, value);
  adrinput::LubricantPanel panel;
  panel.resize(panel.minimumSizeHint());
  panel.show();
  panel.setDeck(deck);
  panel.drawNow();
  auto* conditions = panel.findChild<QLabel*>("lubricant-conditions");
  CHECK_THAT(conditions->text().toStdString(), Catch::Contains("mine: 350 K"));
  CHECK(conditions->height() >= conditions->heightForWidth(conditions->width()));
  CHECK(conditions->geometry().top() > panel.chart().geometry().bottom());
  const desktop::ChartPage& page = panel.chart().chartScene().page();
  REQUIRE(page.panels.size() == 1);
  CHECK(page.title == "mine");
  // The limit that is assumed for a user's lubricant; without it hundreds at 2 GPa.
  const auto most = [](const desktop::ChartPage& of) {
    double out = 0.0;
    for (const auto& one : of.panels[0].curves)
      for (const double y : one.y) out = std::max(out, y);
    return out;
  };
  CHECK_FALSE(page.panels[0].log);
  CHECK(most(page) <= tribology::kUserLimit);
  CHECK(most(page) > 0.8 * tribology::kUserLimit);
  CHECK_THAT(page.note, !Catch::Contains("highest measured pressure"));
  auto free = calculators::lubricant_contact(deck);
  REQUIRE(free);
  free->stress_limit = false;
  const desktop::ChartPage unlimited =
      desktop::lubricant_pages(*free, desktop::LubricantTitle::Lubricant).front();
  CHECK(unlimited.panels[0].log);
  CHECK_THAT(unlimited.note, Catch::Contains("no limiting shear stress"));
  panel.findChild<QComboBox*>("lubricant-page")->setCurrentIndex(1);
  const auto& curve = panel.chart().chartScene().page().panels[0].curves[1].y;
  // 350 K: the traction's viscosity, of type I.
  CHECK(curve.front() == Approx(0.2 * std::exp(0.03 * (313.0 - 350.0))).epsilon(1e-6));
  deck.set("refTracVis", "0.0");
  panel.setDeck(deck);
  panel.drawNow();
  CHECK(panel.chart().chartScene().page().panels.empty());
  CHECK_THAT(panel.chart().chartScene().page().note, Catch::Contains("refTracVis"));
}

TEST_CASE("adrinput: lubricant and drawing docks fit into a window of 1000 pixels", "[gui][film]") {
  test::use_qt();
  adrinput::DeckWindow window;
  window.resize(1000, 690);
  window.show();
  auto* dock = window.findChild<QDockWidget*>("lubricant-dock");
  REQUIRE(dock != nullptr);
  dock->toggleViewAction()->trigger();
  QTest::qWait(50);
  CHECK(dock->isVisible());
  CHECK(window.minimumSizeHint().width() <= 1000);
  CHECK(window.width() == 1000);
  CHECK(window.height() == 690);
  // With enough space everything is visible.
  window.resize(1280, 800);
  dock->toggleViewAction()->trigger();
  dock->toggleViewAction()->trigger();
  QTest::qWait(50);
  const auto* panel = window.findChild<adrinput::LubricantPanel*>();
  CHECK(panel->visibleRegion().boundingRect().width() >= panel->minimumSizeHint().width());
  CHECK(panel->visibleRegion().boundingRect().height() >= panel->minimumSizeHint().height());
}
