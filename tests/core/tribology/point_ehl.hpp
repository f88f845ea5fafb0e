#pragma once

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>
#include <vector>

namespace testing {

/// A numerical solution of an isothermal, smooth, flooded point contact in oil, for tests: what
/// line_ehl.hpp does for lines, on cells of constant pressure over half the plane (y -> -y):
///   div (H3/(eta lambda) grad P) = dH/dX,  lambda = 12 mu0 u Rx2/(b3 p0),
///   H = H0 + X2/2 + Y2 Rx/(2 Ry) + 2 p0 Rx/(pi E' b) int P/r dA,  int P dA = 2/3 pi a/b,
/// lengths over b, the half width of Hertz along rolling. Newton's method with all deflections;
/// the pressure coefficient grows to its value in steps, or the first guess is too far away.
struct PointEhl {
  double rolling = 0.0;   ///< -int p x dA/(2 Rx) over E' Rx2, which is int h/2 dp/dx dA
  double shear = 0.0;     ///< the latter, by faces
  double central = 0.0;   ///< film over Rx
  double half_width = 0;  ///< b over Rx
  bool converged = false;
};

/// Complete elliptic integrals K and E of the modulus e, by the mean of Gauss.
inline std::pair<double, double> elliptic(double e) {
  double a = 1.0, g = std::sqrt(1.0 - e * e), c = e, sum = 0.5 * c * c, power = 0.5;
  for (int i = 0; i < 40 && std::abs(c) > 1e-16; ++i) {
    c = 0.5 * (a - g);
    const double next = 0.5 * (a + g);
    g = std::sqrt(a * g);
    a = next;
    power *= 2.0;
    sum += power * c * c;
  }
  const double K = std::numbers::pi / (2.0 * a);
  return {K, K * (1.0 - sum)};
}

/// Of Hertz with k = a/b > 1: p0/E' = width b/Rx, and Ry/Rx.
struct HertzOfShape {
  double width, radii;
};
inline HertzOfShape hertz_of(double k) {
  const double e2 = 1.0 - 1.0 / (k * k);
  const auto [K, E] = elliptic(std::sqrt(e2));
  return {0.25 * e2 * k * k / (k * k * E - K), (k * k * E - K) / (K - E)};
}
/// W = Q/(E' Rx2) of p0/E'.
inline double load_of_pressure(double k, double p0) {
  const double b = p0 / hertz_of(k).width;
  return 2.0 / 3.0 * std::numbers::pi * k * b * b * p0;
}

/// @param inlet, side where the grid ends, over b and over a
inline PointEhl point_ehl(double U, double G, double W, double k, double E, double inlet = 16.0,
                          double side = 4.0) {
  using Eigen::MatrixXd, Eigen::VectorXd;
  using Parts = std::initializer_list<std::pair<int, double>>;
  constexpr double kPi = std::numbers::pi;
  const HertzOfShape hertz = hertz_of(k);
  const double b = std::cbrt(W / (2.0 / 3.0 * kPi * k * hertz.width)), p0 = hertz.width * b * E;
  const double lambda = 12.0 * U * E / (b * b * b * p0);
  const double ln_mu = std::log(0.05) + 9.67, p_r = 1.962e8;  // Roelands
  double z = 0.0;

  // Faces: dense under the contact, then ever wider.
  std::vector<double> xf, yf;
  constexpr int kInlet = 18, kUnder = 23, kAcross = 9, kBeside = 5;
  for (int i = 0; i < kInlet; ++i) {
    const double t = 1.0 - static_cast<double>(i) / kInlet;
    xf.push_back(-1.15 - (inlet - 1.15) * t * t);
  }
  for (int i = 0; i <= kUnder; ++i) xf.push_back(-1.15 + 2.85 * i / kUnder);
  for (int i = 0; i < kAcross; ++i) yf.push_back(1.02 * k * i / kAcross);
  for (int i = 0; i <= kBeside; ++i) {
    const double t = static_cast<double>(i) / kBeside;
    yf.push_back(k * (1.02 + (side - 1.02) * 0.5 * (t + t * t)));
  }
  const int nx = static_cast<int>(xf.size()) - 1, ny = static_cast<int>(yf.size()) - 1, N = nx * ny;
  std::vector<double> x, y, dx, dy;
  for (int i = 0; i < nx; ++i)
    x.push_back(0.5 * (xf[i] + xf[i + 1])), dx.push_back(xf[i + 1] - xf[i]);
  for (int j = 0; j < ny; ++j)
    y.push_back(0.5 * (yf[j] + yf[j + 1])), dy.push_back(yf[j + 1] - yf[j]);
  const auto at = [&](int i, int j) { return i + nx * j; };

  // Deflection of cell (i, j) by the pressure of cell (I, J) and of its image: int dA/r.
  const auto corner = [](double u, double v) {
    return (u == 0.0 ? 0.0 : u * std::asinh(v / std::abs(u))) +
           (v == 0.0 ? 0.0 : v * std::asinh(u / std::abs(v)));
  };
  MatrixXd K(N, N);
  for (int J = 0; J < ny; ++J)
    for (int I = 0; I < nx; ++I)
      for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
          const double x0 = xf[I] - x[i], x1 = xf[I + 1] - x[i];
          double sum = 0.0;
          for (const bool image : {false, true}) {
            const double y0 = (image ? -yf[J + 1] : yf[J]) - y[j],
                         y1 = (image ? -yf[J] : yf[J + 1]) - y[j];
            sum += corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0);
          }
          K(at(i, j), at(I, J)) = 2.0 * p0 / (kPi * E * b) * sum;
        }

  VectorXd P(N), gap(N), weight(N), H(N);
  int middle = 0;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      P[at(i, j)] = std::sqrt(std::max(1.0 - x[i] * x[i] - y[j] * y[j] / (k * k), 0.0));
      gap[at(i, j)] = 0.5 * (x[i] * x[i] + y[j] * y[j] / hertz.radii);
      weight[at(i, j)] = 2.0 * dx[i] * dy[j];
      if (j == 0 && std::abs(x[i]) < std::abs(x[middle])) middle = i;
    }
  P *= 2.0 / 3.0 * kPi * k / weight.dot(P);
  double H0 = 2.69 * std::pow(U, 0.67) * std::pow(G, 0.53) * std::pow(W, -0.067) *
                  (1.0 - 0.61 * std::exp(-0.73 * k)) / (b * b) -
              K.row(middle).dot(P) - gap[middle];

  // One step of Newton's method; the largest change of P that it wants.
  const auto newton_step = [&](double most) {
    H = K * P + gap;
    H.array() += H0;
    std::vector<Eigen::Triplet<double>> by_P, by_H;
    VectorXd R = VectorXd::Zero(N + 1), by_H0 = VectorXd::Zero(N);
    const auto add = [&](int cell, double sign, double flow, Parts dP, Parts dH) {
      R[cell] += sign * flow;
      for (const auto& [n, d] : dP) by_P.emplace_back(cell, n, sign * d);
      for (const auto& [n, d] : dH) {
        if (n < 0) continue;
        by_H.emplace_back(cell, n, sign * d);
        by_H0[cell] += sign * d;
      }
    };
    struct Ease {  // H3/(eta lambda) and its slopes
      double is, of_H, of_P;
    };
    const auto ease = [&](double h, double P_here) {
      const double p = std::max(P_here, 0.0) * p0, thin = std::pow(1.0 + p / p_r, z);
      const double is = h * h * h * std::exp(-ln_mu * (thin - 1.0)) / lambda;
      return Ease{is, 3.0 * is / h, -is * ln_mu * z / p_r * thin / (1.0 + p / p_r) * p0};
    };
    const auto between = [&](int l, int r, double d, double area, double carried, Parts dH) {
      const double grad = (P[r] - P[l]) / d;
      const Ease e = ease(0.5 * (H[l] + H[r]), 0.5 * (P[l] + P[r]));
      const double flow = e.is * grad - carried, half = 0.5 * e.of_H * grad;
      for (const auto& [cell, sign] : {std::pair{l, area}, std::pair{r, -area}}) {
        add(cell, sign, flow,
            {{l, -e.is / d + 0.5 * e.of_P * grad}, {r, e.is / d + 0.5 * e.of_P * grad}},
            {{l, half}, {r, half}});
        add(cell, sign, 0.0, {}, dH);
      }
    };
    const auto at_edge = [&](int n, double d, double area, double carried, bool right) {
      const double grad = (right ? -P[n] : P[n]) / d;
      const Ease e = ease(H[n], 0.0);
      add(n, right ? area : -area, e.is * grad - carried * H[n],
          {{n, (right ? -1.0 : 1.0) * e.is / d}}, {{n, e.of_H * grad - carried}});
    };
    for (int j = 0; j < ny; ++j) {
      at_edge(at(0, j), 0.5 * dx[0], dy[j], 1.0, false);
      at_edge(at(nx - 1, j), 0.5 * dx[nx - 1], dy[j], 1.0, true);
      for (int i = 1; i < nx; ++i) {  // the film that is carried comes from upstream
        const int l = at(i - 1, j), behind = i > 1 ? at(i - 2, j) : -1;
        const double ratio = i > 1 ? 0.5 * dx[i - 1] / (x[i - 1] - x[i - 2]) : 0.0;
        const double carried = H[l] + (i > 1 ? ratio * (H[l] - H[behind]) : 0.0);
        between(l, at(i, j), x[i] - x[i - 1], dy[j], carried, {{l, -1.0 - ratio}, {behind, ratio}});
      }
    }
    for (int i = 0; i < nx; ++i) {
      at_edge(at(i, ny - 1), 0.5 * dy[ny - 1], dx[i], 0.0, true);
      for (int j = 1; j < ny; ++j) between(at(i, j - 1), at(i, j), y[j] - y[j - 1], dx[i], 0.0, {});
    }
    Eigen::SparseMatrix<double, Eigen::RowMajor> of_P(N, N), of_H(N, N);
    of_P.setFromTriplets(by_P.begin(), by_P.end());
    of_H.setFromTriplets(by_H.begin(), by_H.end());
    MatrixXd J = MatrixXd::Zero(N + 1, N + 1);
    J.topLeftCorner(N, N) = of_H * K;
    J.topLeftCorner(N, N) += MatrixXd(of_P);
    J.col(N).head(N) = by_H0;
    for (int n = 0; n < N; ++n)  // P = 0 where the film would pull
      if (x[n % nx] > -0.2 && P[n] + R[n] / (std::abs(J(n, n)) + 1e-300) <= 0.0) {
        R[n] = P[n];
        J.row(n).setZero();
        J(n, n) = 1.0;
      }
    R[N] = weight.dot(P) - 2.0 / 3.0 * kPi * k;
    J.row(N).head(N) = weight.transpose();
    for (int n = 0; n <= N; ++n) {
      const double size = J.row(n).cwiseAbs().maxCoeff();
      J.row(n) /= size;
      R[n] /= size;
    }
    VectorXd step = J.partialPivLu().solve(-R);
    const double wanted = step.head(N).cwiseAbs().maxCoeff();
    step.head(N) = step.head(N).cwiseMax(-most).cwiseMin(most);  // one cell must not hold all
    const VectorXd change = K * step.head(N);
    double size = 1.0;
    while (size > 1e-3 && ((H + size * change).array() + size * step[N] <= 0.3 * H.array()).any())
      size *= 0.7;
    P = (P + size * step.head(N)).cwiseMax(0.0);
    H0 += size * step[N];
    return wanted;
  };

  PointEhl out;
  VectorXd kept = P;
  double H0_kept = H0, reached = 0.0, now = std::min(G, 1000.0), factor = 1.5;
  while (!out.converged && factor > 1.01) {
    z = now / E * p_r / ln_mu;
    double wanted = 1.0;
    const int most = reached > 0.0 ? 14 : 60;
    for (int n = 0; n < most && wanted > 1e-6; ++n)
      wanted = newton_step(0.3 * std::pow(0.955, std::max(n - 30, 0)));
    if (wanted <= 1e-6) {
      kept = P, H0_kept = H0, reached = now;
      out.converged = now >= G;
    } else {
      if (reached == 0.0) break;
      factor = std::sqrt(factor);
      P = kept, H0 = H0_kept;
    }
    now = std::min(G, reached * factor);
  }
  H = K * P + gap;
  H.array() += H0;
  const double force = p0 / E * b * b * b;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      out.rolling -= 0.5 * force * weight[at(i, j)] * P[at(i, j)] * x[i];
      if (i > 0)
        out.shear +=
            0.5 * force * dy[j] * (H[at(i - 1, j)] + H[at(i, j)]) * (P[at(i, j)] - P[at(i - 1, j)]);
    }
  out.central = H[middle] * b * b;
  out.half_width = b;
  return out;
}

}  // namespace testing
