#include "core/runs/user_runs.hpp"

#include <algorithm>

/// ADRX7 of all kinds of contact (decision 431).
using namespace adore;
using namespace adore::user_runs;

namespace {

struct Asked {
  long calls = 0, of_several = 0, contacts = 0, without_load = 0, entrained = 0;
  std::int64_t most = 0;
  bool right_kind = true;
};

/// A plug-in that restates a curve for a kind of contact, times a factor.
std::shared_ptr<user::PlugIn> restating(const bearing::TractionCurve& c, int kind, double factor,
                                        Asked& asked) {
  auto out = std::make_shared<user::PlugIn>();
  out->source = "the test";
  out->hooks[7] = [=, &asked](adore_call& call) {
    call.active = 1;
    auto& a = reinterpret_cast<adore_adrx7&>(call);
    if (call.mode == ADORE_START) a.slip_scale = c.A + c.D == 0.0 ? 1.0 / c.C : 0.0;
    if (call.mode != ADORE_COMPUTE) return 0;
    for (std::int64_t k = 0; k < a.points * a.stride; ++k)
      a.kappa[k] = factor * ((c.A + c.B * a.slip[k]) * std::exp(-c.C * a.slip[k]) + c.D);
    if (call.time == 0.0) return 0;  // at rest, before the run
    asked.right_kind = asked.right_kind && a.kind == kind;
    ++asked.calls;
    if (a.n > 1) ++asked.of_several;
    asked.contacts += a.n;
    asked.most = std::max(asked.most, a.n);
    for (std::int64_t i = 0; i < a.n; ++i) {
      if (!(a.load[i] > 0.0)) ++asked.without_load;
      if (a.entrainment[i] != 0.0) ++asked.entrained;
    }
    return 0;
  };
  return out;
}

}  // namespace

TEST_CASE("user traction: one call for all contacts of each type, and equal laws change nothing",
          "[user][physics]") {
  struct Case {
    const char *name, *type, *variable;
    int kind;
    Sets sets;
    std::int64_t most;  ///< contacts in one call, at least
    double calls;       ///< of an evaluation, at most
    const char* until;
  };
  // Stored steps ask contact by contact: there are but the first and the last.
  const Sets seldom{{"kPltFreq", "100000"}, {"kPrtFreq", "0"}};
  const Sets fast_cage{{"avRatio", "1.2"}};
  const Sets no_cage{{"nCseg", "0"},       {"kPltElemInd[3]", "13"}, {"kPltElemInd[4]", "14"},
                     {"kRRTracType", "2"}, {"reReTC2", "0.06"},      {"reReTC3", "0.6"}};
  const auto with = [](Sets a, const Sets& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  for (const Case& c : {
           Case{"rollers on races", "cylindrical", "kTrac", 0, {}, 32, 2.0, "1e-4s"},
           Case{"barrels on races", "spherical", "kTrac", 0, {}, 32, 2.0, "5e-5s"},
           Case{"ball pockets", "ball", "kCPTrac", 1, fast_cage, 2, 1.0, "2e-4s"},
           Case{"roller pockets", "cylindrical", "kCPTrac", 1, fast_cage, 16, 1.0, "2e-4s"},
           Case{"lands", "cylindrical", "kCRTrac", 2, {{"cageGsCls[1]", "1e-8"}}, 1, 1.0, "1e-4s"},
           Case{"flanges", "tapered", "kRFTrac", 3, {}, 8, 1.0, "1e-4s"},
           Case{"balls", "ball", "kRRTrac", 4,
                with(no_cage, {{"nRe", "14"}, {"pitchDia", "0.0570735"}}), 2, 1.0, "3e-4s"},
       }) {
    CAPTURE(c.name);
    const std::string built_in_deck = deck_of(c.type, with(seldom, c.sets), "");
    const std::string deck = deck_of(c.type, with(with(seldom, c.sets), {{c.variable, "-1"}}), "");
    // Elastic: a damped contact that parts fast overlaps without load, and is asked for.
    const auto elastic = [&](const char* name, const std::string& text) {
      auto request = request_of(name, text, c.until);
      request.options.emplace_back("contactDamping", "0");
      return request;
    };
    const Ran built_in = ran_with(elastic("traction-built-in", built_in_deck));
    REQUIRE(built_in.outcome.status == runs::RunStatus::Done);
    runs::DeckRequest plain;
    plain.text = built_in_deck;
    const bearing::Bearing bearing = runs::prepare(plain).as_built;
    const bearing::TractionCurve curve = c.kind == 0   ? bearing.race_traction
                                         : c.kind == 1 ? bearing.pocket_traction.value()
                                         : c.kind == 2 ? bearing.land_traction.value()
                                         : c.kind == 3 ? bearing.flange_traction.value()
                                                       : bearing.element_traction.value();
    const auto run = [&](double factor, Asked& asked) {
      auto request = elastic("traction", deck);
      request.routines = restating(curve, c.kind, factor, asked);
      return ran_with(request);
    };
    Asked asked, other;
    const Ran restated = run(1.0, asked);
    REQUIRE(restated.outcome.status == runs::RunStatus::Done);
    check_same_to_rounding(built_in, restated);
    CHECK(asked.right_kind);
    CHECK(asked.most >= c.most);
    const auto evaluations = static_cast<double>(restated.outcome.evaluations);
    INFO(fmt::format("{} calls, {} contacts, {} at most, {} evaluations", asked.calls,
                     asked.contacts, asked.most, restated.outcome.evaluations));
    // Rollers on races always come in numbers; the two stored steps ask for each slice by itself.
    const auto calls = static_cast<double>(c.kind == 0 ? asked.of_several : asked.calls);
    CHECK(calls < 1.2 * c.calls * evaluations + 100.0);
    // A land that touches by the last bit of a clearance has no load.
    if (c.kind > 0) CHECK(asked.without_load < asked.contacts / 100);
    if (c.kind == 0) CHECK(asked.entrained > asked.contacts / 2);
    CHECK(difference(built_in, run(1.5, other)) > 1e-9);
  }
}
