#include "adrplot/plot_document.hpp"
#include "adrplot/run_beside.hpp"
#include "deck/templates.hpp"
#include "results/sol_file.hpp"
#include "support/paths.hpp"
#include "support/qt_app.hpp"

#include <QProcess>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <filesystem>

using namespace adore;
using namespace adore::adrplot;
using Catch::Contains;
namespace fs = std::filesystem;

namespace {

/// Runs an example with some of its variables set; the folder with its files.
fs::path example(const QTemporaryDir& folder, const std::string& name, const QStringList& sets) {
  const fs::path root = fs::path(folder.path().toStdString()) / name;
  fs::create_directories(root);
  const fs::path deck = root / "DATA.txt";
  deck::write_deck(deck::new_deck(name), deck);
  QStringList words{"run", QString::fromStdString(deck.string()), "--quiet", "--overwrite"};
  for (const QString& set : sets) words << "--set" << set;
  QProcess process;
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(QString::fromStdString(test::program("adore").string()), words);
  REQUIRE(process.waitForFinished(-1));
  INFO(name << ": " << process.readAll().toStdString());
  REQUIRE(process.exitCode() == 0);
  return root;
}

/// The notes under all pages of the run's plot files.
std::string notes_of(const fs::path& root, int& pages) {
  REQUIRE(page_context_of(results::read_sol(root / "SOL1")).fastest_frequency > 1e3);
  std::string notes;
  for (const auto& entry : fs::directory_iterator(root)) {
    const std::string file = entry.path().filename().string();
    if (file.find("SOL") != 0 || file == "SOL8") continue;
    const PlotDocument document = open_document(entry.path());
    for (int page = 1; page <= static_cast<int>(document.pages.size()); ++page, ++pages)
      notes += document.build(page, {}).note + "\n";
  }
  return notes;
}

}  // namespace

// Six hundred integration steps, 0.06 to 1.5 turns: by then each method takes the steps that it
// takes all along.
TEST_CASE("examples: stored often enough for their fastest contact, or noted in their deck",
          "[gui][examples]") {
  test::use_qt();
  const QTemporaryDir folder;
  int moving = 0, for_long_runs = 0;
  for (const deck::TemplateInfo& info : deck::templates()) {
    const std::string name(info.name);
    const deck::Deck deck = deck::new_deck(name);
    if (!deck.has("maxStps") || deck.integer("maxStps") == 0) continue;  // statics alone
    ++moving;
    INFO(name);
    const long long steps = 600 / deck.integer("nStps");
    int pages = 0;
    const std::string notes =
        notes_of(example(folder, name, {QString("maxStps=%1").arg(steps)}), pages);
    CHECK(pages > 30);
    const bool seldom =
        std::string(deck::template_text(name)).find("stored, for long runs") != std::string::npos;
    for_long_runs += seldom ? 1 : 0;
    if (seldom)
      CHECK_THAT(notes, Contains("Aliased"));
    else
      CHECK_THAT(notes, !Contains("Aliased"));
  }
  CHECK(moving == 10);
  CHECK(for_long_runs == 2);  // decision 344
}
