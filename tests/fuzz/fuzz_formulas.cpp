#include "base/errors.hpp"
#include "input_file.hpp"
#include "json_mutator.hpp"
#include "user/formulas.hpp"

#include <algorithm>
#include <cstring>

using namespace adore;

/// A file of formulas (run --user laws.json): any bytes give routines or a sentence. The file lies
/// in memory, so that its tables are missing.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const testing::InputFile file(data, size);
  try {
    (void)user::load_formulas(file.path());
  } catch (const InputError&) {
  }
  return 0;
}

/// One to three values changed, or pieces of formulas exchanged.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  static const char* const kPieces[] = {"(",  ")",     "+",   "^",        "*", "if(",   "sin",
                                        "u",  ",",     "?",   ":",        "=", "1e999", "t",
                                        "&&", "w",     "a=1", "\\u0000",  "-", "sum(",  "0x",
                                        "#{", "min()", "!",   "((((((((", "e", "pi",    " "};
  testing::JsonMutator mutator(seed);
  std::string text(reinterpret_cast<const char*>(data), size);
  nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_discarded() && mutator.below(2) == 0) {
    for (std::size_t left = 1 + mutator.below(3); left > 0; --left) mutator.change(json);
    text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  } else {
    for (std::size_t left = 1 + mutator.below(4); left > 0; --left)
      text.insert(mutator.below(text.size() + 1), kPieces[mutator.below(std::size(kPieces))]);
  }
  const std::size_t out = std::min(text.size(), most);
  std::memcpy(data, text.data(), out);
  return out;
}
