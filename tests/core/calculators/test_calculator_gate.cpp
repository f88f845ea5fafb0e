#include "base/errors.hpp"
#include "calculators/calculator_description.hpp"
#include "calculators/calculator_schema.hpp"
#include "calculators/calculators.hpp"
#include "life/constants.hpp"
#include "support/bytes.hpp"
#include "support/paths.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>

using namespace adore;
using namespace adore::calculators;

namespace {

using Json = nlohmann::json;

/// One value of an example: its place, and its path in the schema ("Qi[]" for each item of Qi).
struct Leaf {
  Json::json_pointer place;
  std::string path;
};

void collect_leaves(const Json& value, const Json::json_pointer& place, const std::string& path,
                    std::vector<Leaf>& out) {
  if (value.is_object()) {
    for (const auto& [key, item] : value.items())
      collect_leaves(item, place / key, path.empty() ? key : path + "." + key, out);
  } else if (value.is_array()) {
    constexpr std::size_t kItems = 2;  // the other items are of the same schema
    for (std::size_t i = 0; i < std::min(value.size(), kItems); ++i)
      collect_leaves(value[i], place / i, path + "[]", out);
  } else {
    out.push_back({place, path});
  }
}

enum class Outcome { Computed, Rejected };

struct Trial {
  Outcome outcome = Outcome::Rejected;
  Json result;
  std::string text;  ///< of the error
};

/// Every number of a result is finite: "inf" and null are texts of their own.
bool is_finite(const Json& value) {
  if (value.is_structured())
    return std::all_of(value.begin(), value.end(),
                       [](const Json& item) { return is_finite(item); });
  return !value.is_number() || std::isfinite(value.get<double>());
}

Trial try_inputs(const CalculatorInfo& info, const SchemaKind& kind, const Json& inputs) {
  const Json the_case = {{"kind", kind.name}, {"inputs", inputs}};
  try {
    Json result = calculate(info.name, the_case);
    CHECK(is_finite(result));
    return {Outcome::Computed, std::move(result), {}};
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).find("bug") == std::string::npos);
    return {Outcome::Rejected, {}, error.what()};
  } catch (const SolverError& error) {
    return {Outcome::Rejected, {}, error.what()};
  }
}

/// What the schema says about a number, read apart from the gate.
bool schema_allows(const SchemaInput& input, double value) {
  if (input.type == "label") return true;
  if (input.type != "number" && value != std::round(value)) return false;
  if (!input.values.empty()) return std::count(input.values.begin(), input.values.end(), value) > 0;
  const ValueRange& r = input.range;
  if (r.nonzero && value == 0.0) return false;
  if (value == r.low) return !r.low_open;
  if (value == r.high) return !r.high_open;
  return value > r.low && value < r.high;
}

using Visit = std::function<void(const CalculatorInfo&, const SchemaKind&, const Json& example)>;

void for_each_kind(const Visit& visit) {
  for (const CalculatorInfo& info : calculator_list()) {
    const SchemaFamily* family = family_schema(info.family);
    REQUIRE(family != nullptr);
    const auto kinds = calculation_kinds(*family, info.kind);
    CHECK_FALSE(kinds.empty());
    for (const SchemaKind* kind : kinds) {
      CAPTURE(info.name, kind->name);
      visit(info, *kind, Json::parse(kind->example.dump()));
    }
  }
}

void report_accepted(const CalculatorInfo& info, const SchemaKind& kind, const Leaf& leaf,
                     const Json& value) {
  if (std::getenv("ADORE_LIST_ACCEPTED") == nullptr) return;
  fmt::print("{}\t{}\t{}\t{}\n", info.name, kind.name, leaf.path, value.dump());
}

}  // namespace

TEST_CASE("calculator gate: a wrong text → rejected, a code in another case → the same results",
          "[unit][calc]") {
  int codes = 0, labels = 0;
  for_each_kind([&](const CalculatorInfo& info, const SchemaKind& kind, const Json& example) {
    const Trial before = try_inputs(info, kind, example);
    INFO(before.text);
    REQUIRE(before.outcome == Outcome::Computed);
    std::vector<Leaf> leaves;
    collect_leaves(example, Json::json_pointer(), "", leaves);
    for (const Leaf& leaf : leaves) {
      const Json& kept = example.at(leaf.place);
      const SchemaInput* input = kind.find(leaf.path);
      CAPTURE(leaf.path);
      REQUIRE(input != nullptr);
      Json changed = example;
      changed[leaf.place] = "foo";
      const Trial foo = try_inputs(info, kind, changed);
      if (input->type == "label") {
        ++labels;
        CHECK(foo.result == before.result);
        continue;
      }
      CHECK(foo.outcome == Outcome::Rejected);
      if (!kept.is_string() || input->type == "name") continue;
      ++codes;
      CHECK(std::count(input->codes.begin(), input->codes.end(), kept.get<std::string>()) == 1);
      for (const auto change :
           {+[](int c) { return std::toupper(c); }, +[](int c) { return std::tolower(c); }}) {
        std::string text = kept;
        std::transform(text.begin(), text.end(), text.begin(),
                       [&](unsigned char c) { return static_cast<char>(change(c)); });
        changed[leaf.place] = text;
        CHECK(try_inputs(info, kind, changed).result == before.result);
      }
      if (input->type != "code") continue;
      changed[leaf.place] = kept.get<std::string>() + "x";
      const Trial misspelled = try_inputs(info, kind, changed);
      CHECK(misspelled.outcome == Outcome::Rejected);
      CHECK(misspelled.text.find("did you mean") != std::string::npos);
    }
  });
  CHECK(codes > 60);
  CHECK(labels > 0);
}

TEST_CASE("calculator gate: a number outside its schema → rejected, inside → finite results",
          "[unit][calc]") {
  int rejected = 0, accepted = 0;
  for_each_kind([&](const CalculatorInfo& info, const SchemaKind& kind, const Json& example) {
    std::vector<Leaf> leaves;
    collect_leaves(example, Json::json_pointer(), "", leaves);
    for (const Leaf& leaf : leaves) {
      const Json& kept = example.at(leaf.place);
      if (!kept.is_number()) continue;
      const SchemaInput* input = kind.find(leaf.path);
      CAPTURE(leaf.path, kept.dump());
      REQUIRE(input != nullptr);
      const double number = kept.get<double>();
      Json changed = example;
      for (const double value : {number == 0.0 ? -1.0 : -number, 0.0, 1e300}) {
        CAPTURE(value);
        changed[leaf.place] = value;
        const Trial trial = try_inputs(info, kind, changed);
        if (trial.outcome == Outcome::Computed && value != number) {
          CHECK(schema_allows(*input, value));
          report_accepted(info, kind, leaf, value);
          ++accepted;
        }
        if (!schema_allows(*input, value)) {
          CHECK(trial.outcome == Outcome::Rejected);
          CHECK(trial.text.find("give") != std::string::npos);
          ++rejected;
        }
      }
      if (input->type == "label") continue;
      changed[leaf.place] = kept.dump();  // in quotes
      const bool as_name = input->type == "name";
      CHECK((try_inputs(info, kind, changed).outcome == Outcome::Computed) == as_name);
      changed[leaf.place] = nullptr;  // NaN in JSON
      const Trial null = try_inputs(info, kind, changed);
      CHECK(((null.outcome == Outcome::Rejected) || input->null_meaning.has_value()));
      changed[leaf.place] = Json::array({kept});
      CHECK(try_inputs(info, kind, changed).outcome == Outcome::Rejected);
      changed[leaf.place] = true;
      CHECK(try_inputs(info, kind, changed).outcome == Outcome::Rejected);
    }
  });
  CHECK(rejected > 1000);
  CHECK(accepted > 300);
}

TEST_CASE("calculator gate: a required input left out → named, an unknown or unused one → named",
          "[unit][calc]") {
  int missing = 0, unused = 0;
  for_each_kind([&](const CalculatorInfo& info, const SchemaKind& kind, const Json& example) {
    std::vector<Leaf> leaves;
    collect_leaves(example, Json::json_pointer(), "", leaves);
    const auto remove = [&](const std::string& path) {  // lists as a whole
      Json changed = example;
      const auto leaf =
          std::find_if(leaves.begin(), leaves.end(), [&](const Leaf& l) { return l.path == path; });
      if (leaf == leaves.end()) return Json();
      Json::json_pointer place = leaf->place;
      while (!place.empty() && changed.at(place.parent_pointer()).is_array()) place.pop_back();
      changed.at(place.parent_pointer()).erase(place.back());
      return changed;
    };
    const auto is_rejected_with_name = [&](const std::string& path) {
      const Json changed = remove(path);
      if (changed.is_null()) return;
      CAPTURE(path);
      const Trial trial = try_inputs(info, kind, changed);
      CHECK(trial.outcome == Outcome::Rejected);
      const std::string key = path.substr(path.rfind('.') + 1);
      CHECK(trial.text.find(key.substr(0, key.find('['))) != std::string::npos);
      ++missing;
    };
    for (const std::string& path : kind.required) is_rejected_with_name(path);
    for (const auto& group : kind.one_of)
      for (const std::string& path : group) is_rejected_with_name(path);
    // An optional input may be left out: the default acts, or what needs it is named.
    for (const std::string& path : kind.optional)
      if (const Json changed = remove(path); !changed.is_null()) {
        CAPTURE(path);
        const Trial trial = try_inputs(info, kind, changed);
        CHECK((trial.outcome == Outcome::Computed ||
               trial.text.find("missing") != std::string::npos));
      }
    Json changed = example;
    changed["no_such_input"] = 1.0;
    const Trial unknown = try_inputs(info, kind, changed);
    CHECK(unknown.text.find("no_such_input = 1.0: there is no such input") != std::string::npos);
    for (const SchemaInput& other : family_schema(info.family)->inputs) {
      if (kind.find(other.name) != nullptr || other.name.find_first_of(".[") != std::string::npos)
        continue;
      changed = example;
      changed[other.name] = 1.0;
      const Trial trial = try_inputs(info, kind, changed);
      CAPTURE(other.name);
      CHECK(trial.text.find("not used by") != std::string::npos);
      ++unused;
    }
  });
  CHECK(missing > 400);
  CHECK(unused > 200);
}

TEST_CASE("calculator gate: inputs that a condition excludes → rejected with the condition",
          "[unit][calc]") {
  const auto text = [](const char* name, const Json& inputs) -> std::string {
    try {
      (void)calculate(name, inputs);
    } catch (const InputError& error) {
      return error.what();
    }
    return "computed";
  };
  Json film = {{"Q", 400.0},
               {"a", 0.001},
               {"b", 0.00015},
               {"h0", 0.0},
               {"rho", nullptr},
               {"u0_c", 0.0},
               {"u0_t", 0.1},
               {"W", {0, 0, 0}},
               {"law", {{"type", "Two_Slope"}, {"A", 0}, {"B", 0.5}, {"C", 0}, {"um", 0.1}}}};
  CHECK(text("ellipse-traction", film) == "computed");
  film["law"]["D"] = 0.05;
  CHECK(text("ellipse-traction", film).find("law.D = 0.05: not used by ellipse_traction") == 0);
  Json strips = {{"a", 0.001}, {"b", 0.0002},
                 {"p0", 1e9},  {"slip0", {0.3, 0}},
                 {"spin", 0},  {"law", {{"kind", "constant"}, {"kappa", 0.05}, {"h", 1e-7}}}};
  CHECK(text("hertz-traction", strips)
            .find("law.h = 1e-07: only used when law.kind is \"newtonianThermal\"; remove it") ==
        0);
  film["law"].erase("D");
  film["law"].erase("um");
  CHECK(text("ellipse-traction", film).find("law.um: missing") != std::string::npos);
  film["law"]["type"] = "two slope";
  CHECK(text("ellipse-traction", film).find("did you mean two_slope?") != std::string::npos);

  Json sphere = {{"Rx", 0.01}, {"Ry", 0.01}, {"E", 2.06e11}, {"nu", 0.3}};
  Json hertz = {{"body1", sphere}, {"body2", sphere}, {"stress_poisson", 0.3}};
  CHECK(text("hertz", hertz).find("give one of load, approach, pressure, half_axis") !=
        std::string::npos);
  hertz["load"] = 10.0;
  hertz["approach"] = 1e-6;
  CHECK(text("hertz", hertz).find("remove one of them") != std::string::npos);
}

TEST_CASE("calculator gate: lengths of lists follow the schema", "[unit][calc]") {
  int lists = 0;
  for_each_kind([&](const CalculatorInfo& info, const SchemaKind& kind, const Json& example) {
    for (const SchemaInput& input : kind.inputs) {
      if (input.length.is_null() || input.name.find("].") != std::string::npos) continue;
      std::string pointer = "/" + input.name.substr(0, input.name.find('['));
      std::replace(pointer.begin(), pointer.end(), '.', '/');
      const Json::json_pointer place(pointer);
      if (!example.contains(place)) continue;
      CAPTURE(input.name);
      for (const bool longer : {true, false}) {
        Json changed = example;
        Json& list = changed[place];
        if (longer)
          list.push_back(list.back());
        else
          list.erase(list.size() - 1);
        const Trial trial = try_inputs(info, kind, changed);
        CHECK(trial.outcome == Outcome::Rejected);
      }
      ++lists;
    }
  });
  CHECK(lists > 30);
}

TEST_CASE("calculator kinds: older names stay, other names are rejected with the nearest kind",
          "[unit][calc]") {
  int aliases = 0;
  for_each_kind([&](const CalculatorInfo& info, const SchemaKind& kind, const Json& example) {
    const Json before = calculate(info.name, Json{{"kind", kind.name}, {"inputs", example}});
    for (const std::string& alias : kind.aliases) {
      CAPTURE(alias);
      CHECK(calculate(info.name, Json{{"kind", alias}, {"inputs", example}}) == before);
      ++aliases;
    }
    CHECK(calculate(info.name, Json{{"kind", kind.runs}, {"inputs", example}}) == before);
    CHECK(calculate(info.name, Json{{"inputs", example}}) == before);  // the inputs select it
    CHECK_THROWS_AS(calculate(info.name, Json{{"kind", kind.name + "_"}, {"inputs", example}}),
                    InputError);
  });
  CHECK(aliases > 10);
}

TEST_CASE("calculator schema: codes of tables are those of the tables", "[unit][calc]") {
  const SchemaFamily& factors = *family_schema("life_factors");
  const auto codes = [](const SchemaFamily& family, const char* name) -> std::set<std::string> {
    for (const SchemaInput& input : family.inputs)
      if (input.name == name) return {input.codes.begin(), input.codes.end()};
    return {};
  };
  const auto keys = [](const auto& map) {
    std::set<std::string> out;
    for (const auto& [key, value] : map) out.insert(key);
    return out;
  };
  const life::LifeConstants& c = life::constants();
  CHECK(codes(factors, "material") == keys(c.stle_material));
  CHECK(codes(factors, "process") == keys(c.stle_process));
  std::set<std::string> classes = keys(c.contamination);
  classes.erase("grease_slight_large");  // chosen by the pitch diameter
  classes.erase("grease_slight_small");
  classes.insert("grease_slight");
  CHECK(codes(*family_schema("life_iso281"), "code") == classes);
}

TEST_CASE("reference cases: texts, quotes and equivalent loads of the calculators",
          "[unit][calc]") {
  const auto run = [](const char* calculator, const char* text) {
    return calculate(calculator, Json::parse(text));
  };
  const auto error = [&](const char* calculator, const char* text) -> std::string {
    try {
      (void)run(calculator, text);
    } catch (const InputError& e) {
      return e.what();
    }
    return "computed";
  };
  const std::string life =
      R"("geo":{"D":0.007938,"dm":0.03904,"Z":9,"alpha":0,"f_inner":0.515,"f_outer":0.525},)"
      R"("Qi":[900.0,603.4252225,65.12501772,0.0,0.0,0.0,0.0,65.12501772,603.4252225],)"
      R"("Qo":[900.0,603.4252225,65.12501772,0.0,0.0,0.0,0.0,65.12501772,603.4252225],)"
      R"("Estar":114010989000.0,"inner_rotates":true}})";
  // h01: the life model in lower case; 893.89 is the result of "GZ".
  const std::string gz = R"({"kind":"like_lpu_model_inner","inputs":{"model":"gz",)" + life;
  CHECK(run("life", gz.c_str()).at("bearing").get<double>() == Approx(893.89).epsilon(1e-5));
  const std::string roller = R"("Dwe":10.0,"Lwe":9.6,"Dpw":65.0,"Z":14,"alpha_deg":0,"bm":1.1}})";
  CHECK(error("iso281",
              (R"({"kind":"radial_roller_rating","inputs":{"bearing":"radial roller",)" + roller)
                  .c_str())
            .find("did you mean radial_roller?") != std::string::npos);
  CHECK(run("iso281",
            (R"({"kind":"radial_roller_rating","inputs":{"bearing":"RADIAL_roller",)" + roller)
                .c_str())
            .at("C")
            .get<double>() == Approx(48417.0).epsilon(2e-5));
  const std::string thrust = R"("Dw":12.0,"Dpw":60.0,"Z":14,"alpha_deg":90,"bm":1.3}})";
  CHECK(
      error("iso281",
            (R"({"kind":"thrust_ball_rating","inputs":{"bearing":"thrust-ball",)" + thrust).c_str())
          .find("did you mean thrust_ball?") != std::string::npos);
  CHECK(run("iso281",
            (R"({"kind":"thrust_ball_rating","inputs":{"bearing":"thrust_ball",)" + thrust).c_str())
            .at("C")
            .get<double>() == Approx(59674.0).epsilon(2e-5));

  // h02: crossed cylinders, planes of either body; p0 = 3F/(2 π a b).
  const Json crossed = run("hertz", R"({"body1":{"Rx":0.015,"Ry":"inf","E":2.1e11,"nu":0.3},
    "body2":{"Rx":"inf","Ry":0.01,"E":2.1e11,"nu":0.3},"load":100,"stress_poisson":0.3})");
  CHECK(crossed.at("a").get<double>() == Approx(0.2280e-3).epsilon(2e-4));
  CHECK(crossed.at("b").get<double>() == Approx(0.1741e-3).epsilon(4e-4));
  CHECK(crossed.at("p_max").get<double>() == Approx(1.203029783e9).epsilon(1e-9));

  // h03: a number in quotes is no number.
  const char* quoted = R"({"body1":{"Rx":0.003175,"Ry":0.003175,"E":2.06e11,"nu":0.3},
    "body2":{"Rx":"0.02","Ry":"inf","E":2.06e11,"nu":0.3},"load":10,"stress_poisson":0.3})";
  CHECK(error("hertz", quoted).find("body2.Rx = \"0.02\": not a number; give a number") == 0);
  CHECK(error("line-contact", R"({"load":15,"length":0.004,"body1":{"R":0.0015,"E":2.06e11,
    "nu":0.3},"body2":{"R":"0.02","E":2.06e11,"nu":0.3},"stress_poisson":0.3})")
            .find("body2.R = \"0.02\": not a number") == 0);

  // h04: equal spheres by load, approach, pressure and half axis: R* = 25 mm, E* = 10.989 GPa,
  // F = 4/3 E* √R* δ^1.5 = 586,081 N, a = √(R* δ) = 10 mm, p0 = 2798.3 MPa (code_aster SSNV104).
  for (const char* given : {R"("load":586080.5860805861)", R"("approach":0.004)",
                            R"("pressure":2798328669.7476115)", R"("half_axis":0.01)"}) {
    CAPTURE(given);
    const Json out =
        run("hertz",
            (R"({"body1":{"Rx":0.05,"Ry":0.05,"E":2e10,"nu":0.3},"body2":{"Rx":0.05,"Ry":0.05,)"
             R"("E":2e10,"nu":0.3},"stress_poisson":0.3,)" +
             std::string(given) + "}")
                .c_str());
    CHECK(out.at("load").get<double>() == Approx(586080.586).epsilon(1e-9));
    CHECK(out.at("delta").get<double>() == Approx(0.004).epsilon(1e-9));
    CHECK(out.at("a").get<double>() == Approx(0.01).epsilon(1e-9));
    CHECK(out.at("p_max").get<double>() == Approx(2.7983e9).epsilon(2e-5));
  }

  // h09: Fa/Fr = 0.125 below e = 0.68: P = Fr with the factors 1 and 0.
  const Json low = run("iso281", R"({"kind":"angular_contact_equivalent_load",
    "inputs":{"alpha_deg":25,"Fr":4000,"Fa":500,"bearing":"radial_ball"}})");
  CHECK(low.at("P") == 4000.0);
  CHECK(low.at("X_applied") == 1.0);
  CHECK(low.at("Y_applied") == 0.0);
  const Json high =
      run("iso281", R"({"alpha_deg":25,"Fr":4000,"Fa":4000,"bearing":"radial_ball"})");
  CHECK(high.at("P").get<double>() == Approx(high.at("X_applied").get<double>() * 4000.0 +
                                             high.at("Y_applied").get<double>() * 4000.0));
  CHECK(high.at("X_applied") == high.at("X"));
}

TEST_CASE("page of the calculators: the file is the output of the command", "[unit][calc]") {
  const auto page = test::source_dir() / "resources" / "docs" / "calculators.md";
  CHECK(test::bytes_of(page) == calculators_markdown());
}
