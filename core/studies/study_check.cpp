#include "studies/study_check.hpp"

#include "base/errors.hpp"
#include "runs/deck_request.hpp"
#include "runs/option_file.hpp"
#include "studies/quantity_check.hpp"
#include "studies/worst_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace adore::studies {
namespace {

/// A point's own sets replace those of the study.
Settings over(Settings base, const Settings& more) {
  for (const auto& [name, value] : more) {
    std::erase_if(base, [&](const auto& old) { return old.first == name; });
    base.emplace_back(name, value);
  }
  return base;
}

/// Empty: nothing is wrong with it.
std::string problem_of(const Study& study, const Point& point, const deck::Deck& base) {
  for (const auto& [name, value] : over(study.options, point.options))
    if (const std::string problem = runs::option_problem(name, value); !problem.empty())
      return fmt::format("run option {} = {}: {}", name, value, problem);
  deck::Deck deck = base;
  try {
    deck.set_all(over(study.sets, point.sets));
  } catch (const InputError& error) {
    return error.what();
  }
  const std::string missing = missing_quantities_message(study.quantities, deck, study.until);
  return missing.empty() ? "" : "quantities not available in the runs: " + missing;
}

}  // namespace

std::vector<Point> initial_points(const Study& study) {
  return study.kind == Kind::WorstCase ? first_round_points(study) : make_points(study);
}

void check_decks(const Study& study, const std::vector<Point>& points) {
  std::vector<deck::Deck> decks;
  for (const auto& path : study.decks) {
    runs::DeckRequest request;
    request.deck = path;
    decks.push_back(runs::read_deck(request).deck);
  }
  if (points.empty()) return;
  std::string first;
  const std::set<std::size_t> places{0, points.size() / 2, points.size() - 1};
  for (const std::size_t at : places) {
    const Point& point = points.at(at);
    const std::string problem = problem_of(study, point, decks.at(point.deck));
    if (problem.empty()) return;  // the others may be corners that cannot be
    if (first.empty()) first = fmt::format("run {}: {}", at + 1, problem);
  }
  throw InputError(fmt::format("{}: nothing was started: {}", study.file.string(), first));
}

std::string key_in_message(const std::string& sentence, const std::string& file) {
  if (!sentence.starts_with(file)) return {};
  std::size_t begin = file.size();
  if (constexpr std::string_view kLine = ", line ";
      sentence.compare(begin, kLine.size(), kLine) == 0)
    begin = sentence.find(':', begin);
  if (begin == std::string::npos || sentence.compare(begin, 2, ": ") != 0) return {};
  begin += 2;
  std::size_t end = begin;
  const auto part_of_key = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '[' ||
           c == ']';
  };
  while (end < sentence.size() && part_of_key(sentence[end])) ++end;
  std::string key = sentence.substr(begin, end - begin);
  while (key.ends_with('.')) key.pop_back();
  const std::string rest = sentence.substr(end);
  const auto follows = [&](std::string_view words) { return rest.starts_with(words); };
  return follows(" = ") || follows(": ") || follows(" is missing") || follows(" is empty") ||
                 follows(" is not used") || follows(" has no effect") || follows(" contains ")
             ? key
             : std::string();
}

}  // namespace adore::studies
