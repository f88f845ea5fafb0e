#include "results/run_folder.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "results/sol_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace adore::results {
namespace {

namespace fs = std::filesystem;

/// Names in the folder itself, as RUN.json lists them.
std::vector<std::string> listed(const fs::path& folder) {
  std::vector<std::string> out;
  try {
    const fs::path file = folder / "RUN.json";
    const nlohmann::json run = parse_json(read_text_file(file), file.string());
    const auto files = run.is_object() ? run.find("files") : run.end();
    if (files == run.end() || !files->is_array()) return out;
    for (const nlohmann::json& name : *files)
      if (name.is_string()) {
        const auto text = name.get<std::string>();
        if (fs::path(text).filename() == text) out.push_back(text);
      }
  } catch (const InputError&) {  // none, or not ours
  }
  return out;
}

void add(const fs::path& file, PlottableFiles& out) {
  try {
    if (sol_kind(file) == SolKind::Animation) {
      if (!out.animation) out.animation = file;
    } else {
      out.plots.push_back(file);
    }
  } catch (const InputError&) {  // a listing, a table ...
  }
}

}  // namespace

PlottableFiles run_folder(const fs::path& folder) {
  PlottableFiles out;
  std::error_code ignored;
  for (int number = 1; number <= 7; ++number)
    if (const fs::path file = folder / fmt::format("SOL{}", number);
        fs::is_regular_file(file, ignored))
      out.plots.push_back(file);  // damaged ones are reported when they are opened
  if (const fs::path file = folder / "SOL8"; fs::is_regular_file(file, ignored))
    out.animation = file;
  for (const std::string& name : listed(folder)) {
    const fs::path file = folder / name;
    if (!fs::is_regular_file(file, ignored) || file == out.animation ||
        std::find(out.plots.begin(), out.plots.end(), file) != out.plots.end())
      continue;
    add(file, out);
  }
  return out;
}

fs::path animation_file(const fs::path& path) {
  std::error_code ignored;
  if (!fs::is_directory(path, ignored)) return path;
  if (const auto sol8 = run_folder(path).animation) return *sol8;
  if (const fs::path file = path / "RESULTS.h5"; fs::is_regular_file(file, ignored)) return file;
  throw InputError(fmt::format(
      "{}: this folder has no animation, because it contains neither SOL8 nor RESULTS.h5; give the "
      "folder of a run that stores its motion, or one of these files",
      path.string()));
}

}  // namespace adore::results
