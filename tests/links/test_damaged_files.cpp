#include "adrinput/deck_window.hpp"
#include "adrplot/own_chart.hpp"
#include "adrplot/plot_document.hpp"
#include "adrplot/plot_window.hpp"
#include "agore/agore_window.hpp"
#include "deck/templates.hpp"
#include "desktop/project.hpp"
#include "support/bytes.hpp"
#include "support/message.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"
#include "support/result_files.hpp"

#include <QFileDialog>
#include <QInputDialog>
#include <QProcess>
#include <QTemporaryDir>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Damaged and newer files in all programs: a message that names the file, no change of the file,
/// and everything that was open stays.
using namespace adore;
namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// Pointers of all members and entries.
void collect(const Json& json, const Json::json_pointer& at,
             std::vector<Json::json_pointer>& pointers) {
  if (json.is_object())
    for (const auto& [key, value] : json.items()) {
      pointers.push_back(at / key);
      collect(value, at / key, pointers);
    }
  if (json.is_array())
    for (std::size_t i = 0; i < json.size(); ++i) {
      pointers.push_back(at / i);
      collect(json[i], at / i, pointers);
    }
}

/// A text of JSON that is cut off, garbage, or has a member less or of another type.
std::vector<std::string> damaged(const std::string& text) {
  std::vector<std::string> out{"",
                               text.substr(0, 1),
                               text.substr(0, text.size() / 3),
                               text.substr(0, text.size() - 3),
                               std::string("\0\xff\xfe\x01garbage", 11),
                               "[]",
                               "{}",
                               "null",
                               "[[[[[[[[",
                               text + text};
  const Json json = Json::parse(text);
  std::vector<Json::json_pointer> pointers;
  collect(json, Json::json_pointer(), pointers);
  for (const Json::json_pointer& pointer : pointers) {
    Json less = json;
    Json& parent = less.at(pointer.parent_pointer());
    if (parent.is_object())
      parent.erase(pointer.back());
    else
      parent.erase(static_cast<std::size_t>(std::stoul(pointer.back())));
    out.push_back(less.dump(1));
    for (const char* const other : {"null", "-1", "1e300", "\"x\"", "[7]"}) {
      Json changed = json;
      changed.at(pointer) = Json::parse(other);
      out.push_back(changed.dump(1));
    }
  }
  return out;
}

/// Bytes of another type of file, cut off, or with damage in the middle.
std::vector<std::string> damaged_bytes(const std::string& bytes) {
  std::vector<std::string> out{"", "garbage", bytes.substr(0, 8), bytes.substr(0, 100),
                               bytes.substr(0, bytes.size() / 2)};
  for (const double part : {0.02, 0.1, 0.4, 0.9}) {
    std::string changed = bytes;
    changed.replace(static_cast<std::size_t>(part * static_cast<double>(bytes.size())), 64, 64,
                    '\x55');
    out.push_back(changed);
  }
  return out;
}

/// Opens the file in a window that already shows something.
struct Outcome {
  bool opened = false;
  QString message;
  bool kept = true;  ///< what was shown before
};
using Open = std::function<Outcome(const fs::path&)>;

/// A damaged file is rejected with a message that names it, or opened as far as it is valid.
void check_damaged(const fs::path& file, const std::vector<std::string>& texts, const Open& open) {
  int rejected = 0;
  for (const std::string& text : texts) {
    INFO(text.substr(0, 600));
    write(file, text);
    const Outcome outcome = open(file);
    CHECK(outcome.kept);
    if (!outcome.opened) {
      ++rejected;
      INFO(outcome.message.toStdString());
      CHECK(outcome.message.contains(QString::fromStdString(file.filename().string())));
    }
    CHECK(test::bytes_of(file) == text);
  }
  CHECK(rejected > 4);
}

void check_newer(const fs::path& file, const std::string& text, const Open& open) {
  write(file, text);
  const Outcome outcome = open(file);
  CHECK_FALSE(outcome.opened);
  CHECK(outcome.kept);
  INFO(outcome.message.toStdString());
  CHECK(outcome.message.contains("newer"));
  CHECK(test::bytes_of(file) == text);
}

Outcome open_in_adrplot(const fs::path& file) {
  adrplot::PlotWindow window;
  window.addFile(test::synthetic_sol(results::SolKind::Power));
  Outcome out;
  out.opened = desktop::is_project(file) ? window.openProject(file) : window.openFile(file);
  out.message = test::take_message(window);
  out.kept = window.fileCount() >= 1 && window.pageCount() > 0;
  return out;
}

Outcome open_in_agore(const fs::path& file) {
  agore::AgoreWindow window;
  window.setAnimation(agore::prepare(test::synthetic_sol8()));
  Outcome out;
  out.opened = desktop::is_project(file) ? window.openProject(file) : window.openFile(file);
  out.message = test::take_message(window);
  out.kept = window.picture() != nullptr && !window.picture()->animation().time.empty();
  return out;
}

/// With an unsaved change.
struct Input {
  explicit Input(const fs::path& deck) {
    window.show();
    REQUIRE(window.openFile(deck));
  }
  [[nodiscard]] bool kept() { return window.document().deck().records.size() > 3; }
  adrinput::DeckWindow window;
};

Outcome open_in_adrinput(const fs::path& file) {
  Input input(file.parent_path() / "DATA.txt");
  input.window.askForProject();
  auto* dialog = input.window.findChild<QFileDialog*>("project");
  REQUIRE(dialog != nullptr);
  emit dialog->fileSelected(QString::fromStdString(file.string()));
  dialog->close();
  Outcome out;
  out.message = test::take_message(input.window);
  auto* decks = input.window.findChild<QInputDialog*>("projectDecks");
  out.opened = decks != nullptr || out.message.startsWith("None of the decks");
  out.kept = input.kept();
  return out;
}

Outcome add_in_adrinput(const fs::path& file) {
  Input input(file.parent_path() / "DATA.txt");
  input.window.addToProject();
  auto* dialog = input.window.findChild<QFileDialog*>("project");
  REQUIRE(dialog != nullptr);
  emit dialog->fileSelected(QString::fromStdString(file.parent_path().string()));
  dialog->close();
  Outcome out;
  out.message = test::take_message(input.window);
  out.opened = out.message.isEmpty();
  out.kept = input.kept();
  return out;
}

/// Folder with a deck, a run of two files, and a project of both.
struct Folder {
  Folder() {
    write(path / "DATA.txt", std::string(deck::template_text("ball")));
    fs::create_directories(path / "run");
    write(path / "run" / "SOL7", test::sol_text(test::synthetic_sol(results::SolKind::Power)));
    write(path / "run" / "SOL8", test::sol8_text(test::synthetic_sol8()));
    desktop::Project project = desktop::Project::open_or_create(path);
    project.add_deck(path / "DATA.txt");
    project.add_run(path / "run");
    project.save();
    text = test::bytes_of(path / desktop::kProjectFile);
  }
  QTemporaryDir temporary;
  fs::path path = fs::path(temporary.path().toStdString());
  std::string text;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  REQUIRE(text.find(from) != std::string::npos);
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("damaged files: PROJECT.json in all programs → message or valid part, file unchanged",
          "[gui][links][slow]") {
  test::use_qt();
  const Folder folder;
  const fs::path file = folder.path / desktop::kProjectFile;
  const std::string newer = replaced(folder.text, "\"version\": 1", "\"version\": 2");
  for (const Open& open : {Open(open_in_adrplot), Open(open_in_agore), Open(open_in_adrinput)}) {
    check_damaged(file, damaged(folder.text), open);
    check_newer(file, newer, open);
  }
}

TEST_CASE("damaged files: deck added to a damaged or newer project → rejected, file unchanged",
          "[gui][links][slow]") {
  test::use_qt();
  const Folder folder;
  const fs::path file = folder.path / desktop::kProjectFile;
  for (const std::string& text :
       {std::string(), folder.text.substr(0, 40), std::string("garbage"), std::string("[]"),
        std::string("{}"), replaced(folder.text, "\"version\": 1", "\"version\": 2"),
        replaced(folder.text, "\"version\": 1", "\"version\": \"1\"")}) {
    INFO(text);
    write(file, text);
    const Outcome outcome = add_in_adrinput(file);
    CHECK_FALSE(outcome.opened);
    CHECK(outcome.kept);
    CHECK(outcome.message.contains("PROJECT.json"));
    CHECK(test::bytes_of(file) == text);
  }
}

TEST_CASE("damaged files: session of AdrPlot → message or valid part, file unchanged",
          "[gui][links][slow]") {
  test::use_qt();
  const Folder folder;
  const fs::path file = folder.path / "work.adrplot";
  {
    adrplot::PlotWindow window;
    REQUIRE(window.openFile(folder.path / "run" / "SOL7"));
    const auto power = std::make_shared<adrplot::PlotDocument>(
        adrplot::open_document(folder.path / "run" / "SOL7"));
    adrplot::FormulaChannel channel{"Twice", "2*a", "W", {}};
    channel.inputs.push_back({"a", power, 1, 0, power->build(1, {}).panels[0].curves[0].name});
    window.addChart({{power.get(), 1, 0, 0}}, adrplot::Combine::Overlay);
    window.addFormula(channel);
    REQUIRE(window.saveSession(QString::fromStdString(file.string())));
  }
  const std::string text = test::bytes_of(file);
  check_damaged(file, damaged(text), open_in_adrplot);
  check_newer(file, replaced(text, "\"adrplot_session\": 1", "\"adrplot_session\": 2"),
              open_in_adrplot);
}

TEST_CASE("damaged files: CHARTS.json of a study → message or valid part, file unchanged",
          "[gui][links][slow]") {
  test::use_qt();
  const Folder folder;
  const fs::path file = folder.path / "CHARTS.json";
  const std::string text = R"([
 {"kind": "curves", "name": "c", "title": "T", "x_title": "x", "y_title": "y", "x_unit": "N",
  "y_unit": "", "curves": [{"name": "n", "x": [1, 2], "y": [1, null], "low": [0, 1],
  "high": [2, 3], "runs": [[1], [2]]}]},
 {"kind": "heat-map", "name": "h", "title": "T", "x_title": "x", "y_title": "y", "legend": "l",
  "unit": "m", "x": [1, 2], "y": [3], "values": [[1, 2]], "marks": [["a", "b"]],
  "runs": [[[1], [2]]]},
 {"kind": "parallel", "name": "p", "title": "T", "heavy": 0, "axes": ["a [m]", "b"],
  "columns": [[1, 2], [3, 4]], "runs": [1, 2]},
 {"kind": "tornado", "name": "t", "title": "T", "x_title": "x",
  "bars": [{"name": "a", "value": 1, "doubt": 0.5}]}])";
  check_damaged(file, damaged(text), [](const fs::path& path) {
    const Outcome out = open_in_adrplot(path);
    if (out.opened) {  // all its pages can be drawn
      adrplot::PlotWindow window;
      window.resize(700, 500);
      REQUIRE(window.openFile(path));
      for (int page = 1; page <= window.pageCount(); ++page) {
        window.showPage(page);
        (void)window.grab();
      }
    }
    return out;
  });
  check_newer(file, replaced(text, "\"tornado\"", "\"violin\""), open_in_adrplot);
}

TEST_CASE("damaged files: RESULTS.h5 in AdrPlot and AGORE → message or valid part, file unchanged",
          "[gui][links][slow]") {
  test::use_qt();
  const Folder folder;
  const QString run = QString::fromStdString((folder.path / "h5").string());
  REQUIRE(QProcess::execute(QString::fromStdString(test::program("adore").string()),
                            {"run", QString::fromStdString((folder.path / "DATA.txt").string()),
                             "--out", run, "--until", "30", "--set", "kPltFreq=5", "--quiet"}) ==
          0);
  const fs::path file = folder.path / "h5" / "RESULTS.h5";
  const std::string bytes = test::bytes_of(file);
  REQUIRE(bytes.size() > 10000);
  for (const Open& open : {Open(open_in_adrplot), Open(open_in_agore)}) {
    check_damaged(file, damaged_bytes(bytes), open);
    write(file, bytes);
    CHECK(open(file).opened);
  }
}
