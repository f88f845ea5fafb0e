#pragma once

#include <string_view>

/// The program's name and version, said once; a test compares them with the version of the build
/// system.
namespace adore {

inline constexpr std::string_view kVersionNumber = "0.9.0";
/// As printed and as stored in our own formats.
inline constexpr std::string_view kProgramVersion = "Adore 0.9.0";
/// As stored in SOL1-SOL8, whose shortest version field has ten columns (N60).
inline constexpr std::string_view kFileVersion = "Adore0.9.0";
static_assert(kFileVersion.size() <= 10);

}  // namespace adore
