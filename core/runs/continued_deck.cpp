#include "runs/continued_deck.hpp"

#include "deck/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace adore::runs {
namespace {

enum class Change : unsigned char {
  Ignored,  ///< values that a continuation is meant to change
  Accepted,
  NoEffect,      ///< read at the start of a new run only
  WrongBearing,  ///< refused, as the next one
  Rejected,      ///< the same bearing, but the stored state and files do not fit
};

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Of a record as a whole where `variable` is empty.
Change kind_of(std::string_view record, std::string_view variable, bool continues) {
  if (record == "2.3" || is_one_of(variable, {"kIcOpt", "kFnOpt", "maxStps", "fTime"}))
    return Change::Ignored;
  if (record == "9.6" || record == "9.6.k" || variable == "kAngVel" || variable == "angVelOrient")
    return Change::NoEffect;
  if (variable == "kBrg") return Change::WrongBearing;  // states of another kind of bearing
  if (!continues)
    return is_one_of(variable, {"kUnit", "runID"}) ? Change::Ignored : Change::Accepted;
  if (record == "9.2" || record == "X4" || variable == "kStif") return Change::NoEffect;
  const bool bearing = is_one_of(record, {"3.2", "4", "9.0", "X3"}) || record.starts_with("5") ||
                       record.starts_with("6") || record.starts_with("7") ||
                       (record.starts_with("8") && !record.starts_with("8.6"));
  const bool code = is_one_of(variable, {"kReMat", "kRaceMat1", "kRaceMat2", "kHsngMat", "kShftMat",
                                         "kReIP", "kRaceIP1", "kRaceIP2"});
  if (bearing || code) return Change::WrongBearing;
  return is_one_of(variable, {"mode", "kDOF", "runID", "kNumPltElem", "kPltElemInd"})
             ? Change::Rejected
             : Change::Accepted;
}

/// "rpm2: 10000.0 rpm before, 12000.0 rpm now"
std::string sentence(const deck::Difference& d) {
  if (d.variable.empty())
    return fmt::format("record {}: {}", d.record, d.in_left ? "only before" : "only now");
  return fmt::format("{}{}: {} before, {} now", d.variable,
                     d.index > 0 ? fmt::format("[{}]", d.index) : std::string(),
                     d.in_left ? d.left : "none", d.in_right ? d.right : "none");
}

Issue note(const std::filesystem::path& file, std::string message) {
  Issue out;
  out.severity = Severity::Note;
  out.file = file.string();
  out.message = std::move(message);
  return out;
}

}  // namespace

deck::Deck read_stored_deck(const std::string& stored, const std::filesystem::path& file) {
  // Not under the name of the file, which the deck may give as finName or masName.
  deck::ReadResult read = deck::read_deck_text(stored, file.string() + " (its deck)");
  if (!read.ok())
    throw InputError(
        fmt::format("{}: the deck in this file has errors, so the file is damaged; use the file of "
                    "an earlier run, or start from the quasi-static solution (kIcOpt = 0)\n{}",
                    file.string(), to_text(read.issues)));
  return std::move(read.deck);
}

bool may_change_equilibrium(const std::string& stored, const deck::Deck& now,
                            setup::StartState start) {
  const auto differences = deck::differences(read_stored_deck(stored, {}), now);
  return std::any_of(differences.begin(), differences.end(), [&](const deck::Difference& d) {
    const bool output =
        is_one_of(d.record, {"12", "2.1", "3.1"}) ||
        is_one_of(d.variable, {"kNumPltElem", "kPltElemInd"}) ||
        (d.record == "1" && !is_one_of(d.variable, {"mode", "kDOF", "kDCR", "kTherm"}));
    return !d.label && !output &&
           kind_of(d.record, d.variable, start == setup::StartState::Continue) == Change::Accepted;
  });
}

std::vector<Issue> compare_with_stored(const std::string& stored, const deck::Deck& now,
                                       const std::filesystem::path& file, setup::StartState start) {
  if (stored.empty())
    return {note(file,
                 "the file does not contain the deck of the run that wrote it. Only the number of "
                 "elements and the cage can be compared with the deck of this run")};
  const deck::Deck before = read_stored_deck(stored, file);
  const bool continues = start == setup::StartState::Continue;
  std::vector<Issue> refused;
  std::string accepted, idle;
  for (const deck::Difference& d : deck::differences(before, now)) {
    if (d.label || d.record == "12") continue;
    const Change kind = kind_of(d.record, d.variable, continues);
    switch (kind) {
      case Change::Ignored:
        break;
      case Change::Accepted:
        accepted += (accepted.empty() ? "" : "; ") + sentence(d);
        break;
      case Change::NoEffect:
        idle += (idle.empty() ? "" : "; ") + sentence(d);
        break;
      case Change::WrongBearing:
      case Change::Rejected: {
        Issue issue = now.issue(
            Severity::Error, d.variable.empty() ? "kIcOpt" : d.variable,
            fmt::format(
                "{} ({})",
                kind == Change::WrongBearing
                    ? "the run to be continued had a different bearing"
                    : "the state and files of the run to be continued do not allow this change",
                sentence(d)),
            d.variable == "kBrg"
                ? "start from the quasi-static solution (kIcOpt = 0)"
                : "restore the old value, or start a new run from the stored state (kIcOpt = -1)",
            d.instance);
        refused.push_back(std::move(issue));
      }
    }
  }
  if (!refused.empty()) throw InputError(std::move(refused));
  std::vector<Issue> out;
  if (!accepted.empty())
    out.push_back(note(file, fmt::format("the run {} with a changed deck: {}",
                                         continues ? "continues" : "starts", accepted)));
  if (!idle.empty())
    out.push_back(note(
        file, fmt::format(
                  "these changes have no effect, because the run starts from the stored state: {}",
                  idle)));
  return out;
}

}  // namespace adore::runs
