#include "setup/check_pockets.hpp"

#include "contact/roller_pocket_play.hpp"
#include "contact/roller_shape.hpp"
#include "setup/deck_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <string>
#include <utility>
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
    of_ = random_ ? fmt::format(" (pocket {}, random deviation)", pocket + 1) : std::string();
    room(own);
    if (deck_.integer("mode") < 0) return;
    if (issues_.empty()) play(pocket, own);
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

  void error(const std::string& variable, std::string message, std::string remedy,
             int instance = 1) {
    if (!named_.insert(variable).second) return;  // of the first pocket that shows it
    issues_.push_back(deck_.issue(Severity::Error, variable, std::move(message) + of_,
                                  std::move(remedy), instance));
  }

  void room(const PocketDeviation& own) {
    opening("1", cage_.pocket_clearance_1 + own.clearance[0]);
    if (has_second_clearance()) opening("2", cage_.pocket_clearance_2 + own.clearance[1]);
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
    error(
        deviates ? deviation
        : faces  ? std::string("bPocGsCen2")
                 : given,
        clearance > 0.0
            ? fmt::format("makes the pocket opening ({}) wider than the pitch diameter",
                          length_text(deck_, D + clearance))
            : fmt::format("leaves no opening for an element of diameter {}", length_text(deck_, D)),
        faces && !deviates
            ? std::string(
                  "place the guide faces about half a roller diameter from the pocket center")
            : fmt::format("give {} between {} and {}, preferably above 0",
                          deviates ? "a deviation that leaves a clearance" : "a clearance",
                          length_text(deck_, -D), length_text(deck_, pitch - D)));
  }

  /// A pocket without play presses its element from both sides for good. A cone is exempt: it
  /// carries its ball by an opening that is smaller than the ball.
  void play(std::size_t k, const PocketDeviation& own) {
    if (cage_.pocket == bearing::PocketShape::Conical) return;
    for (std::size_t i = 0; i < (has_second_clearance() ? 2U : 1U); ++i) {
      const double left = play_of(k, i) + own.clearance[i];
      if (left >= 0.0) continue;
      const auto [variable, instance] = cause(k, i, own.clearance[i]);
      error(variable,
            fmt::format("makes the pocket of element {} narrower than the element by {}", k + 1,
                        length_text(deck_, -left)),
            "give values that leave a clearance of 0 or more", instance);
    }
  }

  [[nodiscard]] bool has_second_clearance() const {
    return bearing_.rollers() == nullptr && deck_.integer("kPocType") >= 2;
  }

  /// Of element k in the pocket that all have in common.
  [[nodiscard]] double play_of(std::size_t k, std::size_t i) const {
    const bearing::RollerGeometry* rollers = bearing_.rollers();
    if (!cage_.pocket_faces.empty())
      return contact::roller_pocket_play(
          cage_.pocket_faces, contact::roller_profile(*rollers, rollers->deviation_of(k)));
    const std::vector<double>& balls = bearing_.imperfections.ball_diameter;
    const double larger = rollers != nullptr ? rollers->deviation_of(k).diameter
                          : k < balls.size() ? balls[k]
                                             : 0.0;
    return common_play(i) - larger;
  }

  /// Between the common pocket and an element without deviations.
  [[nodiscard]] double common_play(std::size_t i) const {
    return i == 0 ? cage_.pocket_clearance_1 : cage_.pocket_clearance_2;
  }

  /// The variable without which there is play, and the instance of its record.
  [[nodiscard]] std::pair<std::string, int> cause(std::size_t k, std::size_t i, double own) const {
    const std::string n = fmt::format("{}", i + 1);
    const double of_all = deck_.has("bPocClsVar" + n) && deck_.integer("kCagePocImp") == 2
                              ? deck_.si("bPocClsVar" + n)
                              : 0.0;
    if (common_play(i) - of_all < 0.0)
      return cage_.pocket_faces.empty() ? std::pair{"bPocCls" + n, 1} : cause_of_face();
    if (common_play(i) < 0.0) return {"bPocClsVar" + n, 1};
    if (play_of(k, i) < 0.0 || own >= 0.0) {
      const std::string each = fmt::format("reDiaVar{}", k + 1);
      return {deck_.has("reDiaVar") ? "reDiaVar" : deck_.has(each) ? each : "kReGeoImp", 1};
    }
    return {deck_.has("bPocClsVar" + n) ? "bPocClsVar" + n : "kCagePocImp", 1};
  }

  [[nodiscard]] std::pair<std::string, int> cause_of_face() const {
    const auto roller = contact::roller_profile(*bearing_.rollers());
    for (std::size_t f = 0; f < cage_.pocket_faces.size(); ++f) {
      const auto play_with = [&](const bearing::RollerPocketFace& face) {
        return contact::roller_pocket_play(std::span(&face, 1), roller);
      };
      bearing::RollerPocketFace face = cage_.pocket_faces[f];
      // A face outside the ends of the roller cannot touch it.
      if (std::abs(face.centre[0]) - 0.5 * face.length > 0.5 * roller.length) continue;
      if (play_with(face) >= 0.0) continue;
      for (int a = 0; a < 3; ++a) {
        face = cage_.pocket_faces[f];
        face.angles[a] = 0.0;
        if (play_with(face) >= 0.0)
          return {fmt::format("bPocGsAng{}", a + 1), static_cast<int>(f) + 1};
      }
      return {"bPocGsCen2", static_cast<int>(f) + 1};
    }
    return {"bPocGsCen2", 1};
  }

  void wall(const PocketDeviation& own) {
    const double thickness = 0.5 * (cage_.outer_diameter - cage_.inner_diameter);
    const double middle = 0.25 * (cage_.outer_diameter + cage_.inner_diameter);
    const double left = thickness + own.thickness;
    if (left > 0.0 && 0.5 * left < middle) return;
    error("bPocThknsVar",
          left > 0.0 ? std::string("makes the pocket wall so thick that it reaches the bearing "
                                   "axis")
                     : std::string("leaves no wall around the pocket"),
          fmt::format("give more than {} and less than {}", length_text(deck_, -thickness),
                      length_text(deck_, 2.0 * middle - thickness)));
  }

  void place(const PocketDeviation& own) {
    if (!(std::abs(own.axial) < 0.5 * cage_.width))
      error("bPocCenVar1", "puts the center of the pocket outside the cage",
            fmt::format("give an absolute value below {}", length_text(deck_, 0.5 * cage_.width)));
    const double share = std::numbers::pi / bearing_.element_count();
    if (!(std::abs(own.angular) < share))
      error("bPocCenVar2", "moves the pocket closer to the next element than to its own element",
            fmt::format("give an absolute value below {:.6g} degrees",
                        share * 180.0 / std::numbers::pi));
    for (int k = 0; k < 3; ++k)
      if (!(std::abs(own.tilt[k]) < 0.25 * std::numbers::pi))
        error(fmt::format("bPocAngVar{}", k + 1), "rotates the pocket frame by 45 degrees or more",
              "give an absolute value below 45 degrees");
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
  for (std::size_t k = 0; k < static_cast<std::size_t>(bearing.element_count()); ++k)
    check.look_at(k);
  check.finish();
}

}  // namespace adore::setup
