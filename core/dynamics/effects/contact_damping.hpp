#pragma once

#include "bearing/material.hpp"
#include "contact/damping_law.hpp"
#include "dynamics/effect.hpp"

/// Effect "contact damping": energy loss of normal contacts (contact/damping_law.hpp), which every
/// block of contacts takes into its own normal force.
///
/// One choice for every kind of contact: friction, pressure, life, wear and stored loads are of the
/// total force F; the stored elastic energy is that of the elastic one. What damping takes, (F - Q)
/// δ̇ >= 0, is an item of the ledger for each kind of contact.
/// Elements in force balance (modes 1 and 2) have no rate of approach on their races: no part
/// there.
namespace adore::dynamics {

/// Of a contact of two bodies that share the mass [kg]; none where the scene has no damping.
/// @param share_of_length 1/L of slices of a line [1/m]; else 1
[[nodiscard]] contact::DampingLaw<> damping_law(const SceneBuilder& scene,
                                                const bearing::Material& a,
                                                const bearing::Material& b, double mass,
                                                double share_of_length = 1.0);
/// Of elements on race j: an element vibrates on its outer and inner contact. With the squeeze of
/// the oil film (contact/film_squeeze.hpp) of the most loaded contact of the race at the start.
[[nodiscard]] contact::DampingLaw<> race_damping(const ScenePlan& plan,
                                                 const bearing::Bearing& bearing,
                                                 const SystemOptions& options,
                                                 const statics::StaticSolution& start,
                                                 std::size_t j);

/// One body between two: 1/(1/a + 1/b).
[[nodiscard]] inline double reduced_mass(double a, double b) noexcept { return a * b / (a + b); }

/// Power that damping takes in one kind of contact.
inline constexpr LedgerTerm kRaceDamping{LedgerKind::Heat,
                                         "contact_damping",
                                         "damping of the race contacts",
                                         {"damping at the outer race", "damping at the inner race"},
                                         "dissipated since the start"};
inline constexpr LedgerTerm kFlangeDamping{
    LedgerKind::Heat,
    "flange_damping",
    "damping at the flanges",
    {"damping at the outer race flanges", "damping at the inner race flanges"},
    "dissipated since the start"};
inline constexpr LedgerTerm kPocketDamping{LedgerKind::Heat,
                                           "pocket_damping",
                                           "damping in the pockets",
                                           {"damping in the cage pockets"},
                                           "dissipated since the start"};
inline constexpr LedgerTerm kLandDamping{LedgerKind::Heat,
                                         "land_damping",
                                         "damping at the guide lands",
                                         {"damping at the guide lands"},
                                         "dissipated since the start"};
inline constexpr LedgerTerm kElementDamping{LedgerKind::Heat,
                                            "element_damping",
                                            "damping between elements",
                                            {"damping between elements"},
                                            "dissipated since the start"};

}  // namespace adore::dynamics
