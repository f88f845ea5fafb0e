#include "thermal/heat_network.hpp"

#include "base/errors.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <limits>
#include <utility>

namespace adore::thermal {

HeatNetwork::Node HeatNetwork::add(std::string name, double heat, double capacity) {
  nodes_.push_back({std::move(name), heat, capacity, std::nullopt});
  return nodes_.size() - 1;
}

void HeatNetwork::fix_temperature(Node node, double temperature) {
  nodes_[node].given = temperature;
}

void HeatNetwork::link(Node a, Node b, double conductance) {
  demand(a < nodes_.size() && b < nodes_.size() && a != b, "a link does not connect two nodes");
  demand(conductance >= 0.0 && conductance < std::numeric_limits<double>::infinity(),
         "a conductance is negative or not finite");
  if (conductance > 0.0) links_.push_back({a, b, conductance});
}

std::string HeatNetwork::find_unconnected_node() const {
  std::vector<bool> reached(nodes_.size());
  for (Node i = 0; i < nodes_.size(); ++i) reached[i] = is_boundary(i);
  for (bool grows = true; grows;) {
    grows = false;
    for (const Link& link : links_)
      if (reached[link.a] != reached[link.b]) reached[link.a] = reached[link.b] = grows = true;
  }
  const auto lost = std::find(reached.begin(), reached.end(), false);
  return lost == reached.end() ? std::string()
                               : nodes_[static_cast<Node>(lost - reached.begin())].name;
}

HeatNetwork::Solution HeatNetwork::solve() const { return solve(nullptr, 0.0); }

HeatNetwork::Solution HeatNetwork::step(const std::vector<double>& before, double time_step) const {
  demand(before.size() == nodes_.size() && time_step > 0.0,
         "a thermal step needs the temperature of every node and a duration above 0");
  return solve(&before, time_step);
}

HeatNetwork::Solution HeatNetwork::solve(const std::vector<double>* before,
                                         double time_step) const {
  // Temperatures over the coldest boundary: sums of positive terms, so that rounding cannot put a
  // node below it.
  double coldest = std::numeric_limits<double>::infinity();
  for (Node i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].given) coldest = std::min(coldest, *nodes_[i].given);
    if (before != nullptr && nodes_[i].capacity > 0.0) coldest = std::min(coldest, (*before)[i]);
  }
  std::vector<Eigen::Index> row(nodes_.size(), -1);
  Eigen::Index free = 0;
  for (Node i = 0; i < nodes_.size(); ++i)
    if (!is_boundary(i)) row[i] = free++;
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(free, free);
  Eigen::VectorXd H = Eigen::VectorXd::Zero(free);
  for (Node i = 0; i < nodes_.size(); ++i) {
    if (row[i] < 0) continue;
    H(row[i]) = nodes_[i].heat;
    if (before == nullptr) continue;
    const double stored = nodes_[i].capacity / time_step;
    G(row[i], row[i]) += stored;
    H(row[i]) += stored * ((*before)[i] - coldest);
  }
  for (const Link& link : links_)
    for (const auto& [here, there] : {std::pair{link.a, link.b}, std::pair{link.b, link.a}}) {
      if (row[here] < 0) continue;
      G(row[here], row[here]) += link.conductance;
      if (row[there] >= 0)
        G(row[here], row[there]) -= link.conductance;
      else
        H(row[here]) += link.conductance * (*nodes_[there].given - coldest);
    }
  const Eigen::VectorXd T = G.llt().solve(H);
  Solution out;
  for (Node i = 0; i < nodes_.size(); ++i)
    out.temperature.push_back(row[i] < 0 ? *nodes_[i].given : coldest + T(row[i]));
  if (before != nullptr)
    for (Node i = 0; i < nodes_.size(); ++i)
      if (row[i] >= 0)
        out.stored += nodes_[i].capacity / time_step * (out.temperature[i] - (*before)[i]);
  out.taken.assign(nodes_.size(), 0.0);
  for (Node i = 0; i < nodes_.size(); ++i)
    if (row[i] < 0) out.taken[i] = nodes_[i].heat;
  for (const Link& link : links_) {
    const double heat = link.conductance * (out.temperature[link.a] - out.temperature[link.b]);
    out.flows.push_back({link.a, link.b, heat});
    if (row[link.a] < 0) out.taken[link.a] -= heat;
    if (row[link.b] < 0) out.taken[link.b] += heat;
  }
  return out;
}

}  // namespace adore::thermal
