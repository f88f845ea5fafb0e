#include "adrinput/unfinished_runs.hpp"

#include "base/counted.hpp"
#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "studies/sweep_mark.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <system_error>

namespace adore::adrinput {

namespace fs = std::filesystem;

namespace {

struct Report {
  std::string deck, status;
};

/// No value for a missing or damaged file.
Report report_in(const fs::path& folder) {
  nlohmann::json json;
  try {
    const fs::path file = folder / "RUN.json";
    json = parse_json(read_text_file(file), file.string());
  } catch (const InputError&) {
  }
  if (!json.is_object()) return {};
  const auto text = [&](const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  return {text("deck"), text("status")};
}

/// The folder of the deck, and its subfolders with names that begin so.
std::vector<fs::path> folders_of(const fs::path& deck_file, const char* start) {
  std::error_code error;
  const fs::path beside = deck_file.parent_path();
  std::vector<fs::path> out;
  for (fs::directory_iterator at(beside, error), end; !error && at != end; at.increment(error))
    if (std::error_code none;
        at->path().filename().string().rfind(start, 0) == 0 && at->is_directory(none))
      out.push_back(at->path());
  std::sort(out.begin(), out.end());
  out.insert(out.begin(), beside);
  return out;
}

constexpr const char* kCutOff = "interrupted, or still active in another program";

}  // namespace

bool can_continue(const fs::path& folder, const deck::Deck& deck) {
  std::error_code ignored;
  const std::string state = deck.has_record("2.3") ? deck.text("masName") : "MASTER";
  return fs::exists(folder / (state.empty() ? "MASTER" : state), ignored);
}

std::vector<UnfinishedRun> unfinished_runs(const fs::path& deck_file, const deck::Deck& deck) {
  std::vector<UnfinishedRun> out;
  for (const fs::path& folder : folders_of(deck_file, "run-")) {
    if (!can_continue(folder, deck)) continue;
    const auto& [of, status] = report_in(folder);
    if (status == "done" || status == "untrusted") continue;  // came to its end
    if (!of.empty() && of != deck_file.filename().string()) continue;
    out.push_back({folder, status == "interrupted" ? "cancelled"
                           : status == "running"   ? kCutOff
                           : status.empty()        ? "not finished (no RUN.json)"
                                                   : status});
  }
  return out;
}

std::vector<UnfinishedSweep> unfinished_sweeps(const fs::path& deck_file) {
  std::vector<UnfinishedSweep> out;
  for (const fs::path& folder : folders_of(deck_file, "sweep-")) {
    const auto mark = studies::read_sweep_manifest(folder);
    if (!mark || mark->deck != deck_file.filename().string()) continue;
    const bool whole = mark->status == "done";
    if (whole && mark->failed == 0) continue;
    const std::string state = whole ? counted(mark->failed, "run") + " without a result"
                              : mark->status == "interrupted" ? "cancelled"
                                                              : kCutOff;
    out.push_back({folder, "sweep of " + mark->range + ", " + state});
  }
  return out;
}

}  // namespace adore::adrinput
