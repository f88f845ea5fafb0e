#pragma once

/// Vector unit that contact kernels use. Kernels are compiled once per set; one set serves a
/// process.
namespace adore {

enum class InstructionSet : unsigned char { Baseline, Avx2, Avx512 };

[[nodiscard]] bool is_instruction_set_available(InstructionSet set) noexcept;
[[nodiscard]] const char* instruction_set_name(InstructionSet set) noexcept;

/// The widest one of the machine, or that of the environment variable ADORE_ISA = baseline, avx2 or
/// avx512, chosen at first use.
[[nodiscard]] InstructionSet chosen_instruction_set() noexcept;

/// Call once at start-up: a wrong ADORE_ISA is the user's error, but the hot path cannot throw (it
/// then uses the best set).
/// @throws InputError when ADORE_ISA names no instruction set or one that this machine lacks.
void check_instruction_set_request();

}  // namespace adore
