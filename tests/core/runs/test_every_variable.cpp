#include "core/results/synthetic.hpp"
#include "deck/lookup.hpp"
#include "deck/templates.hpp"
#include "runs/prepare.hpp"
#include "runs/run.hpp"
#include "setup/unused_values.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <deque>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

/// Every variable of the schema acts, or is refused, or is said to play no part. Walks the records
/// of decks of all types, quasi-static and in motion; an option that brings other records opens
/// another deck, whose new records are walked in turn.
using namespace adore;
using deck::Deck;
using deck::RecordData;
using deck::Value;
using deck::VariableSpec;
using deck::VarType;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// What a run said of a deck.
struct Outcome {
  bool ran = false;
  std::string refusal;
  std::map<std::string, std::string>
      results;                              ///< by file or part, whatever echoes the deck cut out
  std::map<std::string, std::string> idle;  ///< variable -> why it plays no part
  std::set<std::string> warnings;           ///< of the model, not of one value by itself
};

/// Values of the deck that a result repeats: {"origin": "deck", "value": ...}.
void drop_echoes(json& part) {
  if (part.is_object())
    for (auto it = part.begin(); it != part.end();)
      it = it->is_object() && it->contains("origin") && it->contains("value") ? part.erase(it)
                                                                              : std::next(it);
  if (part.is_structured())
    for (json& item : part) drop_echoes(item);
}

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find(to, begin) - begin);
}

Outcome run_deck(const Deck& deck, const fs::path& folder) {
  Outcome out;
  std::error_code error;
  fs::remove_all(folder, error);
  fs::create_directories(folder);
  deck::write_deck(deck, folder / "DATA.txt");
  runs::RunRequest request;
  request.deck = folder / "DATA.txt";
  runs::RunOutcome run;
  try {
    run = runs::run(request);
  } catch (const InputError& refused) {
    out.refusal = refused.what();
    return out;
  } catch (const SolverError& failed) {
    out.refusal = failed.what();
    return out;
  }
  out.ran = true;
  std::set<std::string> of_values;
  for (const Issue& issue : deck::check_deck(deck)) of_values.insert(issue.message);
  for (const Issue& issue : run.warnings)
    if (of_values.count(issue.message) == 0) out.warnings.insert(issue.message);
  json summary = json::parse(testing::read_bytes(folder / "RUN.json"));
  for (const json& value : summary.at("played_no_part"))
    out.idle[value.at("variable").get<std::string>()] = value.at("because").get<std::string>();
  for (const char* echo : {"measured", "options", "plan", "notes", "findings", "defaults_used",
                           "deck", "integrator", "tolerance", "played_no_part", "request"})
    summary.erase(echo);
  drop_echoes(summary);
  for (const auto& [name, part] : summary.items()) out.results[name] = part.dump();
  for (const fs::path& file : run.files) {
    const std::string name = file.filename().string();
    if (name == "RUN.json" || name == "MASTER") continue;
    const std::string text = testing::read_bytes(file);
    if (name == "PRINT.txt") {
      // Other pages repeat the deck or RUN.json, the last one has times.
      out.results["inertia"] = between(text, "Inertia about", "Traction coefficient");
      out.results["stiffness"] = between(text, "STIFFNESS OVER SPEED", "FATIGUE LIFE");
      out.results["split races"] = between(text, "Split outer race:", "OPERATING FITS") +
                                   between(text, "Split inner race:", "OPERATING FITS");
      out.results["printed steps"] = between(text, "STEP 0", "TIME STEP SUMMARY");
    } else if (name == "FINAL") {
      out.results[name] = text.substr(0, text.find("\ndeck "));
    } else {
      out.results[name] = text;
    }
  }
  return out;
}

/// A deck in which little stands at a value that hides others: fits, temperatures, loads and speeds
/// of both races.
Deck lively(const std::string& type, bool motion) {
  Deck deck = deck::new_deck(type);
  std::vector<std::pair<std::string, std::string>> sets{
      {"mode", motion ? "0" : "-1"}, {"hsngTemp", "303"},  {"shftTemp", "318"},
      {"raceTemp1", "308"},          {"raceTemp2", "323"}, {"reTemp", "333"},
      {"cageTemp", "328"},           {"raceFit1", "5e-6"}, {"raceFit2", "1e-5"},
      {"bPocCls2", "1e-4"},          {"rpm1", "-500"},     {"shftID", "0.01"}};
  if (motion)  // long and wild enough for the cage to meet elements and, at small slips, lands
    for (const auto& set : {std::pair{"maxStps", "90"},
                            {"nStps", "1"},
                            {"kPrtOpt", "1"},
                            {"kPrtFreq", "30"},
                            {"kPltFreq", "20"},
                            {"kAGraf", "20"},
                            {"kLifeFreq", "20"},
                            {"kNumPltElem", "2"},
                            {"kPltElemInd", "1,5"},
                            {"avRatio", "0.05"},
                            {"wvRatio", "400"},
                            {"cageGcPos", "0,0,-7.8e-5"},
                            {"cageGsCls[1]", "2e-4"},
                            {"cageGsCls[2]", "2e-4"}})
      sets.emplace_back(set.first, set.second);
  deck.set_all(sets);
  return deck;
}

/// A few steps that are all written.
const std::vector<std::pair<std::string, std::string>> kShort{
    {"maxStps", "60"},   {"nStps", "1"},       {"kPrtOpt", "1"},
    {"kPrtFreq", "30"},  {"kPltFreq", "20"},   {"kAGraf", "20"},
    {"kLifeFreq", "20"}, {"kNumPltElem", "2"}, {"kPltElemInd", "1,5"}};

/// Rollers that meet flanges, pockets and guide lands within these steps; pocket walls begin beyond
/// the pitch circle, so that rollers touch their edge, and traction falls at slips that occur.
Deck lively_rollers() {
  Deck deck = deck::new_deck("cylindrical");
  auto sets = kShort;
  for (const auto& set : {std::pair{"kFlngInd12", "1"},
                          {"kFlngInd22", "1"},
                          {"flngHt12", "0.0015"},
                          {"flngHt22", "0.0015"},
                          {"flngAng12", "0.5"},
                          {"flngAng22", "0.5"},
                          {"flngCls1", "2e-5"},
                          {"flngCls2", "2e-5"},
                          {"kFS1", "0"},
                          {"appLoadX", "500"},
                          {"reRaceTC4", "0.05"},
                          {"avRatio", "1.3"},
                          {"wvRatio", "40"},
                          {"cageGcPos", "0,0,-1.2e-4"},
                          {"cageDia2", "0.0605"},
                          {"kCagePocImp", "1"},
                          {"bPocThknsVar", "1e-5"},
                          {"cageGsCls[1]", "2.405e-4"},
                          {"cageGsCls[2]", "2.405e-4"}})
    sets.emplace_back(set.first, set.second);
  deck.set_all(sets);
  return deck;
}

/// Two segments that meet their rollers, which lean on the rib.
Deck lively_segments() {
  Deck deck = deck::new_deck("tapered");
  auto sets = kShort;
  for (const auto& set : {std::pair{"nRe", "16"},
                          {"nCseg", "2"},
                          {"cageAngCut", "0.5"},
                          {"lSeg[1]", "1"},
                          {"lSeg[2]", "9"},
                          {"cageGcPos[1]", "0,0,5e-5"},
                          {"avRatio[1]", "1.3"},
                          {"avRatio[2]", "1.2"},
                          {"wvRatio[1]", "1.0"},
                          {"wvRatio[2]", "1.0"}})
    sets.emplace_back(set.first, set.second);
  deck.set_all(sets);
  return deck;
}

/// Something to begin with for the records that an option brings in, whose defaults are 0.
void fill(Deck& deck, const Deck& before) {
  static const std::pair<const char*, double> kValues[] = {
      {"Den", 7800.0},        {"EM", 2e11},           {"PR", 0.3},
      {"CTE", 1.2e-5},        {"RaceTC1", 0.01},      {"RaceTC2", 0.06},
      {"RaceTC3", 0.04},      {"RaceTC4", 0.5},       {"CageTC1", 0.01},
      {"CageTC2", 0.06},      {"CageTC3", 0.04},      {"CageTC4", 0.5},
      {"FlngTC1", 0.01},      {"FlngTC2", 0.06},      {"FlngTC3", 0.04},
      {"FlngTC4", 0.5},       {"TC", 40.0},           {"SH", 450.0},
      {"ESL", 0.02},          {"WC", 1e-6},           {"VM", 5e8},
      {"flngAng", 0.5},       {"flngHt", 0.004},      {"flngCls", 1e-4},
      {"pctDisp", 1.0},       {"rpmRange11", -500},   {"rpmRange21", 0.0},
      {"rpmRange12", 1000.0}, {"rpmRange22", 2000.0}, {"reDiaVar", 1e-6},
      {"reCrnVar", 1e-3},     {"reLenVar", 1e-6},     {"reCLVar", 1e-6},
      {"reCLOffset", 1e-6},   {"rndVar1", 2e-6},      {"rndVar2", 1e-6},
      {"rndVar3", 20.0},      {"cFacVar1", 1e-3},     {"cFacVar2", 2.0},
      {"GsRadVar1", 2e-5},    {"GsRadVar2", 2e-5},    {"GsRadVar3", 20.0},
      {"cFacVar3", 20.0},     {"rlOffset1", 1e-4},    {"rlOffset2", 2.0},
      {"rlOffset3", 20.0},    {"rlTaper1", 1e-2},     {"rlTaper2", 2.0},
      {"rlTaper3", 20.0},     {"cageMass", 0.02},     {"cageMI", 1e-5},
      {"raceMass", 0.3},      {"raceMI", 2e-4},       {"bReMass", 0.009},
      {"bReMI", 1.5e-7},      {"rotLoadFrac", 0.2},   {"rotLoadRpm", 5000.0},
      {"raceVibAmp", 1e-7},   {"raceVibFreq", 900.0}, {"raceAngAcc", 1e6},
      {"endTime", 1.0},       {"raceSpeedAmp", 500},  {"raceSpeedFreq", 900},
      {"brgOrbitRad", 0.05},  {"brgAngVel", 1000.0},  {"brgLoadFrac", 0.3}};
  for (RecordData& record : deck.records) {
    if (before.has_record(record.id, record.instance)) continue;
    const deck::RecordSpec& spec = *deck::find_record(record.id);
    for (std::size_t v = 1; v < record.values.size(); ++v)
      for (Value& value : record.values[v]) {
        const auto* real = std::get_if<double>(&value);
        if (real == nullptr || *real != 0.0) continue;
        const std::string_view name = spec.variables[v].name;
        const auto* known = std::find_if(
            std::begin(kValues), std::end(kValues),
            [&](const auto& k) { return name.find(k.first) != std::string_view::npos; });
        // Waves per turn, or a length [m].
        const bool land_waves = (name == "cageGsRadVar2" && deck.integer("kCageGsImp") == 2) ||
                                (name == "raceGsRadVar2" && deck.integer("kRaceGsImp") == 2);
        const bool waves = land_waves || (name.starts_with("rndVar2") &&
                                          (record.id.ends_with("B") || record.id.ends_with("D")));
        if (waves)
          value = 3.0;
        else if (known != std::end(kValues))
          value = known->second;
        else if (record.id.starts_with("8"))
          value = 60.0;  // hardness
      }
  }
}

std::string name_of(const RecordData& record, const VariableSpec& variable, std::size_t element) {
  std::string name(variable.name);
  if (!deck::find_record(record.id)->repeat.empty()) name += fmt::format("[{}]", record.instance);
  if (variable.length != "1") name += fmt::format("[{}]", element + 1);
  return name;
}

/// Other legal values to try, in that order.
std::vector<std::string> alternatives(const Deck& deck, const VariableSpec& variable,
                                      const Value& value) {
  std::vector<std::string> out;
  const auto add = [&](const std::string& text) {
    if (std::find(out.begin(), out.end(), text) == out.end()) out.push_back(text);
  };
  if (const auto* text = std::get_if<std::string>(&value)) return {*text + "x"};
  if (const auto* integer = std::get_if<long long>(&value)) {
    for (const deck::OptionSpec& option : variable.options)
      if (option.code != "n" && option.code != "-n") add(std::string(option.code));
    if (!variable.option_table.empty())
      for (const deck::OptionSpec& option : deck::option_table(variable.option_table)) {
        if (out.size() < 4) add(std::string(option.code));
      }
    for (const long long other : {3LL, *integer + 1, *integer - 1, *integer + 2, -1LL})
      if ((variable.options.empty() || deck::is_valid_code(variable, other)) &&
          deck::is_in_range(variable.range, static_cast<double>(other)) && out.size() < 8)
        add(fmt::format("{}", other));
    std::erase(out, fmt::format("{}", *integer));
    return out;
  }
  if (const auto* real = std::get_if<double>(&value)) {
    const deck::Range range = deck::range_in_deck_units(deck, variable);
    std::vector<double> numbers;
    if (*real != 0.0)
      for (const double factor : {1.01, 0.99, 1.1, 0.9, 2.0, 0.5, 10.0, 0.1, 1e-3, 1e3, 1e-6, 1e6})
        numbers.push_back(factor * *real);
    else
      for (const double number : {1e-5, 1e-3, 0.1, 1.0, 1e-7, 1e-4, 100.0, 1e4, 1e6, 1e8}) {
        numbers.push_back(number);
        numbers.push_back(-number);
      }
    for (const double number : numbers)
      if (deck::is_in_range(range, number)) add(fmt::format("{}", number));
  }
  return out;
}

class Walk {
 public:
  /// @param numbers_of records, by how their names begin: numbers of those alone, and no options;
  /// none: everything, also what options bring
  /// @param may_be_refused the first deck need not run
  Walk(std::string title, Deck first, std::vector<std::string> numbers_of = {},
       bool may_be_refused = false)
      : title_(std::move(title)),
        numbers_of_(std::move(numbers_of)),
        may_be_refused_(may_be_refused) {
    queue_.push_back(std::move(first));
  }

  void run() {
    while (!queue_.empty()) {
      deck_ = std::move(queue_.front());
      queue_.pop_front();
      base_ = run_deck(deck_, folder_ / "base");
      if (!numbers_of_.empty() && !base_.ran && !may_be_refused_)
        fault("", "does not run: " + base_.refusal);
      if (!base_.ran) continue;  // the option that brought the records is refused
      for (const RecordData& record : deck_.records) queued_.insert(record.id);
      for (const RecordData& record : deck_.records)
        if (wanted(record.id) && walked.insert(record.id).second) walk(record);
    }
  }

  std::set<std::string> walked;  ///< records
  std::vector<std::string> faults;
  std::size_t runs = 0, examined = 0;

 private:
  [[nodiscard]] bool wanted(const std::string& id) const {
    return numbers_of_.empty() ||
           std::any_of(numbers_of_.begin(), numbers_of_.end(),
                       [&](const std::string& start) { return id.starts_with(start); });
  }

  void walk(const RecordData& record) {
    const deck::RecordSpec& spec = *deck::find_record(record.id);
    for (std::size_t v = 1; v < record.values.size(); ++v)
      for (std::size_t k = 0; k < record.values[v].size() && k < 2; ++k)
        examine(record, spec.variables[v], v, k);
  }

  void examine(const RecordData& record, const VariableSpec& variable, std::size_t v,
               std::size_t k) {
    const std::string name = name_of(record, variable, k);
    if (name == "mode" || name == "kUnit" || name == "kBrg") return;  // other walks
    const bool option = !variable.options.empty() || !variable.option_table.empty();
    if (!numbers_of_.empty() && variable.type != VarType::Real) return;
    ++examined;
    const auto told = base_.idle.find(name);
    if (told != base_.idle.end() && told->second == setup::kNoReason)
      fault(name, "plays no part without a reason");
    bool accepted = false, acted = false;
    std::string tried;
    for (const std::string& value : alternatives(deck_, variable, record.values[v][k])) {
      Deck changed = deck_;
      const std::pair<std::string, std::string> set{name, value};
      try {
        changed.set_all({&set, 1});
        fill(changed, deck_);
      } catch (const InputError&) {
        continue;
      }
      bool wrong = false;
      for (const Issue& issue : deck::check_deck(changed))
        wrong = wrong || issue.severity == Severity::Error;
      if (wrong) continue;
      tried += (tried.empty() ? "" : ", ") + value;
      const Outcome outcome = run_deck(changed, folder_ / "changed");
      ++runs;
      if (!outcome.ran) {
        if (option) follow(changed);
        continue;
      }
      accepted = true;
      const bool idle_now = outcome.idle.count(name) > 0;
      const bool same = outcome.results == base_.results;
      // The table of inertia repeats record 6.2, also of a race that is held.
      const auto but_inertia = [](auto results) {
        results.erase("inertia");
        return results;
      };
      if (idle_now && told != base_.idle.end() &&
          but_inertia(outcome.results) != but_inertia(base_.results))
        fault(name, fmt::format("is said to play no part ({}), but {} changes {}", told->second,
                                value, first_change(outcome)));
      const bool acts = idle_now || !same || outcome.warnings != base_.warnings;
      if (option) {
        follow(changed);
        const bool steel = variable.option_table == "@materials" && value == "100";  // 0 means it
        const bool brings = std::any_of(
            changed.records.begin(), changed.records.end(), [&](const RecordData& other) {
              return !deck_.has_record(other.id, other.instance);  // which are walked, too
            });
        // Where it stood it played no part, and at its default it asks for nothing.
        const bool neutral = told != base_.idle.end() && same;
        if (!acts && !steel && !brings && !neutral)
          fault(name, fmt::format("= {} does nothing", value));
        continue;
      }
      acted = acted || acts;
      if (acts) break;
    }
    if (!option && accepted && !acted) fault(name, fmt::format("does nothing (tried {})", tried));
  }

  /// A deck with records that no deck had before is walked, too.
  void follow(const Deck& changed) {
    bool fresh = false;
    for (const RecordData& record : changed.records)
      fresh = queued_.insert(record.id).second || fresh;
    if (fresh) queue_.push_back(changed);
  }

  [[nodiscard]] std::string first_change(const Outcome& outcome) const {
    for (const auto& [part, text] : outcome.results) {
      const auto before = base_.results.find(part);
      if (before == base_.results.end()) return part + " (new)";
      if (before->second != text) {
        const auto at =
            std::mismatch(text.begin(), text.end(), before->second.begin(), before->second.end());
        const auto offset = static_cast<std::size_t>(at.first - text.begin());
        return fmt::format("{} at '{}'", part, text.substr(offset < 60 ? 0 : offset - 60, 90));
      }
    }
    return "files";
  }

  void fault(const std::string& name, const std::string& what) {
    faults.push_back(fmt::format("{}: {} {}", title_, name, what));
  }

  std::string title_;
  std::vector<std::string> numbers_of_;
  bool may_be_refused_;
  testing::TemporaryFolder folder_;
  std::deque<Deck> queue_;
  std::set<std::string> queued_;
  Deck deck_;
  Outcome base_;
};

void check_walk(const std::string& title, const Deck& first,
                const std::vector<std::string>& numbers_of = {}, std::size_t least = 21) {
  Walk walk(title, first, numbers_of);
  walk.run();
  std::string all;
  for (const std::string& fault : walk.faults) all += fault + "\n";
  INFO(walk.runs << " runs, " << walk.walked.size() << " records\n" << all);
  CHECK(walk.faults.empty());
  CHECK(walk.walked.size() >= least);
}

}  // namespace

TEST_CASE("every variable: quasi-static ball deck → acts, is rejected, or is listed as unused",
          "[validation][variables][slow]") {
  check_walk("ball, mode -1", lively("ball", false));
}

TEST_CASE("every variable: ball deck in motion → acts, is rejected, or is listed as unused",
          "[validation][variables][slow]") {
  check_walk("ball, mode 0", lively("ball", true));
}

TEST_CASE("every variable: contacts of moving rollers → acts, or is listed as unused",
          "[validation][variables][slow]") {
  check_walk("cylindrical, mode 0", lively_rollers(), {"2", "5", "7", "9.6", "10"}, 12);
}

TEST_CASE("every variable: contacts of a moving segmented cage → acts, or is listed as unused",
          "[validation][variables][slow]") {
  check_walk("segments, mode 0", lively_segments(), {"5", "7", "9.6", "10"}, 8);
}

TEST_CASE("every variable: quasi-static roller deck → acts, is rejected, or is listed as unused",
          "[validation][variables][slow]") {
  for (const char* type : {"cylindrical", "spherical", "tapered", "spherical-tapered"})
    check_walk(fmt::format("{}, mode -1", type), lively(type, false));
}

namespace {

/// Walks every number of a record beside every other one that is 0, where 0 may stand for "built
/// in", "none" or "automatic" and so hide its neighbors.
/// @return faults, one per line
std::string walk_beside_zeros(const std::string& type, const Deck& deck,
                              const std::vector<std::string>& records, int& pairs) {
  std::string faults;
  for (const RecordData& record : deck.records) {
    if (std::none_of(records.begin(), records.end(),
                     [&](const std::string& start) { return record.id.starts_with(start); }))
      continue;
    const deck::RecordSpec& spec = *deck::find_record(record.id);
    for (std::size_t v = 1; v < record.values.size(); ++v) {
      const VariableSpec& variable = spec.variables[v];
      if (record.values[v].empty()) continue;
      const auto* value = std::get_if<double>(&record.values[v].front());
      if (value == nullptr || *value == 0.0) continue;
      const std::string name = name_of(record, variable, 0);
      Deck at_zero = deck;
      at_zero.set(name, "0.0");
      const auto issues = deck::check_deck(at_zero);
      if (std::any_of(issues.begin(), issues.end(),
                      [](const Issue& i) { return i.severity == Severity::Error; }))
        continue;
      Walk walk(type + ", " + name + " = 0", at_zero, {record.id}, true);
      walk.run();
      pairs += static_cast<int>(walk.examined);
      for (const std::string& fault : walk.faults) faults += fault + "\n";
    }
  }
  return faults;
}

Deck with_given_life_constants(const std::string& type) {
  Deck deck = lively(type, false);
  if (type != "ball") deck.set("appLoadZ", "30000");  // above the fatigue limit
  deck.set("kLifeCons", "1");
  deck.complete();
  for (const auto& [name, value] : {std::pair{"shEx", "9.0"},
                                    {"depEx", "2.0"},
                                    {"wbDis", "1.2"},
                                    {"sProb", "0.9"},
                                    {"brgWbDis", "1.1"}})
    for (const RecordData& record : deck.records)
      for (std::size_t v = 1; v < record.values.size(); ++v) {
        const std::string variable(deck::find_record(record.id)->variables[v].name);
        if (record.id.starts_with("8.6") && variable.starts_with(name)) deck.set(variable, value);
      }
  return deck;
}

}  // namespace

TEST_CASE("every variable: next to a 0 in its record → acts, is rejected or is listed",
          "[validation][variables][slow]") {
  int pairs = 0;
  for (const char* type : {"ball", "cylindrical", "tapered"})
    CHECK(walk_beside_zeros(type, with_given_life_constants(type),
                            {"2", "3", "4", "5", "8", "9", "10"}, pairs) == "");
  CHECK(pairs > 400);
}

TEST_CASE("every variable: unused value of an example → has a reason, in both kinds of run",
          "[unit][variables]") {
  int decks = 0;
  const fs::path folder = test::source_dir() / "resources/decks";
  for (const auto& entry : fs::directory_iterator(folder))
    for (const char* mode : {"own", "-1"}) {
      const std::pair<std::string, std::string> set{"mode", mode};
      runs::DeckRequest request;
      request.deck = entry.path();
      if (set.second != "own") request.sets = {set};
      runs::Prepared prepared;
      try {
        prepared = runs::prepare(request);
      } catch (const InputError& refused) {
        INFO(entry.path() << ": " << refused.what());
        CHECK_THAT(refused.what(), Catch::Contains("does not simulate yet"));
        continue;
      }
      ++decks;
      for (const deck::NoPart& value : prepared.no_part) {
        INFO(entry.path() << ", mode " << mode << ": " << value.variable << " = " << value.value);
        CHECK(value.because != setup::kNoReason);
      }
    }
  CHECK(decks > 15);
}
