#include "statics/friction_balance.hpp"
#include "statics/roller_statics.hpp"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

/// Equilibria of friction that are not found are reported (statics/friction_balance.hpp).
using namespace adore;

namespace {

std::vector<std::string> codes_of(const statics::FrictionBalance& balance) {
  std::vector<std::string> out;
  for (const Finding& one : balance.findings()) out.push_back(one.code);
  return out;
}

}  // namespace

TEST_CASE("friction balance: each equilibrium that was not found → a finding with its cause",
          "[statics][findings]") {
  statics::FrictionBalance balance;
  CHECK(codes_of(balance).empty());

  balance.without_cage = "traction forces and loads did not converge in 30 passes";
  balance.without_turning = "the bearing has no equilibrium with the traction forces";
  balance.turning = 2.5;
  balance.turning_ball = 6;
  balance.plain_stiffness = true;
  balance.left = {1, 2};
  CHECK(codes_of(balance) ==
        std::vector<std::string>{"statics.friction_balance", "statics.cage_orbit",
                                 "statics.plain_stiffness", "statics.spin_lag"});
  const std::vector<Finding> found = balance.findings();
  CHECK_THAT(found[0].message, Catch::Contains("balls 2-3"));
  CHECK_THAT(found[1].message, Catch::Contains(balance.without_cage));
  CHECK_THAT(found[3].message, Catch::Contains(balance.without_turning));
  CHECK_THAT(found[3].message, Catch::Contains("lower bound"));
  CHECK(found[3].body == "ball 7");
  REQUIRE(found[3].measured);
  CHECK(*found[3].measured == 2.5);
  CHECK(found[3].limit == 1.0);

  // A small moment is no lower bound of the heat.
  balance.turning = 0.2;
  CHECK_THAT(balance.findings()[3].message, !Catch::Contains("lower bound"));

  // The spin rule for all balls: nothing else applies.
  balance.failure = "the bearing has no equilibrium with the traction forces";
  CHECK(codes_of(balance) == std::vector<std::string>{"statics.friction_balance"});
}

TEST_CASE("friction balance: rollers without a balance → a note", "[statics][findings]") {
  statics::RollerFrictionBalance rollers;
  CHECK(rollers.findings().empty());
  rollers.left = {0};
  REQUIRE(rollers.findings().size() == 1);
  CHECK(rollers.findings()[0].code == "statics.friction_balance");
  CHECK(rollers.findings()[0].body == "roller 1");
  CHECK_THAT(rollers.findings()[0].message, Catch::Contains("roller 1"));
  rollers.failure = "the bearing has no equilibrium with the friction forces";
  CHECK_THAT(rollers.findings().at(0).message, Catch::Contains(rollers.failure));
}
