#include "base/errors.hpp"
#include "design/bearing_candidates.hpp"
#include "json_mutator.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <string_view>
#include <vector>

using namespace adore;
using namespace adore::design;

/// FACTS.json of `adore new --from`: rejected with a message, or reported; each candidate has a
/// deck.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const CandidateReport report = find_candidates(read_facts(text));
    (void)candidates_text(report);
    (void)candidates_json(report);
    if (!report.candidates.empty())
      (void)deck::describe_catalogue_bearing(candidate_bearing(report, 1));
  } catch (const InputError&) {
  }
  return 0;
}

namespace {

std::vector<nlohmann::json> examples() {
  std::vector<nlohmann::json> out;
  for (const char* text :
       {R"({"designation": "6205", "C": "14 kN", "C0": "7.8 kN", "BPFO": 3.585, "BPFI": 5.415,
            "FTF": 0.398, "BSF": 2.357, "mass": "0.13 kg", "limiting_speed": "18000 rpm"})",
        R"({"type": "angular-contact", "bore": "40 mm", "outside": "80 mm", "width": "18 mm",
            "contact_angle": "25 deg", "C": "30 kN", "count": 14, "element_diameter": "11.1 mm"})",
        R"({"type": "cylindrical", "bore": "45 mm", "outside": "85 mm", "width": "19 mm", "rows": 1,
            "C0": "64 kN", "element_length": "11 mm", "pitch_diameter": "65 mm", "cage": "brass"})",
        R"({"designation": "22210", "C0": "108 kN", "Cu": "11.8 kN", "clearance": "C3",
            "source": "x"})",
        R"({"designation": "30208", "C": "61.6 kN", "cage": "full complement"})"})
    out.push_back(nlohmann::json::parse(text));
  return out;
}

}  // namespace

/// One of the examples with one to three values changed.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t, std::size_t most,
                                               unsigned seed) {
  static const std::vector<nlohmann::json> kExamples = examples();
  testing::JsonMutator mutator(seed);
  nlohmann::json file = kExamples[mutator.below(kExamples.size())];
  for (std::size_t left = 1 + mutator.below(3); left > 0; --left) mutator.change(file);
  const std::string text = file.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const std::size_t length = std::min(text.size(), most);
  std::memcpy(data, text.data(), length);
  return length;
}
