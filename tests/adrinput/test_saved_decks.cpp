#include "adrinput/document.hpp"
#include "adrinput/driver.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "runs/check.hpp"
#include "support/paths.hpp"

#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

/// Reading and writing of decks on the disk, including broken decks.
using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& path, std::string_view text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::vector<fs::path> bad_decks() {
  std::vector<fs::path> out;
  for (const auto& entry :
       fs::directory_iterator(adore::test::source_dir() / "tests" / "decks" / "bad"))
    if (entry.path().extension() == ".txt") out.push_back(entry.path());
  std::sort(out.begin(), out.end());
  return out;
}

bool errors_in(const std::vector<Issue>& issues) {
  return std::any_of(issues.begin(), issues.end(),
                     [](const Issue& issue) { return issue.severity == Severity::Error; });
}

}  // namespace

TEST_CASE("example decks: the second save has the same bytes as the first", "[unit][adrinput]") {
  const QTemporaryDir folder;
  for (const deck::TemplateInfo& info : deck::templates()) {
    INFO(info.name);
    const fs::path path = folder.filePath("DATA.txt").toStdString();
    const fs::path backup = path.string() + ".bak";
    fs::remove(backup);
    const std::string original(deck::template_text(info.name));
    write(path, original);
    Document document;
    document.open(path);
    CHECK_FALSE(document.modified());
    CHECK(document.deck() == deck::new_deck(info.name));
    document.save(path);
    CHECK(bytes_of(path) == original);  // with its remarks
    document.open(path);
    document.save(path);
    CHECK(bytes_of(path) == original);
    CHECK_FALSE(fs::exists(backup));  // nothing was lost
    CHECK(deck::read_deck(path).deck == deck::new_deck(info.name));
  }
}

TEST_CASE("a deck that adore check refuses is not written, and the reason is given",
          "[unit][adrinput]") {
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  Document document;
  document.save(path);
  const std::string good = bytes_of(path);
  const auto refused = [&] {
    try {
      document.save(path);
    } catch (const InputError& error) {
      return !error.issues().empty() && bytes_of(path) == good;
    }
    return false;
  };
  document.edit(cell("pitchDia"), "0.001");
  CHECK(refused());
  document.undo();
  document.edit(cell("bReDia"), "twelve");
  CHECK(refused());
  document.undo();
  document.set_user_lines({"'Rec 5A', 1.0, 2.0"});
  CHECK(refused());
  document.undo();
  document.edit(cell("runID"), "name with trailing blanks  ");
  document.edit(cell("rmsAspHt1"), "");
  CHECK(refused());
  document.edit(cell("rmsAspHt1"), "2e-7");
  document.set_user_lines({"12.1, 3.0 first line of a routine", "  second  "});
  document.save(path);
  const deck::ReadResult back = deck::read_deck(path);
  CHECK(back.ok());
  CHECK(back.deck == document.deck());
  CHECK(back.deck.user_lines.size() == 2);
  CHECK_THROWS_AS(document.save(fs::path(folder.path().toStdString()) / "none" / "DATA.txt"),
                  InputError);
}

TEST_CASE(
    "broken decks: every problem is shown, nothing typed is lost, and only a right deck is "
    "written",
    "[unit][adrinput]") {
  const QTemporaryDir folder;
  const std::vector<fs::path> decks = bad_decks();
  REQUIRE(decks.size() > 20);
  int with_text = 0, saved = 0;
  for (const fs::path& bad : decks) {
    INFO(bad.string());
    const fs::path path = folder.filePath("DATA.txt").toStdString();
    const fs::path backup = path.string() + ".bak";
    fs::remove(backup);
    const std::string original = bytes_of(bad);
    write(path, original);
    Document document;
    deck::ReadResult read;
    try {
      read = deck::read_deck(path);
    } catch (const InputError&) {
      CHECK_THROWS_AS(document.open(path), InputError);
      continue;
    }
    document.open(path);
    document.check_model();
    CHECK(document.original() == original);
    for (const Issue& issue : read.issues) {
      INFO(issue.text());
      const auto shown = [&](const Problem& problem) {
        return problem.issue.record == issue.record &&
               (problem.issue.message.find(issue.message) != std::string::npos ||
                (!issue.variable.empty() && problem.cell == cell_of(issue)));
      };
      CHECK(std::any_of(document.problems().begin(), document.problems().end(), shown));
      const std::optional<Cell> at = cell_of(issue);
      if (!at || issue.value.empty() || value_at(document.deck(), *at) == nullptr) continue;
      const deck::VariableSpec& variable = *variable_of(*at);
      if (variable.type == deck::VarType::String || variable.length != "1") continue;
      if (document.text(*at) == issue.value) ++with_text;
    }
    try {
      document.save(path);
      ++saved;
      const deck::ReadResult back = deck::read_deck(path);
      CHECK_FALSE(errors_in(back.issues));
      CHECK_FALSE(errors_in(runs::check_model(back.deck)));
      if (!read.ok()) CHECK(bytes_of(backup) == original);
    } catch (const InputError& error) {
      CHECK_FALSE(error.issues().empty());
      CHECK(bytes_of(path) == original);
    }
  }
  CHECK(with_text > 10);
  CHECK(saved < static_cast<int>(decks.size()));
}

TEST_CASE(
    "damaged decks: truncated, repeated and swapped lines, huge counts, non-ASCII letters, line "
    "ends",
    "[unit][adrinput]") {
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  const std::string good = deck::write_deck(deck::new_deck("ball"));
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < good.size();) {
    const std::size_t end = good.find('\n', at);
    lines.push_back(good.substr(at, end - at + 1));
    at = end + 1;
  }
  const auto joined = [](const std::vector<std::string>& parts) {
    std::string out;
    for (const std::string& part : parts) out += part;
    return out;
  };
  std::vector<std::string> texts;
  for (std::size_t i = 1; i < 60; ++i) texts.push_back(good.substr(0, good.size() * i / 60));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<std::string> changed = lines;
    changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(i), lines[i]);
    texts.push_back(joined(changed));
    changed = lines;
    std::swap(changed[i], changed[(i + 1) % lines.size()]);
    texts.push_back(joined(changed));
    changed = lines;
    changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(i));
    texts.push_back(joined(changed));
    changed = lines;  // every number of a line gone wild
    for (char& c : changed[i])
      if (c == '1') c = '9';
    for (const char* wild : {", 999999999", ", -7", ", 1e999", ", 'text'", ", nan"}) {
      const std::size_t comma = lines[i].find(',');
      std::string line = lines[i];
      const std::size_t next = comma == std::string::npos ? comma : line.find(',', comma + 1);
      if (next == std::string::npos) continue;
      line.replace(comma, next - comma, wild);
      std::vector<std::string> wilder = lines;
      wilder[i] = line;
      texts.push_back(joined(wilder));
    }
    texts.push_back(joined(changed));
  }
  std::string crlf;
  for (const char c : good) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  texts.push_back(crlf);
  std::string latin = good;
  latin.insert(latin.find('\'', latin.find("Rec 3.1") + 10) + 1, "W\xE4lzlager \xD8 40 ");
  texts.push_back(latin);
  std::string high;
  for (int i = 0; i < 20000; ++i) high += static_cast<char>(0x80 + i * 7 % 128);
  texts.push_back(high);
  texts.push_back(std::string(300000, '\''));
  texts.push_back(std::string(300000, ','));
  texts.push_back("\xEF\xBB\xBF" + good);
  for (int i = 0; i < 3; ++i) high += good;
  texts.push_back(high);

  int refused = 0, saved = 0;
  for (const std::string& text : texts) {
    INFO(text.substr(0, 3000));
    write(path, text);
    fs::remove(path.string() + ".bak");
    const deck::ReadResult read = deck::read_deck(path);
    Document document;
    document.open(path);
    document.check_model();
    CHECK(document.original() == text);
    CHECK_FALSE(document.modified());
    if (errors_in(read.issues)) CHECK_FALSE(document.problems().empty());
    for (const Issue& issue : read.issues) {
      if (text == latin || text == high) break;  // their letters are others after decoding
      const std::optional<Cell> at = cell_of(issue);
      const auto shown = [&](const Problem& problem) {
        return problem.issue.record == issue.record &&
               (problem.issue.message.find(issue.message) != std::string::npos ||
                (at && problem.cell && problem.cell->variable == at->variable));
      };
      INFO(issue.text());
      CHECK(std::any_of(document.problems().begin(), document.problems().end(), shown));
    }
    // Values that could be read are at their place in the file.
    for (const deck::RecordData& record : read.deck.records) {
      const deck::RecordData* here =
          deck::find_record_data(document.deck(), record.id, record.instance);
      if (here == nullptr) continue;
      for (std::size_t v = 1; v < record.values.size(); ++v)
        for (std::size_t k = 0; k < record.values[v].size(); ++k) {
          const auto* real = std::get_if<double>(&record.values[v][k]);
          if (real == nullptr || k >= here->values[v].size()) continue;
          CHECK(here->values[v][k] == record.values[v][k]);
        }
    }
    // A later session finds the same.
    Document again;
    CHECK(again.restore(document.snapshot("1")) == "1");
    CHECK(again.deck() == document.deck());
    again.check_model();
    CHECK(again.problems().size() == document.problems().size());
    try {
      document.save(path);
      ++saved;
      CHECK_FALSE(errors_in(deck::read_deck(path).issues));
      // The old file is kept as a copy unless the new one has all its contents.
      if (!read.ok() && deck::write_deck(read.deck) != text)
        CHECK(bytes_of(path.string() + ".bak") == text);
      else if (deck::write_deck(read.deck) != text && bytes_of(path) != text)
        CHECK((fs::exists(path.string() + ".bak") || deck::with_deck(text, document.deck()).kept));
    } catch (const InputError& error) {
      ++refused;
      CHECK_FALSE(error.issues().empty());
      CHECK(bytes_of(path) == text);
    }
  }
  CHECK(refused > 100);
  CHECK(saved > 10);

  write(path, latin);
  Document document;
  document.open(path);
  CHECK(document.text(cell("runID")).find("W\u00e4lzlager \u00d8 40") != std::string::npos);
  REQUIRE_FALSE(document.problems().empty());
  CHECK(document.problems().back().issue.message.find("Latin-1") != std::string::npos);
  const deck::Deck before = document.deck();
  for (const std::string& garbage : {std::string("\x7f"
                                                 "ELF\x02\x01\x01\0\0\0",
                                                 10),
                                     std::string(5000, '\0')}) {
    write(path, garbage);
    CHECK_THROWS_AS(document.open(path), InputError);
    CHECK(document.deck() == before);
  }
  CHECK_THROWS_AS(document.restore("not a snapshot"), InputError);
  CHECK(document.deck() == before);
}

TEST_CASE("adrinput: remark of a file on its deck → unchanged after saving", "[unit][adrinput]") {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("DATA.txt").toStdString();
  std::string text = deck::write_deck(deck::new_deck("ball"));
  for (int line = 0; line < 20; ++line) text += "1 2 3 a line of somebody\n";
  std::ofstream(file, std::ios::binary) << text;
  Document document;
  document.open(file);
  const auto told = [&] {
    return std::count_if(
        document.problems().begin(), document.problems().end(), [](const Problem& problem) {
          return problem.issue.message.find("after the last required record") != std::string::npos;
        });
  };
  REQUIRE(told() == 1);
  document.edit(cell("brgBore"), "0.041");
  document.end_undo_step();
  document.save(file);
  CHECK(told() == 1);
  Document again;
  again.open(file);
  again.check_model();  // as saving does
  CHECK(again.problems().size() == document.problems().size());
}
