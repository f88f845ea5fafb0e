#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// The ADORE.json in the folder of a deck, for programs that edit it.
namespace adore::facade {

struct RunOptionInfo {
  std::string name, default_value, meaning;  ///< the meaning lists the valid values
  std::vector<std::string> choices;  ///< words that it takes; empty when it takes numbers only
};

/// Every run option, in a fixed order; the list of `--opt`.
[[nodiscard]] const std::vector<RunOptionInfo>& run_options();

/// Why a run option does not take a value: "is not valid: ..."; empty when it does.
[[nodiscard]] std::string option_problem(std::string_view name, std::string_view value);

/// Do two texts mean the same value of an option? "16" and "16.0" do.
[[nodiscard]] bool same_option(std::string_view a, std::string_view b);

/// The file as it was read. Names that are not run options stay in it.
class OptionFile {
 public:
  OptionFile() = default;  ///< no file
  [[nodiscard]] static std::filesystem::path path_beside(const std::filesystem::path& deck_file);
  /// Never throws: what is wrong with the file is problem().
  [[nodiscard]] static OptionFile beside(const std::filesystem::path& deck_file);
  [[nodiscard]] static OptionFile from_text(std::string text);

  [[nodiscard]] bool exists() const { return exists_; }
  [[nodiscard]] const std::string& text() const { return text_; }
  /// A clause that continues "ADORE.json ..."; empty when the file can be understood.
  [[nodiscard]] const std::string& problem() const { return problem_; }
  /// Run options that the file gives, as text.
  [[nodiscard]] const std::map<std::string, std::string>& values() const { return values_; }
  /// Names in it that are not run options, or whose value is not a number, string or true/false.
  [[nodiscard]] const std::vector<std::string>& strange() const { return strange_; }

  /// The file's text with these run options instead of its options. Values equal to the default are
  /// left out, unknown names stay, an unchanged option keeps its spelling. Equal
  /// to text() when nothing changed.
  [[nodiscard]] std::string with(const std::map<std::string, std::string>& values) const;

 private:
  bool exists_ = false;
  std::string text_, problem_;
  std::map<std::string, std::string> values_;
  std::vector<std::string> strange_;
};

}  // namespace adore::facade
