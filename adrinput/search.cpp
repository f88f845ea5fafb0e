#include "adrinput/search.hpp"

#include "adrinput/options_page.hpp"

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

int score_of(const deck::RecordSpec& record, const deck::VariableSpec& variable,
             const std::vector<std::string>& words) {
  const std::string name = lowered(variable.name), help = lowered(variable.help);
  const std::string title = lowered(record.title);
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

}  // namespace

std::vector<Found> search_variables(std::string_view query, std::size_t most) {
  std::vector<Found> found;
  const std::vector<std::string> words = words_of(query);
  if (words.empty()) return found;
  const auto search_in = [&](const deck::RecordSpec& record) {
    for (std::size_t v = 0; v < record.variables.size(); ++v) {
      if (record.variables[v].name == "recID") continue;
      const int score = score_of(record, record.variables[v], words);
      if (score == 0) continue;
      Found one;
      one.cell.record = record.id;
      one.cell.variable = v;
      one.score = score;
      found.push_back(std::move(one));
    }
  };
  for (const deck::RecordSpec& record : deck::schema()) search_in(record);
  search_in(options_record());
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.score > b.score; });
  if (found.size() > most) found.resize(most);
  return found;
}

}  // namespace adore::adrinput
