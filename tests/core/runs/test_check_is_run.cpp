#include "base/finding.hpp"
#include "core/results/synthetic.hpp"
#include "deck/catalogue.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "runs/check.hpp"
#include "runs/plan.hpp"
#include "runs/run.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <exception>
#include <fstream>
#include <numeric>
#include <random>
#include <set>

/// `check` and `plan` report what `run` reports before its first step, and reject the same decks:
/// decks of all finding codes and all examples, as they are and with variables changed at random.
using namespace adore;
using deck::Deck;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

using Sets = std::vector<std::pair<std::string, std::string>>;

struct Case {
  std::string name, type;
  Sets sets, options;
  json files;
};

/// The decks of all finding codes with the changes of their first run, then all examples.
std::vector<Case> all_cases() {
  std::vector<Case> out;
  const json table = json::parse(test::bytes_of(test::source_dir() / "tests/findings/decks.json"));
  const auto text = [](const json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
  };
  for (const json& deck : table.at("decks")) {
    Case one{deck.at("name"), deck.at("template"), {}, {}, deck.value("files", json::object())};
    const json sets = deck.value("set", json::object()),
               options = deck.value("opt", json::object());
    for (const auto& [name, value] : sets.items()) one.sets.emplace_back(name, text(value));
    for (const auto& [name, value] : options.items()) one.options.emplace_back(name, text(value));
    if (deck.contains("runs")) {
      const json& words = deck.at("runs").at(0);
      for (std::size_t k = 0; k + 1 < words.size(); ++k) {
        const std::string word = words.at(k), next = words.at(k + 1);
        const std::size_t equals = next.find('=');
        if (word == "--set" && next.find(':') == std::string::npos)
          one.sets.emplace_back(next.substr(0, equals), next.substr(equals + 1));
        if (word == "--opt")
          one.options.emplace_back(next.substr(0, equals), next.substr(equals + 1));
      }
    }
    out.push_back(std::move(one));
  }
  for (const deck::TemplateInfo& info : deck::templates())
    out.push_back({std::string(info.name), std::string(info.name), {}, {}, json::object()});
  return out;
}

Deck deck_of(const Case& one) {
  constexpr std::string_view kCatalogue = "catalogue:";
  Deck out = one.type.starts_with(kCatalogue)
                 ? deck::read_deck_text(
                       deck::catalogue_deck(deck::find_bearing(one.type.substr(kCatalogue.size()))),
                       "DATA.txt")
                       .deck
                 : deck::new_deck(one.type);
  out.set_all(one.sets);
  // One step, and what is stored of it.
  if (out.integer("mode") >= 0 && out.integer("maxStps") > 0) {
    out.set("maxStps", "1");
    out.set("nStps", "1");
  }
  return out;
}

/// A variable of the deck and another value for it, legal or not; empty: none.
std::pair<std::string, std::string> changed_value(const Deck& deck, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (int trial = 0; trial < 50; ++trial) {
    const deck::RecordData& record = deck.records[below(deck.records.size())];
    if (record.values.size() < 2) continue;
    const std::size_t v = 1 + below(record.values.size() - 1);
    const deck::RecordSpec& spec = *deck::find_record(record.id);
    const deck::VariableSpec& variable = spec.variables[v];
    // Of the run's length, or of another deck.
    static const std::set<std::string_view> kLeft{"maxStps", "nStps", "kUnit",
                                                  "kBrg",    "nRe",   "kStif"};
    if (record.values[v].empty() || kLeft.count(variable.name) > 0) continue;
    const std::size_t k = below(record.values[v].size());
    std::string name(variable.name);
    if (!spec.repeat.empty()) name += fmt::format("[{}]", record.instance);
    if (variable.length != "1") name += fmt::format("[{}]", k + 1);
    if (const auto* real = std::get_if<double>(&record.values[v][k])) {
      constexpr double kFactors[] = {0.0, -1.0, 0.5, 2.0, 0.9, 30.0}, kValues[] = {1e-6, 1e-3, 1.0};
      return {name,
              fmt::format("{}", *real != 0.0 ? *real * kFactors[below(6)] : kValues[below(3)])};
    }
    if (const auto* code = std::get_if<long long>(&record.values[v][k])) {
      if (!variable.options.empty()) {
        const std::string_view other = variable.options[below(variable.options.size())].code;
        if (other != "n" && other != "-n") return {name, std::string(other)};
      }
      return {name, fmt::format("{}", *code + static_cast<long long>(below(3)) - 1)};
    }
  }
  return {};
}

/// (code, variable) of findings of deck, statics, scene and start.
using Found = std::set<std::pair<std::string, std::string>>;
Found found(const std::vector<Finding>& findings) {
  static const std::set<std::string> kLater{
      "run.continued",   "run.moved_results",  "thermal.settled",  "thermal.window",
      "thermal.growing", "thermal.film_doubt", "thermal.geometry", "validity.cage.yield"};
  Found out;
  for (const Finding& one : findings) {
    const FindingKind* const kind = find_finding_kind(one.code);
    REQUIRE(kind != nullptr);
    if (kind->origin != "end" && kLater.count(one.code) == 0) out.insert({one.code, one.variable});
  }
  return out;
}

std::string listed(const Found& some, const Found& but) {
  std::string out;
  for (const auto& [code, variable] : some)
    if (but.count({code, variable}) == 0) out += fmt::format(" {}({})", code, variable);
  return out;
}

/// One of three programs: what it reports, or why it rejects the deck.
struct Answer {
  Found findings;
  std::string refusal;
};
template <class Action>
Answer answer_of(Action&& action) {
  Answer out;
  try {
    out.findings = found(action());
  } catch (const std::exception& error) {
    out.refusal = error.what();
  }
  return out;
}

/// What differs; empty: nothing.
std::string compare(const runs::RunRequest& request) {
  const Answer run = answer_of([&] { return runs::run(request).warnings; });
  const Answer plan = answer_of([&] { return runs::plan(request).remarks; });
  std::vector<Finding> errors;
  const Answer check = answer_of([&] {
    std::vector<Finding> all = runs::check(request).issues;
    for (const Finding& one : all)
      if (one.severity == Severity::Error) errors.push_back(one);
    return all;
  });
  std::string out;
  if (plan.refusal != run.refusal)
    out += fmt::format("  run: {}\n  plan: {}\n", run.refusal, plan.refusal);
  if (run.refusal.empty() != (check.refusal.empty() && errors.empty()))
    out += fmt::format("  run: {}\n  check: {}\n", run.refusal,
                       errors.empty() ? check.refusal : errors.front().message);
  for (const Finding& error : errors) {
    const std::string_view prefix = "`adore run` will refuse this deck: ";
    std::string_view text = error.message;
    if (text.starts_with(prefix)) text.remove_prefix(prefix.size());
    if (run.refusal.find(text) == std::string::npos)
      out += fmt::format("  run: {}\n  check: {}\n", run.refusal, error.message);
  }
  if (!run.refusal.empty()) return out;
  const auto differ = [&](const char* name, const Answer& other) {
    const std::string more = listed(other.findings, run.findings),
                      less = listed(run.findings, other.findings);
    if (!more.empty()) out += fmt::format("  {} only:{}\n", name, more);
    if (!less.empty()) out += fmt::format("  not in {}:{}\n", name, less);
  };
  if (plan.refusal.empty()) differ("plan", plan);
  if (check.refusal.empty() && errors.empty()) differ("check", check);
  return out;
}

/// @param changes random changes of each deck, one at a time
/// @param every one of so many decks
/// @return decks compared
int walk(int changes, std::size_t every = 1) {
  const testing::TemporaryFolder folder;
  int decks = 0;
  const std::vector<Case> cases = all_cases();
  for (std::size_t n = 0; n < cases.size(); n += every) {
    const Case& one = cases[n];
    const Deck base = deck_of(one);
    std::mt19937 random(std::accumulate(one.name.begin(), one.name.end(), 875U));
    for (int k = changes == 0 ? 0 : 1; k <= changes; ++k) {
      const auto change =
          k == 0 ? std::pair<std::string, std::string>() : changed_value(base, random);
      const fs::path place = folder / fmt::format("{}", decks);
      fs::create_directories(place);
      runs::RunRequest request;
      request.deck = place / "DATA.txt";
      request.out = place / "results";
      request.options = one.options;
      deck::write_deck(base, request.deck);
      if (!change.first.empty()) request.sets = {change};
      for (const auto& [name, content] : one.files.items()) {
        std::ofstream(place / name) << content.dump();
        if (name == "user.json") request.user = place / name;
      }
      ++decks;
      INFO(one.name << " " << change.first << " " << change.second);
      CHECK(compare(request) == "");
      fs::remove_all(place);
    }
  }
  return decks;
}

}  // namespace

TEST_CASE("check and plan: decks of all findings and examples → findings and rejections of run",
          "[check][slow]") {
  CHECK(walk(0) > 90);
}

TEST_CASE(
    "check and plan: decks with a variable changed at random → findings and rejections of run",
    "[check][slow]") {
  CHECK(walk(1, 4) > 20);
}

TEST_CASE("check and plan: every deck with two variables changed at random → as run",
          "[check][slow][nightly]") {
  CHECK(walk(2) > 180);
}
