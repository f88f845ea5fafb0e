#pragma once

#include "base/finding.hpp"
#include "base/validity.hpp"
#include "bearing/bearing.hpp"
#include "life/bearing_life.hpp"
#include "scene/snapshot.hpp"
#include "statics/ball_statics.hpp"
#include "statics/friction.hpp"
#include "statics/roller_statics.hpp"
#include "tribology/bearing_drag.hpp"
#include "tribology/contact_film.hpp"
#include "tribology/lubricant.hpp"

#include <nlohmann/json_fwd.hpp>

#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Compares the state of a bearing with the register of validity (base/validity.hpp): of the
/// quasi-static solution and, at stored steps, of a motion. Films are judged at contacts that carry
/// a tenth or more of the heaviest load of that instant [choice].
namespace adore::runs {

class LawValidityMonitor {
 public:
  /// @param bearing in operation; outlives this
  explicit LawValidityMonitor(const bearing::Bearing& bearing);
  ~LawValidityMonitor();
  LawValidityMonitor(LawValidityMonitor&&) noexcept;

  /// The bearing has other temperatures or another geometry (thermal steps).
  void update_bearing();

  void check(const scene::Snapshot& at);
  /// @param friction of a quasi-static deck; null: not computed
  void check(const statics::StaticSolution& solution, const statics::FrictionEstimate* friction);
  void check(const statics::RollerSolution& solution, const statics::FrictionEstimate* friction);
  /// Load of ISO 281.
  void check(const life::BearingLife& life);

  /// A finding of another watch, for the same list.
  void add(const validity::Finding& finding);
  /// Findings of the motion that this one continues, as RUN.json has them.
  void restore(const nlohmann::json& outside_validity);

  /// Left ranges, and friction coefficients that carry 1 % or more of load × slip.
  [[nodiscard]] std::vector<validity::Finding> findings() const;
  /// Largest friction coefficient of a curve of the deck or a routine, when it is above
  /// traction.coefficient.
  [[nodiscard]] std::optional<Finding> friction_coefficient_finding() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Removes findings of the ranges `described`, for which there are more detailed remarks.
[[nodiscard]] std::vector<validity::Finding> without(
    std::vector<validity::Finding> findings, std::initializer_list<std::string_view> described);
/// Why the results are not trusted: a finding of that grade; empty: none.
[[nodiscard]] std::string untrusted(std::span<const validity::Finding> findings);
/// For RUN.json.
[[nodiscard]] nlohmann::ordered_json validity_json(std::span<const validity::Finding> findings);

}  // namespace adore::runs
