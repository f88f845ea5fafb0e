#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// Steady heat flow between nodes, SI, kelvin:
///   Σ_j G_ij (T_i - T_j) = H_i for a free node i, T_i given for a boundary node.
/// All conductances are above 0, so the matrix of the free nodes is symmetric, positive definite
/// and an M-matrix (its inverse has no negative element). For H >= 0 two facts follow, for all
/// values: no node is colder than the coldest boundary, and the boundaries take Σ H. A free
/// node with H = 0 is between its coldest and its hottest neighbor; one with H > 0 is hotter than
/// its coldest neighbor.
/// With heat capacities one implicit step is the same system with C_i/Δt as a link of each node to
/// its previous temperature, so the same facts are valid for steps of any length.
namespace adore::thermal {

class HeatNetwork {
 public:
  using Node = std::size_t;

  /// @param heat made in the node [W]; capacity [J/K]
  Node add(std::string name, double heat = 0.0, double capacity = 0.0);
  /// Makes a node a boundary of this temperature [K].
  void fix_temperature(Node node, double temperature);
  void add_heat(Node node, double heat) { nodes_[node].heat += heat; }
  /// @param conductance [W/K]; 0: no link
  void link(Node a, Node b, double conductance);

  struct Flow {
    Node from = 0, to = 0;
    double heat = 0.0;  ///< [W], either sign
  };
  struct Solution {
    std::vector<double> temperature;  ///< by node [K]
    std::vector<Flow> flows;          ///< by link, in the order of link()
    std::vector<double> taken;        ///< by node: heat that a boundary takes [W]; else 0
    double stored = 0.0;              ///< Σ C ΔT/Δt of the free nodes [W]
  };
  /// Name of a node that no path joins to a boundary; empty: none, the system has one solution.
  [[nodiscard]] std::string find_unconnected_node() const;
  /// @pre unconnected() is empty
  [[nodiscard]] Solution solve() const;
  /// One implicit Euler step. Nodes without capacity follow at once.
  /// @param before temperatures by node [K]
  [[nodiscard]] Solution step(const std::vector<double>& before, double time_step) const;

  [[nodiscard]] std::size_t size() const noexcept { return nodes_.size(); }
  [[nodiscard]] const std::string& name(Node node) const { return nodes_[node].name; }
  [[nodiscard]] double heat(Node node) const { return nodes_[node].heat; }
  [[nodiscard]] bool is_boundary(Node node) const { return nodes_[node].given.has_value(); }

 private:
  struct NodeData {
    std::string name;
    double heat = 0.0, capacity = 0.0;
    std::optional<double> given;
  };
  struct Link {
    Node a = 0, b = 0;
    double conductance = 0.0;
  };
  [[nodiscard]] Solution solve(const std::vector<double>* before, double time_step) const;

  std::vector<NodeData> nodes_;
  std::vector<Link> links_;
};

}  // namespace adore::thermal
