#include "tribology/film_thickness.hpp"

#include <algorithm>
#include <cmath>

namespace adore::tribology {
namespace {

struct Groups {
  double U, G, W;
};

Groups groups(const FilmInlet& inlet, double radius, double load_over_modulus) {
  constexpr double kLeastLoad = 1e-9;
  return {inlet.viscosity * inlet.speed / (inlet.modulus * radius), inlet.alpha * inlet.modulus,
          std::max(load_over_modulus, kLeastLoad)};
}

}  // namespace

FilmThickness point_film(const FilmInlet& inlet, double radius, double load, double k) {
  const auto [U, G, W] = groups(inlet, radius, load / (inlet.modulus * radius * radius));
  return {2.69 * radius * std::pow(U, 0.67) * std::pow(G, 0.53) * std::pow(W, -0.067) *
              (1.0 - 0.61 * std::exp(-0.73 * k)),
          3.63 * radius * std::pow(U, 0.68) * std::pow(G, 0.49) * std::pow(W, -0.073) *
              -std::expm1(-0.68 * k)};
}

FilmThickness any_point_film(const FilmInlet& inlet, double along, double across, double load) {
  const auto [U, G, W] = groups(inlet, along, load / (inlet.modulus * along * along));
  const double shape = std::pow(across / along, 2.0 / 3.0);
  const double common = along * std::pow(U, 0.68) * std::pow(G, 0.49) * std::pow(W, -0.073);
  return {4.31 * common * -std::expm1(-1.23 * shape), 3.68 * common * -std::expm1(-0.67 * shape)};
}

FilmThickness line_film(const FilmInlet& inlet, double radius, double load) {
  const auto [U, G, W] = groups(inlet, radius, load / (inlet.modulus * radius));
  return {3.06 * radius * std::pow(G, 0.56) * std::pow(U, 0.69) * std::pow(W, -0.10),
          2.65 * radius * std::pow(G, 0.54) * std::pow(U, 0.7) * std::pow(W, -0.13)};
}

double line_film_1966(const FilmInlet& inlet, double radius, double load) {
  const auto [U, G, W] = groups(inlet, radius, load / (inlet.modulus * radius));
  return 1.6 * radius * std::pow(G, 0.6) * std::pow(U, 0.7) * std::pow(W, -0.13);
}

FilmThickness line_film_1989(const FilmInlet& inlet, double radius, double load) {
  const auto [U, G, W] = groups(inlet, radius, load / (inlet.modulus * radius));
  return {2.922 * radius * std::pow(W, -0.166) * std::pow(U, 0.692) * std::pow(G, 0.470),
          1.714 * radius * std::pow(W, -0.128) * std::pow(U, 0.694) * std::pow(G, 0.568)};
}

}  // namespace adore::tribology
