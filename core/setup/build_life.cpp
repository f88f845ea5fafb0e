#include "setup/build_life.hpp"

#include "setup/grade_oil.hpp"
#include "setup/lubricated.hpp"

#include <string>

namespace adore::setup {
namespace {

using bearing::LifeComponentInput;
using bearing::LifeModelInput;
using deck::Deck;

class Reader {
 public:
  explicit Reader(const Deck& deck) : deck_(deck) {}

  /// Empty when no present record has the variable.
  [[nodiscard]] std::optional<double> value(const std::string& name, bool acts = true) const {
    if (!deck_.has(name)) return std::nullopt;
    const deck::ReportOnly quiet(deck_, !acts);
    return deck_.si(name);
  }
  /// The same for a value that must be above 0.
  [[nodiscard]] std::optional<double> positive(const std::string& name, const char* remedy) {
    const std::optional<double> out = value(name);
    if (out && !(*out > 0.0))
      issues_.push_back(deck_.issue(Severity::Error, name,
                                    "must be above 0; otherwise the life is zero", remedy));
    return out;
  }
  /// Every stress falls with depth exponents and stress exponents that are far enough apart.
  void check_exponents(const std::string& stress, const std::string& depth) {
    const auto c = value(stress), h = value(depth);
    if (c && h && *c > 0.0 && !(*c - *h + 1.0 > 0.0))
      issues_.push_back(
          deck_.issue(Severity::Error, stress,
                      "is too small for the depth exponent of the same record: life would not "
                      "decrease with load",
                      "give a value above the depth exponent minus 1"));
  }
  void finish() {
    if (!issues_.empty()) throw InputError(std::move(issues_));
  }

 private:
  const Deck& deck_;
  std::vector<Issue> issues_;
};

void read_constants(Reader& read, const std::string& suffix, const std::string& slope,
                    LifeComponentInput& out) {
  constexpr const char* kKeep = "give 1 to keep the built-in value";
  out.original_factor = read.positive("fco" + suffix, kKeep);
  out.updated = {read.positive("fcLP" + suffix, kKeep), read.value("shExLP" + suffix),
                 read.value("depExLP" + suffix)};
  out.zaretsky = {read.positive("fcGZ" + suffix, kKeep), read.value("shExGZ" + suffix),
                  std::nullopt};
  out.harris = {read.positive("fcIH" + suffix, kKeep), read.value("shExIH" + suffix),
                read.value("depExIH" + suffix)};
  read.check_exponents("shExLP" + suffix, "depExLP" + suffix);
  read.check_exponents("shExIH" + suffix, "depExIH" + suffix);
  out.weibull_slope = read.positive(slope,
                                    "give a value such as 1.111 (point contact) or 1.125 "
                                    "(line contact)");
}

/// `film`: a film parameter is known, so that asperities are counted.
void read_factors(Reader& read, const std::string& suffix, const std::string& stle_suffix,
                  bool film, LifeComponentInput& out) {
  out.asperity_slope = read.value("rmsAspSlope" + suffix, film);
  out.asperity_traction = read.value("aspTrac" + suffix, film);
  out.tallian_material = read.value("facMat" + suffix);
  out.tallian_contamination = read.value("facCont" + suffix);
  out.tallian_process = read.value("facProc" + suffix);
  out.stle_material = read.value("facMatLF" + stle_suffix);
  out.stle_process = read.value("facProcLF" + stle_suffix);
  out.stle_hardness = read.value("hardnessLF" + stle_suffix);
}

}  // namespace

bearing::LifeInputs build_life_inputs(const Deck& deck, const bearing::LifeChoices& choices) {
  bearing::LifeInputs out;
  out.choices = choices;
  Reader read(deck);
  out.survival = read.value("sProb");
  out.bearing_slope = read.positive("brgWbDis", "give a value above 0, such as 1.111");
  const std::string suffixes[] = {"1", "2", "re"};
  const std::string slopes[] = {"wbDis1", "wbDis2", "wbDisRe"};
  for (std::size_t i = 0; i < 3; ++i) read_constants(read, suffixes[i], slopes[i], out.part[i]);
  const bool film = choices.film_parameter.has_value() || is_lubricated(deck);
  read_factors(read, "1", "1", film, out.part[bearing::kOuterRacePart]);
  read_factors(read, "2", "2", film, out.part[bearing::kInnerRacePart]);
  read_factors(read, "Re", "re", film, out.part[bearing::kElementPart]);
  out.part[bearing::kOuterRacePart].residual_stress = read.value("res1").value_or(0.0);
  out.part[bearing::kInnerRacePart].residual_stress = read.value("res2").value_or(0.0);
  out.limit_factor = read.value("facStrLimit").value_or(1.0);
  bearing::MakerRatings& ratings = out.choices.ratings;
  for (const auto& [name, value] :
       {std::pair{"ratingC", &ratings.C}, std::pair{"ratingC0", &ratings.C0},
        std::pair{"ratingCu", &ratings.C_u}, std::pair{"ratingE", &ratings.e},
        std::pair{"ratingX", &ratings.X}, std::pair{"ratingY", &ratings.Y}})
    *value = read.value(name);
  out.race_limit = read.value("ratingVM");
  out.choices.oil = grade_oil_of(deck);
  read.finish();
  return out;
}

}  // namespace adore::setup
