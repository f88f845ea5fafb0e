#include "adrinput/cell_table.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/record_page.hpp"
#include "desktop/theme.hpp"
#include "support/qt_app.hpp"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <catch2/catch.hpp>

/// Tables, names and values without a part.
using namespace adore;
using namespace adore::adrinput;

TEST_CASE("forty deviations are one table, and a pasted row or column fills it",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.document().edit(cell("kReGeoImp"), "2");
  window.showRecord("5G.1D.1");
  auto* table = window.page()->findChild<CellTable*>("deviations");
  REQUIRE(table != nullptr);
  CHECK(table->rowCount() * table->columnCount() == 40);
  QStringList row, column;
  for (int k = 1; k <= 40; ++k) row << QString("%1e-7").arg(k);
  QApplication::clipboard()->setText(row.join('\t') + "\n");
  table->setFocus();
  table->setCurrentCell(0, 0);
  QTest::keyClick(table, Qt::Key_V, Qt::ControlModifier);
  CHECK(window.document().deck().real("reDiaVar1") == 1e-7);
  CHECK(window.document().deck().real("reDiaVar12") == 12e-7);
  CHECK(window.document().deck().real("reDiaVar40") == 40e-7);
  QApplication::clipboard()->setText("0,5 µm\n-0,25 µm\r\n");
  table->setCurrentCell(1, 1);  // element 12
  QTest::keyClick(table, Qt::Key_V, Qt::ControlModifier);
  CHECK(window.document().deck().real("reDiaVar12") == 0.5e-6);
  CHECK(window.document().deck().real("reDiaVar13") == -0.25e-6);
  CHECK(window.document().deck().real("reDiaVar14") == 14e-7);
  // One paste is one step of undo.
  window.document().undo();
  CHECK(window.document().deck().real("reDiaVar12") == 12e-7);
  CHECK(window.document().deck().real("reDiaVar13") == 13e-7);
  window.document().undo();
  for (const char* name : {"reDiaVar1", "reDiaVar12", "reDiaVar40"})
    CHECK(window.document().deck().real(name) == 0.0);
  // The editor that a click opens takes a list into the table, and one value into its cell.
  table->setCurrentCell(0, 0);
  const auto paste_into_editor = [&](const QString& text) {
    QApplication::clipboard()->setText(text);
    table->editItem(table->item(0, 0));
    auto* editor = table->viewport()->findChild<QLineEdit*>();
    REQUIRE(editor != nullptr);
    editor->selectAll();
    QTest::keyClick(editor, Qt::Key_V, Qt::ControlModifier);
    QTest::keyClick(table, Qt::Key_Return);
    table->setFocus();
    QCoreApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  for (const QString& list : {row.join('\t'), row.join('\n'), row.join(' '), row.join("; ")}) {
    paste_into_editor(list);
    CHECK(window.document().deck().real("reDiaVar1") == 1e-7);
    CHECK(window.document().deck().real("reDiaVar40") == 40e-7);
    window.document().undo();
    CHECK(window.document().deck().real("reDiaVar1") == 0.0);
  }
  QApplication::clipboard()->setText("0.5 µm");
  table->editItem(table->item(0, 0));
  auto* editor = table->viewport()->findChild<QLineEdit*>();
  REQUIRE(editor != nullptr);
  editor->selectAll();
  QTest::keyClick(editor, Qt::Key_V, Qt::ControlModifier);
  CHECK(editor->text() == QString::fromUtf8("0.5 µm"));
}

TEST_CASE("adrinput: invalid value → unused values stay pale", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.document().edit(cell("kReGeoImp"), "2");
  window.checkNow();
  const Cell absent = cell("reDiaVar40");
  REQUIRE_FALSE(window.document().unused_reason(absent).empty());
  window.document().edit(cell("reDiaVar3"), "abc");
  window.checkNow();
  CHECK(window.document().has_errors());
  CHECK_FALSE(window.document().unused_reason(absent).empty());
}

TEST_CASE("bodies and vectors have names", "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.showRecord("3.4");
  auto* bodies = qobject_cast<CellTable*>(window.page()->fieldOf(cell("kPltElemInd").variable));
  REQUIRE(bodies != nullptr);
  CHECK(bodies->item(0, 2)->text() == QString("13 — cage"));
  CHECK(bodies->item(0, 3)->text() == QString("15 — inner race"));
  window.showRecord("9.6");
  auto* place = qobject_cast<CellTable*>(window.page()->fieldOf(cell("cageGcPos").variable));
  REQUIRE(place != nullptr);
  CHECK(place->horizontalHeaderItem(0)->text() == "x");
  CHECK(place->horizontalHeaderItem(2)->text() == "z");
}

TEST_CASE("adrinput: values unused by the options → displayed as unused, with the reason",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.document().edit(cell("mode"), "-1");
  window.checkNow();
  const Cell steps = cell("maxStps");
  CHECK_FALSE(window.document().unused_reason(steps).empty());
  window.showRecord("1");
  auto* said = window.page()->findChild<QLabel*>("unused-maxStps");
  REQUIRE(said != nullptr);
  CHECK(said->text().startsWith("Not used:"));
  CHECK(said->isVisibleTo(window.page()));
  window.document().edit(cell("mode"), "0");
  window.checkNow();
  CHECK(window.document().unused_reason(steps).empty());
  CHECK_FALSE(said->isVisibleTo(window.page()));
}

TEST_CASE("adrinput: diameter deviations of missing elements → pale, with both unit systems too",
          "[gui][adrinput][daily]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.document().edit(cell("kReGeoImp"), "2");
  window.checkNow();
  const QColor text = desktop::current_theme().text;
  for (const bool others : {false, true}) {
    INFO("other units: " << others);
    window.showRecord("5G.1D.2");
    window.page()->setOtherUnitsShown(others);
    auto* table = window.page()->findChild<CellTable*>();
    REQUIRE(table != nullptr);
    table->setCurrentCell(0, 0);
    const QImage image = table->viewport()->grab().toImage();
    const auto dark = [&](int row, int column) {
      const QRect rect = table->visualItemRect(table->item(row, column)).adjusted(3, 3, -3, -3);
      int count = 0;
      for (int y = rect.top(); y < rect.bottom(); ++y)
        for (int x = rect.left(); x < rect.right(); ++x) count += image.pixelColor(x, y) == text;
      return count;
    };
    CHECK(dark(1, 1) > 0);   // of 12 elements the last
    CHECK(dark(1, 2) == 0);  // there is no 13th
    CHECK(dark(3, 3) == 0);
  }
}
