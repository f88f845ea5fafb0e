#include "base/finding.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <regex.h>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/// One writer, one reader, one way to the terminal, one way to the text of JSON (decision 830).
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> kFolders{"core", "cli", "desktop", "adrplot", "agore", "adrinput"};

/// Extended regular expression of the C library: thirty times as fast as std::regex.
class Pattern {
 public:
  explicit Pattern(const char* text) {
    REQUIRE(::regcomp(&compiled_, text, REG_EXTENDED | REG_NOSUB) == 0);
  }
  ~Pattern() { ::regfree(&compiled_); }
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;
  [[nodiscard]] bool is_in(const std::string& line) const {
    return ::regexec(&compiled_, line.c_str(), 0, nullptr, 0) == 0;
  }

 private:
  regex_t compiled_{};
};

struct Found {
  std::string file, line;
};

/// Lines of the sources, without comments, that match; not those of the files that may.
std::vector<Found> lines_with(const Pattern& pattern, const std::set<std::string>& allowed) {
  std::vector<Found> out;
  const fs::path root = adore::test::source_dir();
  for (const std::string& folder : kFolders)
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      const std::string name = fs::relative(entry.path(), root).string();
      if (allowed.contains(name)) continue;
      std::istringstream lines(adore::test::bytes_of(entry.path()));
      for (std::string line; std::getline(lines, line);) {
        line = line.substr(0, line.find("//"));
        if (pattern.is_in(line)) out.push_back({name, line});
      }
    }
  return out;
}

std::string faults(const Pattern& pattern, const std::set<std::string>& allowed) {
  std::string out;
  for (const std::string& name : allowed)
    if (!fs::exists(adore::test::source_dir() / name))
      out += name + " is allowed, and does not exist\n";
  for (const Found& found : lines_with(pattern, allowed))
    out += found.file + ": " + found.line + "\n";
  return out;
}

}  // namespace

TEST_CASE("sources: only base/write_folder.cpp opens files for writing or changes folders",
          "[unit][architecture]") {
  static const Pattern writer(
      R"(\bofstream\b|\bstd::fstream\b|\b(fopen|freopen|fdopen|creat|mkstemp|mkostemp|mkdtemp|tmpfile)\s*\()"
      R"(|\bO_(WRONLY|RDWR|CREAT|TRUNC|APPEND|TMPFILE)\b)"
      R"(|\b(unlink|unlinkat|rmdir|mkdir|mkdirat|mkfifo|symlink|linkat|renameat)\s*\()"
      R"(|(^|\W)::(link|truncate|rename|chmod|chown)\s*\()"
      R"(|\b(fs|filesystem)::(create_directory|create_directories|create_symlink|create_hard_link|remove|remove_all|rename|copy|copy_file|resize_file|permissions)\s*\()"
      R"(|\bQ(SaveFile|TemporaryFile|TemporaryDir|LockFile)\b|\bmkpath\s*\()"
      R"(|\bQFile\b.*\bWrite|\bH5Fcreate\s*\()");
  CHECK(faults(writer,
               {"core/base/write_folder.cpp",
                "core/results/h5_driver.cpp",   // opens what PendingFile made (openat, O_NOFOLLOW)
                "core/results/results_h5.cpp",  // a file in memory
                "core/studies/study_table_h5.cpp",  // a file in memory
                "core/results/h5_process.cpp",      // /dev/null as standard streams of the reader
                "cli/streams.cpp"}) == "");         // /dev/null in place of a closed stream
}

TEST_CASE("sources: only base/input_file.cpp opens files for reading", "[unit][architecture]") {
  static const Pattern reader(
      R"(\bifstream\b|\bQFile\s+\w|(^|\W)::(open|openat)\s*\(|\bopen\s*\(.*\bO_RD|\bH5Fopen\s*\()");
  CHECK(faults(
            reader,
            {"core/base/input_file.cpp", "core/base/write_folder.cpp", "core/results/h5_driver.cpp",
             "core/results/h5_file.cpp",     // in the reading process, after reject_special_file()
             "core/results/results_h5.cpp",  // in its file
             "core/results/run_findings.cpp",      // the same; in the reading process
             "core/studies/study_table_read.cpp",  // STUDY.h5, after reject_special_file()
             "core/runs/output_folder.cpp",        // locks
             "agore/scene_page.cpp",               // a resource of the program
             "core/results/h5_process.cpp", "core/studies/slurm.cpp", "cli/streams.cpp"}) ==
        "");  // these three: /dev/null
}

TEST_CASE("sources: remarks are Finding; lists of sentences are texts of a listing",
          "[unit][architecture]") {
  static const Pattern list(
      R"(std::vector<(std::string|Issue)> *&? *(notes|remarks|warnings|hints)_?\b *(=|;|\)|,|\{))");
  CHECK(faults(list, {"core/statics/friction.hpp",        // below the table of friction in PRINT
                      "core/listing/static_summary.hpp",  // and texts for a listing
                      "core/listing/static_summary.cpp", "core/listing/print_file.hpp",
                      "core/listing/print_file.cpp", "core/runs/run_outputs.cpp",
                      // about a drawing, a change of the deck, a page of experiments
                      "core/drawing/outline.hpp", "core/drawing/outline_model.hpp",
                      "core/deck/monitored_bodies.cpp", "core/python/bindings/deck.cpp",
                      "core/validation/experiments.hpp"}) == "");
}

TEST_CASE("sources: no finding is made from a sentence", "[unit][architecture]") {
  // A search in the sentence of a finding: base/finding.cpp cuts the text for PRINT, by code.
  static const Pattern in_sentence(
      R"(\bmessage *(\.|->) *(find|rfind|starts_with|ends_with|contains|compare) *\()");
  CHECK(faults(in_sentence, {"core/base/finding.cpp"}) == "");
  // Each code is named by the source that makes it; deck.<severity> is that of an Issue without
  // one.
  std::string sources;
  for (const std::string& folder : kFolders)
    for (const auto& entry : fs::recursive_directory_iterator(adore::test::source_dir() / folder))
      if (entry.path().extension() == ".cpp") sources += adore::test::bytes_of(entry.path());
  std::string unnamed;
  for (const adore::FindingKind& kind : adore::finding_kinds())
    if (!kind.code.starts_with("validity.") &&
        !(kind.code == "deck.error" || kind.code == "deck.warning" || kind.code == "deck.note") &&
        sources.find('"' + kind.code + '"') == std::string::npos)
      unnamed += kind.code + " ";
  CHECK(unnamed == "");
}

TEST_CASE("sources: all text for the terminal goes through base/terminal_text.hpp",
          "[unit][architecture]") {
  static const Pattern printer(
      R"(\bfmt::print\s*\(|\bstd::(cout|cerr|clog)\b|\b(fwrite|puts|fputs|printf|fprintf|putchar)\s*\()");
  CHECK(faults(printer, {"core/base/terminal_text.cpp", "core/studies/worker.cpp"}) ==
        "");  // to its driver, through a pipe
}

TEST_CASE("sources: JSON becomes text by dump_json(), which takes any bytes",
          "[unit][architecture]") {
  static const Pattern dump(R"((\.|->)dump\s*\()");
  CHECK(faults(dump, {"core/base/json_text.hpp", "core/calculators/json_access.hpp"}) ==
        "");  // a value that was parsed: UTF-8
}
