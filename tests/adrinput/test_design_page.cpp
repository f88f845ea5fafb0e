#include "adrinput/deck_window.hpp"
#include "adrinput/design_card.hpp"
#include "adrinput/design_form.hpp"
#include "adrinput/design_page.hpp"
#include "adrinput/record_list.hpp"
#include "adrinput/run_driver.hpp"
#include "adrinput/search.hpp"
#include "deck/catalogue.hpp"
#include "desktop/project.hpp"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTemporaryDir>

#include <algorithm>
#include <filesystem>

/// The front page: from a designation to results and to a moving picture.
using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

/// Counts what a user does: a click, a key or a typed entry is one action.
class User {
 public:
  explicit User(const QWidget& window) : window_(window) {}
  void type(const QString& text) {
    ++actions_;
    QTest::keyClicks(target(), text);
  }
  void key(Qt::Key key) {
    ++actions_;
    QTest::keyClick(target(), key);
  }
  void click(QWidget* widget) {
    REQUIRE(widget != nullptr);
    REQUIRE(widget->isVisible());
    ++actions_;
    QTest::mouseClick(widget, Qt::LeftButton);
  }
  [[nodiscard]] int actions() const { return actions_; }

 private:
  /// A list of completions gets the keys, as on a real screen.
  [[nodiscard]] QWidget* target() const {
    QWidget* popup = QApplication::activePopupWidget();
    QWidget* out = popup != nullptr ? popup : window_.focusWidget();
    REQUIRE(out != nullptr);
    return out;
  }
  const QWidget& window_;
  int actions_ = 0;
};

struct Front {
  DeckWindow window;
  Front() {
    window.resize(1280, 800);
    window.show();
    window.activateWindow();
    REQUIRE(QTest::qWaitForWindowActive(&window));
    window.showDesign();
  }
  bool settled() {
    return QTest::qWaitFor(
        [&] { return !window.design().computing() && window.design().resultsPanel().summary(); },
        60000);
  }
  QString shown(const char* id) { return window.design().resultsPanel().textOf(id); }
  QLineEdit* field(const char* variable) {
    QLineEdit* line = window.design().form().fieldOf(variable);
    REQUIRE(line != nullptr);
    return line;
  }
  Document& document() { return window.document(); }
};

/// Size of the part of the widget that no area or window cuts off.
QSize seen(const QWidget& widget) {
  if (!widget.isVisible()) return {};
  QRect place = widget.rect();
  for (const QWidget* at = &widget; !at->isWindow(); at = at->parentWidget())
    place = place.translated(at->pos()).intersected(at->parentWidget()->rect());
  return place.size();
}
bool is_seen(const QWidget& widget) { return seen(widget) == widget.size(); }

}  // namespace

TEST_CASE("design page: opened → life, safety and torque without an action",
          "[gui][adrinput][design]") {
  const QtInUse qt;
  Front front;
  CHECK(front.window.isDesignShown());
  REQUIRE(front.settled());
  for (const char* id : {"life_iso281", "static_safety", "torque_total", "contact_angle_inner"}) {
    INFO(id);
    CHECK_FALSE(front.shown(id).isEmpty());
    CHECK(front.shown(id) != "not computed");
  }
}

TEST_CASE("design page: 7208, load and speed → life, angle and torque in at most 6 actions",
          "[gui][adrinput][design]") {
  const QtInUse qt;
  Front front;
  REQUIRE(front.settled());
  User user(front.window);
  user.type("7208");
  user.key(Qt::Key_Tab);  // to the radial load
  user.type("4000");
  user.key(Qt::Key_Tab);
  user.key(Qt::Key_Tab);
  user.type("6000");
  QTest::qWait(400);
  REQUIRE(front.settled());
  CHECK(user.actions() <= 6);
  CHECK(front.document().deck().text("runID") == "7208 B");
  CHECK(front.document().deck().real("appLoadZ") == 4000.0);
  CHECK(front.document().deck().real("rpm2") == 6000.0);
  for (const char* id : {"life_iso281", "life_iso16281", "contact_angle_inner", "torque_total"})
    CHECK(front.shown(id) != "not computed");
  // The results are those of this deck.
  const design::DesignSummary same = design::design_summary(front.document().deck());
  CHECK(front.shown("life_iso281").toStdString() ==
        design::quantity_text(*same.find("life_iso281")));
}

TEST_CASE("design page: 7208 → a moving picture in at most 8 actions",
          "[gui][adrinput][design][slow]") {
  const QtInUse qt;
  const QTemporaryDir folder;
  Front front;
  Launches launches;
  front.window.runPanel().launch = [&](const QString& program, const QStringList& arguments) {
    launches.emplace_back(program, arguments);
  };
  User user(front.window);
  user.type("7208");
  user.key(Qt::Key_Return);
  user.click(front.window.findChild<QPushButton*>("design-move"));
  auto* dialog = front.window.findChild<QDialog*>("moving");
  REQUIRE(dialog != nullptr);
  CHECK(dialog->findChild<QLabel*>("assumptions")->text().contains("ESTIMATED cage"));
  CHECK(front.document().deck().integer("mode") == -1);  // nothing changes before the answer
  user.click(dialog->findChild<QPushButton*>("moving-run"));
  CHECK(front.document().deck().integer("mode") == 0);
  QFileDialog* name = nullptr;
  REQUIRE(QTest::qWaitFor(
      [&] { return (name = front.window.findChild<QFileDialog*>()) != nullptr; }, 5000));
  name->setDirectory(folder.path());
  auto* line = name->findChild<QLineEdit*>();
  line->setFocus();
  line->selectAll();
  User in_dialog(*name);
  in_dialog.type("DATA.txt");
  QSignalSpy finished(&front.window.runPanel(), &RunPanel::finished);
  in_dialog.key(Qt::Key_Return);
  REQUIRE(QTest::qWaitFor([&] { return front.window.runPanel().busy(); }, 10000));
  REQUIRE(finished.wait(600000));
  CHECK(user.actions() + in_dialog.actions() <= 8);
  // The animation opens at the end of the run.
  CHECK(std::count_if(launches.begin(), launches.end(),
                      [](const auto& launch) { return launch.first == "agore"; }) == 1);
  const fs::path out = folder.path().toStdString();
  CHECK(fs::file_size(out / "SOL8") > 100000);
  CHECK(note(front.window).contains("3.2 revolutions"));
}

TEST_CASE("design page: window of 1280x800 → results and at least 10 inputs are visible",
          "[gui][adrinput][design]") {
  const QtInUse qt;
  for (const char* type : {"7208", "NU209", "30208", "22210"}) {
    Front front;
    QTest::keyClicks(&front.window.design().form().bearingField(), type);
    QTest::keyClick(&front.window.design().form().bearingField(), Qt::Key_Return);
    REQUIRE(front.settled());
    QTest::qWait(50);
    INFO(type);
    int inputs = 0;
    DesignForm& form = front.window.design().form();
    for (const QLineEdit* one : form.findChildren<QLineEdit*>()) inputs += is_seen(*one) ? 1 : 0;
    for (const QComboBox* one : form.findChildren<QComboBox*>()) inputs += is_seen(*one) ? 1 : 0;
    CHECK(inputs >= 10);
    for (const design::DesignValue& one : front.window.design().resultsPanel().summary()->values) {
      const auto* label =
          front.window.findChild<QLabel*>(QString::fromStdString("design-" + one.id));
      REQUIRE(label != nullptr);
      INFO(one.id);
      CHECK(is_seen(*label));
    }
    CHECK(is_seen(*front.window.findChild<QWidget*>("design-drawing")));
    CHECK(is_seen(*front.window.findChild<QWidget*>("design-loads")));
    CHECK(seen(*front.window.findChild<QWidget*>("design-findings")).height() > 40);
  }
}

TEST_CASE("design page and records: one deck, both in step, undo across",
          "[gui][adrinput][design]") {
  const QtInUse qt;
  Front front;
  const std::string before = deck::write_deck(front.document().deck());
  replace_text(&front.window.design().form().bearingField(), "7208");
  const std::string bearing = deck::write_deck(front.document().deck());
  CHECK(front.document().text(cell("brgBore")) == "0.04");
  replace_text(front.field("brgBore"), "40");  // the same value: the digits of the deck stay
  CHECK(deck::write_deck(front.document().deck()) == bearing);
  replace_text(front.field("hsngTemp"), "60");
  for (const char* name : {"hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp", "cageTemp"})
    CHECK(front.document().text(cell(name)) == "333.15");
  replace_text(front.field("appLoadX"), "1.5 kN");
  CHECK(front.document().text(cell("appLoadX")) == "1500.0");
  CHECK(front.field("appLoadX")->text() == "1500");
  CHECK(line_of(front.window, "appLoadX")->text() == "1500.0");  // leaves the page
  CHECK_FALSE(front.window.isDesignShown());
  replace_text(line_of(front.window, "rpm2"), "4321");
  front.window.showDesign();
  CHECK(front.field("rpm2")->text() == "4321");
  front.window.undo();
  CHECK(front.window.isDesignShown());
  CHECK(front.field("rpm2")->text() != "4321");
  front.window.undo();
  CHECK(front.field("appLoadX")->text() != "1500");
  front.window.undo();
  CHECK(front.field("hsngTemp")->text() == "20");
  CHECK(deck::write_deck(front.document().deck()) == bearing);
  front.window.undo();
  CHECK(deck::write_deck(front.document().deck()) == before);
  front.window.redo();
  CHECK(deck::write_deck(front.document().deck()) == bearing);
}

TEST_CASE("design page: oil → film; without oil \"not computed\"", "[gui][adrinput][design]") {
  const QtInUse qt;
  Front front;
  replace_text(&front.window.design().form().bearingField(), "7208");
  REQUIRE(front.settled());
  CHECK(front.shown("film_inner") == "not computed");
  QComboBox& oil = front.window.design().form().oilField();
  CHECK(oil.currentText().contains("none"));
  oil.setFocus();
  QTest::keyClick(&oil, Qt::Key_Down);
  CHECK(front.document().deck().integer("kTrac") == 21);
  CHECK(front.document().deck().integer("oilGrade") == 32);
  CHECK(front.document().deck().real("strParam") == 10.0);
  REQUIRE(front.settled());
  CHECK(front.shown("film_inner").endsWith("µm"));
  CHECK(front.shown("lambda_inner") != "not computed");
}

TEST_CASE("design page: oil by grade → saved with the deck, and replaced by another oil",
          "[gui][adrinput][design]") {
  const QtInUse qt;
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("DATA.txt").toStdString();
  Front front;
  replace_text(&front.window.design().form().bearingField(), "7208");
  QComboBox& oil = front.window.design().form().oilField();
  oil.setFocus();
  for (int k = 0; k < oil.count() && oil.currentText() != "ISO VG 68 mineral oil"; ++k)
    QTest::keyClick(&oil, Qt::Key_Down);
  CHECK(oil.currentText() == "ISO VG 68 mineral oil");
  REQUIRE(front.settled());
  CHECK(front.shown("lambda_inner") != "not computed");
  front.document().save(file);
  Document again;
  again.open(file);
  CHECK(again.deck().integer("oilGrade") == 68);
  CHECK(design::design_oil_index(again.deck()) ==
        design::design_oil_index(front.document().deck()));
  QTest::keyClick(&oil, Qt::Key_Home);
  CHECK(front.document().deck().integer("kTrac") == 0);
  CHECK_FALSE(front.document().deck().has("oilGrade"));
  front.window.undo();
  CHECK(oil.currentText() == "ISO VG 68 mineral oil");
}

TEST_CASE("design page: window of 1280x800 → the oil box shows whole names, the chart its title",
          "[gui][adrinput][design]") {
  const QtInUse qt;
  for (const char* type : {"7208", "NU209"}) {
    INFO(type);
    Front front;
    replace_text(&front.window.design().form().bearingField(), type);
    REQUIRE(front.settled());
    QTest::qWait(50);
    QComboBox& oil = front.window.design().form().oilField();
    for (int i = 0; i < 9; ++i) {
      QStyleOptionComboBox box;
      box.initFrom(&oil);
      const int room =
          oil.style()
              ->subControlRect(QStyle::CC_ComboBox, &box, QStyle::SC_ComboBoxEditField, &oil)
              .width();
      INFO(oil.itemText(i).toStdString());
      CHECK(oil.fontMetrics().horizontalAdvance(oil.itemText(i)) <= room);
    }
  }
}

TEST_CASE("design page: several changes in a row → only the last deck is computed",
          "[gui][adrinput][design]") {
  const QtInUse qt;
  Front front;
  replace_text(&front.window.design().form().bearingField(), "7208");
  for (const char* load : {"1000", "2000", "3000", "4000"})
    replace_text(front.field("appLoadZ"), load);
  CHECK(front.window.design().computing());
  REQUIRE(front.settled());
  const design::DesignSummary last = design::design_summary(front.document().deck());
  CHECK(front.shown("pressure_inner").toStdString() ==
        design::quantity_text(*last.find("pressure_inner")));
}

TEST_CASE("design page: invalid inputs → a reason, and the deck keeps or marks its value",
          "[gui][adrinput][design]") {
  const QtInUse qt;
  Front front;
  const std::string before = deck::write_deck(front.document().deck());
  DesignForm& form = front.window.design().form();
  replace_text(&form.bearingField(), "9999");
  CHECK(deck::write_deck(front.document().deck()) == before);
  CHECK(front.window.findChild<QLabel*>("design-facts")->text().contains("9999"));
  replace_text(front.field("rpm2"), "fast");
  CHECK(front.document().has_errors());
  QTest::qWait(200);
  CHECK(front.window.findChild<QLabel*>("design-state")->text().contains("errors"));
  front.window.undo();
  CHECK_FALSE(front.document().has_errors());
  CHECK(deck::write_deck(front.document().deck()) == before);
}

TEST_CASE("deck_window: Add to Project → PROJECT.json lists the deck", "[gui][adrinput][project]") {
  const QtInUse qt;
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("DATA.txt").toStdString();
  Front front;
  front.window.addToProject();
  CHECK(front.window.findChild<QFileDialog*>("project") == nullptr);  // not saved yet
  front.document().save(file);
  front.window.addToProject();
  auto* dialog = front.window.findChild<QFileDialog*>("project");
  REQUIRE(dialog != nullptr);
  emit dialog->fileSelected(folder.path());
  const desktop::Project project = desktop::Project::open(folder.path().toStdString());
  REQUIRE(project.decks().size() == 1);
  CHECK(project.decks()[0].name == "DATA.txt");
  CHECK(project.runs().empty());
}

TEST_CASE("design page: saved → comments of the bearing that the deck has",
          "[gui][adrinput][design]") {
  const QtInUse qt;
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("DATA.txt").toStdString();
  Front front;
  replace_text(&front.window.design().form().bearingField(), "7208");
  front.document().save(file);
  CHECK(bytes_of(file).find("boundary dimensions of 7208 B") != std::string::npos);
  replace_text(&front.window.design().form().bearingField(), "6205");
  front.document().save(file);
  CHECK(bytes_of(file).find("boundary dimensions of 6205") != std::string::npos);
  CHECK(bytes_of(file).find("7208") == std::string::npos);
  CHECK(fs::exists(front.document().kept_copy()));
  front.window.undo();
  front.document().save(file);
  CHECK(bytes_of(file).find("boundary dimensions of 7208 B") != std::string::npos);
  // A later session has them, too.
  Document restored;
  restored.restore(front.document().snapshot(kDesignPage));
  CHECK_FALSE(restored.modified());
  restored.edit(cell("rpm2"), "1234");
  restored.save(file);
  CHECK(bytes_of(file).find("boundary dimensions of 7208 B") != std::string::npos);
}

TEST_CASE("search: words of users → the variable that they mean first",
          "[unit][adrinput][design]") {
  const Document document;
  const auto first = [&](const char* words) {
    const auto found = search_variables(
        words, [&](const Cell& one) { return document.instances(one.record) > 0; });
    return found.empty() ? std::string() : std::string(variable_of(found.front().cell)->name);
  };
  CHECK(first("radial load") == "appLoadZ");
  CHECK(first("axial load") == "appLoadX");
  CHECK(first("speed") == "rpm2");
  CHECK(first("oil") == "kTrac");
  CHECK(first("number of balls") == "nRe");
  CHECK(first("contact angle") == "freeConAng");
  // Of records that the deck does not have, none comes before its own.
  const auto found = search_variables(
      "clearance", [&](const Cell& one) { return document.instances(one.record) > 0; });
  REQUIRE_FALSE(found.empty());
  CHECK(document.instances(found.front().cell.record) > 0);
  // A phrase of the table names a variable of the schema.
  for (const char* words : {"fit", "gravity", "tolerance", "end time", "misalignment", "cage"})
    CHECK_FALSE(first(words).empty());
}

TEST_CASE("text with the focus: Page Down and Ctrl+End act in it", "[gui][adrinput][design]") {
  const QtInUse qt;
  Front front;
  front.window.showRecord("3.2");
  front.window.runQuasiStatic();
  REQUIRE(QTest::qWaitFor([&] { return !front.window.staticsPanel().busy(); }, 60000));
  auto* text = front.window.staticsPanel().findChild<QPlainTextEdit*>("text");
  REQUIRE(text != nullptr);
  text->setFocus();
  QTest::keyClick(text, Qt::Key_PageDown);
  CHECK(front.window.currentRecord() == "3.2");
  const int page = text->verticalScrollBar()->value();
  CHECK(page > 0);
  QTest::keyClick(text, Qt::Key_End, Qt::ControlModifier);
  CHECK(text->verticalScrollBar()->value() == text->verticalScrollBar()->maximum());
  QTest::keyClick(text, Qt::Key_Home, Qt::ControlModifier);
  CHECK(text->verticalScrollBar()->value() == 0);
  // Elsewhere it goes to the next record.
  front.window.page()->focusFirst();
  QTest::keyClick(front.window.focusWidget(), Qt::Key_PageDown);
  CHECK(front.window.currentRecord() == "3.3");
}

TEST_CASE("design page left → records, panels and docks as before", "[gui][adrinput][design]") {
  const QtInUse qt;
  Front front;
  auto* list = front.window.findChild<QWidget*>("panels");
  CHECK_FALSE(list->isVisible());
  QTest::mouseClick(front.window.findChild<QPushButton*>("design-records"), Qt::LeftButton);
  CHECK_FALSE(front.window.isDesignShown());
  CHECK(list->isVisible());
  CHECK(front.window.findChild<QWidget*>("drawing-dock")->isVisible());
  CHECK(front.window.pageArea().isVisible());
  QTest::keyClick(&front.window, Qt::Key_B, Qt::ControlModifier);
  CHECK(front.window.isDesignShown());
}
