#include "adrinput/driver.hpp"
#include "adrinput/notice_bar.hpp"
#include "adrinput/render.hpp"
#include "adrinput/study_form.hpp"
#include "adrinput/study_panel.hpp"
#include "adrinput/study_table.hpp"
#include "adrinput/study_window.hpp"
#include "base/errors.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"
#include "desktop/one_window.hpp"
#include "studies/campaign.hpp"
#include "studies/study_text.hpp"
#include "support/drops.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"

#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

using namespace adore;
using namespace adore::adrinput;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// A folder with the ball example, in a moment of patience.
struct Bench {
  QTemporaryDir folder;
  fs::path path(const std::string& name) const {
    return folder.filePath(QString::fromStdString(name)).toStdString();
  }
  Bench() { std::ofstream(path("DATA.txt")) << deck::template_text("ball"); }
};

void type_cell(StudyTable* table, int row, int column, const QString& text) {
  table->setCurrentCell(row, column);  // which opens its field
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  auto* line = table->findChild<QLineEdit*>();
  REQUIRE(line != nullptr);
  line->selectAll();
  QTest::keyClicks(line, text);
}

void use_program(StudyWindow& window) { window.panel().program = test::program("adore"); }

QLabel* state_of(StudyWindow& window) { return window.findChild<QLabel*>("study-state"); }

}  // namespace

TEST_CASE("study tables: cells of the example studies equal their rows",
          "[gui][adrinput][studies]") {
  for (const char* kind :
       {"sweep", "tolerance", "cage-map", "sensitivity", "worst-case", "what-if"}) {
    const StudyJson json = studies::read_study_text(studies::example_study(kind), "a.json").json;
    for (const StudyTableSpec& table : study_tables()) {
      const std::string key(table.key);
      if (!json.contains(key)) continue;
      for (const StudyJson& row : json[key]) {
        INFO(kind << " " << row.dump());
        CHECK(row_from_cells(key, row_cells(key, row), row) == row);
      }
    }
    for (const StudyField& field : study_fields()) {
      const std::string key(field.key);
      if (!json.contains(key) || key == "deck") continue;
      INFO(kind << " " << key);
      if (!json[key].empty()) CHECK(typed_value(field.cell, shown_value(json[key])) == json[key]);
    }
  }
}

TEST_CASE("study window: typed values → checked with the messages of the command line",
          "[gui][adrinput][studies]") {
  test::use_qt();
  const Bench bench;
  StudyWindow window;
  window.newStudy(bench.path("tolerance.json"), "tolerance", bench.path("DATA.txt"));
  window.show();
  CHECK(state_of(window)->text().startsWith("600 runs."));
  StudyTable* variables = window.form().table("variables");
  REQUIRE(variables != nullptr);
  type_cell(variables, 1, 3, "25, -0.8");
  window.panel().checkNow();
  const std::string said = state_of(window)->text().toStdString();
  CHECK_THAT(said, Contains("variables[2].normal = [25,-0.8]: give [mean, standard deviation]"));
  CHECK(window.panel().finding().key == "variables[2].normal");
  CHECK_FALSE(window.findChild<QPushButton*>("study-run")->isEnabled());
  // The command line reads the same text.
  std::ofstream(bench.path("as-typed.json")) << window.document().text();
  CHECK_THROWS_WITH(studies::open_study(bench.path("as-typed.json")),
                    Contains(said.substr(said.find("variables[2]"))));
  window.document().undo();
  window.panel().checkNow();
  CHECK(state_of(window)->text().startsWith("600 runs."));
  // A row more, a value of the deck that it does not take, and the row gone again.
  type_cell(variables, 4, 0, "nRe");
  variables->setCurrentCell(4, 3);
  type_cell(variables, 4, 3, "7.5, 9.5");
  window.panel().checkNow();
  CHECK_THAT(state_of(window)->text().toStdString(), Contains("nothing was started: run 1"));
  variables->setCurrentCell(4, 0);
  window.findChild<QPushButton*>("remove-variables")->click();
  window.panel().checkNow();
  CHECK(state_of(window)->text().startsWith("600 runs."));
  fs::remove(bench.path("DATA.txt"));
  window.panel().checkNow();
  CHECK_THAT(state_of(window)->text().toStdString(), Contains("there is no deck"));
}

TEST_CASE("study window: plan, run, cancel and resume → no run is lost",
          "[gui][adrinput][studies]") {
  test::use_qt();
  const Bench bench;
  StudyWindow window;
  use_program(window);
  QStringList opened;
  window.panel().launch = [&](const QString& program, const QStringList& files) {
    opened << program << files;
  };
  window.newStudy(bench.path("sweep.json"), "sweep", bench.path("DATA.txt"));
  window.show();
  StudyTable* variables = window.form().table("variables");
  type_cell(variables, 0, 3, "500, 3000, 40");
  window.panel().checkNow();
  CHECK(state_of(window)->text().startsWith("120 runs."));
  CHECK_FALSE(fs::exists(bench.path("sweep.json")));

  QSignalSpy ended(&window.panel(), &StudyPanel::finished);
  window.findChild<QPushButton*>("study-plan")->click();
  REQUIRE(window.panel().busy());
  REQUIRE(ended.wait(60000));
  CHECK(fs::exists(bench.path("sweep.json")));
  CHECK_THAT(
      window.panel().text().toStdString(),
      Contains("runs:      120, 3 of them already done") && Contains("time:") && Contains("disk:"));

  window.findChild<QPushButton*>("study-run")->click();
  QTest::qWait(400);
  window.findChild<QPushButton*>("study-cancel")->click();
  REQUIRE(ended.wait(60000));
  const studies::Study study = studies::open_study(bench.path("sweep.json"));
  const long recorded = studies::study_status(study).done;
  CHECK(recorded >= 3);
  if (recorded < 120) CHECK(window.findChild<QPushButton*>("study-run")->text() == "&Resume");
  {
    StudyWindow again;  // as after another start of the program
    again.openFile(bench.path("sweep.json"));
    CHECK_THAT(again.panel().note().toStdString(),
               Contains(std::to_string(recorded) + " of 120 runs are done"));
  }
  window.findChild<QPushButton*>("study-run")->click();
  REQUIRE(ended.wait(120000));
  CHECK_THAT(window.panel().note().toStdString(),
             Contains("120 runs: 120 done, 0 of them failed") &&
                 Contains(std::to_string(recorded) + " computed earlier"));
  CHECK(studies::study_status(study).done == 120);
  window.findChild<QPushButton*>("study-results")->click();
  CHECK(opened == QStringList({"adrplot", "--project", desktop::folder_of(bench.path("sweep.json")),
                               QString::fromStdString(bench.path("sweep.study"))}));
}

TEST_CASE("a study dropped anywhere on its window opens; a link of the web stays text",
          "[gui][adrinput][studies]") {
  test::use_qt();
  const Bench bench;
  StudyDocument example;
  example.start_new(bench.path("other.json"), "sweep", bench.path("DATA.txt"));
  for (const char* name : {"other.json", "saved.json"})
    std::ofstream(bench.path(name)) << example.text();
  StudyWindow window;
  window.show();
  for (const QPoint& place : test::places_of(window)) {
    INFO(place.x() << ", " << place.y());
    window.openFile(bench.path("saved.json"));
    CHECK(test::drop_on(window, bench.folder.path(), {"other.json"}, place));
    CHECK(window.document().path() == bench.path("other.json"));
  }
  window.showText(true);
  QCoreApplication::processEvents();
  auto* text = window.findChild<QPlainTextEdit*>("study-file");
  QMimeData link;
  link.setUrls({QUrl("https://example.org/DATA.txt")});
  link.setText("https://example.org/DATA.txt");
  test::drop_on(window, link, text->viewport()->mapTo(&window, text->viewport()->rect().center()));
  CHECK(text->toPlainText().contains("https://example.org/DATA.txt"));
  CHECK(window.document().path() == bench.path("other.json"));
}

TEST_CASE("study window: budget exceeded → starts only after confirmation",
          "[gui][adrinput][studies]") {
  test::use_qt();
  const Bench bench;
  StudyWindow window;
  use_program(window);
  window.newStudy(bench.path("sweep.toml"), "sweep", bench.path("DATA.txt"));
  window.show();
  window.document().set_field(*find_study_field("budget.runs"), "5");
  QSignalSpy ended(&window.panel(), &StudyPanel::finished);
  window.findChild<QPushButton*>("study-run")->click();
  REQUIRE(ended.wait(60000));
  CHECK_THAT(window.panel().note().toStdString(), Contains("18 runs, but the budget is 5"));
  auto* anyway = window.findChild<QPushButton*>("study-over-budget");
  REQUIRE(anyway->isVisible());
  // The check that the save asked for comes a moment later, before or after the answer.
  window.panel().checkNow();
  CHECK(anyway->isVisible());
  // Of another study nobody has said that it is too much.
  window.document().set_field(*find_study_field("budget.runs"), "6");
  window.panel().checkNow();
  CHECK_FALSE(anyway->isVisible());
  window.document().undo();
  window.panel().checkNow();
  REQUIRE(anyway->isVisible());
  anyway->click();
  REQUIRE(ended.wait(60000));
  CHECK_THAT(window.panel().note().toStdString(), Contains("18 runs: 18 done"));
  CHECK_THAT(bytes_of(bench.path("sweep.toml")), Contains("budget = {runs = 5"));
}

TEST_CASE("study window: crash → typed values restored; closing asks to save",
          "[gui][adrinput][studies]") {
  test::use_qt();
  const Bench bench;
  std::ofstream(bench.path("a.json")) << studies::example_study("sweep");
  {
    StudyDocument cut_off;
    cut_off.open(bench.path("a.json"));
    cut_off.set_field(*find_study_field("until"), "7rev");
    cut_off.store_unsaved();
  }
  StudyWindow window;
  window.show();
  REQUIRE(window.openFile(bench.path("a.json")));
  REQUIRE(window.notice().isVisible());
  window.notice().findChild<QPushButton*>("restore")->click();
  CHECK(window.document().field(*find_study_field("until")) == "7rev");
  CHECK(window.document().modified());
  window.close();
  auto* box = window.findChild<QMessageBox*>("unsaved");
  REQUIRE(box != nullptr);
  CHECK(window.isVisible());
  box->button(QMessageBox::Save)->click();
  CHECK_FALSE(window.isVisible());
  CHECK_THAT(bytes_of(bench.path("a.json")), Contains("\"until\": \"7rev\""));
  CHECK_FALSE(fs::exists(window.document().unsaved_path()));
  // The remarks of the example are still there.
  CHECK_THAT(bytes_of(bench.path("a.json")), Contains("\"// budget\""));
}

TEST_CASE("results of a study go to the one window of plots that its project has",
          "[gui][adrinput][studies]") {
  test::use_qt();
  const Bench bench;
  std::ofstream(bench.path("a.json")) << studies::example_study("sweep");
  StudyWindow window;
  window.show();
  REQUIRE(window.openFile(bench.path("a.json")));
  std::vector<QStringList> started;
  window.panel().launch = [&](const QString& program, const QStringList& arguments) {
    CHECK(program == "adrplot");
    started.push_back(arguments);
  };
  const QString results = QString::fromStdString(bench.path("a.study").string());
  const QString project = desktop::folder_of(bench.path("a.json"));
  window.panel().openResults();
  REQUIRE(started.size() == 1);
  CHECK(started.front() == QStringList{"--project", project, results});
  QStringList shown;
  const desktop::SingleWindowServer plots("adrplot", project, nullptr,
                                          [&](const QStringList& names) { shown = names; });
  REQUIRE(plots.is_listening());
  window.panel().openResults();
  CHECK(QTest::qWaitFor([&] { return shown == QStringList{results}; }, 5000));
  CHECK(started.size() == 1);
}

TEST_CASE("study window: file that is not JSON → corrected in its text",
          "[gui][adrinput][studies]") {
  test::use_qt();
  const Bench bench;
  std::string text = studies::example_study("sweep");
  text.erase(text.rfind('}'));
  std::ofstream(bench.path("a.json")) << text;
  StudyWindow window;
  window.show();
  REQUIRE(window.openFile(bench.path("a.json")));
  CHECK_THAT(state_of(window)->text().toStdString(), Contains("is not valid JSON"));
  CHECK_FALSE(window.form().isEnabled());
  auto* file = window.findChild<QPlainTextEdit*>("study-file");
  CHECK(file->isVisible());
  file->moveCursor(QTextCursor::End);
  QTest::keyClicks(file, "}");
  window.panel().checkNow();
  CHECK(state_of(window)->text().startsWith("18 runs."));
  CHECK(window.form().isEnabled());
}

TEST_CASE("the pages of a study are drawn without a window", "[gui][adrinput][studies]") {
  test::use_qt();
  const Bench bench;
  std::ofstream(bench.path("a.json")) << studies::example_study("tolerance");
  RenderOptions options;
  options.folder = bench.path("pictures");
  options.width = 700;
  options.height = 450;
  const auto pages = render_study(bench.path("a.json"), options);
  CHECK(pages.size() > 3);
  for (const fs::path& page : pages) CHECK(fs::file_size(page) > 5000);
}

TEST_CASE("study window: new study of any kind → no errors for any bearing and units",
          "[gui][adrinput][studies]") {
  test::use_qt();
  const Bench bench;
  for (const char* type : {"ball", "cylindrical", "tapered", "spherical", "spherical-tapered"})
    for (const auto units : {deck::UnitSystem::SI, deck::UnitSystem::English}) {
      const deck::Deck deck = deck::in_units(deck::new_deck(type), units);
      std::ofstream(bench.path("DATA.txt")) << deck::write_deck(deck);
      for (int kind = 0; kind < studies::kKinds; ++kind) {
        const std::string name(studies::kind_name(static_cast<studies::Kind>(kind)));
        INFO(type << ", " << name << ", kUnit " << deck.integer("kUnit"));
        StudyDocument study;
        study.start_new(bench.path(name + "-new.json"), name, bench.path("DATA.txt"));
        const StudyDocument::Finding found = study.check();
        CHECK(found.problem == "");
        CHECK(found.runs > 1);
        // Ranges contain the value of the deck.
        if (study.values()->contains("variables"))
          for (const StudyJson& row : study.values()->at("variables"))
            for (const char* law : {"grid", "list", "uniform"}) {
              if (!row.contains(law) || !row.contains("name")) continue;
              const auto of = row.at("name").get<std::string>();
              if (!deck.has(of) || deck.real(of) == 0.0) continue;
              const StudyJson& last =
                  row.at(law).at(law == std::string("grid") ? 1 : row.at(law).size() - 1);
              INFO(row.dump());
              const double share = deck.real(of);
              CHECK((row.at(law).at(0).get<double>() <= share || share < 0.0));
              CHECK((last.get<double>() >= share || share < 0.0));
            }
      }
      // The varied variable is the load of this bearing, in its units.
      StudyDocument sweep;
      sweep.start_new(bench.path("s.json"), "sweep", bench.path("DATA.txt"));
      const StudyJson row = sweep.values()->at("variables").at(0);
      const double own = deck.real(row.at("name").get<std::string>());
      CHECK(own != 0.0);
      CHECK(std::abs(row.at("grid").at(0).get<double>()) < std::abs(own));
      CHECK(std::abs(row.at("grid").at(1).get<double>()) > std::abs(own));
    }
}
