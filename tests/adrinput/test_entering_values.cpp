#include "adrinput/cell_table.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/drawing_view.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/unit_choice.hpp"
#include "runs/run.hpp"
#include "support/qt_app.hpp"

#include <QAction>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTest>
#include <QToolButton>
#include <catch2/catch.hpp>

/// Typed values are read with the selected units.
using namespace adore;
using namespace adore::adrinput;

TEST_CASE("quantities: incomplete → no value; complete → converted to the unit of the deck",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  QLineEdit* line = line_of(window, "bReDia");
  line->selectAll();
  QTest::keyClicks(line, "12.8");
  CHECK(window.document().deck().real("bReDia") == 0.0127);
  QTest::keyClicks(line, " m");
  CHECK(beside(window, "bReDia") == "= 12.8 m");  // the new value is shown before it is accepted
  QTest::keyClicks(line, "m");
  CHECK(beside(window, "bReDia") == "= 0.0128 m");
  CHECK(window.document().deck().real("bReDia") == 0.0127);
  QTest::keyClick(line, Qt::Key_Return);
  CHECK(window.document().deck().real("bReDia") == 0.0128);
  CHECK(line->text() == "0.0128");
  window.undo();
  CHECK(line->text() == "0.0127");
  CHECK_FALSE(window.document().can_undo());
  replace_text(line, "1/2 in");
  CHECK(window.document().deck().real("bReDia") == 0.0127);
  CHECK_FALSE(window.document().can_undo());  // the same as before: no step
  replace_text(line, "5-3");
  CHECK(window.document().has_errors());
  CHECK(window.page()->findChild<QLabel*>("problem-bReDia")->text().contains("5e-3 or 5 - 3"));
}

TEST_CASE("display units: unit selected → display changes, deck does not",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  const deck::Deck before = window.document().deck();
  choose_unit("m", "mm");
  choose_unit("K", "°C");
  QLineEdit* line = line_of(window, "bReDia");
  CHECK(line->text() == "12.7 mm");
  QTest::keyClick(line, Qt::Key_End);
  CHECK(line_of(window, "roomTemp")->text() == "20 °C");
  CHECK(window.document().deck() == before);
  line = line_of(window, "bReDia");
  replace_text(line, "13 mm");
  CHECK(window.document().deck().real("bReDia") == 0.013);
  CHECK(line->text() == "13 mm");
  replace_text(line, "12.7");  // without a unit: in the unit that the field is shown in
  CHECK(line->text() == "12.7 mm");
  CHECK(window.document().deck().real("bReDia") == 0.0127);
  replace_text(line, "0.013 m");
  CHECK(line->text() == "13 mm");
  for (const auto& [typed, metres] : {std::pair{"3*4", 0.012},
                                      {"12,5", 0.0125},
                                      {"1/2 in", 0.0127},
                                      {"1.25e1", 0.0125},
                                      {"127e-1", 0.0127},
                                      {"2+9", 0.011},
                                      {"10 - 1/2", 0.0095},
                                      {"(1+2)*4", 0.012},
                                      {"30/3", 0.01}}) {
    INFO(typed);
    replace_text(line, typed);
    CHECK(window.document().deck().real("bReDia") == Approx(metres).epsilon(1e-14));
  }
  // The same digits as the deck has, in another unit: no text of "no change".
  choose_unit("N", "kN");
  line = line_of(window, "appLoadX");
  replace_text(line, "3 N");
  CHECK(window.document().deck().real("appLoadX") == 3.0);
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QString::fromStdString(window.document().text(cell("appLoadX"))));
  CHECK(beside(window, "appLoadX") == "= 3000.0 N");
  QTest::keyClick(line, Qt::Key_Return);
  CHECK(window.document().deck().real("appLoadX") == 3000.0);
  CHECK(line->text() == "3 kN");
  choose_unit("m", {});
  choose_unit("K", {});
  choose_unit("N", {});
}

TEST_CASE("adrinput: unit next to values and in tables → unit in which they are displayed",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  const auto told = [&] {
    QString out;
    for (const auto* label : window.page()->findChildren<QLabel*>()) out += label->text() + "\n";
    for (const auto* table : window.page()->findChildren<CellTable*>())
      for (int row = 0; row < table->rowCount(); ++row)
        if (const auto* head = table->verticalHeaderItem(row)) out += head->text() + "\n";
    return out;
  };
  window.showRecord("7.2.i");
  auto* table = window.page()->findChild<CellTable*>("instances");
  REQUIRE(table->focusCell(cell("cageGsCls", 1)));
  const int row = table->currentRow();
  CHECK(table->verticalHeaderItem(row)->text().contains("[m]"));
  auto* choices = window.findChild<QMenu*>("unit-choices");
  REQUIRE(choices != nullptr);
  const auto choose = [&](const QString& unit) {
    QMenu* lengths = choices->actions().first()->menu();
    emit lengths->aboutToShow();
    for (QAction* action : lengths->actions())
      if (action->text() == unit) action->trigger();
  };
  choose("mm");
  CHECK(table->item(row, 0)->text().endsWith(" mm"));
  CHECK(table->verticalHeaderItem(row)->text().contains("[mm]"));
  window.document().edit(cell("kReGeoImp"), "2");
  window.showRecord("5G.1D.1");
  INFO(told().toStdString());
  CHECK(told().split('\n').contains("mm"));
  CHECK_FALSE(told().split('\n').contains("m"));
  choose("as in deck");
}

TEST_CASE("times of a run are shown and typed in seconds and turns", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.showRecord("2.1");
  REQUIRE(QTest::qWaitFor([&] { return window.document().scales().has_value(); }, 60000));
  CHECK(beside(window, "fTime").contains("revolutions"));
  const runs::RunScales scales = *window.document().scales();
  CHECK(scales.turns_per_second == Approx(10000.0 / 60.0));
  QLineEdit* line = line_of(window, "fTime");
  replace_text(line, "5 rev");
  CHECK(window.document().deck().real("fTime") * scales.time * scales.turns_per_second ==
        Approx(5.0).epsilon(1e-12));
  CHECK(beside(window, "fTime").contains("= 5 revolutions"));
  replace_text(line, "20 ms");
  CHECK(window.document().deck().real("fTime") * scales.time == Approx(0.02).epsilon(1e-12));
  replace_text(line, "3 mm");
  CHECK(window.document().has_errors());
}

TEST_CASE(
    "adrinput: time in revolutions typed while another error exists → accepted after the "
    "correction",
    "[gui][adrinput][daily]") {
  test::use_qt();
  const auto turns = [](DeckWindow& window) {
    const auto scales = window.document().scales();
    return scales ? window.document().deck().real("fTime") * scales->time * scales->turns_per_second
                  : 0.0;
  };
  // The error that is not in the scale remains; of the others the last is corrected first.
  struct Error {
    const char *name, *wrong, *right;
  };
  for (const Error& error : {Error{"kNumPltElem", "12", nullptr}, Error{"tol", "abc", nullptr},
                             Error{"bReDia", "-1 m", "12 mm"}}) {
    INFO(error.name);
    DeckWindow window;
    window.show();
    window.document().edit(cell(error.name), error.wrong);
    if (std::string_view(error.name) == "kNumPltElem")
      window.document().edit(cell("kPltElemInd", 1, 11), "900");
    REQUIRE(window.document().has_errors());
    window.showRecord("2.1");
    QLineEdit* line = line_of(window, "fTime");
    replace_text(line, "3 rev");
    if (error.right != nullptr) {
      QTest::qWait(300);
      CHECK(turns(window) == 0.0);
      window.showRecord(cell(error.name).record);
      window.document().edit(cell(error.name), error.right);
      window.document().end_undo_step();
    }
    REQUIRE(QTest::qWaitFor([&] { return window.document().scales().has_value(); }, 60000));
    REQUIRE(QTest::qWaitFor([&] { return !window.document().has_unparsed_text(cell("fTime")); },
                            10000));
    CHECK(turns(window) == Approx(3.0).epsilon(1e-12));
    window.showRecord("2.1");
    CHECK(beside(window, "fTime").contains("= 3 revolutions"));
    CHECK(window.document().has_errors() == (error.right == nullptr));
    // One step for undo: what was typed is there again, and not the number before it.
    if (error.right != nullptr) CHECK_FALSE(window.document().has_errors());
  }
}

TEST_CASE("adrinput: deck without motion → reported next to the end time and in the sweep dialog",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.showRecord("2.1");
  REQUIRE(QTest::qWaitFor([&] { return window.document().scales().has_value(); }, 60000));
  const auto sweep_message = [&](const QString& typed) {
    for (QAction* action : window.findChildren<QAction*>())
      if (action->text().contains("weep a variable")) action->trigger();
    auto* dialog = window.findChild<QInputDialog*>("sweep");
    REQUIRE(dialog != nullptr);
    dialog->setTextValue(typed);
    const QString said = dialog->labelText();
    dialog->reject();
    QTest::qWait(1);
    return said;
  };
  CHECK_FALSE(beside(window, "fTime").contains("maxStps"));
  CHECK_FALSE(sweep_message("appLoadZ=1:2:3").contains("The runs have no motion"));
  window.document().edit(cell("maxStps"), "0");
  window.checkNow();
  CHECK(beside(window, "fTime").contains("maxStps is 0"));
  CHECK_FALSE(beside(window, "fTime").contains("revolution"));  // which nobody will see
  CHECK(sweep_message("appLoadZ=1:2:3").contains("The runs have no motion"));
  CHECK_FALSE(sweep_message("maxStps=10:20:2").contains("The runs have no motion"));
}

TEST_CASE("adrinput: header of a deck → result of a run is announced", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  auto* state = window.findChild<QToolButton*>("deck-state");
  const auto says = [&](const char* name, const char* value, const QString& text,
                        const QString& reason) {
    window.document().edit(cell(name), value);
    window.document().end_undo_step();
    window.checkNow();
    INFO(name << " = " << value);
    CHECK(QTest::qWaitFor([&] { return state->text() == text; }, 60000));
    CHECK(state->toolTip().contains(reason));
    CHECK(state->accessibleName().contains(text));
    window.undo();
    window.checkNow();
    CHECK(QTest::qWaitFor([&] { return state->text() == "Ready to run"; }, 60000));
  };
  says("maxStps", "10", "Ready to run", "");
  says("maxStps", "0", "Ready: no motion", "maxStps is 0");
  says("fTime", "0", "Ready: no motion", "fTime is 0");
  says("mode", "-1", "Ready: quasi-static", "mode is -1");
}

TEST_CASE("typed numbers: incomplete exponent → rejected with this reason",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  for (const char* name : {"tol", "bReDia", "appLoadX"})
    for (const char* text : {"1e-", "1e", "2.5E+", "3d"}) {
      CAPTURE(name, text);
      replace_text(line_of(window, name), text);
      const QString said = window.page()->findChild<QLabel*>(QString("problem-") + name)->text();
      CHECK(said.contains("has an incomplete exponent"));
      CHECK_FALSE(said.contains("unit"));
      window.undo();
    }
}

TEST_CASE("display units: drawing and field menu use the selected unit", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.showRecord("9.1.1");
  auto* drawing = window.findChild<DrawingView*>("drawing");
  const auto labels = [&] {
    QStringList out;
    for (const drawing::Pane& pane : drawing->drawing().panes) {
      for (const drawing::Arrow& arrow : pane.arrows) out << QString::fromStdString(arrow.label);
      for (const drawing::Dimension& one : pane.dimensions)
        out << QString::fromStdString(one.label);
    }
    return out;
  };
  QTest::qWait(300);
  REQUIRE(labels().contains("appLoadX = 1500.0 N"));
  QLineEdit* line = line_of(window, "appLoadX");
  line->setFocus();
  QTest::keyClick(line, Qt::Key_Down, Qt::AltModifier);
  auto* button = window.page()->findChild<QToolButton*>("unit-appLoadX");
  REQUIRE(button->menu()->isVisible());
  for (QAction* action : button->menu()->actions())
    if (action->text() == "kN") action->trigger();
  button->menu()->hide();
  CHECK(line->text() == "1.5 kN");
  CHECK(labels().contains("appLoadX = 1.5 kN"));
  CHECK_FALSE(labels().contains("appLoadX = 1500.0 N"));
  for (QAction* action : button->menu()->actions())
    if (action->text() == "lbf") action->trigger();
  CHECK(line->text() == "337.213414649566 lbf");
  CHECK(labels().contains("appLoadX = 337.213 lbf"));
  choose_unit("N", {});
}
