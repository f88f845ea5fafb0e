#include "adrinput/lubricant_panel.hpp"
#include "deck/templates.hpp"
#include "desktop/chart_view.hpp"
#include "desktop/lubricant_pages.hpp"
#include "support/qt_app.hpp"

#include <QComboBox>
#include <QDockWidget>
#include <QMainWindow>
#include <catch2/catch.hpp>

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

TEST_CASE("the contact beside record 10 is that of the deck", "[gui][film]") {
  deck::Deck deck = in_oil("4");
  deck.set("raceTemp2", "360.0");
  deck.set("reTemp", "370.0");
  deck.set("rmsAspHt2", "2.0e-7");
  const auto contact = adrinput::lubricant_contact(deck);
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
  const auto other = adrinput::lubricant_contact(deck);
  REQUIRE(other);
  CHECK(other->metal_type == 0);
  CHECK(other->metal[1] == Approx(0.07));
  CHECK_FALSE(adrinput::lubricant_contact(deck::new_deck("ball")));
}

TEST_CASE("the lubricant's dock is closed at first and draws what it is asked for", "[gui][film]") {
  test::use_qt();
  QMainWindow window;
  adrinput::LubricantPanel* panel = adrinput::LubricantPanel::inDockOf(&window);
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
  CHECK(panel->chart().chartScene().page().panels.size() == 1);
  CHECK(panel->chart().chartScene().page().panels[0].curves.size() == 4);
  const std::string lubricant = panel->chart().chartScene().page().title;
  const auto whole = desktop::lubricant_pages(*adrinput::lubricant_contact(in_oil("4")));
  CHECK(whole.front().title.starts_with(lubricant + ": "));  // what is drawn stands in the list
  panel->findChild<QComboBox*>("lubricant-page")->setCurrentIndex(2);
  CHECK(panel->chart().chartScene().page().panels.size() == 2);
  panel->setDeck(deck::new_deck("ball"));
  panel->drawNow();
  CHECK(panel->chart().chartScene().page().panels.empty());
  CHECK(panel->chart().chartScene().page().note.find("kTrac") != std::string::npos);
}
