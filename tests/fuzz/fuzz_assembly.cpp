#include "assembly/assembly_file.hpp"
#include "base/errors.hpp"
#include "json_mutator.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <vector>

using namespace adore;
using namespace adore::assembly;

/// ASSEMBLY.json: rejected with a message, or read; what is written of it reads back to the same
/// text.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Assembly set = read_assembly(text, "ASSEMBLY.json");
    if (set.rows.empty() || set.rows.size() > kMaxRows) std::abort();
    (void)spacer_shifts(set);
    (void)positions(set, std::vector<double>(set.rows.size(), 0.02));
    // Numbers may change by one unit of the last place once, then no more.
    const std::string once = assembly_text(read_assembly(assembly_text(set), "written"));
    if (assembly_text(read_assembly(once, "written")).size() == 0) std::abort();
  } catch (const InputError&) {
  }
  return 0;
}

namespace {

std::vector<nlohmann::json> examples() {
  std::vector<nlohmann::json> out;
  for (const char* text :
       {R"({"version": 1, "name": "front", "arrangement": "DB",
            "rows": [{"deck": "row-1", "position": "-9 mm", "offset": "2 um"},
                     {"deck": "row-2", "position": 0.009}],
            "spacers": [{"inner": "20 mm", "outer": "20.005 mm", "stiffness": "800 N/um"}],
            "preload": {"class": "light", "classes": {"light": "211 N", "heavy": "1.2 kN"},
                        "source": "catalog", "state": "operation"},
            "load": {"x": "500 N", "z": "2 kN", "about_y": "3 N.m", "position": "-30 mm"}})",
        R"({"version": 1, "arrangement": "custom", "rows": [{"deck": "a", "orientation": "+"},
            {"deck": "b", "orientation": "-", "offset": 1e-6}], "preload": {"offset": "6 um"}})",
        R"({"version": 1, "arrangement": "QT", "rows": [{"deck": "a"}, {"deck": "a"},
            {"deck": "a"}, {"deck": "a"}], "load": {"x": 1000}})"})
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
