#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace adore::desktop {

inline constexpr const char* kProjectFile = "PROJECT.json";

/// Decks and runs that belong together: a folder with PROJECT.json,
///   {"format": "adore-project", "version": 1, "decks": ["DATA.txt"], "runs": ["out"]}
/// with paths relative to the folder. Other members stay as they are.
class Project {
 public:
  static constexpr int kVersion = 1;

  /// A file or a folder. @throws InputError: missing, damaged, or of a newer version; the file is
  /// not changed
  [[nodiscard]] static Project open(const std::filesystem::path& named);
  /// The project of a folder; a new one, not yet saved, if it has none. @throws InputError as
  /// open()
  [[nodiscard]] static Project open_or_create(const std::filesystem::path& folder);

  struct Entry {
    std::string name;            ///< as in the file
    std::filesystem::path path;  ///< complete
    bool missing = false;        ///< not on the disk, or a folder without results
  };
  [[nodiscard]] std::vector<Entry> decks() const { return entries("decks"); }
  [[nodiscard]] std::vector<Entry> runs() const { return entries("runs"); }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  /// @return false: it is listed already
  bool add_deck(const std::filesystem::path& deck) { return add("decks", deck); }
  bool add_run(const std::filesystem::path& folder) { return add("runs", folder); }
  /// Replaces the file as a whole. @throws WriteError
  void save() const;

 private:
  [[nodiscard]] std::vector<Entry> entries(const char* list) const;
  bool add(const char* list, const std::filesystem::path& path);
  std::filesystem::path file_;
  nlohmann::ordered_json json_;
};

/// Is it PROJECT.json, or a folder that has one?
[[nodiscard]] bool is_project(const std::filesystem::path& path);
/// The same for programs that show results: a folder with results of a run is that run.
[[nodiscard]] bool opens_as_project(const std::filesystem::path& path);

}  // namespace adore::desktop
