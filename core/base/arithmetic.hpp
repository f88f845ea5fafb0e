#pragma once

/// Causes of different last digits of a result in addition to source and compiler.
namespace adore {

/// Whether sin, exp, pow and the other functions of double were bound into the program
/// (cmake/PortableMath.cmake). Otherwise the C library's are called, which picks variants by
/// processor and so rounds differently from machine to machine.
[[nodiscard]] bool has_portable_math() noexcept;

}  // namespace adore
