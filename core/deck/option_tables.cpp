#include "base/errors.hpp"
#include "deck/schema.hpp"

#include <array>
#include <string>

/// The code tables that several variables share.
namespace adore::deck {
namespace {

constexpr std::array<OptionSpec, 32> kMaterials = {{{"100", "AISI 52100 bearing steel"},
                                                    {"101", "M50 bearing steel"},
                                                    {"102", "M50 VIM-VAR bearing steel"},
                                                    {"103", "440C stainless steel"},
                                                    {"104", "430 ferritic stainless steel"},
                                                    {"105", "410 martensitic stainless steel"},
                                                    {"106", "304 austenitic stainless steel"},
                                                    {"107", "AMS 5898 Cronidur 30 stainless steel"},
                                                    {"108", "AMS 5643 (17-4PH) stainless steel"},
                                                    {"110", "C1045 steel"},
                                                    {"111", "AISI 4340 steel"},
                                                    {"112", "Inconel 625"},
                                                    {"113", "Inconel 718"},
                                                    {"114", "AISI 304HN high-nitrogen steel"},
                                                    {"120", "M50 NiL case-hardened steel"},
                                                    {"121", "P-675 HTT case-hardened steel"},
                                                    {"122", "P-675 LTT case-hardened steel"},
                                                    {"140", "NITINOL 60 (60NiTi)"},
                                                    {"150", "silicon nitride Si3N4"},
                                                    {"151", "zirconium oxide ZrO2"},
                                                    {"160", "copper"},
                                                    {"161", "brass"},
                                                    {"162", "bronze"},
                                                    {"163", "titanium 6Al-4V"},
                                                    {"200", "PEEK, bearing grade"},
                                                    {"201", "polyamide (nylon)"},
                                                    {"202", "Armalon"},
                                                    {"203", "carbon phenolic"},
                                                    {"204", "carbon phenolic with 10% MoS2"},
                                                    {"205", "cotton phenolic"},
                                                    {"206", "graphite"},
                                                    {"207", "PTFE (Teflon)"}}};

constexpr std::array<OptionSpec, 23> kLubricants = {
    {{"-1", "user routine ADRX7"},
     {"0", "hypothetical traction-slip curve"},
     {"1", "mineral oil SAE 30 / Mobil DTE, Newtonian"},
     {"2", "5P4E polyphenyl ether, Newtonian"},
     {"3", "MIL-L-7808, Newtonian"},
     {"4", "MIL-L-23699 / Mobil Jet II, Newtonian"},
     {"5", "MIL-L-27502 / MCS 1780, Newtonian"},
     {"6", "Santotrac 30 traction fluid, Newtonian"},
     {"7", "Santotrac 50 traction fluid, Newtonian"},
     {"8", "MIL-L-7808, visco-elastic"},
     {"9", "coefficients on records 10.4.0, 10.4.1, 10.4.4"},
     {"10", "MIL-L-23699, Newtonian on measured viscosity"},
     {"11", "MIL-L-23699, shear-thinning"},
     {"12", "MIL-L-23699, visco-elastic"},
     {"13", "PAO-100, shear-thinning, up to 1 GPa"},
     {"14", "PAO-100, shear-thinning, hybrid viscosity law"},
     {"15", "PAO-600, shear-thinning, up to 1 GPa"},
     {"16", "PAO-600, shear-thinning, hybrid viscosity law"},
     {"17", "PAO-650, shear-thinning, up to 1 GPa"},
     {"18", "Shell T9 mineral oil, shear-thinning"},
     {"19", "FVA-3 mineral oil, shear-thinning"},
     {"20", "Krytox 143AZ, shear-thinning"},
     {"21", "oil of record X2, Newtonian with limiting shear stress"}}};

constexpr std::array<OptionSpec, 15> kCoolants = {{{"0", "no circulating coolant"},
                                                   {"1", "the lubricant"},
                                                   {"2", "properties on record 9.8"},
                                                   {"3", "liquid oxygen"},
                                                   {"4", "liquid hydrogen"},
                                                   {"5", "liquid nitrogen"},
                                                   {"6", "liquefied natural gas"},
                                                   {"7", "methane"},
                                                   {"8", "RP1"},
                                                   {"9", "RP2"},
                                                   {"10", "JP10"},
                                                   {"11", "JP8-3638"},
                                                   {"12", "JP8-4658"},
                                                   {"13", "dry air"},
                                                   {"14", "water"}}};

constexpr std::array<OptionSpec, 15> kChurning = {{{"0", "neglected"},
                                                   {"1", "the lubricant of kTrac"},
                                                   {"2", "properties on record 10.7A"},
                                                   {"3", "liquid oxygen"},
                                                   {"4", "liquid hydrogen"},
                                                   {"5", "liquid nitrogen"},
                                                   {"6", "liquefied natural gas"},
                                                   {"7", "methane"},
                                                   {"8", "RP1"},
                                                   {"9", "RP2"},
                                                   {"10", "JP10"},
                                                   {"11", "JP8-3638"},
                                                   {"12", "JP8-4658"},
                                                   {"13", "dry air at atmospheric pressure"},
                                                   {"14", "water"}}};

}  // namespace

std::span<const OptionSpec> option_table(std::string_view name) {
  if (name == "@materials") return kMaterials;
  if (name == "@lubricants") return kLubricants;
  if (name == "@coolants") return kCoolants;
  if (name == "@churning") return kChurning;
  throw InternalError("there is no option table named " + std::string(name));
}

}  // namespace adore::deck
