#include "results/energy_judgement.hpp"

#include "results/run_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace adore::results {
namespace {

Trust judge(double ratio, double warning, double limit) {
  if (!(ratio <= limit)) return Trust::None;
  return ratio <= warning ? Trust::Full : Trust::Warned;
}

}  // namespace

EnergyJudgement judge_energy(const scene::EnergyLedger& energy, double elastic, double largest) {
  EnergyJudgement out;
  const double at_end = std::abs(energy.residual()), moved = energy_scale(energy);
  const double residual = at_end < largest ? largest : at_end;  // no number stays none
  if (!(moved <= 0.0)) out.over_moved = residual / moved;
  if (elastic > 0.0) out.over_elastic = residual / elastic;
  const Trust by_moved = judge(out.over_moved, kMovedWarning, kMovedLimit);
  const Trust by_elastic = judge(out.over_elastic, kElasticWarning, kElasticLimit);
  out.trust = std::max(by_moved, by_elastic);
  if (out.trust == Trust::Full) return out;
  out.text =
      fmt::format("{:.3g} J of energy have no account{}: {:.2g} of the {:.3g} J that moved{}",
                  residual, at_end < residual ? " at some time of the run" : "", out.over_moved,
                  moved, by_moved == Trust::None ? fmt::format(" (limit {:g})", kMovedLimit) : "");
  if (elastic > 0.0)
    out.text +=
        fmt::format(", {:.2g} of the {:.3g} J of elastic energy in the quasi-static solution{}",
                    out.over_elastic, elastic,
                    by_elastic == Trust::None ? fmt::format(" (limit {:g})", kElasticLimit) : "");
  out.text += ". ";
  out.text += out.trust == Trust::None
                  ? "The results of this run cannot be trusted. Lower the tolerance (tol on record "
                    "2.1, or --tol) or the longest step (stpMax), lower stpMin when steps were "
                    "accepted above the tolerance, or choose another integrator"
                  : "Where that matters, lower the tolerance (tol on record 2.1, or --tol) or the "
                    "longest step (stpMax)";
  return out;
}

}  // namespace adore::results
