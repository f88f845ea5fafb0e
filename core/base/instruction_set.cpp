#include "base/instruction_set.hpp"

#include "base/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <string_view>

namespace adore {
namespace {

constexpr const char* kRequestVariable = "ADORE_ISA";
constexpr InstructionSet kAllSets[] = {InstructionSet::Avx512, InstructionSet::Avx2,
                                       InstructionSet::Baseline};

std::optional<InstructionSet> named_instruction_set(std::string_view name) noexcept {
  for (InstructionSet set : kAllSets) {
    if (name == instruction_set_name(set)) return set;
  }
  return std::nullopt;
}

InstructionSet choose_instruction_set() noexcept {
  if (const char* request = std::getenv(kRequestVariable)) {
    const auto set = named_instruction_set(request);
    if (set && is_instruction_set_available(*set)) return *set;
  }
  return *std::find_if(std::begin(kAllSets), std::end(kAllSets), is_instruction_set_available);
}

}  // namespace

InstructionSet chosen_instruction_set() noexcept {
  static const InstructionSet set = choose_instruction_set();
  return set;
}

bool is_instruction_set_available(InstructionSet set) noexcept {
#if defined(__x86_64__)
  if (set == InstructionSet::Avx512) {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx2") &&
           __builtin_cpu_supports("fma");
  }
  if (set == InstructionSet::Avx2)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
  return set == InstructionSet::Baseline;
}

const char* instruction_set_name(InstructionSet set) noexcept {
  switch (set) {
    case InstructionSet::Avx512:
      return "avx512";
    case InstructionSet::Avx2:
      return "avx2";
    case InstructionSet::Baseline:
      break;
  }
  return "baseline";
}

void check_instruction_set_request() {
  const char* request = std::getenv(kRequestVariable);
  if (request == nullptr) return;
  const auto set = named_instruction_set(request);
  if (!set) {
    throw InputError(
        fmt::format("the environment variable {} = \"{}\" is not an instruction set. Set it to "
                    "\"baseline\", \"avx2\" or \"avx512\", or unset it",
                    kRequestVariable, request));
  }
  if (!is_instruction_set_available(*set)) {
    throw InputError(
        fmt::format("the environment variable {} requests {}, which this machine does not support. "
                    "The largest supported instruction set is {}",
                    kRequestVariable, request,
                    instruction_set_name(*std::find_if(std::begin(kAllSets), std::end(kAllSets),
                                                       is_instruction_set_available))));
  }
}

}  // namespace adore
