#include "facade/catalogue_torque.hpp"

#include "deck/templates.hpp"
#include "facade/prepare.hpp"
#include "tribology/lubricant.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>

namespace adore::facade {
namespace {

enum class Form { DeepGroove, Cylindrical, Tapered };

struct Bearing {
  const char* deck;
  const char* name;
  Form form;
  double d, D;                          // mm
  double R1, R2, S1, S2;                // of the series
  double Y;                             // of the size
  double Kz, film;                      // φrs; μ of a full film
  std::array<double, 3> radial, axial;  // N
};

constexpr Bearing kBearings[] = {
    {"deep-groove-6205",
     "6205 deep groove",
     Form::DeepGroove,
     25.0,
     52.0,
     3.9e-7,
     0.0,
     3.23e-3,
     0.0,
     0.0,
     3.1,
     0.05,
     {350.0, 700.0, 1400.0},
     {0.0, 0.0, 0.0}},
    {"cylindrical-nu209",
     "NU 209 cylindrical roller",
     Form::Cylindrical,
     45.0,
     85.0,
     1.09e-6,
     0.0,
     0.16,
     0.0015,
     0.0,
     5.1,
     0.02,
     {1500.0, 4450.0, 9000.0},
     {0.0, 0.0, 0.0}},
    {"tapered-30208",
     "30208 tapered roller",
     Form::Tapered,
     40.0,
     80.0,
     1.76e-6,
     10.9,
     0.017,
     2.0,
     1.6,
     6.0,
     0.002,
     {1500.0, 3000.0, 6000.0},
     {1500.0, 3000.0, 6000.0}},
};
constexpr std::array<double, 4> kSpeeds{500.0, 1500.0, 3000.0, 6000.0};
constexpr int kOil = 1;                  // SAE 30
constexpr double kTemperature = 343.15;  // K

void add_catalogue(const Bearing& b, double nu, TorqueLine& line) {
  const double dm = 0.5 * (b.d + b.D), n = line.rpm;
  double rolling = 0.0, sliding = 0.0;
  switch (b.form) {
    case Form::DeepGroove:
      rolling = b.R1 * std::pow(dm, 1.96) * std::pow(line.radial, 0.54);
      sliding = b.S1 * std::pow(dm, -0.26) * std::pow(line.radial, 5.0 / 3.0);
      break;
    case Form::Cylindrical:
      rolling = b.R1 * std::pow(dm, 2.41) * std::pow(line.radial, 0.31);
      sliding = b.S2 * dm * line.radial;
      break;
    case Form::Tapered:
      rolling = b.R1 * std::pow(dm, 2.38) * std::pow(line.radial + b.R2 * b.Y * line.axial, 0.31);
      sliding = b.S1 * std::pow(dm, 0.82) * (line.radial + b.S2 * b.Y * line.axial);
      break;
  }
  const double inlet = 1.0 / (1.0 + 1.84e-9 * std::pow(n * dm, 1.28) * std::pow(nu, 0.64));
  const double starved =
      std::exp(-3e-8 * nu * n * (b.d + b.D) * std::sqrt(b.Kz / (2.0 * (b.D - b.d))));
  const double mixed = std::exp(-2.6e-8 * std::pow(n * nu, 1.4) * dm);
  constexpr double kBoundary = 0.15, kMillimetre = 1e-3;
  line.catalogue_rolling = kMillimetre * inlet * starved * rolling * std::pow(nu * n, 0.6);
  line.catalogue_sliding = kMillimetre * sliding * (mixed * kBoundary + (1.0 - mixed) * b.film);
}

TorqueLine line_of(const Bearing& b, double rpm, double radial, double axial) {
  LoadedDeck input;
  input.path = kStandardInput;
  input.deck = deck::new_deck(b.deck);
  deck::Deck& deck = input.deck;
  deck.set("kTrac", std::to_string(kOil));
  deck.set("kTracType", "1");
  if (b.form == Form::Tapered || b.form == Form::Cylindrical) deck.set("kRFTracType", "2");
  deck.complete();
  const auto real = [&](const char* name, double value) {
    deck.set(name, fmt::format("{:.6e}", value));
  };
  // Mixed friction below a film of the roughness, 0.15 as in the catalogue.
  real("reRaceTC1", 0.0);
  real("reRaceTC2", 0.15);
  real("reRaceTC3", 0.14);
  real("reRaceTC4", 0.1);
  real("reRaceFilm", 1.5e-7);
  real("strParam", 10.0);
  if (deck.has("reFlngTC1")) {
    real("reFlngTC1", 0.0);
    real("reFlngTC2", 0.05);
    real("reFlngTC3", 0.5);
  }
  for (const char* name : {"hsngTemp", "shftTemp", "raceTemp1", "raceTemp2", "reTemp", "roomTemp"})
    real(name, kTemperature);  // cold clearances stay
  real("rpm2", rpm);
  real("appLoadZ", radial);
  real("appLoadX", axial);
  const Prepared prepared = prepare(std::move(input));
  const statics::FrictionEstimate& f = *prepared.friction;
  const statics::FrictionOfContact outer = f.of_race(0), inner = f.of_race(1);
  TorqueLine out;
  out.rpm = rpm;
  out.radial = radial;
  out.axial = axial;
  out.rolling = (outer.rolling + inner.rolling) / f.speed;
  out.sliding = (outer.sliding + inner.sliding) / f.speed;
  out.spin = (outer.spin + inner.spin) / f.speed;
  out.rib = (f.flange[0] + f.flange[1]) / f.speed;
  out.drag = f.drag() / f.speed;
  return out;
}

}  // namespace

std::vector<TorqueTable> catalogue_torques() {
  const tribology::Lubricant& oil = tribology::lubricant(kOil);
  const double nu = oil.base_viscosity(kTemperature) / oil.density.at(kTemperature);
  constexpr double kSquareMillimetre = 1e6;
  std::vector<TorqueTable> out;
  for (const Bearing& b : kBearings) {
    TorqueTable& table = out.emplace_back();
    table.deck = b.deck;
    table.bearing = b.name;
    table.viscosity = nu;
    for (std::size_t load = 0; load < b.radial.size(); ++load)
      for (const double rpm : kSpeeds) {
        table.lines.push_back(line_of(b, rpm, b.radial[load], b.axial[load]));
        add_catalogue(b, kSquareMillimetre * nu, table.lines.back());
      }
  }
  return out;
}

namespace {

/// One row; `cell` writes a value in N mm.
std::string torque_row(const TorqueLine& l, const char* form) {
  constexpr double kMilli = 1e3;
  return fmt::format(fmt::runtime(form), l.radial, l.axial, l.rpm, kMilli * l.rolling,
                     kMilli * l.sliding, kMilli * l.spin, kMilli * l.rib, kMilli * l.total(),
                     kMilli * l.catalogue_rolling, kMilli * l.catalogue_sliding,
                     kMilli * l.catalogue(), l.rolling / l.catalogue_rolling,
                     l.total() / l.catalogue());
}

}  // namespace

std::string torque_text(const std::vector<TorqueTable>& tables) {
  std::string out;
  for (const TorqueTable& table : tables) {
    out += fmt::format(
        "\n{} ({}.txt), SAE 30 at 70 degrees Celsius, {:.1f} mm2/s, flooded; torques in N mm\n",
        table.bearing, table.deck, 1e6 * table.viscosity);
    out += fmt::format(
        "{:>7} {:>7} {:>6} | {:>8} {:>8} {:>6} {:>6} {:>8} | {:>8} {:>8} {:>8} | {:>7} "
        "{:>6}\n",
        "Fr [N]", "Fa [N]", "rpm", "rolling", "sliding", "spin", "rib", "ours", "rolling",
        "sliding", "formula", "rolling", "total");
    for (const TorqueLine& line : table.lines)
      out +=
          torque_row(line,
                     "{:>7.0f} {:>7.0f} {:>6.0f} | {:>8.2f} {:>8.2f} {:>6.2f} {:>6.1f} {:>8.2f} | "
                     "{:>8.2f} {:>8.2f} {:>8.2f} | {:>7.2f} {:>6.2f}\n");
  }
  return out;
}

std::string torque_markdown(const std::vector<TorqueTable>& tables) {
  std::string out;
  for (const TorqueTable& table : tables) {
    out += fmt::format(
        "\n## {}\n\nSAE 30 at 70 °C, {:.1f} mm²/s, flooded, no medium in the cavity; N mm. The "
        "last "
        "two columns are ours over the formula.\n\n",
        table.bearing, 1e6 * table.viscosity);
    out +=
        "| Fr [N] | Fa [N] | rpm | rolling | sliding | spin | rib | ours | formula: rolling | "
        "sliding | formula | rolling | total "
        "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const TorqueLine& line : table.lines)
      out += torque_row(line,
                        "| {:.0f} | {:.0f} | {:.0f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} | {:.2f} | "
                        "{:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n");
  }
  return out;
}

nlohmann::ordered_json torque_json(const std::vector<TorqueTable>& tables) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const TorqueTable& table : tables) {
    nlohmann::ordered_json lines = nlohmann::ordered_json::array();
    for (const TorqueLine& l : table.lines)
      lines.push_back({{"rpm", l.rpm},
                       {"radial load [N]", l.radial},
                       {"axial load [N]", l.axial},
                       {"rolling [N.m]", l.rolling},
                       {"sliding [N.m]", l.sliding},
                       {"spin [N.m]", l.spin},
                       {"rib [N.m]", l.rib},
                       {"drag [N.m]", l.drag},
                       {"catalogue rolling [N.m]", l.catalogue_rolling},
                       {"catalogue sliding [N.m]", l.catalogue_sliding}});
    out.push_back({{"bearing", table.bearing},
                   {"deck", table.deck},
                   {"viscosity [m2/s]", table.viscosity},
                   {"lines", lines}});
  }
  return out;
}

}  // namespace adore::facade
