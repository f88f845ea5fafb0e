#include "signal/window.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace adore::signal {
namespace {

std::array<double, 5> cosine_terms(Window window) {
  switch (window) {
    case Window::Hann:
      return {1.0, -1.0, 0.0, 0.0, 0.0};
    case Window::FlatTop:
      return {1.0, -1.93, 1.29, -0.388, 0.0322};
    case Window::None:
      break;
  }
  return {1.0, 0.0, 0.0, 0.0, 0.0};
}

}  // namespace

std::vector<double> window_weights(Window window, std::size_t n) {
  const std::array<double, 5> terms = cosine_terms(window);
  std::vector<double> out(n, 1.0);
  if (window == Window::None) return out;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    out[i] = 0.0;
    for (std::size_t k = 0; k < terms.size(); ++k)
      out[i] += terms.at(k) * std::cos(static_cast<double>(k) * a);
  }
  return out;
}

std::string window_name(Window window) {
  switch (window) {
    case Window::Hann:
      return "Hann window";
    case Window::FlatTop:
      return "flat top window";
    case Window::None:
      break;
  }
  return "no window";
}

double noise_bandwidth(Window window, std::size_t n) {
  double sum = 0.0, squares = 0.0;
  for (const double w : window_weights(window, n)) sum += w, squares += w * w;
  return static_cast<double>(n) * squares / (sum * sum);
}

}  // namespace adore::signal
