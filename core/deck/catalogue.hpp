#pragma once

#include "deck/deck.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Bearings by designation: boundary dimensions of ISO 15 and ISO 355 (resources/catalogue.json),
/// and what is proposed for the inside, which no maker publishes and which is an estimate.
namespace adore::deck {

enum class BearingType : unsigned char {
  DeepGroove,      ///< 60, 62, 63, 160, 618, 619
  AngularContact,  ///< 70, 72, 73, 719 with C (15 deg), AC (25 deg) or B (40 deg)
  Cylindrical,     ///< NU, N, NJ, NUP with 10, 2, 22, 3, 23
  Tapered,         ///< 302, 303, 313, 320, 322, 323
  Spherical        ///< 222, 223, 230, 231; one row of it
};

/// Outside of a bearing [m].
struct Envelope {
  double bore = 0.0, outside = 0.0;
  double width = 0.0;      ///< of the inner ring
  double cup_width = 0.0;  ///< of the outer ring of a tapered bearing; else as width
};

/// Internal geometry that is published or chosen; 0: not known, estimated.
struct KnownInternalGeometry {
  long long count = 0;                               ///< elements per row
  double diameter = 0.0, length = 0.0, pitch = 0.0;  ///< [m]
  double groove_outer = 0.0, groove_inner = 0.0;     ///< groove radius / ball diameter
  std::string source;                                ///< of these values, a clause
};

struct CatalogueBearing {
  std::string designation;  ///< "7208 B"
  BearingType type = BearingType::DeepGroove;
  Envelope envelope;
  double angle = 0.0;  ///< contact angle, of a tapered bearing the cup half angle [deg]; 0: from
                       ///< the clearance
  bool angle_given = false;      ///< by the designation or a standard, not by a habit
  std::string clearance = "CN";  ///< group of ISO 5753-1, of types that have one: "C3"
  bool tapered_bore = false;     ///< "K", of rollers: no deck has it; its groups are others
  std::string left_out;          ///< remaining parts of the designation, "-2RS": not in the deck
  KnownInternalGeometry known;   ///< of a test rig, or of a candidate of published facts
  std::string design;            ///< of cylindrical roller bearings: NU, N, NJ, NUP
  bool standard = false;         ///< a designation: boundary dimensions of a standard
  bool rig = false;              ///< of the library of public test rigs
};

/// "6205", "7208 B", "NU 209", "30208", "22210", with or without blanks and a manufacturer; a
/// clearance group ("6205-2RS C3") is used if the type has one, and suffixes for
/// cage, seals or tolerances are listed as left out. Also a size without a number: "deep-groove
/// 25x52x15", "angular-contact", "cylindrical", "tapered" or "spherical" with millimeters. Also the
/// name of a public test rig ("CWRU-6205-DE", resources/test_rigs.json).
/// @throws InputError with the valid designations
[[nodiscard]] CatalogueBearing find_bearing(std::string_view designation);

/// Every designation that has a number, in order of type and size.
[[nodiscard]] std::vector<std::string> catalogue_designations();

/// Names of the public test rigs.
[[nodiscard]] std::vector<std::string> test_rig_names();

/// Bearings and rigs of the catalogue. @param bore [mm] 0: all; @param type a word ("deep-groove")
/// or empty: all @throws InputError for an unknown type
[[nodiscard]] std::vector<CatalogueBearing> catalogue_list(double bore_mm, std::string_view type);

/// "deep-groove", "angular-contact", "cylindrical", "tapered", "spherical"
[[nodiscard]] std::string_view bearing_type_keyword(BearingType type);
[[nodiscard]] std::string_view type_name(BearingType type);
/// @throws InputError listing the words
[[nodiscard]] BearingType parse_bearing_type(std::string_view word);
[[nodiscard]] const std::vector<std::string>& bearing_type_keywords();
/// Contact angle that a type has by habit [deg].
[[nodiscard]] double default_contact_angle(BearingType type, const Envelope& envelope);

/// A proposal for the inside of a bearing.
struct ProposedInternalGeometry {
  /// Variables in SI: elements and their number, grooves or lands, clearance, shoulders or flanges.
  std::vector<std::pair<std::string, std::string>> sets;
  std::string reasons;  ///< source of the values, in one sentence
};
/// @param group of the clearance (ISO 5753-1): C2, CN, C3, C4, of balls C5
/// @param tapered_bore of spherical rollers, whose groups are others; unknown for cylindrical ones
/// @throws InputError when no elements fit between bore and outside, or the group is none of them
/// @param known replaces what is estimated
[[nodiscard]] ProposedInternalGeometry propose_internal_geometry(
    BearingType type, const Envelope& envelope, double angle, std::string_view group = "CN",
    bool tapered_bore = false, const KnownInternalGeometry& known = {});

/// The same for the bearing of a deck, from its own bore, outside diameter and race widths, in the
/// deck's units. Contact or cup angles of the deck are kept. @throws InputError for
/// spherical-tapered bearings, of which no proportions are known, and when nothing fits
[[nodiscard]] ProposedInternalGeometry propose_internal_geometry(const Deck& deck);

/// A complete quasi-static deck in SI units, one record per line; the remarks mark standard values
/// and estimates. Load and speed are scaled from the example of the type.
[[nodiscard]] std::string catalogue_deck(const CatalogueBearing& bearing);

/// Sentences for a person: dimensions, inside, and where both come from.
[[nodiscard]] std::vector<std::string> describe_catalogue_bearing(const CatalogueBearing& bearing);

}  // namespace adore::deck
