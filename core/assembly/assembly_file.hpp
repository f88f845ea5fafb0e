#pragma once

#include "assembly/assembly.hpp"

#include <filesystem>
#include <string>
#include <string_view>

/// ASSEMBLY.json: reader and writer. A number is in SI units, a text may have its own unit, such as
/// "211 N" or "6.35 µm". Unknown members are errors.
///
///   {"version": 1, "name": "spindle, front", "arrangement": "DB",
///    "rows": [{"deck": "row-1", "position": "-9 mm", "offset": "0 µm"}, {"deck": "row-2", ...}],
///    "spacers": [{"inner": "20 mm", "outer": "20.005 mm", "stiffness": "800 N/µm"}],
///    "preload": {"force": "211 N", "state": "unmounted", "source": "..."},
///    "load": {"x": "500 N", "y": 0, "z": "2 kN", "about_y": "3 N.m", "about_z": 0,
///             "position": "0 mm"}}
///
/// "position" is in all rows or in none. "orientation" ("+" or "-") belongs to the arrangement
/// "custom". "preload" has one of "force", "offset" and "class"; a class needs "classes" (name and
/// force) and "source".
namespace adore::assembly {

inline constexpr int kFormatVersion = 1;
inline constexpr const char* kFileName = "ASSEMBLY.json";

/// @param name of the file in messages @throws InputError naming member and cause
[[nodiscard]] Assembly read_assembly(std::string_view json, std::string_view name);
/// @param folder with ASSEMBLY.json, or that file
[[nodiscard]] Assembly read_assembly_file(const std::filesystem::path& folder);
/// Reads back to the same values within 1e-15.
[[nodiscard]] std::string assembly_text(const Assembly& assembly);

/// Is it an ASSEMBLY.json, or a folder that has one?
[[nodiscard]] bool is_assembly(const std::filesystem::path& path);
/// The folder of the assembly of such a path.
[[nodiscard]] std::filesystem::path assembly_folder(const std::filesystem::path& path);

}  // namespace adore::assembly
