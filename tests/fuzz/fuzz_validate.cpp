#include "base/errors.hpp"
#include "input_file.hpp"
#include "json_mutator.hpp"
#include "validation/validate.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

using namespace adore;
using namespace adore::validation;

/// `adore validate`: a file of reference cases. Every file is rejected with a message or reported.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const testing::InputFile file(data, size);
  try {
    const std::array files{file.path()};
    const ValidateReport report = validate_files(files);
    for (const FileResult& one : report.files) (void)file_result_text(one, true);
  } catch (const InputError&) {
  }
  return 0;
}

namespace {

/// One file per case of tests/reference whose answer is a formula or an equilibrium. Integration
/// over time takes as long as a case asks for.
std::vector<nlohmann::json> short_cases() {
  std::vector<nlohmann::json> out;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(ADORE_SOURCE_DIR "/tests/reference"))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const std::filesystem::path& path : files) {
    const std::string name = path.filename().string();
    if (name.starts_with("dynamics") || name.starts_with("motion") || name.starts_with("F_"))
      continue;
    std::ifstream stream(path);
    const nlohmann::json whole = nlohmann::json::parse(stream);
    for (const nlohmann::json& one : whole.at("cases"))
      if (one.dump().size() < 4000)
        out.push_back({{"family", whole.at("family")}, {"cases", nlohmann::json::array({one})}});
  }
  return out;
}

}  // namespace

/// A reference case with one to three values changed.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t, std::size_t most,
                                               unsigned seed) {
  static const std::vector<nlohmann::json> kCases = short_cases();
  testing::JsonMutator mutator(seed);
  nlohmann::json file = kCases[mutator.below(kCases.size())];
  for (std::size_t left = 1 + mutator.below(3); left > 0; --left) mutator.change(file);
  const std::string text = file.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const std::size_t length = std::min(text.size(), most);
  std::memcpy(data, text.data(), length);
  return length;
}
