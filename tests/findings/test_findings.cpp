#include "adrinput/deck_window.hpp"
#include "adrinput/run_panel.hpp"
#include "adrplot/plot_window.hpp"
#include "agore/agore_window.hpp"
#include "base/write_folder.hpp"
#include "desktop/findings_bar.hpp"
#include "results/run_findings.hpp"
#include "results/run_json.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"

#include <QListWidget>
#include <QProcess>
#include <QTemporaryDir>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

/// Each code of the register in command line, RUN.json and all windows (issue 44 C): decks.json.
namespace fs = std::filesystem;
namespace {

using adore::Finding;
using Json = nlohmann::json;
using Codes = std::set<std::string>;

const Json& table() {
  static const Json kTable =
      Json::parse(adore::test::bytes_of(adore::test::source_dir() / "tests/findings/decks.json"));
  return kTable;
}

/// Standard output of the program.
std::string output_of_adore(const QStringList& arguments) {
  adore::test::use_qt();
  QProcess program;
  program.start(QString::fromStdString(adore::test::program("adore").string()), arguments);
  REQUIRE(program.waitForFinished(600000));
  INFO(arguments.join(' ').toStdString() << "\n" << program.readAllStandardError().toStdString());
  CHECK(program.exitStatus() == QProcess::NormalExit);
  return program.readAllStandardOutput().toStdString();
}

void add_codes(const Json& findings, Codes& codes) {
  for (const Json& one : findings) codes.insert(one.at("code").get<std::string>());
}

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// What happens to files between two runs: one is lost, or is of another release.
void disturb(const Json& how, const fs::path& folder) {
  if (how.contains("remove")) {
    REQUIRE(fs::remove(folder / how.at("remove").get<std::string>()));
    return;
  }
  const Json& edit = how.at("replace");
  const fs::path file = folder / edit.at(0).get<std::string>();
  std::string text = adore::test::bytes_of(file);
  const std::string from = edit.at(1);
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  std::ofstream(file) << text.replace(at, from.size(), edit.at(2).get<std::string>());
}

/// Nothing of a finding is in its sentence alone: the sentence without its data is only a remark of
/// the deck, and a value has its quantity.
void check_data(const Json& finding) {
  adore::Issue bare;
  bare.message = finding.at("sentence");
  bare.severity = adore::find_finding_kind(finding.at("code").get<std::string>())->severity;
  CHECK(Finding(bare).code.starts_with("deck."));
  if (finding.contains("value")) CHECK(finding.contains("quantity"));
}

/// Codes in the JSON output of the program.
struct Said {
  Codes all, last;  ///< of all its calls, of the last one
  Codes measured;   ///< with the value of a quantity
  bool error = false;

  void add(const QStringList& arguments) {
    const Json findings = Json::parse(output_of_adore(arguments)).at("findings");
    last.clear();
    add_codes(findings, last);
    all.insert(last.begin(), last.end());
    for (const Json& one : findings) {
      error = error || one.at("severity") == "error";
      check_data(one);
      if (one.contains("value")) measured.insert(one.at("code").get<std::string>());
    }
  }
};

/// Makes and runs a deck of the table in a folder; checks and runs one without "runs".
Said said_by_cli(const Json& deck, const QString& folder) {
  const QString file = folder + "/DATA.txt";
  const std::string from = deck.at("template");
  QStringList make{"new"};
  if (from.starts_with("catalogue:"))
    make << "--catalogue" << QString::fromStdString(from.substr(10));
  else
    make << QString::fromStdString(from);
  const Json sets = deck.value("set", Json::object());
  for (const auto& [name, value] : sets.items())
    make << "--set" << QString::fromStdString(name + "=" + text_of(value));
  output_of_adore(make << "--out" << file);
  const fs::path path = folder.toStdString();
  if (deck.contains("opt")) std::ofstream(path / "ADORE.json") << deck.at("opt").dump();
  const Json files = deck.value("files", Json::object());
  for (const auto& [name, content] : files.items()) std::ofstream(path / name) << content.dump();
  Said out;
  if (!deck.contains("runs")) {
    out.add({"check", file, "--json"});
    if (!out.error) output_of_adore({"run", file, "--until", "1e-6s", "--quiet"});
    return out;
  }
  for (const Json& step : deck.at("runs")) {
    if (step.is_object()) {
      disturb(step, path);
      continue;
    }
    QStringList run{"run", file, "--json", "--progress", "none"};
    for (const std::string argument : step)
      run << QString::fromStdString(argument).replace("FOLDER", folder);
    out.add(run);
  }
  return out;
}

/// Codes that a list of a window shows.
Codes shown_in(QWidget& window) {
  Codes out;
  auto* bar = window.findChild<adore::desktop::FindingsBar*>("findings");
  REQUIRE(bar != nullptr);
  for (int row = 0; row < bar->list().count(); ++row)
    out.insert(bar->list().item(row)->toolTip().toStdString());
  CHECK(bar->isVisibleTo(&window) == !out.empty());
  return out;
}

/// All codes of RUN.json are in the three windows; AGORE has no run without an animation.
void check_windows(const fs::path& folder, const Codes& codes) {
  adore::test::use_qt();
  {
    adore::adrplot::PlotWindow window;
    REQUIRE(window.openFile(folder / (fs::exists(folder / "SOL7") ? "SOL7" : "RUN.json")));
    CHECK(shown_in(window) == codes);
  }
  if (fs::exists(folder / "SOL8")) {
    adore::agore::AgoreWindow window;
    REQUIRE(window.openFile(folder / "SOL8"));
    CHECK(shown_in(window) == codes);
  }
  adore::adrinput::DeckWindow window;
  window.openFile(folder / "DATA.txt");
  CHECK(shown_in(window.runPanel()) == codes);
}

Codes codes_of_run(const fs::path& folder) {
  Codes out;
  for (const Finding& one : adore::results::run_findings(folder)) out.insert(one.code);
  return out;
}

}  // namespace

TEST_CASE("findings: each code of the register has a deck or a reason", "[findings]") {
  Codes made, left;
  for (const Json& deck : table().at("decks"))
    for (const std::string code : deck.at("codes")) made.insert(code);
  for (const auto& [code, reason] : table().at("without_deck").items()) {
    CHECK_FALSE(reason.get<std::string>().empty());
    left.insert(code);
  }
  for (const auto& [code, detailed] : table().at("replaced").items()) {
    INFO(code);
    const adore::FindingKind* kind = adore::find_finding_kind(detailed.get<std::string>());
    REQUIRE(kind != nullptr);
    CHECK("validity." + kind->range == code);
    CHECK(made.count(kind->code) == 1);
    left.insert(code);
  }
  for (const adore::FindingKind& kind : adore::finding_kinds()) {
    INFO(kind.code);
    CHECK(made.count(kind.code) + left.count(kind.code) == 1);
  }
  CHECK(made.size() + left.size() == adore::finding_kinds().size());
}

TEST_CASE("findings: decks of the table lead to their codes in the command line and in RUN.json",
          "[findings][gui][slow]") {
  for (const Json& deck : table().at("decks")) {
    INFO(deck.at("name").get<std::string>());
    const QTemporaryDir folder;
    const fs::path path = folder.path().toStdString();
    const Said said = said_by_cli(deck, folder.path());
    const bool ran = fs::exists(path / "RUN.json");  // not of a sweep, a deck with errors
    const Codes stored = ran ? codes_of_run(path) : Codes();
    for (const std::string code : deck.at("codes")) {
      INFO(code);
      CHECK(said.all.count(code) == 1);
      const adore::FindingKind* kind = adore::find_finding_kind(code);
      REQUIRE(kind != nullptr);
      const bool has_value = !kind->quantity.empty() && !deck.value("without_value", false);
      if (has_value) CHECK(said.measured.count(code) == 1);
      if (ran && kind->origin != "check" && said.last.count(code) == 1)
        CHECK(stored.count(code) == 1);
    }
    for (const auto& [code, detailed] : table().at("replaced").items()) {
      INFO(code << " in place of " << detailed);
      CHECK(said.all.count(code) + stored.count(code) == 0);
    }
    if (!ran) continue;
    if (deck.contains("runs")) CHECK(stored == said.last);
    check_windows(path, stored);
  }
}

TEST_CASE("findings: a run with all codes of the register → each is listed in the three windows",
          "[findings][gui]") {
  const QTemporaryDir folder;
  const Json deck{{"template", "ball"},
                  {"set", {{"kAGraf", 1}, {"kPltFreq", 1}}},
                  {"runs", Json::array({Json::array({"--until", "0.01rev"})})}};
  said_by_cli(deck, folder.path());
  const fs::path run = folder.path().toStdString();
  std::vector<Finding> findings;
  Codes all;
  for (const adore::FindingKind& kind : adore::finding_kinds()) {
    findings.push_back(adore::make_finding(kind.code, "Sentence of " + kind.code));
    all.insert(kind.code);
  }
  adore::results::amend_run(adore::WriteFolder(run), {{"findings", adore::findings_json(findings)}},
                            {});
  REQUIRE(codes_of_run(run) == all);
  check_windows(run, all);
}

TEST_CASE("findings: runs of a study → counted by code in REPORT.txt", "[findings][gui]") {
  const QTemporaryDir folder;
  const std::string path = folder.path().toStdString();
  output_of_adore({"new", "angular-218", "--out", folder.path() + "/DATA.txt"});
  std::ofstream(path + "/a.json") << R"({"adore_study": 1, "kind": "tolerance", "deck": "DATA.txt",
    "options": {"ballFriction": "spin-rule"},
    "variables": [{"name": "rpm2", "uniform": [9900, 10100]}], "sampling": {"runs": 3},
    "quantities": ["load_x_N"]})";
  output_of_adore({"study", "run", folder.path() + "/a.json", "--quiet"});
  const std::string report = adore::test::bytes_of(path + "/a.study/REPORT.txt");
  for (const char* line :
       {"3        warning   statics.shoulder", "3        warning   statics.gyroscopic"})
    CHECK_THAT(report, Catch::Contains(line));
}
