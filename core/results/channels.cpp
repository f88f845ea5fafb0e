#include "results/channels.hpp"

#include "base/errors.hpp"
#include "results/motion.hpp"

#include <fmt/format.h>

#include <unordered_map>

namespace adore::results {
namespace {

std::string state_key(const Channel& channel, std::size_t at) {
  return fmt::format("branch {}[{}]", channel.id, at);
}

}  // namespace

std::size_t channel_index(std::string_view id) {
  static const auto index = [] {
    std::unordered_map<std::string_view, std::size_t> made;
    for (std::size_t i = 0; i < channels().size(); ++i) made.emplace(channels()[i].id, i);
    return made;
  }();
  const auto found = index.find(id);
  if (found == index.end()) throw InternalError(fmt::format("there is no channel '{}'", id));
  return found->second;
}

Shape shape_of(const bearing::Bearing& bearing) {
  Shape shape;
  shape.elements = bearing.element_count();
  shape.rollers = bearing.rollers() != nullptr;
  shape.split = !shape.rollers && (bearing.balls().shim[0] > 0.0 || bearing.balls().shim[1] > 0.0);
  shape.thermal = bearing.thermal.has_value();
  if (bearing.cage) {
    const bearing::Segmentation& cut = bearing.cage->segments;
    shape.cages = cut.count;
    shape.last_halves = cut.several() && cut.through_pockets ? cut.count : 0;
    shape.first_pocket = cut.first;
    shape.pocket_surfaces = bearing::pocket_surfaces(*bearing.cage, shape.rollers);
    shape.lands = static_cast<int>(bearing.cage->lands.size());
  } else {
    shape.pairs = shape.elements == 2 ? 1 : shape.elements > 2 ? shape.elements : 0;
  }
  return shape;
}

std::size_t places(Per per, const Shape& shape) {
  const int count = [&] {
    switch (per) {
      case Per::Run:
        return 1;
      case Per::Element:
        return shape.elements;
      case Per::Contact:
        return 2 * shape.elements;
      case Per::Second:
        return shape.split ? 2 * shape.elements : 0;
      case Per::Flange:
        return shape.rollers ? 4 * shape.elements : 0;
      case Per::Pocket:
        return (shape.elements + shape.last_halves) * shape.pocket_surfaces;
      case Per::Pair:
        return shape.pairs;
      case Per::Cage:
        return shape.cages;
      case Per::Land:
        return shape.cages * shape.lands;
      case Per::Race:
        return 2;
      case Per::Thermal:
        return shape.thermal ? 1 : 0;
    }
    return 0;
  }();
  return static_cast<std::size_t>(count);
}

std::size_t channel_size(const Channel& channel, const Shape& shape) {
  return places(channel.per, shape) * static_cast<std::size_t>(channel.components);
}

ChannelRecorder::ChannelRecorder(bearing::Bearing bearing, UnitSystem units, ChannelTable table)
    : bearing_(std::move(bearing)),
      table_(std::move(table)),
      length_unit_(to_si(1.0, unit::kLength, units)) {
  record_.shape = shape_of(bearing_);
  for (const Channel& channel : table_.all()) {
    record_.values.emplace_back(channel_size(channel, record_.shape), 0.0);
    std::optional<scene::ExtremeQuantity>& looked = band_quantities_.emplace_back();
    for (std::size_t k = 0; k < scene::kExtremeQuantityCount; ++k)
      if (channel_of(static_cast<scene::ExtremeQuantity>(k)) == channel.id)
        looked = static_cast<scene::ExtremeQuantity>(k);
  }
}

void ChannelRecorder::set_bearing(bearing::Bearing bearing) {
  demand(shape_of(bearing) == record_.shape, "a thermal step changed the number of bearing parts");
  bearing_ = std::move(bearing);
}

const StepRecord& ChannelRecorder::record(const scene::Snapshot& snapshot, StepBand* band) {
  const Shape& shape = record_.shape;
  demand(snapshot.elements.size() == static_cast<std::size_t>(shape.elements) &&
             snapshot.cages.size() == static_cast<std::size_t>(shape.cages),
         "the snapshot belongs to another bearing");
  for (const scene::ElementSnapshot& element : snapshot.elements)
    demand(shape.cages == 0 ||
               element.pocket.size() == static_cast<std::size_t>(shape.pocket_surfaces),
           "an element of the snapshot lacks a contact with a guide surface of its pocket");
  for (const scene::CageSnapshot& cage : snapshot.cages)
    demand(shape.last_halves == 0 ||
               cage.last_half.size() == static_cast<std::size_t>(shape.pocket_surfaces),
           "a cage segment of the snapshot lacks a guide surface of its last half pocket");
  for (std::size_t i = 0; i < static_cast<std::size_t>(shape.pairs); ++i)
    demand(snapshot.elements[i].to_next.has_value(),
           "an element of a snapshot without cage lacks the contact with the next element");

  for (const scene::ElementSnapshot& element : snapshot.elements)
    demand(!shape.split || element.second.size() == 2,
           "a ball of the snapshot lacks the contact with the second half of a split race");

  demand(!shape.thermal || snapshot.thermal.has_value(),
         "the snapshot lacks the last thermal step of the thermal analysis");

  record_.step = snapshot.step;
  record_.time = snapshot.time;
  record_.step_size = snapshot.step_size;
  record_.shaft_rotation = snapshot.shaft_rotation;
  ChannelSource source;
  source.snapshot = &snapshot;
  if (band == nullptr) {
    instant_band_.clear();
    band = &instant_band_;
  }
  source.band = band;
  for (std::size_t c = 0; c < band_quantities_.size(); ++c) {
    if (!band_quantities_[c]) continue;
    table_.all()[c].get(source, shape, record_.values[c].data());
    band->look(*band_quantities_[c], record_.values[c]);
  }
  band->stored();
  source.bearing = &bearing_;
  source.unit_length = length_unit_;
  for (std::size_t c = 0; c < record_.values.size(); ++c) {
    const Channel& channel = table_.all()[c];
    std::vector<double>& values = record_.values[c];
    if (values.empty() || band_quantities_[c]) continue;
    source.term = channel.term;
    source.looked = channel.looked;
    const bool follows = channel.continuous && has_previous_;
    if (follows) previous_values_ = values;
    channel.get(source, shape, values.data());
    if (!follows) continue;
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = nearest_branch(values[k], previous_values_[k]);
  }
  has_previous_ = true;
  return record_;
}

void ChannelRecorder::save(std::map<std::string, double>& state) const {
  if (!has_previous_) return;
  for (std::size_t c = 0; c < record_.values.size(); ++c) {
    const Channel& channel = table_.all()[c];
    if (!channel.continuous) continue;
    for (std::size_t k = 0; k < record_.values[c].size(); ++k)
      state[state_key(channel, k)] = record_.values[c][k];
  }
}

void ChannelRecorder::restore(const std::map<std::string, double>& state) {
  for (std::size_t c = 0; c < record_.values.size(); ++c) {
    const Channel& channel = table_.all()[c];
    if (!channel.continuous) continue;
    for (std::size_t k = 0; k < record_.values[c].size(); ++k) {
      const auto found = state.find(state_key(channel, k));
      if (found == state.end()) continue;
      record_.values[c][k] = found->second;
      has_previous_ = true;
    }
  }
}

}  // namespace adore::results
