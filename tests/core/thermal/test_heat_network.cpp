#include "thermal/contact_conductance.hpp"
#include "thermal/heat_network.hpp"
#include "thermal/network.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace adore;
using thermal::HeatNetwork;

namespace {

double between(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// Over ten decades.
double conductance(std::mt19937& random) { return std::pow(10.0, between(random, -5.0, 5.0)); }

/// A random network in which every node has a path to a boundary.
HeatNetwork random_network(std::mt19937& random, double& heat, double& coldest) {
  HeatNetwork net;
  const int nodes = 2 + static_cast<int>(between(random, 0.0, 30.0));
  heat = 0.0;
  for (int i = 0; i < nodes; ++i) {
    const double one = random() % 2 == 0 ? 0.0 : between(random, 0.0, 100.0);
    net.add("n" + std::to_string(i), one);
  }
  for (int i = 1; i < nodes; ++i)
    net.link(static_cast<std::size_t>(i), random() % static_cast<unsigned>(i), conductance(random));
  for (int extra = 0; extra < nodes; ++extra) {
    const std::size_t a = random() % static_cast<unsigned>(nodes),
                      b = random() % static_cast<unsigned>(nodes);
    if (a != b) net.link(a, b, conductance(random));
  }
  coldest = 1e9;
  const int boundaries = 1 + static_cast<int>(random() % 3);
  for (int k = 0; k < boundaries; ++k) {
    const std::size_t node = random() % static_cast<unsigned>(nodes);
    const double T = between(random, 20.0, 400.0);
    if (net.is_boundary(node)) continue;
    net.fix_temperature(node, T);
    coldest = std::min(coldest, T);
  }
  for (std::size_t i = 0; i < net.size(); ++i) heat += net.heat(i);
  return net;
}

}  // namespace

TEST_CASE("HeatNetwork: random networks → maximum principle and closed balance",
          "[physics][thermal]") {
  std::mt19937 random(43);
  for (int trial = 0; trial < 2000; ++trial) {
    INFO("trial " << trial);
    double heat = 0.0, coldest = 0.0;
    const HeatNetwork net = random_network(random, heat, coldest);
    REQUIRE(net.find_unconnected_node().empty());
    const HeatNetwork::Solution at = net.solve();
    double taken = 0.0;
    for (const double one : at.taken) taken += one;
    const double scale = *std::max_element(at.temperature.begin(), at.temperature.end());
    CHECK(taken == Approx(heat).margin(1e-9 * (heat + 1e5 * scale)));
    for (std::size_t i = 0; i < net.size(); ++i) {
      CHECK(at.temperature[i] >= coldest - 1e-9 * scale);
      if (net.is_boundary(i)) continue;
      double low = 1e99, high = -1e99;
      for (const HeatNetwork::Flow& flow : at.flows)
        if (flow.from == i || flow.to == i) {
          const double T = at.temperature[flow.from == i ? flow.to : flow.from];
          low = std::min(low, T);
          high = std::max(high, T);
        }
      CHECK(at.temperature[i] >= low - 1e-9 * scale);
      if (net.heat(i) == 0.0) CHECK(at.temperature[i] <= high + 1e-9 * scale);
    }
  }
}

TEST_CASE("HeatNetwork: chain of two links → temperatures by hand", "[unit][thermal]") {
  HeatNetwork net;
  const auto hot = net.add("hot", 10.0), middle = net.add("middle"), cold = net.add("cold");
  net.link(hot, middle, 2.0);
  net.link(middle, cold, 5.0);
  CHECK(net.find_unconnected_node() == "hot");
  net.fix_temperature(cold, 300.0);
  const HeatNetwork::Solution at = net.solve();
  CHECK(at.temperature[middle] == Approx(302.0).epsilon(1e-14));
  CHECK(at.temperature[hot] == Approx(307.0).epsilon(1e-14));
  CHECK(at.taken[cold] == Approx(10.0).epsilon(1e-14));
}

TEST_CASE("HeatNetwork: implicit steps of one capacity → exponential, first order in the step",
          "[physics][thermal]") {
  // C dT/dt = H - G (T - T0): T = T0 + H/G (1 - exp(-t G/C)).
  const auto error = [](int steps) {
    HeatNetwork net;
    const auto body = net.add("body", 20.0, 50.0), room = net.add("room");
    net.link(body, room, 2.0);
    net.fix_temperature(room, 300.0);
    std::vector<double> T{300.0, 300.0};
    constexpr double kEnd = 25.0;
    for (int i = 0; i < steps; ++i) T = net.step(T, kEnd / steps).temperature;
    return T[body] - (300.0 + 10.0 * (1.0 - std::exp(-kEnd * 2.0 / 50.0)));
  };
  CHECK(std::abs(error(200)) < 0.01);
  CHECK(error(100) / error(200) == Approx(2.0).epsilon(0.02));
}

TEST_CASE("patch_conductance(): circle at rest → 4 k a; fast patch → grows with the root of speed",
          "[physics][thermal]") {
  bearing::Material steel;
  steel.conductivity = 46.0;
  steel.density = 7800.0;
  steel.specific_heat = 460.0;
  constexpr double a = 2e-4;
  CHECK(thermal::patch_conductance(steel, a, a, 0.0) == Approx(4.0 * 46.0 * a).epsilon(1e-12));
  // Static ellipses conduct more than the circle of the same area.
  CHECK(thermal::patch_conductance(steel, 4.0 * a, 0.25 * a, 0.0) >
        thermal::patch_conductance(steel, a, a, 0.0));
  const double fast = thermal::patch_conductance(steel, a, a, 1e4);
  CHECK(thermal::patch_conductance(steel, a, a, 4e4) / fast == Approx(2.0).epsilon(1e-3));
  // Mean of Blok's band solution over strips of the ellipse, by quadrature.
  constexpr double U = 1e4;
  const double root = std::sqrt(std::numbers::pi * 46.0 * 7800.0 * 460.0 * U);
  double sum = 0.0, area = 0.0;
  constexpr int kStrips = 20000;
  for (int i = 0; i < kStrips; ++i) {
    const double y = a * (2.0 * (i + 0.5) / kStrips - 1.0), chord = 2.0 * std::sqrt(a * a - y * y),
                 width = 2.0 * a / kStrips;
    sum += 4.0 / 3.0 * std::sqrt(chord) / root * chord * width;
    area += chord * width;
  }
  CHECK(fast == Approx(area / (sum / area)).epsilon(2e-3));
}

TEST_CASE(
    "solve_bearing_network(): strong convection → coolant leaves as warm as the parts, and "
    "weak convection → mean of inlet and exit",
    "[physics][thermal]") {
  for (const double hA : {1e-4, 1.0, 1e4}) {
    thermal::BearingNetwork n;
    const thermal::NetworkRing ring{0.02, 0.03, 0.02, 46.0};
    n.rings = {ring, ring, ring, ring};
    n.joint = {10.0, 10.0};
    n.sources.race = {30.0, 20.0};
    n.race = {{{5.0, 5.0}, {5.0, 5.0}}};
    n.element_film = hA;
    n.capacity_flow = 2.0;
    n.coolant_in = 320.0;
    n.ambient = 300.0;
    n.base = thermal::BaseNode::CoolantIn;
    const thermal::BearingNetworkResult out = thermal::solve_bearing_network(n);
    const thermal::NetworkTemperatures& T = out.temperature;
    CHECK(out.flows.coolant == Approx(50.0).epsilon(1e-9));
    CHECK(T.coolant_out == Approx(345.0).epsilon(1e-9));
    const double N = hA / 2.0;
    // dT/dx = N (T* - T) from the inlet.
    CHECK(T.element == Approx(320.0 + 25.0 / -std::expm1(-N)).epsilon(1e-9));
    if (N < 1e-3) CHECK(T.coolant_mean == Approx(332.5).margin(0.01));
    CHECK(T.coolant_mean < T.coolant_out);
    CHECK(T.coolant_out <= T.element * (1.0 + 1e-12));
  }
}
