#pragma once

#include "base/constants.hpp"
#include "deck/catalogue.hpp"

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <numbers>
#include <string>
#include <string_view>

/// Common parts of the catalogue files: its table, types, and clearance groups.
namespace adore::deck {

/// resources/catalogue.json
[[nodiscard]] const nlohmann::json& catalogue_table();

inline constexpr double kMm = 1e-3, kMicron = 1e-6;

struct BearingTypeInfo {
  BearingType type;
  std::string_view word;  ///< before bore x outside x width
  std::string_view name;  ///< in sentences
  std::string_view template_name;
};
inline constexpr std::array<BearingTypeInfo, 5> kTypes = {{
    {BearingType::DeepGroove, "deep-groove", "deep groove ball bearing", "deep-groove-6205"},
    {BearingType::AngularContact, "angular-contact", "angular contact ball bearing", "angular-218"},
    {BearingType::Cylindrical, "cylindrical", "cylindrical roller bearing", "cylindrical-nu209"},
    {BearingType::Tapered, "tapered", "tapered roller bearing", "tapered-30208"},
    {BearingType::Spherical, "spherical", "spherical roller bearing", "spherical-22210"},
}};

[[nodiscard]] const BearingTypeInfo& bearing_type_info(BearingType type);

/// Of radial clearance (ISO 5753-1).
inline constexpr std::array<std::string_view, 5> kGroups = {"C2", "CN", "C3", "C4", "C5"};
[[nodiscard]] bool has_clearance_group(BearingType type, std::string_view group);
/// Middle of a clearance group [m]; beyond the table in proportion to its last row.
/// @throws InputError when the type has no such group
/// @param tapered_bore of spherical rollers: before mounting; it plays no part for others
[[nodiscard]] double clearance_group_mean(BearingType type, std::string_view group, double bore,
                                          bool tapered_bore = false);

/// A proposed value; 0: it is not among them.
[[nodiscard]] double number(const ProposedInternalGeometry& inner, std::string_view name);
/// Of a text that is one.
[[nodiscard]] double real(const std::string& text);

}  // namespace adore::deck
