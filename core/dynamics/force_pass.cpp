#include "dynamics/force_pass.hpp"

#include "dynamics/effect.hpp"

namespace adore::dynamics {

void ForcePass::apply(Evaluation& e, Which which) const noexcept {
  for (const Assembly::Block& b : parts_->blocks) {
    if (b.phase != Phase::Force || (elements_alone_ && !b.block->acts_on_elements())) continue;
    const BodyId* partner = b.partners.of(0);
    const bool on_race = partner != nullptr && partner->kind == BodyId::Kind::Race;
    if (on_race != (which == Which::OnRaces)) continue;
    b.block->apply(e);
    if (!e.valid) return;
  }
}

void ForcePass::resist(const Evaluation& e, std::size_t i, Mat3& stiffness) const noexcept {
  for (NonRaceContacts* support : parts_->supports) support->resist(e, i, stiffness);
}

void ForcePass::damp(const Evaluation& e, std::size_t i, Eigen::Matrix2d& damping) const noexcept {
  for (NonRaceContacts* support : parts_->supports) support->damp(e, i, damping);
}

}  // namespace adore::dynamics
