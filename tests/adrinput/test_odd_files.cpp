#include "adrinput/deck_window.hpp"
#include "adrinput/driver.hpp"
#include "deck/templates.hpp"
#include "support/qt_app.hpp"

#include <QGuiApplication>
#include <QTemporaryDir>
#include <catch2/catch.hpp>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

/// Decks as they come from other hands: huge, foreign, damaged, none at all.
using namespace adore;
using namespace adore::adrinput;
namespace fs = std::filesystem;

namespace {

void write_bytes(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string repeated(const std::string& text, int times) {
  std::string out;
  out.reserve(text.size() * static_cast<std::size_t>(times));
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

/// The example's deck with a remark behind the values of its bearing.
std::string remarked(const std::string& remark) {
  std::string deck(deck::template_text("ball"));
  const std::size_t end = deck.find('\n', deck.find("Rec 4"));
  REQUIRE(end != std::string::npos);
  return deck.insert(end, "   " + remark);
}

}  // namespace

TEST_CASE("adrinput: file that is not a deck → rejected with a message, previous deck stays",
          "[gui][adrinput][odd]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("ODD.txt").toStdString();
  fs::create_directory(folder.filePath("empty-folder").toStdString());
  const std::string deck(deck::template_text("ball"));
  const std::vector<std::pair<std::string, QString>> files{
      {repeated(std::string(79, 'x') + "\n", 650000), "larger than 16 MiB"},  // 50 MB
      {deck + repeated("a remark\n", 1000000), "lines and is not a data deck"},
      {repeated("a remark\n", 1000000) + deck, "lines and is not a data deck"},
      {repeated("1.0, 2.0\n", 1500000), "lines and is not a data deck"},
      {std::string("\x7f"
                   "ELF\x02\x01\x01\0\0\0\0\0\0\0\0\0",
                   16) +
           std::string(5000, '\0'),
       "not a text file"},
      {std::string(1000, '\0'), "not a text file"}};
  DeckWindow window;
  window.show();
  window.document().edit(cell("appLoadX"), "1234");
  window.document().end_undo_step();
  const deck::Deck before = window.document().deck();
  const auto refused = [&](const fs::path& file, const QString& why) {
    CHECK_FALSE(window.openFile(file));
    const QString said = take_message(window);
    INFO(said.toStdString());
    CHECK(said.contains(why));
    CHECK(said.size() < 600);
    CHECK(window.document().deck() == before);
    CHECK(QGuiApplication::overrideCursor() == nullptr);
  };
  for (const auto& [bytes, why] : files) {
    write_bytes(path, bytes);
    refused(path, why);
  }
  refused(folder.filePath("empty-folder").toStdString(), "DATA.txt");
  refused(folder.filePath("not-there.txt").toStdString(), "not-there.txt");
}

TEST_CASE("adrinput: empty file → reported; saving to it is rejected with reasons",
          "[gui][adrinput][odd]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  for (const char* bytes : {"", "\n\n \n"}) {
    write_bytes(path, bytes);
    DeckWindow window;
    window.show();
    REQUIRE(window.openFile(path));
    QString problems;
    for (const Problem& problem : window.document().problems())
      problems += QString::fromStdString(problem.issue.text()) + "\n";
    INFO(problems.left(2000).toStdString());
    CHECK(problems.contains("empty"));
    window.save();
    CHECK(take_message(window).contains("not saved"));
    CHECK(bytes_of(path) == bytes);
  }
}

TEST_CASE("saving: line ends, byte-order mark, tabs and non-ASCII letters are kept",
          "[gui][adrinput][odd]") {
  test::use_qt();
  const QTemporaryDir folder;
  const fs::path path = folder.filePath("DATA.txt").toStdString();
  const std::string plain = remarked("Lager für Prüfstand, 7208 µm"), latin = remarked(
                                                                          "Lager f\xfcr Pr\xfc"
                                                                          "fstand, 7208 \xb5m");
  struct Form {
    const char* name;
    std::string bytes, kept;
  };
  const std::string mark = "\xef\xbb\xbf";
  const std::vector<Form> forms{
      {"UTF-8", plain, plain},
      {"CRLF", replaced(plain, "\n", "\r\n"), replaced(plain, "\n", "\r\n")},
      {"byte-order mark", mark + plain, mark + plain},
      {"tabs", replaced(plain, ", ", ",\t"), replaced(plain, ", ", ",\t")},
      {"Latin-1", latin, plain},
      {"all of them", mark + replaced(replaced(plain, ", ", ",\t"), "\n", "\r\n"),
       mark + replaced(replaced(plain, ", ", ",\t"), "\n", "\r\n")}};
  for (const Form& form : forms) {
    INFO(form.name);
    write_bytes(path, form.bytes);
    DeckWindow window;
    window.show();
    REQUIRE(window.openFile(path));
    CHECK_FALSE(window.document().has_errors());
    const std::string old = window.document().text(cell("appLoadX"));
    window.document().edit(cell("appLoadX"), "1234.5");
    window.document().end_undo_step();
    window.save();
    CHECK(take_message(window) == "");
    const std::string saved = bytes_of(path);
    // The changed number alone is another one.
    const std::size_t at = saved.find("1234.5");
    REQUIRE(at != std::string::npos);
    CHECK(saved.substr(0, at) == form.kept.substr(0, at));
    const std::string rest = saved.substr(at + 6);
    REQUIRE(rest.size() < form.kept.size());
    CHECK(form.kept.substr(form.kept.size() - rest.size()) == rest);
    CHECK(deck::read_deck(path).deck.real("appLoadX") == 1234.5);
  }
}
