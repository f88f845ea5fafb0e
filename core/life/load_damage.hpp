#pragma once

#include "life/accumulation.hpp"
#include "life/bearing_life.hpp"

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

/// Fatigue damage of a run from the contact loads of every step.
///
/// A full evaluation of a life model needs a snapshot (pressures, ellipses, angles, films) and
/// costs as much as several right-hand sides, but life falls with a high power of load (3 to 12),
/// so samples at a few instants miss most of the damage. Here the load enters at every step and all
/// that changes slowly enters at a few:
///   damage rate of part i = c_i(t) s_i(loads at t),
/// s_i: damage of the model at these loads, everything else as in the equilibrium (LoadDamage);
/// c_i: rate by the full model over s_i at the same instant, taken every kStepsPerEvaluation steps
/// and taken as the mean of both ends in between (StepDamageAccumulator). c_i holds what s_i leaves
/// out: contact angles, edge loads, films, spin of the elements, speed of the races.
///
/// Error: the change of c_i between two evaluations, which is recorded; loads are integrated by the
/// trapezoidal rule over the integrator's own steps (about five per period of the fastest contact
/// vibration).
namespace adore::life {

/// Damage of the parts by contact loads alone.
class LoadDamage {
 public:
  /// Tables from the model itself, at the contact of largest load of each race, under 2^-12 to 2^8
  /// times that load; no damage below, a fourth power above. A race without load in the reference
  /// has a third power (points) or a fourth power (lines) with any factor: c_i takes it up.
  /// @param reference contacts of an equilibrium
  LoadDamage(LifeCalculator& calculator, const BearingContacts& reference);

  /// 1/life of outer race, inner race and elements [1/(1e6 revolutions of the races)]. Two table
  /// look-ups per contact. @param outer, inner normal loads of all elements [N]
  [[nodiscard]] DamageParts at(std::span<const double> outer,
                               std::span<const double> inner) const noexcept;
  /// A number that differs between different tables: for continued runs.
  [[nodiscard]] double stamp() const noexcept;

 private:
  static constexpr int kBelow = 12, kAbove = 8;  ///< octaves around the reference load
  static constexpr int kPerOctave = 32;          ///< linear between: 0.9 % of a ninth power at most
  static constexpr int kEvaluatedPerOctave = 2;  ///< by the model; power laws between
  static constexpr int kLast = (kBelow + kAbove) * kPerOctave;
  struct Table {
    double reference = 1.0;       ///< load [N]
    std::vector<double> race;     ///< when all elements have this load; to the power of the slope
                                  ///< if the race does not rotate relative to the load
    std::vector<double> element;  ///< likewise
  };
  struct MeanDamage {
    double race = 0.0, element = 0.0;
  };
  void make_table(LifeCalculator& calculator, const BearingContacts& reference, std::size_t race);
  [[nodiscard]] static MeanDamage mean(const Table& table, std::span<const double> loads) noexcept;

  std::array<Table, 2> table_;
  std::array<bool, 2> race_rotates_{};
  std::array<double, 3> weibull_slope_{};
  bool shared_track_ = false;
};

/// Scatter of the damage rate of a run: standard error of the mean of batches that are equally long
/// in revolutions. Up to kBatches of them; when there are more, neighbors are joined, so that from
/// kBatches/2 revolutions on each batch is one revolution or more.
class DamageBatches {
 public:
  static constexpr std::size_t kBatches = 16;
  static constexpr double kFirstLength = 1.0 / 64.0;  ///< [revolutions]

  void add(const DamageParts& damage, double seconds, double revolutions);
  /// Complete batches.
  [[nodiscard]] std::size_t count() const noexcept { return batches_.size(); }
  [[nodiscard]] double revolutions_per_batch() const noexcept { return length_; }
  /// Relative standard error of 1/life; NaN with fewer than four batches or without damage.
  [[nodiscard]] double relative_error(const DamageParts& slopes) const;

  void save(std::map<std::string, double>& state) const;
  void restore(const std::map<std::string, double>& state);

 private:
  struct Batch {
    DamageParts damage{};
    double seconds = 0.0, revolutions = 0.0;
  };
  double length_ = kFirstLength;
  std::vector<Batch> batches_;
  Batch open_batch_;
};

/// Adds up the damage of a run.
class StepDamageAccumulator {
 public:
  /// Steps between two evaluations of the full model. Fixed, so that results depend on no output
  /// interval.
  static constexpr long kStepsPerEvaluation = 64;

  explicit StepDamageAccumulator(LoadDamage loads) : loads_(std::move(loads)) {}

  /// Loads at the end of an integration step.
  void step(double time, std::span<const double> outer, std::span<const double> inner) noexcept;
  /// Is a full evaluation due? Also at the first step with load when the last evaluation had none.
  [[nodiscard]] bool due() const noexcept;
  /// Full model at the time of the last step() (or the start). @param loads of that instant
  /// @param counted the instant is in the window whose damage counts
  void evaluate(double time, const std::array<std::vector<double>, 2>& loads,
                const DamageRate& rate, bool counted);

  /// Up to the last step.
  [[nodiscard]] DamageSum damage() const;
  [[nodiscard]] const DamageBatches& batches() const noexcept { return batches_; }
  [[nodiscard]] long steps() const noexcept { return counted_steps_; }
  [[nodiscard]] long evaluations() const noexcept { return evaluations_; }
  /// Relative change of c from one evaluation to the next, mean weighted by damage: bounds the
  /// error of taking c between them as the mean of both. 0 before the second evaluation.
  [[nodiscard]] double mean_calibration_change() const noexcept;

  void save(std::map<std::string, double>& state) const;
  /// Of a run with other tables c is unknown, and an evaluation is due.
  void restore(const std::map<std::string, double>& state);

 private:
  template <class Self, class Visit>
  static void visit(Self& self, Visit visit);

  LoadDamage loads_;
  bool started_ = false, in_damage_window_ = false, evaluation_due_ = true;
  double time_ = 0.0;                  ///< of the last step [s]
  double last_evaluation_time_ = 0.0;  ///< time of the last evaluation [s]
  double revolutions_per_second_ =
      0.0;           ///< relative revolutions per second at the last evaluation [1/s]
  DamageParts s_{};  ///< at the last step
  DamageParts load_damage_integral_{};                  ///< of s since the last evaluation
  DamageParts c_{};                                     ///< [1e6 rev/s]
  std::array<bool, kDamageParts> calibration_known_{};  ///< c: a load was there at some evaluation
  long steps_since_evaluation_ = 0;                     ///< steps since the last evaluation
  long counted_steps_ = 0, evaluations_ = 0;
  double weighted_change_ = 0.0, change_weight_ = 0.0;
  DamageSum damage_sum_;
  DamageBatches batches_;
};

}  // namespace adore::life
