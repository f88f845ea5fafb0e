#include "tribology/film_thickness.hpp"

#include <algorithm>
#include <cmath>

namespace adore::tribology {
namespace {

struct Groups {
  double U, G, W;
};

Groups groups(const FilmInlet& inlet, double radius, double load_over_modulus) {
  return {inlet.viscosity * inlet.speed / (inlet.modulus * radius), inlet.alpha * inlet.modulus,
          std::max(load_over_modulus, kLeastLoadGroup)};
}

double thickness(const FilmRegression& f, const Groups& g, double radius, double k) {
  return f.coefficient * radius * std::pow(g.U, f.speed) * std::pow(g.G, f.material) *
         std::pow(g.W, -f.load) * (1.0 - f.shape * std::exp(-f.decay * k));
}

}  // namespace

FilmThickness point_film(const FilmInlet& inlet, double radius, double load, double k) {
  const Groups g = groups(inlet, radius, load / (inlet.modulus * radius * radius));
  return {thickness(kPointCentral, g, radius, k), thickness(kPointMinimum, g, radius, k)};
}

FilmThickness chittenden_point_film(const FilmInlet& inlet, double along, double across,
                                    double load) {
  const auto [U, G, W] = groups(inlet, along, load / (inlet.modulus * along * along));
  const double shape = std::pow(across / along, 2.0 / 3.0);
  const double common = along * std::pow(U, 0.68) * std::pow(G, 0.49) * std::pow(W, -0.073);
  return {4.31 * common * -std::expm1(-1.23 * shape), 3.68 * common * -std::expm1(-0.67 * shape)};
}

FilmThickness line_film(const FilmInlet& inlet, double radius, double load) {
  const Groups g = groups(inlet, radius, load / (inlet.modulus * radius));
  return {thickness(kLineCentral, g, radius, 0.0), thickness(kLineMinimum, g, radius, 0.0)};
}

double dowson_higginson_line_film(const FilmInlet& inlet, double radius, double load) {
  const auto [U, G, W] = groups(inlet, radius, load / (inlet.modulus * radius));
  return 1.6 * radius * std::pow(G, 0.6) * std::pow(U, 0.7) * std::pow(W, -0.13);
}

FilmThickness pan_hamrock_line_film(const FilmInlet& inlet, double radius, double load) {
  const auto [U, G, W] = groups(inlet, radius, load / (inlet.modulus * radius));
  return {2.922 * radius * std::pow(W, -0.166) * std::pow(U, 0.692) * std::pow(G, 0.470),
          1.714 * radius * std::pow(W, -0.128) * std::pow(U, 0.694) * std::pow(G, 0.568)};
}

}  // namespace adore::tribology
