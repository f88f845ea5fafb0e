#include "base/errors.hpp"
#include "base/json_text.hpp"
#include "calculators/calculator_description.hpp"
#include "calculators/calculators.hpp"
#include "json_mutator.hpp"
#include "validation/adapters.hpp"

#include <algorithm>
#include <cstring>

using namespace adore;
using namespace adore::calculators;

/// `adore calc`: a line with the calculator's name, then its JSON. Any input gives results, a
/// sentence, or numerics that give up.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  try {
    const nlohmann::json input = parse_json(text.substr(end), "input");
    (void)calculate(text.substr(0, end), input, validation::all_adapters())
        .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  } catch (const InputError&) {
  } catch (const SolverError&) {
  }
  return 0;
}

/// Inputs of a random calculator's example with one to three values changed.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t, std::size_t most,
                                               unsigned seed) {
  testing::JsonMutator mutator(seed);
  const CalculatorInfo& info = calculator_list()[mutator.below(calculator_list().size())];
  const nlohmann::ordered_json all = describe_calculator(info).at("calculations");
  nlohmann::json input =
      nlohmann::json::parse(all.at(mutator.below(all.size())).at("example").dump());
  for (std::size_t left = 1 + mutator.below(3); left > 0; --left) mutator.change(input);
  const std::string text =
      info.name + "\n" + input.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const std::size_t size = std::min(text.size(), most);
  std::memcpy(data, text.data(), size);
  return size;
}
