#pragma once

#include "assembly/new_assembly.hpp"
#include "cli/deck_options.hpp"

#include <optional>
#include <string>
#include <vector>

/// Commands on sets of bearing rows: folders with ASSEMBLY.json.
namespace adore::cli {

/// Does DECK name an assembly?
[[nodiscard]] bool is_assembly_deck(const DeckOptions& options);

struct AssemblyRunOptions {
  std::string out;
  bool overwrite = false, json = false, quiet = false;
};
/// `adore run FOLDER`. @return exit code
[[nodiscard]] int run_assembly(const DeckOptions& options, const AssemblyRunOptions& run);
/// `adore check FOLDER`. @return exit code
[[nodiscard]] int check_assembly(const DeckOptions& options, bool json);

struct NewAssemblyOptions {
  std::string arrangement, out;
  std::optional<double> preload, offset;  ///< [N], [um]
  std::optional<double> axial, radial;    ///< load of the set [N]
};
/// `adore new --assembly`. @param rows one deck, used for all rows, or one for each
void write_assembly(const NewAssemblyOptions& options, std::vector<assembly::RowDeckText> rows);

}  // namespace adore::cli
