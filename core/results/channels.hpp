#pragma once

#include "bearing/bearing.hpp"
#include "results/quantities.hpp"
#include "results/sol_file.hpp"
#include "results/step_band.hpp"
#include "scene/snapshot.hpp"

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The one table of everything that results store. Writers, readers, `show`, `convert` and the plot
/// programs share it: a classic file is a list of columns into this table, RESULTS.h5 is the whole
/// table.
namespace adore::results {

/// How often a channel occurs in one step.
enum class Per : unsigned char {
  Run,
  Element,
  Contact,
  Second,  ///< contact with the other half of a split race, in bearings that have one
  Flange,
  Pocket,
  Pair,
  Cage,
  Land,
  Race,
  Thermal  ///< once, in runs with a thermal analysis
};

/// Input of a channel's getter: one instant and the indices that its `Per` needs (all from 0).
struct ChannelSource {
  const scene::Snapshot* snapshot = nullptr;
  const StepBand* band = nullptr;  ///< since the step stored last
  const bearing::Bearing* bearing = nullptr;
  double unit_length = 1.0;  ///< the deck's unit of length [m], see cage_scale_length()
  std::size_t element = 0, race = 0, side = 0, surface = 0, cage = 0, land = 0, component = 0;
  const scene::LedgerTerm* term = nullptr;       ///< that of the channel
  std::optional<scene::ExtremeQuantity> looked;  ///< whose extremes the channel contains

  [[nodiscard]] const scene::ElementSnapshot& ball() const { return snapshot->elements[element]; }
  [[nodiscard]] const scene::RaceContactSnapshot& contact() const { return ball().race[race]; }
  [[nodiscard]] const scene::RaceContactSnapshot& second() const { return ball().second[race]; }
  [[nodiscard]] const scene::FlangeContactSnapshot& flange() const {
    return ball().flange[race][side];
  }
  [[nodiscard]] const scene::PocketContactSnapshot& pocket() const {
    const std::size_t elements = snapshot->elements.size();
    return element < elements ? ball().pocket[surface]
                              : snapshot->cages[element - elements].last_half[surface];
  }
  /// An element and the next one, in a bearing without cage.
  [[nodiscard]] const scene::NeighborContactSnapshot& pair() const { return *ball().to_next; }
  [[nodiscard]] const scene::ThermalSnapshot& thermal() const { return *snapshot->thermal; }
  [[nodiscard]] const scene::CageSnapshot& cage_body() const { return snapshot->cages[cage]; }
  [[nodiscard]] const scene::RaceSnapshot& race_body() const { return snapshot->races[race]; }
};

struct Shape;

/// The values of a channel, how often it occurs, and of how many components.
struct ChannelValues {
  Per per = Per::Run;
  int components = 1;  ///< 3 for vectors, 4 for quaternions (w, x, y, z)
  /// All of one step, SI and radians, in the order of StepRecord: channel_size() of them.
  void (*get)(ChannelSource, const Shape&, double*) = nullptr;
};

struct Channel : ChannelValues {
  constexpr Channel(std::string_view named, std::string_view shown, const UnitPair* in,
                    std::string_view of_frame, bool is_continuous, ChannelValues values,
                    std::string_view meaning, const scene::LedgerTerm* item = nullptr,
                    std::optional<scene::ExtremeQuantity> band_of = {})
      : ChannelValues(values),
        id(named),
        label(shown),
        unit(in),
        frame(of_frame),
        continuous(is_continuous),
        help(meaning),
        term(item),
        looked(band_of) {}

  std::string_view id;  ///< "contact.load"; the group before the point is the folder in RESULTS.h5
  std::string_view label;  ///< "contact load"
  const UnitPair* unit;
  std::string_view frame;  ///< N base, A azimuth frame of the element, K cage, P pocket, - none
  bool continuous;         ///< an angle kept continuous between records (N101)
  std::string_view help;
  const scene::LedgerTerm* term;                 ///< of channels that show an item of the ledger
  std::optional<scene::ExtremeQuantity> looked;  ///< of channels "X_low", "X_high", "X_mean"
};

/// The channels of every run, in a fixed order.
[[nodiscard]] std::span<const Channel> channels();
/// @throws InternalError for an unknown id.
[[nodiscard]] std::size_t channel_index(std::string_view id);

/// Stored values of one run: channels(), followed by a channel for each item that its energy ledger
/// may contain, the present heat of those that belong to no race, and the residual.
class ChannelTable {
 public:
  /// @param energy all possible items of a ledger, as dynamics::energy_terms() lists them
  explicit ChannelTable(scene::LedgerTerms energy);
  /// Those with these ids alone, in the table's order.
  [[nodiscard]] ChannelTable only(std::span<const std::string_view> ids) const;
  [[nodiscard]] std::span<const Channel> all() const noexcept { return channels_; }

 private:
  std::vector<Channel> channels_;
  std::shared_ptr<const std::deque<std::string>> ids_;  ///< of the channels
};

/// Sizes of one bearing that fix how many values each channel has.
struct Shape {
  int elements = 0, pocket_surfaces = 0, cages = 0, lands = 0;
  int last_halves = 0;   ///< half pockets at the ends of segments, behind the elements' pockets
  int first_pocket = 0;  ///< element that the first segment starts with, from 0
  int pairs = 0;         ///< of elements that may touch
  bool split = false;    ///< a race is split: balls may have second contacts
  bool rollers = false;  ///< each with two ends at two races' flanges
  bool thermal = false;  ///< with a thermal analysis
  bool operator==(const Shape&) const = default;
};
[[nodiscard]] Shape shape_of(const bearing::Bearing& bearing);
/// How often a quantity occurs in one step.
[[nodiscard]] std::size_t places(Per per, const Shape& shape);
/// Values of one channel in one step, components included.
[[nodiscard]] std::size_t channel_size(const Channel& channel, const Shape& shape);

/// One instant, evaluated: values[c][k] of channel c of the run's table, in SI; k runs element,
/// then race (contacts), race and side (flanges) or surface (pockets), or cage then land, then
/// component.
struct StepRecord {
  long step = 0;
  double time = 0.0, step_size = 0.0;  ///< [s]
  double shaft_rotation = 0.0;         ///< [rad]
  Shape shape;
  std::vector<std::vector<double>> values;

  /// By id in channels().
  [[nodiscard]] const std::vector<double>& operator[](std::string_view id) const {
    return values[channel_index(id)];
  }
};

/// Turns snapshots into records and keeps the angles continuous from one record to the next. Feed
/// it every stored step, in order, whichever file wants it, so that all files show the same branch.
class ChannelRecorder {
 public:
  ChannelRecorder(bearing::Bearing bearing, UnitSystem units, ChannelTable table);
  /// New temperatures and fits after a thermal step; the shape must stay.
  void set_bearing(bearing::Bearing bearing);
  /// `band`: the looks since the step stored before, to which this instant is added; null: this
  /// instant alone.
  [[nodiscard]] const StepRecord& record(const scene::Snapshot& snapshot, StepBand* band = nullptr);
  [[nodiscard]] const bearing::Bearing& bearing() const noexcept { return bearing_; }
  [[nodiscard]] const Shape& shape() const noexcept { return record_.shape; }
  [[nodiscard]] const ChannelTable& table() const noexcept { return table_; }

  /// Branches of the angles, for MASTER, and back. Other keys are ignored.
  void save(std::map<std::string, double>& state) const;
  void restore(const std::map<std::string, double>& state);

 private:
  bearing::Bearing bearing_;
  ChannelTable table_;
  double length_unit_;
  StepRecord record_;
  std::vector<double> previous_values_;  ///< of a channel, while it is recorded
  std::vector<std::optional<scene::ExtremeQuantity>>
      band_quantities_;    ///< of each channel that has a band
  StepBand instant_band_;  ///< of a record alone
  bool has_previous_ = false;
};

/// One column of a classic file.
struct SolColumn {
  std::string id;     ///< "contact.load.outer", "pocket.force.7.1"
  std::string label;  ///< "contact load, outer race"
  const UnitPair* unit = nullptr;
  int channel =
      -1;  ///< index into channels(); -1: a value of the format that ball bearings do not have
  std::size_t at = 0;  ///< index into StepRecord::values[channel]
};

/// The columns of one SOL1-SOL7 file as its header describes it, exactly header.value_count of
/// them. Values beyond those that we know are called "value 47". `cage` counts from 0 and matters
/// for segments only.
[[nodiscard]] std::vector<SolColumn> sol_columns(const SolHeader& header);
/// How many values this program writes into a file of that kind.
[[nodiscard]] int sol_value_count(SolKind kind, const Shape& shape);
[[nodiscard]] SolKind sol_kind_of(const SolHeader& header);

/// The ten unit slots of a file kind (outputs.md 2); nullptr for a blank one.
[[nodiscard]] std::array<const UnitPair*, 10> unit_slots(SolKind kind);
/// The file's own unit string of a column: the slot that holds the column's unit; "" for
/// dimensionless values.
[[nodiscard]] std::string unit_of_column(const SolFile& file, const SolColumn& column);

}  // namespace adore::results
