#include "core/runs/deck_runs.hpp"
#include "deck/templates.hpp"
#include "runs/output_folder.hpp"
#include "runs/rehearsal.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <exception>
#include <tuple>
#include <unistd.h>

/// Whether a run begins is known before it is started, and in its own words.
using namespace adore;
namespace fs = std::filesystem;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

struct Try {
  const char* what;
  Sets sets;
  std::map<std::string, std::string> options = {};
};

/// Some that begin and some that a run refuses, each by another place of the program.
const std::vector<Try>& tries() {
  static const std::vector<Try> all{
      {"as it is", {}},
      {"the equilibrium alone", {{"mode", "-1"}}},
      {"a method for balls", {{"intMet", "33"}}},
      {"and with damped contacts", {{"intMet", "33"}}, {{"contactDamping", "0.1"}}},
      {"and in force balance", {{"intMet", "33"}, {"mode", "1"}}},
      {"constant steps", {{"intMet", "21"}, {"stpMin", "0.01"}, {"stpMax", "0.01"}}},
      {"steps that are unstable",
       {{"intMet", "1"}, {"stpMin", "1000"}, {"stpMax", "1000"}, {"stpInt", "1000"}}},
      {"a cage far away", {{"cageGcPos[2]", "1"}}},
      {"a cage inside its elements", {{"cageGcPos[1]", "0.001"}}},
      {"a run to go on with", {{"kIcOpt", "1"}}},
      {"a state to start from", {{"kIcOpt", "-1"}}},
      {"a load that no bearing carries", {{"appLoadX", "4e8"}}},
      {"no load at all", {{"appLoadX", "0"}, {"appLoadZ", "0"}}},
      {"a routine that is not there", {{"kDOF", "6"}}},
      {"an option without sense", {}, {{"ellipseMajor", "-3"}}},
  };
  return all;
}

/// Why a run of a step ends before it; empty: it began.
std::string end_of_run(const fs::path& file, const Try& one) {
  runs::RunRequest request;
  request.deck = file;
  request.overwrite = true;
  for (const auto& [name, value] : one.options) request.options.emplace_back(name, value);
  try {
    (void)runs::run(request);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

/// @param path empty: a deck without a name
std::vector<Issue> rehearsed(const deck::Deck& deck, const fs::path& path, const Try& one) {
  runs::LoadedDeck input;
  input.deck = deck;
  input.path = path;
  input.option_values = one.options;
  return runs::dry_run_errors(std::move(input));
}

void compare(const std::string& type) {
  int refused = 0;
  for (const Try& one : tries()) {
    const testing::TemporaryFolder folder;
    INFO(type << ": " << one.what);
    deck::Deck deck = deck::new_deck(type);
    Sets sets{{"maxStps", "1"}, {"nStps", "1"}, {"kAGraf", "0"}};
    for (const auto& [name, value] : one.sets)
      if (deck.has(name.substr(0, name.find('[')))) sets.emplace_back(name, value);
    deck.set_all(sets);
    const fs::path file = folder / "DATA.txt";
    deck::write_deck(deck, file);
    const auto there = [&] {
      return std::distance(fs::directory_iterator(file.parent_path()), fs::directory_iterator());
    };
    const std::vector<Issue> said = rehearsed(deck, file, one);
    CHECK(there() == 1);  // wrote nothing
    const std::string end = end_of_run(file, one);
    INFO("the run: " << end);
    CHECK(said.empty() == end.empty());
    for (const Issue& issue : said) CHECK_THAT(end, Catch::Contains(issue.message));
    refused += said.empty() ? 0 : 1;
  }
  CHECK(refused >= 6);
}

}  // namespace

TEST_CASE("rehearsal: errors of a ball bearing run → same messages", "[unit][rehearsal]") {
  compare("ball");
}

TEST_CASE("rehearsal: errors of roller runs → same messages", "[unit][rehearsal][slow]") {
  for (const char* type : {"cylindrical", "spherical", "tapered", "spherical-tapered"})
    compare(type);
}

TEST_CASE("rehearsal: stop requested → no equilibrium is started", "[unit][rehearsal]") {
  for (const char* type : {"ball", "tapered"}) {
    runs::LoadedDeck input;
    input.deck = deck::new_deck(type);
    std::stop_source stop;
    input.stop = stop.get_token();
    CHECK_NOTHROW(runs::prepare(input));
    stop.request_stop();
    CHECK_THROWS_WITH(runs::prepare(input), Catch::Contains("the search for the equilibrium"));
  }
}

TEST_CASE("rehearsal: deck without a name → from its equilibrium", "[unit][rehearsal]") {
  deck::Deck deck = deck::new_deck("ball");
  CHECK(rehearsed(deck, {}, {}).empty());
  deck.set("cageGcPos[2]", "1");
  const std::vector<Issue> said = rehearsed(deck, {}, {});
  REQUIRE(said.size() == 1);
  CHECK(said[0].record == "9.6");
}

TEST_CASE("rehearsal: folder without write permission → message of the lock", "[unit][rehearsal]") {
  // The superuser writes anywhere: then as somebody else.
  const bool super = ::geteuid() == 0;
  static constexpr uid_t kNobody = 65534;
  std::string name = "/tmp/adore-read-only-XXXXXX";
  REQUIRE(::mkdtemp(name.data()) != nullptr);
  const fs::path folder = name;
  const deck::Deck deck = deck::new_deck("ball");
  struct Nobody {  // until a check fails as well
    explicit Nobody(bool wanted) : changed(wanted && ::seteuid(kNobody) == 0) {}
    ~Nobody() { back(); }
    void back() const {
      if (changed && ::geteuid() != 0 && ::seteuid(0) != 0) std::abort();
    }
    bool changed;
  };
  const auto found = [&](fs::perms permissions) {
    fs::permissions(folder, permissions);
    const Nobody nobody(super);
    REQUIRE(nobody.changed == super);
    const std::vector<Issue> said = rehearsed(deck, folder / "DATA.txt", {});
    std::string lock;
    try {
      const runs::FolderLock held{WriteFolder(folder)};
    } catch (const InputError& error) {
      lock = error.what();
    }
    nobody.back();
    CHECK(said.empty() == lock.empty());
    for (const Issue& issue : said) CHECK_THAT(lock, Catch::Contains(issue.message));
    return said.size();
  };
  constexpr fs::perms kRead = fs::perms::owner_read | fs::perms::owner_exec |
                              fs::perms::group_read | fs::perms::group_exec |
                              fs::perms::others_read | fs::perms::others_exec;
  CHECK(found(kRead) == 1);
  CHECK(found(fs::perms::all) == 0);
  CHECK(fs::is_empty(folder));
  fs::remove(folder);
}

TEST_CASE("plan: end of the run, by steps or time", "[unit][rehearsal]") {
  const testing::TemporaryFolder folder;
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  request.overwrite = true;
  for (const bool steps_end : {true, false}) {
    INFO("steps end it: " << steps_end);
    deck::Deck deck = deck::new_deck("ball");
    const Sets sets{{"maxStps", steps_end ? "300" : "1000000"},
                    {"nStps", "1"},
                    {"kAGraf", "0"},
                    {"fTime", steps_end ? "1e9" : "20"}};
    deck.set_all(sets);
    deck::write_deck(deck, request.deck);
    runs::Progress last;
    (void)runs::run(request, [&](const runs::Progress& p) { last = p; });
    CHECK(last.last_step == (steps_end ? 300 : 0));
    CHECK(last.step > 10);
  }
}

TEST_CASE("rehearsal: method that does not support the deck → error with its variable",
          "[unit][rehearsal]") {
  deck::Deck deck = deck::new_deck("cylindrical");
  for (const char* method : {"33", "1"}) {
    deck.set("intMet", method);
    const std::vector<Issue> said = rehearsed(deck, {}, {});
    REQUIRE(said.size() == 1);
    INFO(said[0].text());
    CHECK(said[0].record == "1");
    CHECK(said[0].variable == "intMet");
    CHECK(said[0].value == method);
    // A method that would be refused in turn is no way out.
    const std::string& text = said[0].message;
    CHECK(text.find("arkode-imex", text.find("allow these steps")) == std::string::npos);
  }
}

TEST_CASE("progress: completed part of a continued run → share of the whole",
          "[unit][continuation]") {
  const testing::TemporaryFolder folder;
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  const auto fractions = [&](const char* steps, const char* until, bool go_on) {
    deck::Deck deck = deck::new_deck("ball");
    const Sets sets{{"maxStps", steps}, {"nStps", "1"}, {"kAGraf", "0"}, {"fTime", "1e9"}};
    deck.set_all(sets);
    deck::write_deck(deck, request.deck);
    request.until = until;
    request.go_on = go_on;
    request.overwrite = !go_on;
    std::vector<runs::Progress> out;
    (void)runs::run(request, [&](const runs::Progress& p) { out.push_back(p); });
    REQUIRE_FALSE(out.empty());
    CHECK(out.back().fraction == 1.0);
    for (std::size_t i = 1; i < out.size(); ++i) CHECK(out[i].fraction >= out[i - 1].fraction);
    return out;
  };
  for (const auto& [until, first, second] :
       {std::tuple{false, "600", "800"}, std::tuple{true, "0.3rev", "0.4rev"}}) {
    INFO("until " << until);
    const auto whole = fractions(until ? "1000000" : first, until ? first : "", false);
    CHECK(whole.front().fraction < 0.7);
    CHECK(whole.back().last_step == (until ? 0 : 600));
    const auto rest = fractions(until ? "1000000" : second, until ? second : "", true);
    CHECK(rest.front().fraction >= 0.75);
    CHECK(rest.front().remaining >= 0.0);
    CHECK(rest.back().last_step == (until ? 0 : 800));  // maxStps counts from where the run began
  }
}
