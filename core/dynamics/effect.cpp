#include "dynamics/effect.hpp"

#include "base/errors.hpp"

#include <algorithm>

namespace adore::dynamics {

Slice SceneBuilder::state(std::string name, std::string_view unit, int count, ScaleKind kind,
                          int element) {
  const Slice slice = out_.layout.add(std::move(name), unit, count, 1.0);
  out_.kinds.emplace_back(slice, kind);
  out_.owner.insert(out_.owner.end(), static_cast<std::size_t>(count), element);
  return slice;
}

Slice SceneBuilder::add_element_states(std::string name, std::string_view unit, ScaleKind kind) {
  const Slice slice = state(std::move(name), unit, bearing.element_count(), kind, 0);
  for (int i = 0; i < slice.count; ++i) out_.owner[static_cast<std::size_t>(slice.first + i)] = i;
  return slice;
}

Slice SceneBuilder::quaternion(std::string name, int element) {
  const Slice slice = state(std::move(name), "-", 4, ScaleKind::Angle, element);
  out_.quaternions.push_back(slice);
  return slice;
}

void SceneBuilder::integral(int& index, std::string name, std::string_view unit, const double* rate,
                            int count) {
  out_.integrals.push_back({&index, std::move(name), std::string(unit), rate, count});
}

void SceneBuilder::energy(int& index, std::string name, const LedgerTerm& term, const double* rate,
                          int race) {
  out_.energy.push_back({&term, race, static_cast<int>(out_.integrals.size()), rate});
  integral(index, std::move(name), "J", rate);
}

void SceneBuilder::energy(std::string name, const LedgerTerm& term, const double* rate, int race) {
  out_.energy.push_back({&term, race, static_cast<int>(out_.integrals.size()), rate});
  out_.integrals.push_back({nullptr, std::move(name), "J", rate, 1});
}

void SceneBuilder::momentum(int& index, std::string name, Momentum which, const LedgerTerm& term,
                            const double* rate) {
  const bool angular = which == Momentum::Angular;
  out_.momentum.push_back({&term, angular, static_cast<int>(out_.integrals.size())});
  integral(index, std::move(name), angular ? "N m s" : "N s", rate, 3);
}

void SceneBuilder::add_border_body(BodyId id, const BorderBody& body, Slice rows) {
  demand(rows.first >= 0 && rows.count > 0 &&
             rows.first + rows.count <= static_cast<int>(out_.owner.size()),
         "a body was added to the solver without state variables");
  for (int k = rows.first; k < rows.first + rows.count; ++k)
    demand(out_.owner[static_cast<std::size_t>(k)] == kBorder,
           "a state variable of a race or cage belongs to a rolling element");
  for (const Assembly::Border& other : out_.border)
    demand(!(other.id == id), "the same body was added to the solver twice");
  out_.border.push_back({id, &body, rows});
}

bool SceneBuilder::races_move() const {
  return std::any_of(out_.effects.begin(), out_.effects.end(),
                     [](const auto& effect) { return effect->moves_races(); });
}

void SceneBuilder::add_block(Phase phase, std::unique_ptr<EffectBlock> block, std::string_view cost,
                             CoupledBodies partners) {
  out_.blocks.push_back({phase, std::move(block), out_.cost.entry(cost), std::move(partners)});
}

}  // namespace adore::dynamics
