#include "setup/check_pockets.hpp"

#include "setup/deck_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace adore::setup {
namespace {

using bearing::PocketDeviation;
using deck::Deck;

class PocketCheck {
 public:
  PocketCheck(const Deck& deck, const bearing::Bearing& bearing)
      : deck_(deck), bearing_(bearing), cage_(*bearing.cage), random_(has_random_pockets(deck)) {}

  void look_at(std::size_t pocket) {
    const PocketDeviation own = cage_.deviation_of(pocket);
    of_ = random_ ? fmt::format(" of pocket {} (drawn at random)", pocket + 1) : std::string();
    room(own);
    if (deck_.integer("mode") < 0) return;
    if (cage_.pocket_faces.empty()) wall(own);
    place(own);
  }

  void finish() {
    if (!issues_.empty()) throw InputError(std::move(issues_));
  }

 private:
  static bool has_random_pockets(const Deck& deck) {
    return deck.has("bPocClsVar1") && deck.integer("kCagePocImp") == 3;
  }

  void error(const std::string& variable, std::string message, std::string remedy) {
    if (!named_.insert(variable).second) return;  // of the first pocket that shows it
    issues_.push_back(
        deck_.issue(Severity::Error, variable, std::move(message) + of_, std::move(remedy)));
  }

  void room(const PocketDeviation& own) {
    opening("1", cage_.pocket_clearance_1 + own.clearance[0]);
    // Of the pockets of balls that have one.
    if (bearing_.rollers() == nullptr && deck_.integer("kPocType") >= 2)
      opening("2", cage_.pocket_clearance_2 + own.clearance[1]);
  }

  /// @param which of clearance I and II
  void opening(const std::string& which, double clearance) {
    const double D = bearing_.element_diameter(), pitch = bearing_.pitch_diameter();
    const auto fits = [&](double c) { return D + c > 0.0 && D + c < pitch; };
    if (fits(clearance)) return;
    const bool faces = !cage_.pocket_faces.empty();
    const std::string given = "bPocCls" + which, deviation = "bPocClsVar" + which;
    const bool deviates =
        deck_.has(deviation) && deck_.si(deviation) != 0.0 && (faces || fits(deck_.si(given)));
    error(deviates ? deviation
          : faces  ? std::string("bPocGsCen2")
                   : given,
          clearance > 0.0 ? fmt::format("makes an opening of {}, wider than the pitch circle",
                                        length_text(deck_, D + clearance))
                          : fmt::format("leaves no opening for an element {} in diameter",
                                        length_text(deck_, D)),
          faces && !deviates
              ? std::string("put the guide faces beside the roller, at about half its diameter")
              : fmt::format("give a clearance between {} and {}, best above 0",
                            length_text(deck_, -D), length_text(deck_, pitch - D)));
  }

  void wall(const PocketDeviation& own) {
    const double thickness = 0.5 * (cage_.outer_diameter - cage_.inner_diameter);
    const double middle = 0.25 * (cage_.outer_diameter + cage_.inner_diameter);
    const double left = thickness + own.thickness;
    if (left > 0.0 && 0.5 * left < middle) return;
    error("bPocThknsVar",
          left > 0.0 ? std::string("makes a wall that reaches through the bearing's axis")
                     : std::string("leaves no wall around the pocket"),
          fmt::format("give more than {} and less than {}", length_text(deck_, -thickness),
                      length_text(deck_, 2.0 * middle - thickness)));
  }

  void place(const PocketDeviation& own) {
    if (!(std::abs(own.axial) < 0.5 * cage_.width))
      error("bPocCenVar1", "puts the middle of the pocket beside the cage",
            fmt::format("give less than {} either way", length_text(deck_, 0.5 * cage_.width)));
    const double share = std::numbers::pi / bearing_.element_count();
    if (!(std::abs(own.angular) < share))
      error("bPocCenVar2", "puts the pocket nearer to the next element than to its own",
            fmt::format("give less than {:.6g} degrees either way",
                        share * 180.0 / std::numbers::pi));
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(own.tilt[k]) < 0.25 * std::numbers::pi))
        error(fmt::format("bPocAngVar{}", k + 1), "turns the pocket's frame by 45 degrees or more",
              "give less than 45 degrees either way");
  }

  const Deck& deck_;
  const bearing::Bearing& bearing_;
  const bearing::Cage& cage_;
  bool random_;
  std::string of_;
  std::set<std::string> named_;
  std::vector<Issue> issues_;
};

}  // namespace

void check_pockets(const Deck& deck, const bearing::Bearing& bearing) {
  const deck::ReportOnly quiet(deck);
  PocketCheck check(deck, bearing);
  const std::size_t pockets = bearing.cage->pocket_deviation.size();
  // Behind those with a deviation of their own all are alike.
  for (std::size_t k = 0; k < pockets + 1 && k < static_cast<std::size_t>(bearing.element_count());
       ++k)
    check.look_at(k);
  check.finish();
}

}  // namespace adore::setup
