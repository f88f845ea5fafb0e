// Compiled with the flags that core/CMakeLists.txt sets for this file on x86-64; empty elsewhere.
#if defined(__x86_64__)
#include "statics/roller_kernel_impl.hpp"

namespace adore::statics {

void roller_kernel_avx512(const RollerKernelInput& in) noexcept { evaluate_rollers(in); }
void roller_rolling_resistance_avx512(const RollingResistanceInput& in) noexcept {
  evaluate_rolling_resistance(in);
}
void roller_report_avx512(const RollerReportInput& in) noexcept { report_slices(in); }

}  // namespace adore::statics
#endif
