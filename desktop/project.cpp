#include "desktop/project.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/write_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace adore::desktop {
namespace {

namespace fs = std::filesystem;

constexpr const char *kFormat = "format", *kName = "adore-project";
constexpr std::array kResults{"SOL8", "RESULTS.h5", "RUN.json", "SWEEP.csv"};

/// Has the folder something that an app opens?
bool has_results(const fs::path& folder) {
  std::error_code none;
  return std::any_of(kResults.begin(), kResults.end(),
                     [&](const char* name) { return fs::exists(folder / name, none); });
}

[[noreturn]] void refuse(const fs::path& file, const std::string& problem,
                         const std::string& remedy) {
  throw InputError(fmt::format("{}: {}. {}", file.string(), problem, remedy));
}

}  // namespace

bool is_project(const fs::path& path) {
  std::error_code none;
  return path.filename() == kProjectFile ||
         (fs::is_directory(path, none) && fs::exists(path / kProjectFile, none));
}

bool opens_as_project(const fs::path& path) {
  return path.filename() == kProjectFile || (is_project(path) && !has_results(path));
}

Project Project::open(const fs::path& named) {
  Project out;
  std::error_code none;
  out.file_ = fs::absolute(fs::is_directory(named, none) ? named / kProjectFile : named);
  const std::string text = read_text_file(out.file_);
  const std::string kept = "The file is not changed.";
  try {
    out.json_ = parse_json<nlohmann::ordered_json>(text, "");
  } catch (const InputError& error) {
    refuse(out.file_, fmt::format("damaged, it {}", error.what()),
           "Restore it from a copy. " + kept);
  }
  const auto& json = out.json_;
  if (!json.is_object())
    refuse(out.file_, "damaged (it is not a JSON object)", "Restore it from a copy. " + kept);
  if (json.value(kFormat, nlohmann::ordered_json()) != kName)
    refuse(out.file_, "not a project of Adore", "Select another file. " + kept);
  const auto version = json.find("version");
  if (version == json.end() || !version->is_number_integer())
    refuse(out.file_, "damaged (it has no version)", "Restore it from a copy. " + kept);
  if (*version > kVersion)
    refuse(out.file_,
           fmt::format("format version {}, but this program supports version {}",
                       version->get<long>(), kVersion),
           "Open it with a newer program. " + kept);
  for (const char* list : {"decks", "runs"})
    if (const auto found = json.find(list);
        found != json.end() &&
        (!found->is_array() || !std::all_of(found->begin(), found->end(),
                                            [](const auto& one) { return one.is_string(); })))
      refuse(out.file_, fmt::format("damaged (\"{}\" is not a list of names)", list),
             "Restore it from a copy. " + kept);
  return out;
}

Project Project::open_or_create(const fs::path& folder) {
  std::error_code none;
  if (fs::exists(folder / kProjectFile, none)) return open(folder);
  Project out;
  out.file_ = fs::absolute(folder) / kProjectFile;
  out.json_ = {{kFormat, kName},
               {"version", kVersion},
               {"decks", nlohmann::ordered_json::array()},
               {"runs", nlohmann::ordered_json::array()}};
  return out;
}

std::vector<Project::Entry> Project::entries(const char* list) const {
  std::vector<Entry> out;
  const auto found = json_.find(list);
  if (found == json_.end()) return out;
  for (const auto& one : *found) {
    Entry entry{one.get<std::string>(), {}};
    entry.path = (file_.parent_path() / entry.name).lexically_normal();
    std::error_code none;
    entry.missing = fs::is_directory(entry.path, none) ? !has_results(entry.path)
                                                       : !fs::exists(entry.path, none);
    out.push_back(std::move(entry));
  }
  return out;
}

bool Project::add(const char* list, const fs::path& path) {
  const std::string name = fs::absolute(path)
                               .lexically_normal()
                               .lexically_relative(file_.parent_path())
                               .generic_string();
  auto& all = json_[list];
  if (all.is_null()) all = nlohmann::ordered_json::array();
  if (std::find(all.begin(), all.end(), name) != all.end()) return false;
  all.push_back(name);
  return true;
}

void Project::save() const { write_file_atomically(file_, dump_json(json_, 2) + "\n"); }

}  // namespace adore::desktop
