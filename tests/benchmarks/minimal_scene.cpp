#include "../core/dynamics/system_fixture.hpp"
#include "dynamics/ball_motion.hpp"
#include "dynamics/race_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

/// 18 balls on two races, in contact with traction and nothing else, twice: by the whole program,
/// and by a program written for that scene alone, with the same contact kernel and flags. Both also
/// integrate the work and heat of each race, as the ledger of that scene does. minimal_scene.sh
/// counts the instructions of full_scene and minimal_scene under callgrind.
namespace {

using namespace adore;
using namespace adore::dynamics;

constexpr int kBalls = 18;

/// Written for this scene: nine quantities of each ball, then work and heat of both races.
class Minimal {
 public:
  explicit Minimal(const bearing::Bearing& b, const statics::StaticSolution& s)
      : mass_(b.element_inertia.mass), inertia_(b.element_inertia.moments[0]) {
    const contact::GrooveGeometry groove = contact::groove_geometry(b.balls());
    for (std::size_t j = 0; j < 2; ++j) {
      RaceContactModel& model = model_[j];
      model.race = static_cast<bearing::Race>(j);
      model.groove = groove;
      model.effective_modulus = bearing::contact_modulus(b.element_material, b.race_material[j]);
      model.hertz = contact::hertz_constants(
          contact::race_curvature(b.balls(), static_cast<int>(j), b.balls().contact_angle),
          model.effective_modulus);
      model.angle =
          contact::make_angle_law(b.balls(), static_cast<int>(j), model.effective_modulus);
      model.law = b.race_traction;
      model.rule = tribology::make_split_ellipse_rule(15, 2);
      race_[j].centre = Vec3(groove.centre_x[j], 0.0, 0.0);
      race_[j].axis = Vec3::UnitX();
      race_[j].speed = b.speed[j];
    }
    race_[1].centre += Vec3(s.displacement[0], s.displacement[1], s.displacement[2]);
    for (std::size_t q = 0; q < kQuantities.size(); ++q)
      slices_[static_cast<Quantity>(q)] = {static_cast<int>(q) * kBalls, kBalls};
    for (std::vector<double>& action : actions_) action.resize(kBalls);
  }

  bool rhs(const double* y, double* dydt) noexcept {
    for (std::vector<double>& action : actions_) std::fill(action.begin(), action.end(), 0.0);
    if (!view_elements(y, slices_, sin_.data(), cos_.data(), balls_)) return false;
    double* rate = dydt + 9 * kBalls;
    const auto sums = evaluate_both_races(
        model_, balls_, race_,
        {element_force_targets(actions_, load_[0].data(), heat_[0].data(), nullptr),
         element_force_targets(actions_, load_[1].data(), heat_[1].data(), nullptr)});
    for (std::size_t j = 0; j < 2; ++j) {
      *rate++ = -race_[j].speed * sums[j].moment.dot(race_[j].axis);
      *rate++ = sums[j].heat;
    }
    return ball_motion(balls_, actions_, mass_, inertia_, rates_in(dydt, slices_));
  }

 private:
  double mass_, inertia_;
  std::array<RaceContactModel, 2> model_;
  std::array<RaceMotion, 2> race_;
  ElementSlices slices_;
  ElementViews balls_{};
  ElementActions actions_;
  std::array<double, kBalls> sin_{}, cos_{};
  std::array<std::array<double, kBalls>, 2> load_{}, heat_{};
};

[[gnu::noinline]] void full_scene(System& system, const double* y, double* dydt, int times) {
  for (int k = 0; k < times; ++k) system.rhs(0.0, y, dydt);
}
[[gnu::noinline]] void minimal_scene(Minimal& scene, const double* y, double* dydt, int times) {
  for (int k = 0; k < times; ++k) scene.rhs(y, dydt);
}

}  // namespace

int main(int count, char** words) {
  const int times = count > 1 ? std::atoi(words[1]) : 1000;
  const bearing::Bearing b = fixture::angular_contact(kBalls);
  const statics::StaticSolution statics = fixture::statics_of(b, b.balls().contact_angle);
  System system = fixture::make_system(
      b, fixture::plan_with({scene::Effect::RaceContact, scene::Effect::RaceTraction}), statics);
  Minimal minimal(b, statics);
  const std::vector<double> y = system.initial_state();
  std::vector<double> whole(y.size()), own(y.size());
  full_scene(system, y.data(), whole.data(), times);
  minimal_scene(minimal, y.data(), own.data(), times);
  // The same scene: no rate of a ball differs by more than rounding.
  double largest = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < 9 * kBalls; ++i) {
    largest = std::max(largest, std::abs(whole[i]));
    apart = std::max(apart, std::abs(whole[i] - own[i]));
  }
  std::printf("%zu rates, largest %g, apart by %g\n", y.size(), largest, apart);
  return apart <= 1e-9 * largest ? 0 : 1;
}
