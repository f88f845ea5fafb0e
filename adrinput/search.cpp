#include "adrinput/search.hpp"

#include "adrinput/options_page.hpp"
#include "deck/condition.hpp"
#include "deck/lookup.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace adore::adrinput {
namespace {

constexpr std::array<std::string_view, 18> kEmptyWords = {
    "where", "is", "are", "the", "a",    "an",   "of",  "what", "which",
    "how",   "to", "in",  "do",  "does", "find", "for", "my",   "i"};

std::string lowered(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::vector<std::string> words_of(std::string_view query) {
  std::vector<std::string> words(1);
  for (const char c : lowered(query)) {
    const bool part = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ||
                      static_cast<unsigned char>(c) >= 0x80;
    if (part)
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  std::erase_if(words, [](const std::string& word) {
    return word.empty() ||
           std::find(kEmptyWords.begin(), kEmptyWords.end(), word) != kEmptyWords.end();
  });
  return words;
}

/// The word, or the word without its ending, so that "curvatures" finds "curvature" and "curvature"
/// finds raceCurFac.
bool occurs(const std::string& text, const std::string& word) {
  if (text.find(word) != std::string::npos) return true;
  return word.size() > 4 && word.ends_with('s') &&
         text.find(word.substr(0, word.size() - 1)) != std::string::npos;
}

/// Abbreviated names: "pitch diameter" is in pitchDia, "curvature" in raceCurFac1.
bool abbreviated(const std::string& name, const std::string& word) {
  return word.size() > 4 && name.find(word.substr(0, 3)) != std::string::npos;
}

/// Words of users, and the variables that they mean.
struct Meaning {
  std::string_view phrase, variable;
};
constexpr std::array<Meaning, 34> kMeanings = {{{"radial load", "appLoadZ"},
                                                {"radial force", "appLoadZ"},
                                                {"axial load", "appLoadX"},
                                                {"axial force", "appLoadX"},
                                                {"thrust", "appLoadX"},
                                                {"load", "appLoadZ"},
                                                {"load", "appLoadX"},
                                                {"force", "appLoadZ"},
                                                {"moment", "appMomY"},
                                                {"speed", "rpm2"},
                                                {"rotational speed", "rpm2"},
                                                {"shaft speed", "rpm2"},
                                                {"inner race speed", "rpm2"},
                                                {"outer race speed", "rpm1"},
                                                {"rpm", "rpm2"},
                                                {"oil", "kTrac"},
                                                {"lubricant", "kTrac"},
                                                {"grease", "kTrac"},
                                                {"temperature", "raceTemp2"},
                                                {"bore", "brgBore"},
                                                {"outside diameter", "brgOD"},
                                                {"outer diameter", "brgOD"},
                                                {"ball diameter", "bReDia"},
                                                {"roller diameter", "bReDia"},
                                                {"number balls", "nRe"},
                                                {"number rollers", "nRe"},
                                                {"contact angle", "freeConAng"},
                                                {"clearance", "freeIntCls"},
                                                {"cage", "nCseg"},
                                                {"fit", "raceFit2"},
                                                {"gravity", "gravityVecZ"},
                                                {"tolerance", "tol"},
                                                {"end time", "fTime"},
                                                {"misalignment", "appMis12"}}};

/// A score above all others for the variables that the whole query means, more for the first ones.
int meant(const std::vector<std::string>& words, std::string_view variable) {
  constexpr int kMeant = 1000;
  std::string query;
  for (const std::string& word : words) query += (query.empty() ? "" : " ") + word;
  for (std::size_t i = 0; i < kMeanings.size(); ++i)
    if (kMeanings[i].variable == variable &&
        (query == kMeanings[i].phrase || query == std::string(kMeanings[i].phrase) + "s"))
      return kMeant - static_cast<int>(i);
  return 0;
}

int score_of(const deck::RecordSpec& record, const deck::VariableSpec& variable,
             const std::vector<std::string>& words) {
  const std::string name = lowered(variable.name), help = lowered(variable.help);
  const std::string title = lowered(record.title);
  if (const int score = meant(words, variable.name); score > 0) return score;
  std::string meanings;
  for (const deck::OptionSpec& option : variable.options)
    meanings += lowered(option.meaning) + "\n";
  if (!variable.option_table.empty())
    for (const deck::OptionSpec& option : deck::option_table(variable.option_table))
      meanings += lowered(option.meaning) + "\n";
  int total = 0;
  for (const std::string& word : words) {
    const int score = name == word                 ? 40
                      : occurs(name, word)         ? 12
                      : lowered(record.id) == word ? 10
                      : occurs(help, word)         ? 6
                      : abbreviated(name, word)    ? 5
                      : occurs(title, word)        ? 3
                      : occurs(meanings, word)     ? 2
                                                   : 0;
    if (score == 0) return 0;
    total += score;
  }
  return total;
}

/// Codes to try, the smallest change first.
std::vector<std::string> codes_of(const deck::VariableSpec& option) {
  std::vector<std::string> out;
  for (const deck::OptionSpec& code : option.options)
    if (code.code != "n" && code.code != "-n") out.emplace_back(code.code);
  for (const char* more : {"1", "2", "3", "0", "-1"})
    if (std::find(out.begin(), out.end(), more) == out.end() &&
        deck::is_valid_code(option, std::stoll(more)) &&
        deck::is_in_range(option.range, static_cast<double>(std::stoll(more))))
      out.emplace_back(more);
  return out;
}

/// Does a changed deck ask for the record?
bool asks_for(const deck::Deck& deck, const deck::RecordSpec& spec) {
  return deck::evaluate(spec.condition, deck::condition_scope(deck)) &&
         deck::repeat_count(deck, spec) > 0;
}

std::optional<deck::Deck> with(const deck::Deck& deck, std::string_view name,
                               const std::string& code) {
  deck::Deck changed = deck;
  try {
    changed.set(name, code);
    changed.complete();
  } catch (const InputError&) {
    return std::nullopt;
  }
  return changed;
}

/// The first of two options of a condition that must both change.
std::optional<EnablingOption> first_of_two(const deck::Deck& deck, const deck::RecordSpec& spec,
                                           const std::vector<std::string_view>& names) {
  for (const std::string_view name : names) {
    const deck::VariableRef ref = deck::find_present_variable(deck, name);
    if (ref.record == nullptr) continue;
    for (const std::string& code : codes_of(ref.spec())) {
      const std::optional<deck::Deck> changed = with(deck, name, code);
      if (!changed) continue;
      for (const std::string_view other : names) {
        const deck::VariableRef second = deck::find_present_variable(*changed, other);
        if (other == name || second.record == nullptr) continue;
        for (const std::string& last : codes_of(second.spec()))
          if (const auto both = with(*changed, other, last); both && asks_for(*both, spec)) {
            Cell option;
            option.record = ref.record->id;
            option.variable = ref.position;
            return EnablingOption{option, code, false};
          }
      }
    }
  }
  return std::nullopt;
}

constexpr int kDeepest = 4;  // options that decide whether other options are there

std::optional<EnablingOption> find_way(const deck::Deck& deck, std::string_view record, int depth) {
  const deck::RecordSpec* spec = deck::find_record(record);
  if (spec == nullptr || depth > kDeepest) return std::nullopt;
  std::vector<std::string_view> names = deck::variable_names_in(spec->condition);
  if (!spec->repeat.empty()) names.push_back(spec->repeat);
  std::optional<EnablingOption> first_step;
  for (const std::string_view name : names) {
    const deck::VariableRef ref = deck::find_present_variable(deck, name);
    if (ref.record == nullptr) {
      for (const deck::VariableRef& elsewhere : deck::find_variable(name)) {
        if (first_step || elsewhere.record->id == record) continue;
        first_step = find_way(deck, elsewhere.record->id, depth + 1);
        if (first_step) first_step->enough = false;
      }
      continue;
    }
    for (const std::string& code : codes_of(ref.spec())) {
      const std::optional<deck::Deck> changed = with(deck, name, code);
      if (!changed) continue;
      Cell option;
      option.record = ref.record->id;
      option.variable = ref.position;
      if (asks_for(*changed, *spec)) return EnablingOption{option, code, true};
      // Not enough alone: does it make another option of the condition available?
      if (first_step) continue;
      for (const std::string_view other : names)
        if (other != name && deck::find_present_variable(deck, other).record == nullptr &&
            deck::find_present_variable(*changed, other).record != nullptr)
          first_step = EnablingOption{option, code, false};
    }
  }
  return first_step ? first_step : first_of_two(deck, *spec, names);
}

}  // namespace

std::optional<EnablingOption> find_enabling_option(const deck::Deck& deck,
                                                   std::string_view record) {
  return find_way(deck, record, 0);
}

std::vector<VariableMatch> search_variables(std::string_view query,
                                            const std::function<bool(const Cell&)>& is_here,
                                            std::size_t most) {
  std::vector<VariableMatch> found;
  const std::vector<std::string> words = words_of(query);
  if (words.empty()) return found;
  const auto search_in = [&](const deck::RecordSpec& record) {
    for (std::size_t v = 0; v < record.variables.size(); ++v) {
      if (record.variables[v].name == "recID") continue;
      const int score = score_of(record, record.variables[v], words);
      if (score == 0) continue;
      VariableMatch one;
      one.cell.record = record.id;
      one.cell.variable = v;
      one.score = score;
      found.push_back(std::move(one));
    }
  };
  for (const deck::RecordSpec& record : deck::schema()) search_in(record);
  search_in(options_record());
  // A value of this deck is worth more than the same words in a record that the deck does not have.
  constexpr int kHere = 20;
  if (is_here)
    for (VariableMatch& one : found)
      if (is_here(one.cell)) one.score += kHere;
  std::stable_sort(found.begin(), found.end(), [](const VariableMatch& a, const VariableMatch& b) {
    return a.score > b.score;
  });
  if (found.size() > most) found.resize(most);
  return found;
}

}  // namespace adore::adrinput
