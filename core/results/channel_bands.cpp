#include "results/channel_bands.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <string>

namespace adore::results {
namespace {

/// A channel that is looked at between stored steps, as its extremes and mean are called.
struct Band {
  scene::ExtremeQuantity what;
  std::string_view name;
};
constexpr std::array kBands{Band{scene::ExtremeQuantity::ContactLoad, "contact load"},
                            Band{scene::ExtremeQuantity::ContactHeat, "contact heat"},
                            Band{scene::ExtremeQuantity::ContactSlip, "slip velocity"},
                            Band{scene::ExtremeQuantity::FlangeForce, "flange force"},
                            Band{scene::ExtremeQuantity::FlangeSlip, "flange slip velocity"},
                            Band{scene::ExtremeQuantity::PocketForce, "pocket force"},
                            Band{scene::ExtremeQuantity::PairForce, "force between elements"},
                            Band{scene::ExtremeQuantity::LandForce, "guide land force"},
                            Band{scene::ExtremeQuantity::RaceForceX, "applied force x"},
                            Band{scene::ExtremeQuantity::RaceForceY, "applied force y"},
                            Band{scene::ExtremeQuantity::RaceForceZ, "applied force z"},
                            Band{scene::ExtremeQuantity::RaceMomentX, "applied moment x"},
                            Band{scene::ExtremeQuantity::RaceMomentY, "applied moment y"},
                            Band{scene::ExtremeQuantity::RaceMomentZ, "applied moment z"}};

template <Per P, double (StepBand::*value)(scene::ExtremeQuantity, std::size_t) const>
void fill_band(ChannelSource s, const Shape& shape, double* out) {
  const std::size_t count = places(P, shape);
  for (std::size_t k = 0; k < count; ++k) out[k] = (s.band->*value)(*s.looked, k);
}
template <double (StepBand::*value)(scene::ExtremeQuantity, std::size_t) const>
ChannelValues band_values(Per per) {
  switch (per) {
    case Per::Contact:
      return {per, 1, &fill_band<Per::Contact, value>};
    case Per::Flange:
      return {per, 1, &fill_band<Per::Flange, value>};
    case Per::Pocket:
      return {per, 1, &fill_band<Per::Pocket, value>};
    case Per::Pair:
      return {per, 1, &fill_band<Per::Pair, value>};
    case Per::Land:
      return {per, 1, &fill_band<Per::Land, value>};
    case Per::Race:
      return {per, 1, &fill_band<Per::Race, value>};
    default:
      throw InternalError("this channel does not have a min-max band");
  }
}

}  // namespace

std::vector<Channel> with_band_channels(std::span<const Channel> table) {
  static std::deque<std::string> texts;
  std::vector<Channel> out;
  for (const Channel& channel : table) {
    out.push_back(channel);
    const auto band = std::find_if(kBands.begin(), kBands.end(), [&](const Band& one) {
      return channel_of(one.what) == channel.id;
    });
    if (band == kBands.end()) continue;
    const auto add = [&](std::string_view suffix, std::string_view which, ChannelValues values,
                         std::string_view meaning) {
      const std::string& id = texts.emplace_back(fmt::format("{}_{}", channel.id, suffix));
      const std::string& label = texts.emplace_back(fmt::format("{} {}", which, band->name));
      out.push_back(
          {id, label, channel.unit, channel.frame, false, values, meaning, nullptr, band->what});
    };
    add("low", "lowest", band_values<&StepBand::low>(channel.per),
        "lowest value since the previous stored step, sampled once per integration step");
    add("high", "highest", band_values<&StepBand::high>(channel.per),
        "highest value since the previous stored step, sampled once per integration step");
    add("mean", "mean", band_values<&StepBand::mean>(channel.per),
        "mean value of the samples since the previous stored step");
  }
  return out;
}

}  // namespace adore::results
