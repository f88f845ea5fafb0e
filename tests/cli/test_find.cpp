#include "cli/driver.hpp"

#include <nlohmann/json.hpp>

using namespace adore::test;

namespace {

nlohmann::json json_of(const Result& result) { return nlohmann::json::parse(result.out); }

}  // namespace

TEST_CASE("adore find: each answer has its words, keys and exit code", "[cli][find]") {
  const Folder folder;
  REQUIRE(run_adore("new ball --out " + (folder / "DATA.txt").string()).code == 0);
  const std::string find = "find " + folder.path().string() +
                           " --set mode=-1 --set rpm2=0 --set rpm1=0 --unknown appLoadX=1000:5000 ";
  const Result one = run_adore(find + "--target largest_contact_load_N=500");
  CHECK(one.code == 0);
  CHECK(one.out.find("appLoadX from 1000 to 5000 N: largest_contact_load_N = 500 N\nappLoadX = ") ==
        0);
  const Result as_json = run_adore(find + "--target largest_contact_load_N=500 --json");
  CHECK(json_of(as_json).at("answer") == "one");
  CHECK(json_of(as_json).at("solution").at("target") == Approx(500.0));

  const Result none = run_adore(find + "--target largest_contact_load_N=1e6 --json");
  CHECK(none.code == 1);
  CHECK(json_of(none).at("answer") == "none");
  CHECK(json_of(none).at("best").at("value") == 5000.0);
  CHECK(json_of(none).at("best").at("at_bound") == true);

  const Result everywhere = run_adore(find + "--target 'largest_contact_load_N>=1' --json");
  CHECK(everywhere.code == 4);
  CHECK(json_of(everywhere).at("answer") == "everywhere");

  const Result wrong = run_adore(find + "--target largest_contact_lode_N=500");
  CHECK(wrong.code == 2);
  CHECK(wrong.out.find("largest_contact_load_N") != std::string::npos);
  CHECK(run_adore("find " + folder.path().string() + " --unknown appLoadX=1:2").code == 2);
  CHECK(run_adore("find " + folder.path().string() + " --question pivot-speed").code == 2);
}

TEST_CASE("adore find: calculator, questions and the list", "[cli][find]") {
  const Folder folder;
  const std::string input = (folder / "contact.json").string();
  std::ofstream(input) << R"({"body1": {"Rx": 0.05, "Ry": 0.05, "E": 2e10, "nu": 0.3},
    "body2": {"Rx": 0.05, "Ry": 0.05, "E": 2e10, "nu": 0.3}, "load": 1, "stress_poisson": 0.3})";
  const Result load = run_adore("find --question contact-load-for-approach=4e-3 " + input +
                                " --between 1e3:1e7 --json");
  CHECK(load.code == 0);
  CHECK(json_of(load).at("solution").at("value") == Approx(586080.586).epsilon(1e-7));
  CHECK(
      run_adore("find --calc hertz " + input + " --unknown load=1:1e7 --target delta=4e-3").code ==
      0);
  CHECK(run_adore("find --calc hertz " + input +
                  " --unknown load=1:1e7 --target delta=4e-3 --set rpm2=1")
            .code == 2);
  const Result list = run_adore("find --list");
  CHECK(list.code == 0);
  for (const char* name : {"quiet-load", "pivot-speed", "all-loaded", "viscosity_ratio",
                           "a ball pivots if this ratio is above 1"})
    CHECK(list.out.find(name) != std::string::npos);
  CHECK(list.out.find("mean_power_loss_W") == std::string::npos);
}
