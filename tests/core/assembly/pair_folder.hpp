#pragma once

#include "assembly/new_assembly.hpp"
#include "assembly/solve_assembly.hpp"
#include "base/input_file.hpp"
#include "base/write_folder.hpp"
#include "support/paths.hpp"

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Folders of assemblies for tests.
namespace adore::test {

using Sets = std::vector<std::pair<std::string, std::string>>;

/// The deck of experiment TIMKEN-DUPLEX with these values.
inline std::string timken_deck(const Sets& sets = {}) {
  return assembly::make_row_deck(
      read_text_file(source_dir() / "resources" / "experiments" / "timken-210.txt"), sets);
}

/// The same at rest: without friction, so that loads are exact to 1e-9.
inline std::string resting_deck() { return timken_deck({{"rpm2", "0"}}); }

/// Geometry of B7012-C as experiment FAG-B7012C.
inline Sets b7012c() {
  return {
      {"nRe", "18"},      {"bReDia", "0.011112"},    {"pitchDia", "0.0775"},   {"brgBore", "0.06"},
      {"brgOD", "0.095"}, {"shoulderDia1", "0.084"}, {"shoulderDia2", "0.071"}};
}

/// A temporary folder with an assembly, removed at the end.
class AssemblyFolder {
 public:
  AssemblyFolder(const assembly::Assembly& set, std::vector<assembly::RowDeckText> rows)
      : path_(make_temporary_folder("adore-assembly-")) {
    if (rows.size() == 1) rows.resize(set.rows.size(), rows.front());
    assembly::write_assembly(path_, set, rows);
  }
  ~AssemblyFolder() { remove_tree(path_); }
  AssemblyFolder(const AssemblyFolder&) = delete;
  AssemblyFolder& operator=(const AssemblyFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] assembly::AssemblyResult solve(Sets sets = {}) const {
    assembly::AssemblyRequest request;
    request.folder = path_;
    request.sets = std::move(sets);
    return assembly::solve_assembly(request);
  }

 private:
  std::filesystem::path path_;
};

/// Rows of an arrangement 40 mm apart, the middle at X = 0.
inline assembly::Assembly spaced(const std::string& arrangement, double distance = 0.04) {
  assembly::Assembly out = assembly::assembly_from_arrangement(arrangement);
  const double middle = 0.5 * static_cast<double>(out.rows.size() - 1);
  for (std::size_t k = 0; k < out.rows.size(); ++k)
    out.rows[k].position = distance * (static_cast<double>(k) - middle);
  return out;
}

inline double result(const results::KeyResults& list, std::string_view id) {
  for (const results::KeyResult& one : list)
    if (one.of.id == id) return one.value;
  return std::nan("");
}

}  // namespace adore::test
