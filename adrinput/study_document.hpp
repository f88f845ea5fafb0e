#pragma once

#include "adrinput/study_fields.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

/// A study file while it is edited: its text, its values, its errors. No Qt.
namespace adore::adrinput {

class StudyDocument {
 public:
  std::function<void()> changed;  ///< called after every change

  /// @throws InputError when the file cannot be read; a file with mistakes is opened.
  void open(const std::filesystem::path& file);
  /// The explained example of a kind for a deck, not saved yet.
  void start_new(const std::filesystem::path& file, const std::string& kind,
                 const std::filesystem::path& deck);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::string& text() const { return state_; }
  /// Null while the text is not JSON or TOML: the form is then empty.
  [[nodiscard]] const std::optional<StudyJson>& values() const { return values_; }
  /// The last change rewrote a TOML file (studies/study_splice.hpp), which removed comments after
  /// values and in lists.
  [[nodiscard]] bool comments_lost() const { return comments_lost_; }
  [[nodiscard]] std::optional<studies::Kind> kind() const;

  void set_text(const std::string& text);
  [[nodiscard]] std::string field(const StudyField& field) const;
  void set_field(const StudyField& field, const std::string& typed);
  [[nodiscard]] std::size_t rows(std::string_view table) const;
  [[nodiscard]] std::vector<std::string> cells(std::string_view table, std::size_t row) const;
  /// A row behind the last is a new one.
  void set_cell(std::string_view table, std::size_t row, std::size_t column,
                const std::string& typed);
  void remove_row(std::string_view table, std::size_t row);

  [[nodiscard]] bool can_undo() const { return !undo_.empty(); }
  [[nodiscard]] bool can_redo() const { return !redo_.empty(); }
  void undo();
  void redo();

  [[nodiscard]] bool modified() const { return !stored_ || state_ != *stored_; }
  /// Another program changed the file since it was read or saved here.
  [[nodiscard]] bool changed_on_disk() const;
  /// @throws InputError when it cannot be written
  void save(const std::filesystem::path& file);

  /// Problems of `adore study plan`, in the same words except for the folder; empty: none.
  struct Finding {
    std::string problem;  ///< empty: the study can start
    std::string key;      ///< "variables[2].normal": key of the error; may be empty
    long runs = 0;        ///< without errors
  };
  [[nodiscard]] Finding check() const;

  /// Stores unsaved changes next to the file until they are saved or discarded.
  void store_unsaved() const;
  void delete_unsaved_copy() const;
  /// Changes of an earlier session; empty if they equal the file.
  [[nodiscard]] std::optional<std::string> unsaved_text() const;
  [[nodiscard]] std::filesystem::path unsaved_path() const;

 private:
  /// Successive changes at one place are one step for undo.
  void change(std::string text, const std::string& place, bool comments_lost = false);
  void write_values(StudyJson values, const std::string& place);
  void read_values();

  std::filesystem::path path_;
  std::string state_;
  std::optional<std::string> stored_;  ///< content of the file; none: not saved yet
  std::optional<StudyJson> values_;
  bool loose_comments_ = false, comments_lost_ = false;
  std::vector<std::string> undo_, redo_;
  std::string last_edit_target_;
};

}  // namespace adore::adrinput
