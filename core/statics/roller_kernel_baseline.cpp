#include "statics/roller_kernel_impl.hpp"

namespace adore::statics {

void roller_kernel_baseline(const RollerKernelInput& in) noexcept { evaluate_rollers(in); }
void roller_rolling_resistance_baseline(const RollingResistanceInput& in) noexcept {
  evaluate_rolling_resistance(in);
}
void roller_report_baseline(const RollerReportInput& in) noexcept { report_slices(in); }

}  // namespace adore::statics
