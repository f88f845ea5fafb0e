#include "studies/sweep_mark.hpp"

#include "base/errors.hpp"
#include "base/input_file.hpp"
#include "base/json_text.hpp"
#include "base/own_files.hpp"
#include "base/version.hpp"
#include "base/write_folder.hpp"

#include <nlohmann/json.hpp>

namespace adore::studies {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bool is_sweep_range(const std::string& value) { return value.find(':') != std::string::npos; }

std::string sweep_digest(const runs::RunRequest& request) {
  runs::RunRequest shared = request;
  std::erase_if(shared.sets, [](const auto& set) { return is_sweep_range(set.second); });
  try {
    return runs::request_digest(shared, runs::load_deck(shared));
  } catch (const InputError&) {
    return {};  // the runs report the errors
  }
}

void write_sweep_manifest(const SweepManifest& mark, const WriteFolder& folder) {
  Json json;
  json["program"] = kProgramVersion;
  json["format"] = 1;
  json["deck"] = mark.deck;
  json["sweep"] = mark.range;
  json["request"] = mark.request;
  json["status"] = mark.status;
  json["failed"] = mark.failed;
  write_file_atomically({folder, SweepManifest::kName}, dump_json(json, 2) + "\n");
}

std::optional<SweepManifest> read_sweep_manifest(const fs::path& folder) {
  const fs::path file = folder / SweepManifest::kName;
  if (!is_written_by_adore(file)) return {};
  Json json;
  try {
    json = parse_json<Json>(read_text_file(file), file.string());
  } catch (const InputError&) {
    return {};
  }
  if (!json.is_object()) return {};
  const auto text = [&](const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  SweepManifest out{text("deck"), text("sweep"), text("request"), text("status")};
  if (const auto failed = json.find("failed");
      failed != json.end() && failed->is_number_integer() && *failed > 0)
    out.failed = failed->get<long>();
  if (out.range.find('=') == std::string::npos || !is_sweep_range(out.range)) return {};
  return out;
}

}  // namespace adore::studies
