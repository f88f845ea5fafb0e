#pragma once

#include "design/bearing_facts.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

/// All internal geometries of a bearing that agree with published facts, ranked.
///
/// Unknowns: Z elements per row of diameter D on the pitch diameter dm, length L of rollers. The
/// search goes through the ball sizes that are made (steps of 1/64 in up to 3/8 in, then 1/32 in;
/// odd 64ths and whole or half millimeters less likely), or rollers in steps of 0.5 mm, and every
/// Z. Equations (γ = D cos α / dm, inner ring rotating, outer ring at rest, per revolution):
///   BPFO = Z (1 - γ)/2   BPFI = Z (1 + γ)/2   FTF = (1 - γ)/2   BSF = (dm/D)(1 - γ²)/2
///   balls    C = 1.3 f_c (i cos α)^0.7 Z^(2/3) D^1.8 (3.647 D^1.4 above 25.4 mm)
///   balls    C0 = f_0 i Z D² cos α
///   rollers  C = b_m f_c (i L cos α)^(7/9) Z^(3/4) D^(29/27)
///   rollers  C0 = 44 (1 - γ) i Z L D cos α
/// in N with lengths in mm, with f_c and f_0 of core/life (ISO 281, ISO 76). L of rollers follows
/// from C0, else from C.
/// dm is the mean of bore and outside diameter within 3 %, or follows from the fault-frequency
/// factors. Conventions of makers, each a hypothesis with its own spread (fitted to the bearings
/// "rules" of tests/candidates): grooves of 0.52 (C 1.015 ± 0.035, C0/C 1.02 ± 0.02 times those of
/// the formulas), open grooves of 0.55, and C0 by an older rule (1.25 times ISO 76). Filling of
/// deep groove bearings: both rings laid against each other leave room for balls over 2 (Z - 1)
/// asin(D/dm) = 150 to 200 degrees. Cages of other types leave room between elements: Z
/// asin(D/dm)/π = 0.455 + 0.142 ln(D/mm) ± 0.055 of balls (same bearings). The weight of a geometry
/// is the product of the likelihoods of all facts and these habits; it ranks, and is no
/// probability. Geometries below 7 % of the best are counted, not listed.
namespace adore::design {

struct BearingCandidate {
  int count = 0;  ///< Z per row
  int rows = 1;
  double diameter = 0.0, length = 0.0, pitch = 0.0;  ///< [m]; no length of balls
  double angle = 0.0;                                ///< [deg]
  double groove = 0.0;       ///< groove radius / ball diameter of both races; 0: of rollers
  double C = 0.0, C0 = 0.0;  ///< of ISO 281 and ISO 76 for this geometry [N]
  double BPFO = 0.0, BPFI = 0.0, FTF = 0.0, BSF = 0.0;
  double factor_spread = 0.0;    ///< of BPFO from the spread of the pitch diameter, relative
  double diameter_spread = 0.0;  ///< [m]: half the step of the search, or half the size merged
  double weight = 0.0;           ///< the sum of all is 1
  std::string convention;        ///< of the ratings
};

/// Two facts (or one with the boundary dimensions) that no geometry satisfies.
struct Contradiction {
  std::string first, second;  ///< "C0 = 7.8 kN"
};

struct CandidateReport {
  BearingFacts facts;
  deck::CatalogueBearing bearing;  ///< type, boundary dimensions, angle, clearance
  std::vector<BearingCandidate> candidates;
  int left_out = 0;                  ///< candidates of small weight
  std::vector<std::string> missing;  ///< facts without which there is no list
  std::vector<Contradiction> contradictions;
  std::vector<std::string> fact_use;  ///< facts that do not rank, and special readings
  std::string decisive;               ///< the fact that would decide, a sentence
};

/// @throws InputError for a fact out of range or an unknown designation, type or clearance
[[nodiscard]] CandidateReport find_candidates(const BearingFacts& facts);

/// A table for a terminal, with contradictions, missing facts, the use of other facts and the
/// decisive fact.
[[nodiscard]] std::string candidates_text(const CandidateReport& report);
[[nodiscard]] nlohmann::ordered_json candidates_json(const CandidateReport& report);

/// A bearing for catalogue_deck and describe_catalogue_bearing. @param number from 1 @throws
/// InputError when there is no such candidate
[[nodiscard]] deck::CatalogueBearing candidate_bearing(const CandidateReport& report, int number);

}  // namespace adore::design
