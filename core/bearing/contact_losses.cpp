#include "bearing/contact_losses.hpp"

#include "bearing/material_json.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace adore::bearing {

ContactLosses contact_losses(const Material& material) {
  constexpr double kLeastOfMetals = 50e9;  // E [Pa]
  const auto& table = material_json().at("materials");
  std::string key = material.table_key;
  if (!table.contains(key)) key = material.elastic_modulus < kLeastOfMetals ? "201" : "100";
  const auto& entry = table.at(key);
  return {entry.at("loss_factor").at("value").get<double>(),
          entry.at("impact_loss").at("value").get<double>()};
}

ContactLosses contact_losses(const Material& a, const Material& b) {
  const auto compliance = [](const Material& m) {
    return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.elastic_modulus;
  };
  const double share = compliance(a) / (compliance(a) + compliance(b));
  const ContactLosses of_a = contact_losses(a), of_b = contact_losses(b);
  return {share * of_a.loss_factor + (1.0 - share) * of_b.loss_factor,
          share * of_a.impact_loss + (1.0 - share) * of_b.impact_loss};
}

}  // namespace adore::bearing
