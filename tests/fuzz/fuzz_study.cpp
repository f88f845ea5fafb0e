#include "base/errors.hpp"
#include "json_mutator.hpp"
#include "studies/points.hpp"
#include "studies/study.hpp"
#include "studies/study_text.hpp"

#include <algorithm>
#include <cstring>

using namespace adore;
using namespace adore::studies;

namespace {

/// More points than this are counted, not made: the limits of a study allow gigabytes.
constexpr long kMaxPoints = 20'000;

}  // namespace

/// A study file: a line "json" or "toml", then its text. Any bytes give a study or a sentence, a
/// study has a number of points, and what is written again reads the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\n'), input.size());
  const bool toml = input.substr(0, end) == "toml";
  const std::string text = input.substr(std::min(end + 1, input.size()));
  try {
    const Study study = parse_study(text, toml ? "fuzz.toml" : "fuzz.json");
    const long points = count_points(study);
    demand(points >= 0, "a number of points");
    if (points <= kMaxPoints && study.samples <= kMaxPoints) (void)make_points(study);
    const nlohmann::ordered_json json =
        read_study_text(text, toml ? "fuzz.toml" : "fuzz.json").json;
    const std::string written = write_study_text(json, false);
    demand(read_study_text(written, "fuzz.json").json == json, "a study reads as it was written");
  } catch (const InputError&) {
  }
  return 0;
}

/// One to three values of a JSON study changed.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  testing::JsonMutator mutator(seed);
  std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  nlohmann::json json = nlohmann::json::parse(text.substr(end), nullptr, false);
  if (json.is_discarded()) {  // TOML, or bytes: one of them changes
    if (!text.empty()) text[mutator.below(text.size())] = static_cast<char>(mutator.below(256));
  } else {
    for (std::size_t left = 1 + mutator.below(3); left > 0; --left) mutator.change(json);
    text = "json\n" + json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }
  const std::size_t out = std::min(text.size(), most);
  std::memcpy(data, text.data(), out);
  return out;
}
