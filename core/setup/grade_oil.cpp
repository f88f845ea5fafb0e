#include "setup/grade_oil.hpp"

#include <array>
#include <string>

namespace adore::setup {

std::optional<bearing::OilByGrade> grade_oil_of(const deck::Deck& deck) {
  bearing::OilGradeInput in;
  bool any = false;
  const auto real = [&](const char* name, std::optional<double>& value) {
    if (!deck.has(name)) return;
    value = deck.si(name);
    any = true;
  };
  if (deck.has("oilGrade")) {
    in.grade = static_cast<int>(deck.integer("oilGrade"));
    any = true;
  }
  real("oilVisc1", in.first);
  real("oilTemp1", in.first_at);
  real("oilVisc2", in.second);
  real("oilTemp2", in.second_at);
  real("oilIndex", in.viscosity_index);
  real("oilDen", in.density);
  real("oilPrCoeff", in.pressure_coefficient);
  real("oilTemp", in.bearing_temperature);
  if (deck.has("kOilBase")) in.base = static_cast<bearing::BaseOil>(deck.integer("kOilBase"));
  if (deck.has("kGrease")) in.grease = deck.integer("kGrease") == 1;
  if (deck.has("oilName")) in.name = deck.text("oilName");
  if (!any) return std::nullopt;
  return bearing::oil_by_grade(in);
}

}  // namespace adore::setup
