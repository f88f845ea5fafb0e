#include "studies/accuracy_settings.hpp"

#include "integrators/stepper.hpp"
#include "tribology/lubricant.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace adore::studies {
namespace {

/// stpMax that never decides: judge_steps() shortens it to what contact vibrations allow.
constexpr const char* kNoLimit = "1000";

AccuracySetting setting(const std::string& method, double tolerance, bool free, double stp_max) {
  AccuracySetting out;
  out.method = method;
  out.tolerance = tolerance;
  out.as_long_as_stable = free;
  if (free) out.sets = {{"stpMax", kNoLimit}};
  out.name = fmt::format("{}, tol {:g}, stpMax {}", method, tolerance,
                         free ? "as long as stable" : fmt::format("{:g}", stp_max));
  return out;
}

}  // namespace

std::vector<AccuracySetting> trial_settings(const runs::Prepared& prepared,
                                            const std::vector<std::string>& methods,
                                            const std::vector<double>& tolerances) {
  const setup::RunControl& control = prepared.control;
  const bool constant = control.step_minimum == control.step_maximum;
  std::vector<AccuracySetting> out{
      setting(control.integrator, control.tolerance, false, control.step_maximum)};
  out.front().own = true;
  std::vector<std::string> names = methods;
  if (names.empty())
    for (const std::string_view name : integrators::stepper_names()) names.emplace_back(name);
  std::vector<double> tight_first = tolerances;
  std::sort(tight_first.begin(), tight_first.end());
  const auto add = [&](AccuracySetting next) {  // duplicates are run once
    if (std::none_of(out.begin(), out.end(),
                     [&](const AccuracySetting& other) { return other.name == next.name; }))
      out.push_back(std::move(next));
  };
  for (const std::string& name : names)
    for (const bool free : {false, true}) {
      if (free && constant) continue;
      for (const double tolerance : tight_first) {
        add(setting(name, tolerance, free, control.step_maximum));
        if (constant) break;  // no step is chosen by its error
      }
    }
  return out;
}

const AccuracySetting& deck_setting(const std::vector<AccuracySetting>& settings) {
  return settings.front();
}

std::vector<AccuracySetting> trial_model_settings(const runs::Prepared& prepared) {
  std::vector<AccuracySetting> out;
  const auto option = [&](const std::string& name, const std::string& value) {
    AccuracySetting next;
    next.options = {{name, value}};
    next.name = fmt::format("{} = {}", name, value);
    out.push_back(std::move(next));
  };
  const auto variable = [&](const std::string& name, const std::string& value) {
    AccuracySetting next;
    next.sets = {{name, value}};
    next.name = fmt::format("{} = {}", name, value);
    out.push_back(std::move(next));
  };
  if (prepared.rollers) {
    for (const char* slices : {"11", "21", "61"}) option("rollerSlices", slices);
  } else {
    for (const auto& [major, minor] : {std::pair{"15", "1"}, {"15", "2"}, {"30", "8"}}) {
      AccuracySetting next;
      next.options = {{"ellipseMajor", major}, {"ellipseMinor", minor}};
      next.name = fmt::format("ellipse nodes {} x {}", major, minor);
      out.push_back(std::move(next));
    }
    option("hertzConstants", prepared.options.system.moving_angle ? "frozen" : "moving");
  }
  if (const auto& oil = prepared.bearing.lubrication) {
    const tribology::LubricantModel model = tribology::lubricant_of(*oil).model;
    const bool strips = model == tribology::LubricantModel::ViscoElastic;
    if (strips || model == tribology::LubricantModel::ShearThinning) {
      option("filmStress", prepared.options.direct_strips ? "surface" : "direct");
      out.back().dear = strips;
    }
    if (prepared.options.system.single_films) option("filmPrecision", "double");
  }
  const auto mode = prepared.input.deck.integer("mode");
  for (const int other : {0, 1, 2})
    if (other != mode) variable("mode", std::to_string(other));
  if (prepared.control.light_load_ratio == 0.0 && mode == 0) variable("qFac", "0.05");
  return out;
}

}  // namespace adore::studies
