#pragma once

#include "assembly/assembly.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// A new folder of an assembly: ASSEMBLY.json and the deck of each row.
namespace adore::assembly {

/// Deck of a row and the ADORE.json that belongs to it; empty: none.
struct RowDeckText {
  std::string deck, extension;
};

/// Text of a row deck: the given deck with these values, in mode -1. It has no loads, because
/// ASSEMBLY.json has the load of the set, and no table of stiffness over speed. Comments are kept.
/// @throws InputError for a wrong deck and for a load among the values
[[nodiscard]] std::string make_row_deck(
    const std::string& text, const std::vector<std::pair<std::string, std::string>>& sets);

/// Rows of a named arrangement; their decks are row-1/DATA.txt, row-2/DATA.txt ...
/// @throws InputError for an unknown arrangement and for "custom", whose orientations are not known
[[nodiscard]] Assembly assembly_from_arrangement(const std::string& arrangement);

/// Writes the files. @param rows one text for each row @throws InputError when one exists already
/// @return the files
std::vector<std::filesystem::path> write_assembly(const std::filesystem::path& folder,
                                                  const Assembly& assembly,
                                                  const std::vector<RowDeckText>& rows);

}  // namespace adore::assembly
