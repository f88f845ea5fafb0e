#pragma once

#include "deck/catalogue.hpp"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>

/// Published facts about one bearing: FACTS.json, an object of which every member is optional.
///   designation, type, clearance, cage, source   texts
///   bore, outside, width, element_diameter, element_length, pitch_diameter   "25 mm" (m, mm, um,
///   in) C, C0, Cu          "14 kN" (N, kN, MN, lbf)      mass            "0.13 kg" (kg, g, lb)
///   contact_angle      "15 deg" (deg, rad)           limiting_speed  "18000 rpm" (rpm, 1/min,
///   rad/s) count, rows        integers                      BPFO, BPFI, FTF, BSF   numbers per
///   revolution
/// A quantity is a text with its unit; a number without one and an unknown member are errors.
namespace adore::design {

/// SI; empty: not given.
struct BearingFacts {
  std::string designation, type, clearance, cage, source;
  std::optional<double> bore, outside, width;
  std::optional<double> C, C0, Cu;
  std::optional<double> BPFO, BPFI, FTF, BSF;  ///< per revolution of the inner race
  std::optional<double> mass;
  std::optional<double> element_diameter, element_length, pitch_diameter;
  std::optional<double> contact_angle;   ///< [deg]; of a tapered bearing the cup half angle
  std::optional<double> limiting_speed;  ///< [rpm]
  std::optional<int> count, rows;        ///< elements per row
};

/// @param name of the file in messages @throws InputError naming the member
[[nodiscard]] BearingFacts read_facts(std::string_view json, std::string_view name = "FACTS.json");
[[nodiscard]] BearingFacts facts_of_json(const nlohmann::json& json, std::string_view name);

}  // namespace adore::design
