#pragma once

#include "base/errors.hpp"
#include "bearing/bearing.hpp"
#include "bearing/race_motion.hpp"
#include "deck/deck.hpp"
#include "scene/plan.hpp"

#include <optional>
#include <string_view>
#include <vector>

/// How races and base frame move (records 2.2, 9.3, 9.4, 9.5), and inertia that a deck gives (6.1,
/// 6.2, 7.7).
namespace adore::setup {

/// Incompatible values, and missing conditions of a deck.
[[nodiscard]] std::vector<Issue> check_race_motions(const deck::Deck& deck);

/// Parts of record 6.1 that cannot be simulated.
[[nodiscard]] std::vector<Issue> check_element_inertia(const deck::Deck& deck);

/// Loads of free races come from record 9.1.1: they act on the inner race, the opposite ones on the
/// outer race (reading N40).
[[nodiscard]] bearing::RaceMotions build_race_motions(const deck::Deck& deck);

/// The base frame of record 9.5, in every mode (deck/orbit_records.hpp); empty: it does not turn.
/// @throws InputError where a value of the record is missing or its radius negative
[[nodiscard]] std::optional<bearing::FrameMotion> frame_motion(const deck::Deck& deck);

/// Additional load of the turning base frame (record 9.5) to the load of record 9.1.1: the shares
/// of the races' centrifugal force, that of the outer race reversed, because it reaches the inner
/// race through the bearing [N]. Zero without such a frame.
[[nodiscard]] bearing::Vec3 rotating_frame_load(const deck::Deck& deck,
                                                const std::array<bearing::Inertia, 2>& races);

/// Weight of the race that moves freely along each axis, as load on the inner race; that of the
/// outer race, reversed, where the inner one is held [N].
[[nodiscard]] bearing::Vec3 race_weight(const deck::Deck& deck,
                                        const std::array<bearing::Inertia, 2>& races,
                                        const bearing::Vec3& gravity);

/// Lists the bodies and effects in the plan and takes over the motions. @param driven races whose
/// accelerations a routine of the user gives: bodies with states, held in all directions that the
/// deck does not free
void plan_race_motions(const deck::Deck& deck, const bearing::Bearing& bearing,
                       scene::ScenePlan& plan, const std::array<bool, 2>& driven = {});

/// Ten variables of an inertia record, e.g. raceMass1, raceMIx1 ... raceFrameZ1 with the prefix
/// "race" and the suffix "1".
[[nodiscard]] bearing::Inertia read_inertia(const deck::Deck& deck, std::string_view prefix,
                                            std::string_view suffix);

/// Record 6.2.j (race 1 outer, 2 inner). What acts is entered in the deck's log: mass and center
/// where the race moves or a turning frame carries its mass, moments and principal axes where it
/// turns about any axis.
[[nodiscard]] bearing::Inertia read_race_inertia(const deck::Deck& deck, int race);

/// kFDkj, kMDkj of record 2.2 (axis 1 to 3, race 1 outer, 2 inner): is the direction free?
[[nodiscard]] bool is_translation_free(const deck::Deck& deck, int axis, int race);
[[nodiscard]] bool is_rotation_free(const deck::Deck& deck, int axis, int race);

}  // namespace adore::setup
