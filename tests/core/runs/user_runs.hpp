#pragma once

#include "deck/templates.hpp"
#include "results/restart.hpp"
#include "runs/prepare.hpp"
#include "runs/run.hpp"
#include "support/bytes.hpp"
#include "tribology/traction_curve.hpp"
#include "user/plug_in.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Whole runs with routines of the user: what their tests share.
namespace adore::user_runs {
namespace fs = std::filesystem;

using Sets = std::vector<std::pair<std::string, std::string>>;

inline fs::path fresh_folder(const std::string& name) {
  const fs::path out = fs::temp_directory_path() / ("adore-user-runs-" + name);
  fs::remove_all(out);
  fs::create_directories(out);
  return out;
}

inline std::string text_of(const fs::path& file) { return test::bytes_of(file); }

struct Ran {
  runs::RunOutcome outcome;
  fs::path folder;
  std::map<std::string, double> last;  ///< the last state by name
};

/// A deck of a type with changes and lines of records 12.x. Its steps are short enough for a closed
/// ledger; those of the examples are longer.
inline std::string deck_of(const std::string& type, const Sets& sets, const std::string& lines) {
  deck::Deck deck = deck::new_deck(type);
  deck.set_all(Sets{{"intMet", "5"}, {"stpMax", "0.5"}, {"tol", "1e-6"}});
  Sets all{{"nStps", "1"}, {"maxStps", "100000"}, {"kAGraf", "0"}, {"kPrtFreq", "0"}};
  all.insert(all.end(), sets.begin(), sets.end());
  deck.set_all(all);
  return deck::write_deck(deck) + lines;
}

inline std::string deck_with(const Sets& sets, const std::string& lines) {
  return deck_of("ball", sets, lines);
}

inline runs::RunRequest request_of(const std::string& name, const std::string& deck,
                                   const std::string& until) {
  runs::RunRequest request;
  request.out = fresh_folder(name);
  request.text = deck;
  request.until = until;
  // One start for all: statics do not call ADRX7, and friction equilibria amplify rounding.
  request.options = {{"resultsH5", "0"}, {"rollerFriction", "none"}};
  return request;
}

inline Ran ran_with(const runs::RunRequest& request) {
  Ran out;
  out.outcome = runs::run(request);
  out.folder = *request.out;
  if (fs::exists(out.folder / "FINAL")) {
    const results::FinalState state = results::read_final(out.folder / "FINAL");
    for (std::size_t k = 0; k < state.components.size(); ++k)
      out.last[state.components[k]] = state.state[k];
  }
  return out;
}

inline std::string library(const std::string& name) {
  return (fs::path(USER_EXAMPLES) / ("lib" + name + ".so")).string();
}

inline fs::path json_file(const std::string& name, const std::string& text) {
  const fs::path out = fs::temp_directory_path() / ("adore-user-runs-" + name + ".json");
  std::ofstream(out) << text;
  return out;
}

/// Record 10.1C of the ball deck as the coefficients of its curve.
inline std::string own_curve() {
  const bearing::TractionCurve c = tribology::traction_curve(1, {0.0, 0.06, 0.04, 0.5});
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", c.A, c.B, c.C, c.D);
}

/// The largest difference of any state, over the largest size of its kind.
inline double difference(const Ran& a, const Ran& b) {
  std::map<std::string, double> size, worst;
  for (const auto& [name, value] : a.last) {
    const std::string kind = name.substr(0, name.find('['));
    REQUIRE(b.last.count(name) == 1);
    size[kind] = std::max(size[kind], std::abs(value));
    worst[kind] = std::max(worst[kind], std::abs(value - b.last.at(name)));
  }
  double out = 0.0;
  for (const auto& [kind, value] : worst)
    if (size[kind] > 1e-12) out = std::max(out, value / size[kind]);
  return out;
}

/// A place has a last bit of 7e-18 m; a contact that vibrates with some 1e5 1/s makes velocities of
/// 1e-12 m/s of it (beside 1e-3 m/s here) and 1e-9 rad/s of spin, and 1e-4 s makes 1e-16 m of
/// those; a tapered roller's blow on its flange 1.2e-15 m.
inline void check_same_to_rounding(const Ran& a, const Ran& b) {
  double place = 0.0, velocity = 0.0, spin = 0.0;
  for (const auto& [name, value] : a.last) {
    const double off = std::abs(value - b.last.at(name));
    if (name.find("[m]") != std::string::npos) place = std::max(place, off);
    if (name.find("[m/s]") != std::string::npos) velocity = std::max(velocity, off);
    if (name.find("[rad/s]") != std::string::npos) spin = std::max(spin, off);
  }
  CHECK(1e15 * place < 5.0);
  CHECK(velocity < 1e-11);
  CHECK(spin < 1e-8);
}

/// A plug-in of one force law: F of a contact k.
using Force = std::function<double(const adore_force&, std::int64_t k)>;
inline std::shared_ptr<user::PlugIn> force_law(int hook, const Force& law) {
  auto out = std::make_shared<user::PlugIn>();
  out->source = "the test";
  out->hooks[static_cast<std::size_t>(hook)] = [law](adore_call& call) {
    call.active = 1;
    if (call.mode != ADORE_COMPUTE) return 0;
    auto& a = reinterpret_cast<adore_force&>(call);
    for (std::int64_t k = 0; k < a.n; ++k) a.force[k] = law(a, k);
    return 0;
  };
  return out;
}

}  // namespace adore::user_runs
