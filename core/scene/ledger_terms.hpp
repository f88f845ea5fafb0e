#pragma once

#include "scene/ledger.hpp"

/// Items of the ledgers that belong to no effect. Those of an effect are in its file.
namespace adore::scene::terms {

using enum LedgerKind;

inline constexpr LedgerTerm kStart{
    Start, "start", "energy stored at the start", {"stored at the start"}, "of the run"};
inline constexpr LedgerTerm kKinetic{
    Stored, "kinetic", "kinetic energy", {"kinetic energy now"}, "stored now", "N"};
inline constexpr LedgerTerm kElastic{
    Stored, "elastic", "elastic energy", {"elastic energy now"}, "stored now"};

inline constexpr LedgerTerm kMomentumStart{Start, "", "", {"at the start"}, ""};
inline constexpr LedgerTerm kMomentumNow{Stored, "", "", {"now"}, ""};

}  // namespace adore::scene::terms
