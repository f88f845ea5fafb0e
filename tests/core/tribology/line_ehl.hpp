#pragma once

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace testing {

/// A numerical solution of an isothermal, smooth, flooded line contact in oil, for tests: Reynolds'
/// equation, elastic half spaces and the load together by Newton's method. In X = x/b, P = p/p0,
/// H = h R/b2:
///   d/dX (H3/(eta lambda) dP/dX) = dH/dX,  lambda = 12 mu0 u R2/(b3 p0),
///   H = H0 + X2/2 - 1/pi int P ln|X - X'| dX',  int P dX = pi/2,
/// P = 0 where the film would pull, film carried from upstream to second order. Viscosity by
/// Roelands with the slope alpha at p = 0. All for R = 1 m; groups U, G, W as in
/// film_thickness.hpp.
struct LineEhl {
  double rolling = 0.0;               ///< int h/2 dp [N/m]
  double moment = 0.0;                ///< -int p x dx/(2 R), the same by another way [N/m]
  double central = 0.0, least = 0.0;  ///< films [m]
  double pressure = 0.0;              ///< p0 [Pa]
  int steps = 0;
  double last = 0.0;  ///< largest change of P in the last step
};

inline LineEhl line_ehl(double U, double G, double W, double E = 2.27e11, int nodes = 300,
                        double from = -8.0) {
  using Eigen::ArrayXd, Eigen::MatrixXd, Eigen::VectorXd;
  const double b = std::sqrt(8.0 * W / std::numbers::pi), p0 = 0.25 * E * b;
  const double lambda = 12.0 * U * E / (b * b * b * p0);
  const double ln_mu = std::log(0.05) + 9.67, p_r = 1.962e8, z = G / E * p_r / ln_mu;
  const int N = nodes, outside = N / 4;
  VectorXd X(N);
  for (int i = 0; i < outside; ++i) X[i] = from + (-2.2 - from) * i / outside;
  for (int i = outside; i < N; ++i) X[i] = -2.2 + 3.8 * (i - outside) / (N - 1 - outside);
  const auto I0 = [](double t) { return t == 0.0 ? 0.0 : t * std::log(std::abs(t)) - t; };
  const auto I1 = [](double t) {
    return t == 0.0 ? 0.0 : 0.5 * t * t * std::log(std::abs(t)) - 0.25 * t * t;
  };
  MatrixXd K = MatrixXd::Zero(N, N);
  VectorXd weight = VectorXd::Zero(N);
  for (int e = 0; e + 1 < N; ++e) {
    const double L = X[e + 1] - X[e];
    weight[e] += 0.5 * L;
    weight[e + 1] += 0.5 * L;
    for (int i = 0; i < N; ++i) {
      const double ta = X[e] - X[i], tb = X[e + 1] - X[i];
      const double A0 = I0(tb) - I0(ta), A1 = I1(tb) - I1(ta), right = (A1 - ta * A0) / L;
      K(i, e + 1) -= right / std::numbers::pi;
      K(i, e) -= (A0 - right) / std::numbers::pi;
    }
  }
  VectorXd P(N);
  for (int i = 0; i < N; ++i) P[i] = std::sqrt(std::max(1.0 - X[i] * X[i], 0.0));
  int middle = 0;
  X.cwiseAbs().minCoeff(&middle);
  double H0 = 3.06 * std::pow(U, 0.69) * std::pow(G, 0.56) * std::pow(W, -0.1) / (b * b) -
              K.row(middle).dot(P);
  LineEhl out;
  out.pressure = p0;
  VectorXd H(N);
  ArrayXd Hm(N - 1), q(N - 1);
  const VectorXd dX = X.tail(N - 1) - X.head(N - 1);
  for (out.steps = 0; out.steps < 300; ++out.steps) {
    H = K * P + 0.5 * X.cwiseAbs2();
    H.array() += H0;
    MatrixXd D(N - 1, N + 1);
    VectorXd R(N - 1);
    for (int k = 0; k + 1 < N; ++k) {
      Hm[k] = 0.5 * (H[k] + H[k + 1]);
      const double p = std::max(0.5 * (P[k] + P[k + 1]), 0.0) * p0;
      const double thin = std::pow(1.0 + p / p_r, z);
      const double e = Hm[k] * Hm[k] * Hm[k] * std::exp(-ln_mu * (thin - 1.0)) / lambda / dX[k];
      q[k] = e * (P[k + 1] - P[k]);
      D.row(k).head(N) = (1.5 * q[k] / Hm[k]) * (K.row(k) + K.row(k + 1));
      D(k, N) = 3.0 * q[k] / Hm[k];
      const double d = -0.5 * q[k] * ln_mu * z / p_r * thin / (1.0 + p / p_r) * p0;
      D(k, k) += d - e;
      D(k, k + 1) += d + e;
      // The film that is carried over the face, from upstream.
      const double ratio = k > 0 ? 0.5 * dX[k] / dX[k - 1] : 0.0;
      R[k] = q[k] - H[k] - (k > 0 ? ratio * (H[k] - H[k - 1]) : 0.0);
      D.row(k).head(N) -= (1.0 + ratio) * K.row(k);
      if (k > 0) D.row(k).head(N) += ratio * K.row(k - 1);
      D(k, N) -= 1.0;
    }
    MatrixXd J = MatrixXd::Zero(N + 1, N + 1);
    VectorXd F = VectorXd::Zero(N + 1);
    for (int i = 0; i < N; ++i) {
      if (i > 0 && i + 1 < N) {
        F[i] = R[i] - R[i - 1];
        J.row(i) = D.row(i) - D.row(i - 1);
      }
      const bool pulls =
          i > 0 && X[i] > 0.0 && i + 1 < N && P[i] + F[i] / (std::abs(J(i, i)) + 1e-300) <= 0.0;
      if (i == 0 || i + 1 == N || pulls) {
        F[i] = P[i];
        J.row(i).setZero();
        J(i, i) = 1.0;
      }
    }
    F[N] = weight.dot(P) - 0.5 * std::numbers::pi;
    J.row(N).head(N) = weight.transpose();
    for (int i = 0; i <= N; ++i) {
      const double s = J.row(i).cwiseAbs().maxCoeff();
      J.row(i) /= s;
      F[i] /= s;
    }
    const VectorXd step = J.partialPivLu().solve(-F);
    out.last = step.head(N).cwiseAbs().maxCoeff();
    double size = std::min(1.0, 0.15 / std::max(out.last, 1e-300));
    const VectorXd change = K * step.head(N);
    for (bool bad = true; bad;) {
      bad = false;
      for (int i = 0; i < N; ++i)
        if (H[i] + size * (change[i] + step[N]) <= 0.2 * H[i]) bad = true;
      if (bad) size *= 0.5;
    }
    P = (P + size * step.head(N)).cwiseMax(0.0);
    H0 += size * step[N];
    if (out.last < 1e-9) break;
  }
  for (int k = 0; k + 1 < N; ++k)
    out.rolling += 0.5 * p0 * b * b * 0.5 * (H[k] + H[k + 1]) * (P[k + 1] - P[k]);
  out.moment = -0.5 * p0 * b * b * (weight.array() * P.array() * X.array()).sum();
  out.central = H[middle] * b * b;
  out.least = H[middle] * b * b;
  for (int i = middle; i < N && X[i] < 1.2; ++i) out.least = std::min(out.least, H[i] * b * b);
  return out;
}

}  // namespace testing
