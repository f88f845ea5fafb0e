#include "adrinput/cell_table.hpp"
#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "adrinput/options_page.hpp"
#include "adrinput/record_page.hpp"
#include "adrinput/render.hpp"
#include "adrinput/typed.hpp"
#include "deck/condition.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "desktop/theme.hpp"
#include "runs/check.hpp"
#include "support/qt_app.hpp"

#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

/// A number other than the present one that the variable takes, as a person may type it.
QString other_value(const Document& document, const Cell& at) {
  const deck::VariableSpec& variable = *variable_of(at);
  if (variable.type == deck::VarType::String) return document.text(at) == "a'b 7" ? "c,d" : "a'b 7";
  // A little more than it was keeps most decks right.
  if (const auto* old = std::get_if<double>(value_at(document.deck(), at));
      old != nullptr && *old != 0.0) {
    const QString more = QString::number(*old * 1.001, 'g', 6);
    if (deck::is_in_range(deck::range_in_deck_units(document.deck(), variable), more.toDouble()))
      return parse_typed_text(variable, QString(more).replace('.', ',').toStdString()).problem
                 ? more  // "1,001" is asked back
                 : QString(more).replace('.', ',');
  }
  for (const char* text :
       {"0,75", "12,5", "1", "2", "3", "-0,25", "60", "0,4", "0,3", "0,05", "0"}) {
    const TypedValue typed = parse_typed_text(variable, text);
    if (typed.problem || shown_text(typed.value) == document.text(at)) continue;
    const auto* real = std::get_if<double>(&typed.value);
    if (real != nullptr &&
        !deck::is_in_range(deck::range_in_deck_units(document.deck(), variable), *real))
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
  const TypedValue expected = parse_typed_text(*variable_of(at), text.toStdString());
  const deck::Value* value = value_at(document.deck(), at);
  return value != nullptr && *value == expected.value;
}

/// Sets options until the deck asks for a record: tries codes of the variables in its condition.
bool make_record_apply(Document& document, const deck::RecordSpec& record) {
  std::vector<std::string> names;
  for (const std::string_view name : deck::variable_names_in(record.condition))
    if (variable_of(cell(std::string(name)))->length == "1") names.emplace_back(name);
  const std::vector<long long> codes = {0, 1, 2, 3, 4, 5, 9, -1};
  std::vector<std::size_t> choice(names.size(), 0);
  deck::ConditionScope scope = deck::condition_scope(document.deck());
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

/// Gives numbers that the rules accept to what nobody gave, as far as guesses go.
void mend(Document& document, std::string_view record) {
  const auto errors = [&] {
    if (document.instances(record) == 0) return std::ptrdiff_t{1000};  // that guess went too far
    return std::count_if(
        document.problems().begin(), document.problems().end(),
        [](const Problem& problem) { return problem.issue.severity == Severity::Error; });
  };
  std::set<Cell> hopeless;
  for (int round = 0; round < 80; ++round) {
    if (!document.has_errors()) document.check_model();
    const auto wrong = std::find_if(document.problems().begin(), document.problems().end(),
                                    [&](const Problem& problem) {
                                      return problem.issue.severity == Severity::Error &&
                                             problem.cell && hopeless.count(*problem.cell) == 0;
                                    });
    if (wrong == document.problems().end()) return;
    const Cell at = *wrong->cell;
    const std::string old = document.text(at);
    const auto before = errors();
    for (const char* guess : {"1", "0.5", "0.05", "0.02", "0.002", "1e-3", "1e-5", "300", "1000",
                              "2e11", "2", "0", "5"}) {
      document.edit(at, guess);
      if (!document.has_errors()) document.check_model();
      if (errors() < before) break;
    }
    document.end_undo_step();
    if (errors() < before) continue;
    document.edit(at, old);
    hopeless.insert(at);
  }
}

}  // namespace

TEST_CASE("every record of the schema: its page is built, edited by typing, and reads back equal",
          "[gui][adrinput][slow]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  DeckWindow window;
  window.resize(1280, 800);
  window.show();
  Document& document = window.document();
  int edited = 0, records = 0, records_saved = 0;
  std::string only_as_text;
  for (const deck::RecordSpec& record : deck::schema()) {
    if (record.id == "12" || deck::is_extension(record.id)) continue;
    INFO("record " << record.id);
    // A deck of any type whose options can be set so that the record is due.
    bool there = false;
    for (const deck::TemplateInfo& info : deck::templates()) {
      document.start_new(info.name);
      const long long count = record.repeat.empty() ? 2 : document.deck().integer(record.repeat);
      if ((there = document.instances(record.id) > 0 && count >= 2)) break;
    }
    for (const char* type : {"ball", "cylindrical", "tapered"}) {
      if (there) break;
      document.start_new(type);
      there = make_record_apply(document, record);
    }
    REQUIRE(there);
    mend(document, record.id);
    REQUIRE(document.instances(record.id) > 0);
    ++records;
    window.showRecord(std::string(record.id));
    REQUIRE(window.page()->record() == record.id);
    int saved = 0;
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
          // Saved as by a user, or unchanged if the typed value makes no valid bearing.
          bool refused = document.has_errors();
          if (!refused) try {
              document.save(path);
              ++saved;
            } catch (const InputError&) {
              refused = true;
            }
          if (refused) deck::write_deck(document.deck(), path);
          const deck::ReadResult back = deck::read_deck(path);
          if (document.instances(record.id) > 0) CHECK(back.deck == document.deck());
          window.undo();
          CHECK(document.deck() == before);
          if (window.currentRecord() != record.id) window.showRecord(std::string(record.id));
        }
      }
    if (saved > 0)
      ++records_saved;
    else
      only_as_text += " " + std::string(record.id);
  }
  const auto elsewhere = std::count_if(
      deck::schema().begin(), deck::schema().end(),
      [](const auto& spec) { return spec.id == "12" || deck::is_extension(spec.id); });
  CHECK(records + elsewhere == static_cast<int>(deck::schema().size()));
  CHECK(edited > 700);
  INFO("records that were in no deck without errors:" << only_as_text);
  CHECK(records_saved >= 84);

  // Record 12, whose lines are text.
  document.start_new("ball");
  window.showRecord("12");
  QTest::keyClicks(window.page()->findChild<QPlainTextEdit*>("lines"), "12.1, 0.5 'x'");
  document.save(path);
  CHECK(deck::read_deck(path).deck == document.deck());
  CHECK(deck::read_deck(path).deck.user_lines == std::vector<std::string>{"12.1, 0.5 'x'"});
}

TEST_CASE("window sizes: common screens → no text is cut off", "[gui][adrinput][slow][sizes]") {
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
        // Results of a thread (seconds next to fTime) are laid out a moment later.
        const auto cut = [](const QLabel* label) {
          return label->isVisible() && label->height() < label->heightForWidth(label->width());
        };
        (void)QTest::qWaitFor(
            [&] {
              const auto labels = window.page()->findChildren<QLabel*>();
              return std::none_of(labels.begin(), labels.end(), cut);
            },
            2000);
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
