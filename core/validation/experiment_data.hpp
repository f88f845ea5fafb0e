#pragma once

#include "base/json_members.hpp"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Published experiments as data: the schema of resources/experiments/experiments.json and its only
/// reader. Nothing is computed here.
///
/// A figure of a source always has a certainty, which begins with one of the words of
/// certainty_words(). Members that the schema does not know, missing members, wrong types and
/// unknown words are errors that name experiment, run, row and member.
namespace adore::validation {

enum class RowType : unsigned char {
  Value,  ///< theirs is a figure or a range
  Bound,  ///< theirs is the most that ours may be
  Sign    ///< theirs is "+", "-" or "0": ours grows, falls, or stays within kFlatSign
};
/// A sign row whose figure is smaller counts as "no effect" [choice: an exponent of 0.1 changes a
/// quantity by 7 % when its cause doubles].
inline constexpr double kFlatSign = 0.1;

struct RowData {
  std::string of;        ///< name of the quantity (experiments.cpp)
  std::string quantity;  ///< of what an exponent, a spread or a sum is taken
  std::string what;      ///< label; empty: that of the quantity
  std::string unit, kind, certainty;
  RowType type = RowType::Value;
  std::optional<double> theirs, theirs_to;
  std::string their_sign;
  double rating = 0.0;              ///< the source's dynamic rating [N]
  std::optional<double> from;       ///< offset: the preload where it starts [N]
  std::optional<double> reference;  ///< exponent: the value of the variable whose quantity is
                                    ///< subtracted from all
};

using DeckSets = std::vector<std::pair<std::string, std::string>>;

struct VariableSweepData {
  std::string variable;        ///< of the deck
  std::vector<double> values;  ///< in the deck's units
};
struct MotionData {
  std::string deck;   ///< empty: the deck of the run
  std::string until;  ///< as `adore run --until`
  DeckSets set;
};
struct RunDownData {
  std::string deck;
  double inertia = 0.0;  ///< [kg m²]
  DeckSets set;
};
struct TwinDiscData {
  int law = 0;                                          ///< kTrac
  double temperature = 0.0, radius = 0.0, speed = 0.0;  ///< [K, m, m/s]
  std::vector<double> pressure;                         ///< [Pa]
};
/// One steel contact of crowned rollers.
struct FilmData {
  double radius = 0.0, k = 1.0, load = 0.0, speed = 0.0;  ///< [m, -, N, m/s]
  double viscosity = 0.0, alpha = 0.0;                    ///< [Pa s, 1/Pa]
};
/// Share of oil in the cavity, x = c W^0.37 dm^-0.7 (n dm)^-p (1.3e6)^(p-1) with the flow W
/// [cm³/min], n [rpm], dm [mm]; p = 1: the literature's W^0.37/(n dm^1.7) (Parker 1984, recalled
/// high). It is the density of the medium over that of the oil.
struct OilFractionData {
  double c = 0.0, p = 1.0;
};
/// The hottest ring that the source measured.
struct HottestRingData {
  double temperature = 0.0;  ///< [K]
  std::string certainty;
};

struct RunData {
  std::string condition, deck;
  DeckSets set;
  DeckSets options;  ///< run options of the static solution
  std::vector<RowData> rows;
  std::optional<VariableSweepData> over;
  std::optional<MotionData> motion;
  std::optional<RunDownData> run_down;
  std::optional<TwinDiscData> discs;
  std::optional<FilmData> film;
  std::optional<OilFractionData> oil_share;
  std::optional<HottestRingData> hottest_ring;
  DeckSets subtract;  ///< the same quantity with these values too is subtracted
};

/// A figure of a source that this program does not compute.
struct NotComputed {
  std::string condition, what, unit, theirs, certainty, reason;
};

struct ParameterData {
  std::string name, meaning;
  double value = 0.0, low = 0.0, high = 0.0;
  /// A fitted parameter at a bound is missing physics, not a fit.
  [[nodiscard]] bool at_bound() const noexcept { return value <= low || value >= high; }
};

struct ExperimentData {
  std::string id, source, about, open;
  std::vector<std::string> assumed;
  std::vector<ParameterData> parameters;
  std::vector<RunData> runs;
  std::vector<NotComputed> not_computed;
  std::string table;  ///< a file of bearings for rows of the catalogue formula; empty: none
};

/// @throws InputError "experiments.json, NASA-35, run 2, row 1: unknown member "thiers"; ..."
[[nodiscard]] std::vector<ExperimentData> read_experiments(std::string_view json,
                                                           std::string_view name);

/// printed, seen, measured, digitized, inferred, recalled high, ...
[[nodiscard]] const std::vector<std::string>& certainty_words();
/// @throws InputError with `where` when the text does not begin with one of the words
void check_certainty(const std::string& text, const std::string& where);

}  // namespace adore::validation
