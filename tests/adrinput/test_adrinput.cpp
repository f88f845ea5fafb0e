#include "adrinput/cell_table.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/evaluation.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/render.hpp"
#include "adrinput/typed.hpp"
#include "deck/condition.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "desktop/theme.hpp"
#include "facade/check.hpp"
#include "support/qt_app.hpp"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <algorithm>
#include <clocale>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

Cell cell(const std::string& name, int instance = 1, std::size_t element = 0) {
  const auto refs = deck::find_variable(name);
  REQUIRE_FALSE(refs.empty());
  return {std::string(refs[0].record->id), instance, refs[0].position, element};
}

void press(DeckWindow& window, const QString& button) {
  auto* push = window.findChild<QPushButton*>(button);
  REQUIRE(push != nullptr);
  QTest::mouseClick(push, Qt::LeftButton);
}

/// Text of the message shown, which is then closed; empty when there is none.
QString take_message(QWidget& window) {
  auto* box = window.findChild<QMessageBox*>("message");
  if (box == nullptr) return {};
  const QString text = box->text();
  box->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  return text;
}

void replace_text(QLineEdit* line, const QString& text) {
  line->setFocus();
  line->selectAll();
  QTest::keyClick(line, Qt::Key_Backspace);
  QTest::keyClicks(line, text);
  QTest::keyClick(line, Qt::Key_Return);
}

/// A number other than the present one that the variable takes, as a person may type it.
QString other_value(const Document& document, const Cell& at) {
  const deck::VariableSpec& variable = *variable_of(at);
  if (variable.type == deck::VarType::String) return document.text(at) == "a'b 7" ? "c,d" : "a'b 7";
  for (const char* text : {"0,75", "12,5", "1", "2", "3", "-0,25", "60", "0"}) {
    const Typed typed = parse_typed(variable, text);
    if (typed.problem || shown_text(typed.value) == document.text(at)) continue;
    const auto* real = std::get_if<double>(&typed.value);
    if (real != nullptr &&
        !deck::in_range(deck::range_in_deck_units(document.deck(), variable), *real))
      continue;
    return text;
  }
  return {};
}

/// Types another value into a cell through its widget. False when it takes no other.
bool type_into(DeckWindow& window, const Cell& at) {
  Document& document = window.document();
  QWidget* field = window.page()->fieldOf(at.variable);
  REQUIRE(field != nullptr);
  const std::string old = document.text(at);
  if (auto* combo = qobject_cast<QComboBox*>(field)) {
    combo->setFocus();
    const int index = combo->currentIndex();
    QTest::keyClick(combo, index + 1 < combo->count() ? Qt::Key_Down : Qt::Key_Up);
    return document.text(at) != old || combo->count() < 2;
  }
  const QString text = other_value(document, at);
  if (text.isEmpty()) return false;
  if (auto* line = qobject_cast<QLineEdit*>(field)) {
    replace_text(line, text);
  } else {
    auto* table = qobject_cast<CellTable*>(field);
    REQUIRE(table->focusCell(at));
    QTest::keyClick(table, Qt::Key_F2);
    if (auto* combo = table->viewport()->findChild<QComboBox*>()) {
      combo->setCurrentIndex(combo->findData(text));
      QTest::keyClick(combo, Qt::Key_Return);
    } else {
      auto* editor = table->viewport()->findChild<QLineEdit*>();
      REQUIRE(editor != nullptr);
      editor->selectAll();
      QTest::keyClicks(editor, text);
      QTest::keyClick(editor, Qt::Key_Return);
    }
    QCoreApplication::processEvents();  // the table takes the value over in a later event
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  const Typed expected = parse_typed(*variable_of(at), text.toStdString());
  const deck::Value* value = value_at(document.deck(), at);
  return value != nullptr && *value == expected.value;
}

/// Sets options until the deck asks for a record: tries codes of the variables in its condition.
bool make_record_apply(Document& document, const deck::RecordSpec& record) {
  std::vector<std::string> names;
  for (const std::string_view name : deck::names_in(record.condition))
    if (variable_of(cell(std::string(name)))->length == "1") names.emplace_back(name);
  const std::vector<long long> codes = {0, 1, 2, 3, 4, 5, 9, -1};
  std::vector<std::size_t> choice(names.size(), 0);
  deck::ConditionScope scope = deck::scope_of(document.deck());
  scope.array = [](std::string_view) { return std::vector<long long>{1}; };
  for (;;) {
    scope.integer = [&](std::string_view name) {
      const auto found = std::find(names.begin(), names.end(), name);
      return codes[choice[static_cast<std::size_t>(found - names.begin())]];
    };
    if (deck::evaluate(record.condition, scope)) break;
    std::size_t digit = 0;
    while (digit < choice.size() && ++choice[digit] == codes.size()) choice[digit++] = 0;
    if (digit == choice.size()) return false;
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    document.edit(cell(names[i]), std::to_string(codes[choice[i]]));
  if (!record.repeat.empty() && document.deck().integer(record.repeat) < 2)
    document.edit(cell(std::string(record.repeat)), "2");
  if (document.instances(record.id) == 0 &&
      record.condition.find("max(") != record.condition.npos) {
    document.edit(cell("nGL"), "1");
    document.edit(cell("iCageGuide"), "1");
  }
  return document.instances(record.id) > 0;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("every record of the schema: its page is built, edited by typing, and reads back equal",
          "[gui][adrinput][slow]") {
  test::use_qt();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  Document& document = window.document();
  int edited = 0, records = 0;
  for (const deck::RecordSpec& record : deck::schema()) {
    if (record.id == "12") continue;
    INFO("record " << record.id);
    // A deck of any type whose options can be set so that the record is due.
    bool there = false;
    for (const char* type : {"ball", "cylindrical", "tapered"}) {
      document.start_new(type);
      if ((there = make_record_apply(document, record))) break;
    }
    REQUIRE(there);
    ++records;
    window.showRecord(std::string(record.id));
    REQUIRE(window.page()->record() == record.id);
    const int instances = document.instances(record.id);
    if (!record.repeat.empty()) CHECK(instances >= 2);
    for (int instance = 1; instance <= instances; ++instance)
      for (std::size_t v = 0; v < record.variables.size(); ++v) {
        const auto length =
            static_cast<std::size_t>(deck::array_length(document.deck(), record.variables[v]));
        for (std::size_t k = 0; k < length; ++k) {
          const Cell at{std::string(record.id), instance, v, k};
          INFO(record.variables[v].name << " instance " << instance << " element " << k);
          const deck::Deck before = document.deck();
          CHECK(type_into(window, at));
          ++edited;
          const deck::ReadResult back =
              deck::read_deck_text(deck::write_deck(document.deck()), "DATA.txt");
          if (document.instances(record.id) > 0) CHECK(back.deck == document.deck());
          window.undo();
          CHECK(document.deck() == before);
          if (window.currentRecord() != record.id) window.showRecord(std::string(record.id));
        }
      }
  }
  CHECK(records + 1 == static_cast<int>(deck::schema().size()));
  CHECK(edited > 700);
}

TEST_CASE("typing with a German locale writes a decimal point", "[gui][adrinput]") {
  test::use_qt();
  const QLocale old = QLocale();
  QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
  const std::string old_c = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "C.UTF-8"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  {
    DeckWindow window;
    window.show();
    window.showRecord("5A");
    auto* line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell("pitchDia").variable));
    REQUIRE(line != nullptr);
    replace_text(line, "0,0605");
    CHECK(line->text() == "0.0605");
    window.document().save(path);
  }
  std::setlocale(LC_ALL, old_c.c_str());
  QLocale::setDefault(old);
  CHECK(bytes_of(path).find(" 0.0605,") != std::string::npos);
  CHECK(deck::read_deck(path).deck.real("pitchDia") == 0.0605);
}

TEST_CASE("Go Back, Next Rec, Save & Exit and quitting behave as the manual says",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  DeckWindow window;
  window.show();
  CHECK(window.currentRecord() == "1");
  press(window, "back");
  CHECK(take_message(window).contains("first record"));
  press(window, "next");
  CHECK(window.currentRecord() == "2.1");
  press(window, "back");
  CHECK(window.currentRecord() == "1");
  for (std::size_t i = 1; i < window.document().pages().size(); ++i) press(window, "next");
  CHECK(window.currentRecord() == "12");
  press(window, "next");
  CHECK(take_message(window).contains("last record"));

  window.document().edit(cell("pitchDia"), "0.0601");
  CHECK(window.isWindowModified());
  const auto answer = [&](QMessageBox::StandardButton button) {
    CHECK_FALSE(window.close());
    auto* box = window.findChild<QMessageBox*>("unsaved");
    REQUIRE(box != nullptr);
    CHECK(box->text().contains("lost"));
    QTest::mouseClick(box->button(button), Qt::LeftButton);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  };
  answer(QMessageBox::Cancel);
  CHECK(window.isVisible());
  press(window, "save-exit");  // has no name yet
  auto* dialog = window.findChild<QFileDialog*>("save");
  REQUIRE(dialog != nullptr);
  const QString name = folder.filePath("DATA.txt");
  emit dialog->fileSelected(name);
  CHECK_FALSE(window.isVisible());
  CHECK(deck::read_deck(name.toStdString()).deck.real("pitchDia") == 0.0601);

  window.show();
  window.document().edit(cell("pitchDia"), "0.0602");
  answer(QMessageBox::Discard);
  CHECK_FALSE(window.isVisible());
  CHECK(deck::read_deck(name.toStdString()).deck.real("pitchDia") == 0.0601);
}

TEST_CASE("a deck that is refused stays in the window, with the reasons in a message",
          "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  DeckWindow window;
  window.show();
  window.document().save(path);
  const std::string good = bytes_of(path);
  window.showRecord("5A");
  auto* line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell("pitchDia").variable));
  replace_text(line, "tiny");
  auto* remark = window.page()->findChild<QLabel*>("problem-pitchDia");
  REQUIRE(remark != nullptr);
  CHECK(remark->text().contains("not a number"));
  press(window, "save-exit");
  const QString reasons = take_message(window);
  CHECK(reasons.contains("not saved"));
  CHECK(reasons.contains("pitchDia = tiny"));
  CHECK(window.isVisible());
  CHECK(bytes_of(path) == good);

  // The problems panel leads back to the field.
  window.showRecord("1");
  window.nextProblem();
  CHECK(window.currentRecord() == "5A");
  CHECK(line != window.page()->fieldOf(cell("pitchDia").variable));
  line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell("pitchDia").variable));
  CHECK(line->text() == "tiny");
  CHECK(window.focusWidget() == line);
  window.undo();
  CHECK(line->text() == "0.06");
  CHECK(window.page()->findChild<QLabel*>("problem-pitchDia")->text().isEmpty());
}

TEST_CASE("opening: dropped and recent decks, folders, files that are none", "[gui][adrinput]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::ofstream(path) << deck::template_text("tapered");
  DeckWindow window;
  window.show();
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(folder.path())});
  QDragEnterEvent enter({9, 9}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &enter);
  CHECK(enter.isAccepted());
  QDropEvent drop(QPointF(9, 9), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &drop);
  CHECK(window.document().deck() == deck::new_deck("tapered"));
  CHECK(window.windowTitle().startsWith("DATA.txt"));

  window.newDeck("ball");
  CHECK(window.document().deck() == deck::new_deck("ball"));
  auto* recent = window.findChild<QMenu*>("recent");
  emit recent->aboutToShow();
  REQUIRE_FALSE(recent->actions().isEmpty());
  CHECK(recent->actions().front()->text().endsWith("DATA.txt"));
  recent->actions().front()->trigger();
  CHECK(window.document().deck() == deck::new_deck("tapered"));

  const fs::path binary = folder.filePath("picture.png").toStdString();
  std::ofstream(binary, std::ios::binary) << std::string("\x89PNG\0\1\2", 7);
  CHECK_FALSE(window.openFile(binary));
  CHECK(take_message(window).contains("not a text file"));
  CHECK_FALSE(window.openFile(folder.filePath("none.txt").toStdString()));
  CHECK(take_message(window).contains("none.txt"));
  CHECK(window.document().deck() == deck::new_deck("tapered"));
}

TEST_CASE("searching jumps to the field; help tells about the record", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  auto* query = window.findChild<QLineEdit*>("search");
  QTest::keyClicks(query, "pitch diameter");
  QTest::keyClick(query, Qt::Key_Return);
  CHECK(window.currentRecord() == "5A");
  CHECK(window.focusWidget() == window.page()->fieldOf(cell("pitchDia").variable));
  query->clear();
  QTest::keyClicks(query, "crown radius of the roller profile");
  auto* found = window.findChild<QListWidget*>("found");
  REQUIRE(found->count() > 0);
  CHECK(found->item(0)->text().contains("Not in this deck"));
  QTest::keyClick(query, Qt::Key_Return);
  CHECK(take_message(window).contains("not part of this deck"));
  QTest::keyClick(query, Qt::Key_Escape);
  CHECK(query->text().isEmpty());
  int windows = 0;
  for (QAction* action : window.findChild<QMenu*>("help")->actions()) {
    action->trigger();
    if (auto* dialog = window.findChild<QDialog*>("help-window")) {
      ++windows;
      dialog->accept();
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
  }
  CHECK(windows == 4);
}

TEST_CASE("the keyboard is enough: undo in a field, pages, records, tables, lines",
          "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  window.activateWindow();
  REQUIRE(QTest::qWaitForWindowActive(&window));
  window.showRecord("5A");
  auto* line = qobject_cast<QLineEdit*>(window.page()->fieldOf(cell("pitchDia").variable));
  line->setFocus();
  QTest::keyClick(line, Qt::Key_End);
  QTest::keyClicks(line, "12");
  CHECK(window.document().deck().real("pitchDia") == 0.0612);
  QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier);
  CHECK(line->text() == "0.06");
  QTest::keyClick(line, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  CHECK(line->text() == "0.0612");
  CHECK_FALSE(window.document().can_redo());
  QTest::keyClick(line, Qt::Key_PageDown);
  CHECK(window.currentRecord() == "7.0");
  auto* records = window.findChild<QListWidget*>("records");
  records->setFocus();
  QTest::keyClick(records, Qt::Key_Down);
  QTest::keyClick(records, Qt::Key_Down);
  CHECK(window.currentRecord() == "7.2.i");
  CHECK(records->hasFocus());

  auto* table = window.page()->findChild<CellTable*>("instances");
  REQUIRE(table != nullptr);
  REQUIRE(table->focusCell(cell("cageGsCls", 2)));
  QTest::keyClicks(table, "5");
  auto* editor = table->viewport()->findChild<QLineEdit*>();
  REQUIRE(editor != nullptr);
  QTest::keyClicks(editor, "e-4");
  QTest::keyClick(editor, Qt::Key_Tab);  // the last cell: leaves the table
  QCoreApplication::processEvents();
  CHECK(window.document().deck().real("cageGsCls", 2) == 5e-4);
  CHECK_FALSE(table->hasFocus());

  window.showRecord("12");
  auto* lines = window.page()->findChild<QPlainTextEdit*>("lines");
  QTest::keyClicks(lines, "1.0 2.0");
  QTest::keyClick(lines, Qt::Key_Return);
  QTest::keyClicks(lines, "third");
  CHECK(window.document().deck().user_lines == std::vector<std::string>{"1.0 2.0", "third"});
  window.undo();
  CHECK(window.document().deck().user_lines.empty());
  CHECK(lines->toPlainText().isEmpty());
}

TEST_CASE("plan and quasi-static solution are shown beside the form", "[gui][adrinput]") {
  test::use_qt();
  DeckWindow window;
  window.show();
  const auto run = [&](EvaluationPanel& panel, auto start) {
    QSignalSpy spy(&panel, &EvaluationPanel::finished);
    (window.*start)();
    CHECK(panel.busy());
    REQUIRE(spy.wait(60000));
    return panel.text();
  };
  CHECK(run(window.planPanel(), &DeckWindow::showPlan).contains("pocket contact"));
  CHECK(run(window.staticsPanel(), &DeckWindow::runQuasiStatic).contains("Largest contact load"));
  CHECK(window.staticsPanel().headline().contains("Largest contact load"));
  window.document().edit(cell("appLoadX"), "1501");
  CHECK(
      window.staticsPanel().findChild<QLabel*>("note")->text().contains("before the last change"));
  window.undo();
  window.newDeck("cylindrical-nu209");
  CHECK(run(window.staticsPanel(), &DeckWindow::runQuasiStatic).contains("Largest contact load"));
  window.newDeck("ball");
  window.document().edit(cell("pitchDia"), "-1");
  window.showPlan();
  CHECK(take_message(window).contains("errors"));
  CHECK_FALSE(window.planPanel().busy());
}

TEST_CASE("no text is cut off at the sizes people have", "[gui][adrinput][slow]") {
  test::use_qt();
  for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
    DeckWindow window;
    window.resize(size);
    window.show();
    for (const char* type : {"ball", "cylindrical", "spherical", "tapered", "spherical-tapered"}) {
      window.newDeck(type);
      for (const std::string& record : window.document().pages()) {
        window.showRecord(record);
        QCoreApplication::processEvents();
        INFO(type << ", record " << record << ", " << size.width());
        CHECK(window.page()->width() <= window.pageArea().viewport()->width());
        for (const QLabel* label : window.page()->findChildren<QLabel*>()) {
          if (!label->isVisible()) continue;
          INFO(label->text().toStdString());
          CHECK(label->height() >= label->heightForWidth(label->width()));
          if (!label->wordWrap()) CHECK(label->width() >= label->sizeHint().width());
        }
        for (const QComboBox* combo : window.page()->findChildren<QComboBox*>()) {
          INFO(combo->currentText().toStdString());
          CHECK(combo->fontMetrics().horizontalAdvance(combo->currentText()) + 24 < combo->width());
        }
        for (const QLineEdit* line : window.page()->findChildren<QLineEdit*>())
          if (qobject_cast<QComboBox*>(line->parent()) == nullptr && line->isVisible())
            CHECK(line->fontMetrics().horizontalAdvance(line->text()) + 8 < line->width());
      }
    }
  }
}

TEST_CASE("every page as a picture, light and dark", "[gui][adrinput][slow]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path deck = folder.filePath("DATA.txt").toStdString();
  std::ofstream(deck) << deck::template_text("ball");
  RenderOptions options;
  for (const bool dark : {false, true}) {
    options.folder = folder.filePath(dark ? "dark" : "light").toStdString();
    options.dark = dark;
    const auto pictures = render_pages(deck, options);
    CHECK(pictures.size() > 22);
    for (const fs::path& path : pictures) {
      const QImage image(QString::fromStdString(path.string()));
      REQUIRE(image.size() == QSize(1280, 800));
      const int corner = QColor(image.pixel(1278, 560)).lightness();
      CHECK((dark ? corner < 128 : corner > 128));
    }
  }
  desktop::apply_theme(desktop::ThemeKind::Light);
}

TEST_CASE("a random walk never crashes, and what it writes passes the check or is refused",
          "[gui][adrinput][slow]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  std::mt19937 random(20260101);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::vector<std::string> texts = {"0",   "1",    "2",     "3",   "-1",    "9",     "12",
                                          "0,5", "1e-3", "1e999", "abc", "",      "''",    "0.06",
                                          "-5",  "nan",  "1.5d2", "40",  "40000", "a 'b'", "1e-9"};
  constexpr int kActions = 3000;
  int written = 0, refused = 0;
  auto window = std::make_unique<DeckWindow>();
  window->show();
  for (int action = 0; action < kActions; ++action) {
    Document& document = window->document();
    INFO("action " << action);
    const std::size_t what = below(100);
    const auto pages = document.pages();
    if (what < 55) {
      const deck::RecordSpec& spec = *deck::find_record(window->currentRecord());
      if (spec.id == "12") {
        window->page()->findChild<QPlainTextEdit*>()->setPlainText(
            QString::fromStdString(texts[below(texts.size())]));
        window->showRecord(pages[below(pages.size())]);
        continue;
      }
      const std::size_t v = below(spec.variables.size());
      QWidget* field = window->page()->fieldOf(v);
      if (auto* combo = qobject_cast<QComboBox*>(field); combo != nullptr && below(4) != 0) {
        emit combo->activated(static_cast<int>(below(static_cast<std::size_t>(combo->count()))));
      } else if (auto* line = qobject_cast<QLineEdit*>(field)) {
        replace_text(line, QString::fromStdString(texts[below(texts.size())]));
      } else {
        const int instances = std::max(document.instances(spec.id), 1);
        document.edit(
            {std::string(spec.id), 1 + static_cast<int>(below(static_cast<std::size_t>(instances))),
             v, below(4)},
            texts[below(texts.size())]);
      }
    } else if (what < 75) {
      window->showRecord(pages[below(pages.size())]);
    } else if (what < 79) {
      window->nextRecord();
    } else if (what < 82) {
      window->goBack();
    } else if (what < 90) {
      for (std::size_t i = below(6); i > 0; --i) window->undo();
    } else if (what < 93) {
      window->redo();
    } else if (what < 94) {
      const auto& all = deck::templates();
      document.start_new(all[below(all.size())].name);
    } else if (what < 95) {
      window->nextProblem();
    } else if (what < 99) {
      try {
        document.save(path);
        ++written;
        const deck::ReadResult back = deck::read_deck(path);
        CHECK(back.ok());
        CHECK(back.deck == document.deck());
        for (const Issue& issue : facade::check_model(back.deck)) {
          INFO(issue.text());
          CHECK(issue.severity != Severity::Error);
        }
      } catch (const InputError& error) {
        ++refused;
        CHECK(document.has_errors());
      }
    } else if (fs::exists(path)) {
      window->openFile(path);
    }
    while (!take_message(*window).isEmpty()) {
    }
    if (action % 50 == 0) {
      window->checkNow();
      QCoreApplication::processEvents();
    }
  }
  CHECK(written > 5);
  CHECK(refused > 20);
}
