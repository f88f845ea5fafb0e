#include "deck/catalogue.hpp"
#include "deck/deck_text_with_comments.hpp"
#include "deck/templates.hpp"
#include "deck/unit_change.hpp"

#include <catch2/catch.hpp>

#include <map>

using namespace adore;
using Sets = std::vector<std::pair<std::string, std::string>>;

namespace {

std::string example() { return std::string(deck::template_text("ball")); }

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> out{""};
  for (const char c : text)
    if (c == '\n')
      out.emplace_back();
    else
      out.back() += c;
  return out;
}

}  // namespace

TEST_CASE("keep_text(): changed value → rest of the text unchanged", "[unit][deck]") {
  const std::string before = example();
  const deck::DeckTextWithComments after =
      deck::with_values(before, Sets{{"tol", "1e-4"}, {"intMet", "3"}});
  REQUIRE(after.kept);
  const auto a = lines(before), b = lines(after.text);
  REQUIRE(a.size() == b.size());
  std::size_t changed = 0;
  for (std::size_t k = 0; k < a.size(); ++k) changed += a[k] != b[k];
  CHECK(changed == 2);
  CHECK(after.text.find("stpInit stpMin stpMax fTime tol qFac") != std::string::npos);
  CHECK(deck::read_deck_text(after.text, "after").deck.real("tol") == 1e-4);
}

TEST_CASE("keep_text(): byte-order mark, line ends and foreign letters → kept", "[unit][deck]") {
  const std::string plain = example();
  std::string old;
  for (const char c : plain) old += c == '\n' ? std::string("\r\n") : std::string(1, c);
  for (const std::string& text : {plain, old, plain.substr(0, plain.size() - 1)})
    for (const std::string& before : {std::string(), std::string("\xEF\xBB\xBF")})
      for (const std::string& behind :
           {std::string(), std::string("\x1a"), std::string("\x1a\x1a")}) {
        const std::string file = before + text + behind;
        CAPTURE(text.size(), before, behind);
        deck::Deck deck = deck::read_deck_text(file, "before").deck;
        deck.set_all(Sets{{"tol", "1e-4"}});
        for (const deck::DeckTextWithComments& after :
             {deck::with_values(file, Sets{{"tol", "1e-4"}}), deck::with_deck(file, deck)}) {
          REQUIRE(after.kept);
          CHECK(lines(after.text).size() == lines(file).size());
          CHECK(after.text.starts_with(before));
          CHECK(after.text.ends_with(behind));
          std::size_t changed = 0;
          for (std::size_t k = 0; k < lines(file).size(); ++k)
            changed += lines(after.text)[k] != lines(file)[k];
          CHECK(changed == 1);
          CHECK(deck::read_deck_text(after.text, "after").deck == deck);
        }
      }
}

TEST_CASE("keep_text(): every number of a deck can be changed in place", "[unit][deck]") {
  const std::string before = example();
  const deck::Deck deck = deck::read_deck_text(before, "before").deck;
  for (const char* name : {"stpMax", "appLoadX", "pocClsII", "rpm2", "qFac", "temp[2]"}) {
    CAPTURE(name);
    if (!deck.has(std::string(name).substr(0, std::string(name).find('[')))) continue;
    const deck::DeckTextWithComments after = deck::with_values(before, Sets{{name, "0.125"}});
    CHECK(after.kept);
    deck::Deck expected = deck;
    expected.set_all(Sets{{name, "0.125"}});
    CHECK(deck::read_deck_text(after.text, "after").deck == expected);
  }
}

TEST_CASE("keep_text(): value that shares a word with others → text written anew", "[unit][deck]") {
  std::string text = example();
  const std::size_t at = text.find("1.0e-7, 1.0e-7");
  REQUIRE(at != std::string::npos);
  text.replace(at, 14, "2*1.0e-7");
  const deck::Deck deck = deck::read_deck_text(text, "repeated").deck;
  const deck::DeckTextWithComments same = deck::with_values(text, Sets{{"tol", "1e-4"}});
  CHECK(same.kept);
  const deck::DeckTextWithComments other = deck::with_values(text, Sets{{"rmsAspHt1", "2e-7"}});
  CHECK_FALSE(other.kept);
  deck::Deck expected = deck;
  expected.set_all(Sets{{"rmsAspHt1", "2e-7"}});
  CHECK(deck::read_deck_text(other.text, "after").deck == expected);
}

TEST_CASE("keep_text(): records added, removed or enlarged → remarks kept", "[unit][deck]") {
  const std::string before = example();
  const deck::Deck deck = deck::read_deck_text(before, "before").deck;
  const auto with = [&](const Sets& sets) {
    deck::Deck after = deck;
    after.set_all(sets);
    const deck::DeckTextWithComments text = deck::with_deck(before, after);
    CHECK(text.kept);
    CHECK(deck::read_deck_text(text.text, "after").deck == after);
    return text.text;
  };
  const std::string remark = "stpInit stpMin stpMax fTime tol qFac";
  CHECK(with({}) == before);
  CHECK(with({{"tol", "1e-4"}}).find(remark) != std::string::npos);
  // Records that come: imperfections; records that go: everything that only a motion has.
  CHECK(with({{"kReGeoImp", "2"}, {"reDiaVar3", "1e-6"}}).find(remark) != std::string::npos);
  const std::string still = with({{"mode", "-1"}});
  CHECK(still.find(remark) == std::string::npos);
  CHECK(still.find("D, dm, contact angle") != std::string::npos);
}

TEST_CASE("keep_text(): record written anew → remark after it kept", "[unit][deck]") {
  std::string text = example();
  const std::size_t at = text.find("1.0e-7, 1.0e-7");
  REQUIRE(at != std::string::npos);
  text.replace(at, 14, "2*1.0e-7");
  deck::Deck after = deck::read_deck_text(text, "repeated").deck;
  after.set("rmsAspHt1", "2e-7");
  const deck::DeckTextWithComments kept = deck::with_deck(text, after);
  CHECK(kept.kept);
  CHECK(deck::read_deck_text(kept.text, "after").deck == after);
  const auto a = lines(text), b = lines(kept.text);
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] == b[k]) continue;
    const std::size_t remark = a[k].rfind("  ");
    if (remark != std::string::npos) CHECK(b[k].find(a[k].substr(remark + 2)) != std::string::npos);
  }
}

TEST_CASE("keep_text(): lines of user routines and line ends → kept", "[unit][deck]") {
  std::string text = example();
  text += "\n1.5 2.5 my routine\n\n3 4\n";
  std::string dos;
  for (const char c : text) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  deck::Deck after = deck::read_deck_text(dos, "dos").deck;
  REQUIRE(after.user_lines.size() == 2);
  after.set("tol", "1e-4");
  const deck::DeckTextWithComments kept = deck::with_deck(dos, after);
  CHECK(kept.kept);
  CHECK(kept.text.find("my routine\r\n\r\n3 4\r\n") != std::string::npos);
  after.user_lines = {"7 8"};
  const deck::DeckTextWithComments other = deck::with_deck(dos, after);
  CHECK(other.kept);
  CHECK(other.text.find("stpInit stpMin") != std::string::npos);
  CHECK(deck::read_deck_text(other.text, "after").deck == after);
}

namespace {

/// What stands in square brackets, line by line.
std::vector<std::string> brackets(const std::string& text) {
  std::vector<std::string> out;
  for (const std::string& line : lines(text)) {
    const std::size_t open = line.find('['), close = line.find(']', open);
    if (close != std::string::npos) out.push_back(line.substr(open + 1, close - open - 1));
  }
  return out;
}

std::vector<std::string> entries(const std::string& list) {
  std::vector<std::string> out;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t end = std::min(list.find(", ", from), list.size());
    out.push_back(list.substr(from, end - from));
    from = end + 2;
  }
  return out;
}

/// Words behind the values: what is left of a text when every value is taken away.
std::string remark_words(const std::string& text) {
  std::string out;
  for (const std::string& line : lines(text)) {
    const std::size_t blanks = line.rfind("   ");
    out += (blanks == std::string::npos ? "" : line.substr(blanks)) + "\n";
  }
  return out;
}

}  // namespace

TEST_CASE("keep_text(): change of units in every example → units in remarks follow, and back",
          "[unit][deck]") {
  const std::map<std::string, std::string> english = {
      {"m", "in"},     {"N", "lbf"},        {"N.m", "lbf.in"}, {"K", "R"},
      {"m/s", "in/s"}, {"m/s^2", "in/s^2"}, {"s/m", "s/in"},   {"Pa", "lbf/in^2"},
      {"deg", "deg"},  {"rad", "rad"},      {"rpm", "rpm"}};
  std::vector<std::string> texts;
  for (const deck::TemplateInfo& info : deck::templates())
    texts.emplace_back(deck::template_text(info.name));
  for (const char* name : {"6205 C3", "7208 B", "NU209", "30208", "22210", "tapered 40x80x20"})
    texts.push_back(deck::catalogue_deck(deck::find_bearing(name)));
  for (const std::string& text : texts) {
    const deck::Deck deck = deck::read_deck_text(text, "text").deck;
    const bool si = deck.units() == deck::UnitSystem::SI;
    CAPTURE(text.substr(0, 400));
    const deck::Deck other = deck::in_units(deck, deck::other_system(deck.units()));
    const deck::DeckTextWithComments there = deck::with_deck(text, other);
    REQUIRE(there.kept);
    CHECK(there.doubtful_units.empty());
    CHECK(deck::read_deck_text(there.text, "there").deck == other);
    const auto a = brackets(text), b = brackets(there.text);
    REQUIRE(a.size() == b.size());
    REQUIRE_FALSE(a.empty());
    for (std::size_t k = 0; k < a.size(); ++k) {
      const auto was = entries(si ? a[k] : b[k]), is = entries(si ? b[k] : a[k]);
      CAPTURE(a[k], b[k]);
      REQUIRE(was.size() == is.size());
      for (std::size_t e = 0; e < was.size(); ++e) {
        if (english.count(was[e]) == 0) {  // "[1]": a pure number in both
          CHECK(was[e] == is[e]);
          continue;
        }
        CHECK(is[e] == english.at(was[e]));
      }
    }
    const deck::DeckTextWithComments back = deck::with_deck(there.text, deck);
    REQUIRE(back.kept);
    CHECK(back.doubtful_units.empty());
    CHECK(remark_words(back.text) == remark_words(text));
  }
}

TEST_CASE("keep_text(): change of units → foreign remarks kept and listed", "[unit][deck]") {
  const std::string text = example();
  const auto with_remark = [&](const std::string& id, const std::string& remark) {
    std::string out;
    for (const std::string& line : lines(text))
      out +=
          (line.starts_with("'Rec " + id + "'") ? line.substr(0, line.rfind("   ")) + "   " + remark
                                                : line) +
          "\n";
    out.pop_back();
    return out;
  };
  struct Remark {
    const char* words;
    bool speaks_of_si;
  };
  for (const Remark& remark : {Remark{"bore from drawing 4711, 40 mm", true},
                               {"bore 12.7mm", true},
                               {"our bearing [m]", true},
                               {"sizes (m, deg)", true},
                               {"as in the report, item N", false},
                               {"see a.m. of Monday", false},
                               {"in 1/2 in. steps", false},
                               {"0.04 m", true},
                               {"3 parts of 4711", false}}) {
    CAPTURE(remark.words);
    const std::string file = with_remark("4", remark.words);
    REQUIRE(file.find(remark.words) != std::string::npos);
    const deck::Deck deck = deck::read_deck_text(file, "file").deck;
    const deck::DeckTextWithComments after =
        deck::with_deck(file, deck::in_units(deck, deck::UnitSystem::English));
    REQUIRE(after.kept);
    CHECK(after.text.find(remark.words) != std::string::npos);
    CHECK(after.doubtful_units ==
          (remark.speaks_of_si ? std::vector<std::string>{"4"} : std::vector<std::string>{}));
  }
  // Numbers that are kept are in the new units as well; so are the units that are named.
  const deck::DeckTextWithComments kept = deck::with_values(text, Sets{{"kUnit", "2"}});
  REQUIRE(kept.kept);
  CHECK(kept.text.find("displacements [lbf, in]") != std::string::npos);
}
