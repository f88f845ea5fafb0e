#include "listing/ball_warnings.hpp"

#include "base/validity.hpp"
#include "listing/print_words.hpp"
#include "statics/race_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace adore::listing {
namespace {

using statics::StaticBall;

std::string rounded_quantity(double si, const UnitPair& unit, UnitSystem units) {
  return fmt::format("{:.4g} {}", from_si(si, unit, units), unit_name(unit, units));
}

/// Balls of which something is too large, and the worst of them.
struct Offenders {
  std::vector<std::size_t> numbers;  ///< from 1
  std::size_t worst = 0;             ///< index

  /// "ball 3 (the worst of balls 1-4, 16)"
  [[nodiscard]] std::string text() const {
    const std::string one = fmt::format("ball {}", worst + 1);
    if (numbers.size() == 1) return one;
    return fmt::format("{} (the worst of {})", one, statics::number_list(numbers, "ball"));
  }
};
Offenders offenders(const std::vector<StaticBall>& balls, double limit,
                    const std::function<double(const StaticBall&)>& value) {
  Offenders out;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    const double v = value(balls[k]);
    if (!(v > limit)) continue;
    out.numbers.push_back(k + 1);
    if (out.numbers.size() == 1 || v > value(balls[out.worst])) out.worst = k;
  }
  return out;
}

std::string rule_text(bearing::SpinRule rule) {
  switch (rule) {
    case bearing::SpinRule::RaceControl:
      return "race control (kAngVel = 1)";
    case bearing::SpinRule::MinimumHeat:
      return "minimum-heat spin axis (kAngVel = 0)";
    case bearing::SpinRule::Prescribed:
      break;
  }
  return "prescribed spin axis (kAngVel = 2)";
}

}  // namespace

std::vector<Finding> ball_warnings(const bearing::Bearing& bearing,
                                   const statics::StaticSolution& solution,
                                   std::optional<double> available, UnitSystem units) {
  std::vector<Finding> out;
  const auto add = [&](const char* code, const Offenders& of, std::size_t race,
                       std::string sentence) -> Finding& {
    out.push_back(make_finding(code, std::move(sentence)));
    return out.back().of(fmt::format("ball {}, {} race", of.worst + 1, kRaceName[race]));
  };
  const std::vector<StaticBall>& balls = solution.balls;
  for (std::size_t j = 0; j < 2; ++j) {
    const Offenders slip =
        offenders(balls, available.value_or(kLubricatedFriction),
                  [j](const StaticBall& b) { return follows_spin_rule(b) ? b.friction[j] : 0.0; });
    if (!slip.numbers.empty())
      add("statics.gyroscopic", slip, j,
          fmt::format(
              "{}: {} needs a friction coefficient of {:.3g} at the {} race to resist the "
              "gyroscopic moment, but {}. Such balls slip about the gyroscopic axis: their actual "
              "spin, heat and contact angles differ from those shown. Increase the load, reduce "
              "the speed, or use ballFriction=balance or a dynamic run (mode 0)",
              rule_text(bearing.spin_rule), slip.text(), balls[slip.worst].friction[j],
              kRaceName[j],
              available ? fmt::format(
                              "the traction law of the deck gives a coefficient of at most {:.3g}",
                              *available)
                        : "lubricated contacts reach a coefficient of only about 0.06 (the deck "
                          "has no traction law)"))
          .measure(balls[slip.worst].friction[j], available.value_or(kLubricatedFriction));
    const Offenders over = offenders(balls, 0.0, [j](const StaticBall& b) { return b.beyond[j]; });
    if (!over.numbers.empty()) {
      const StaticBall& worst = balls[over.worst];
      double lost = 0.0, carried = 0.0;
      for (const std::size_t number : over.numbers) {
        lost += balls[number - 1].beyond[j];
        carried += balls[number - 1].Q[j];
      }
      add("statics.shoulder", over, j,
          fmt::format("{}: the contact ellipse at the {} race extends beyond the shoulder by {}. "
                      "The part beyond the shoulder supports {} of the contact load of {} ({:.3g} "
                      "%; for all these balls together {:.3g} %). A real race has no surface "
                      "there. The model does not truncate the ellipse, so displacement, loads and "
                      "life are optimistic. The pressure at the shoulder edge is not computed",
                      over.text(), kRaceName[j],
                      rounded_quantity(-worst.shoulder_depth[j], unit::kLength, units),
                      rounded_quantity(worst.beyond[j], unit::kForce, units),
                      rounded_quantity(worst.Q[j], unit::kForce, units),
                      100.0 * worst.beyond[j] / worst.Q[j], 100.0 * lost / carried))
          .measure(-worst.shoulder_depth[j] / validity::range("hertz.shoulder").per, 0.0);
    }
    const double radius = 0.5 * bearing.balls().diameter;
    const Offenders wide = offenders(balls, validity::range("hertz.ellipse").bounds.most * radius,
                                     [j](const StaticBall& b) { return b.a[j]; });
    if (!wide.numbers.empty()) {
      const StaticBall& worst = balls[wide.worst];
      add("statics.ellipse", wide, j,
          fmt::format(
              "{}: the half length of the contact ellipse at the {} race, {}, is more than half "
              "the ball radius ({}). Hertz theory assumes nearly flat bodies, so deflection and "
              "pressure are approximate (groove factor {:.5g}). The half length grows with the "
              "cube root of the load and equals the ball radius at {}. A dynamic run ends when a "
              "contact reaches that load",
              wide.text(), kRaceName[j], rounded_quantity(worst.a[j], unit::kLength, units),
              rounded_quantity(radius, unit::kLength, units), bearing.balls().groove_factor[j],
              rounded_quantity(worst.Q[j] * std::pow(radius / worst.a[j], 3), unit::kForce, units)))
          .measure(worst.a[j] / radius, validity::range("hertz.ellipse").bounds.most);
    }
  }
  return out;
}

}  // namespace adore::listing
