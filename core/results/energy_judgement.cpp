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

struct Shares {
  double over_moved = 0.0, over_elastic = 0.0;
  Shares(double residual, double moved, double elastic) {
    if (!(moved <= 0.0)) over_moved = residual / moved;
    if (elastic > 0.0) over_elastic = residual / elastic;
  }
  [[nodiscard]] Trust by_moved() const { return judge(over_moved, kMovedWarning, kMovedLimit); }
  [[nodiscard]] Trust by_elastic() const {
    return judge(over_elastic, kElasticWarning, kElasticLimit);
  }
  [[nodiscard]] Trust trust() const { return std::max(by_moved(), by_elastic()); }
};

}  // namespace

EnergyJudgment judge_energy(const scene::EnergyLedger& energy, double elastic, double largest) {
  EnergyJudgment out;
  double residual = std::abs(energy.residual());
  const double moved = energy_scale(energy);
  Shares shares(residual, moved, elastic);
  out.trust = shares.trust();
  const bool earlier = out.trust != Trust::None && largest > residual;
  if (earlier) {
    residual = largest;
    shares = Shares(residual, moved, elastic);
    // One that came to nothing again was held back for a while; of one that did not, only the sign
    // changed.
    out.trust = out.trust == Trust::Full ? std::min(shares.trust(), Trust::Warned) : shares.trust();
  }
  out.over_moved = shares.over_moved;
  out.over_elastic = shares.over_elastic;
  const double heat = heat_scale(energy), at_end = std::abs(energy.residual());
  if (heat > 0.0) out.over_heat = at_end / heat;
  const bool falsifies_heat = !(out.over_heat <= kHeatWarning);
  if (falsifies_heat) out.trust = std::max(out.trust, Trust::Warned);
  if (out.trust == Trust::Full) return out;
  const bool none = out.trust == Trust::None;
  const auto limit = [none](Trust trust, double value) {
    return none && trust == Trust::None ? fmt::format(" (limit {:g})", value) : "";
  };
  out.text =
      fmt::format("energy residual of {:.3g} J{}: {:.2g} times the exchanged energy of {:.3g} J{}",
                  residual, earlier ? " (largest value of the run)" : "", out.over_moved, moved,
                  limit(shares.by_moved(), kMovedLimit));
  if (elastic > 0.0)
    out.text += fmt::format(
        " and {:.2g} times the elastic energy of {:.3g} J in the quasi-static solution{}",
        out.over_elastic, elastic, limit(shares.by_elastic(), kElasticLimit));
  if (falsifies_heat)
    out.text += fmt::format(
        ". At the end of the run, the energy residual is {:.2g} % of the heat ({:.3g} J), so heat "
        "and power loss have this uncertainty",
        100.0 * out.over_heat, heat);
  out.text += ". ";
  constexpr double kNothingElse = 0.5;  // of what moved, error of the steps
  if (none && shares.by_elastic() != Trust::None && out.over_moved > kNothingElse) {
    out.text +=
        "The results of this run cannot be trusted. Contacts neither roll nor slide, and a "
        "lubricant without shear acts as a solid, so integration errors cause most of the motion. "
        "Shorter steps do not help. For a bearing at rest or nearly at rest, use the quasi-static "
        "solution (mode = -1) or the hypothetical traction law (kTrac = 0)";
    return out;
  }
  out.text +=
      out.trust == Trust::None
          ? "The results of this run cannot be trusted. Reduce the tolerance (tol on record 2.1, "
            "or --tol) or the maximum step (stpMax). If the run accepted steps with errors above "
            "the tolerance, reduce stpMin. If smaller steps do not help, choose another integrator"
          : "To reduce the energy residual, reduce the tolerance (tol on record 2.1, or --tol) or "
            "the maximum step (stpMax)";
  return out;
}

}  // namespace adore::results
