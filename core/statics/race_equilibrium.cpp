#include "statics/race_equilibrium.hpp"

#include "base/symmetric_eigen.hpp"
#include "statics/race_text.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <utility>

namespace adore::statics {
namespace {

bool is_given(const RaceLoadCase& task, Eigen::Index k) {
  return task.given[static_cast<std::size_t>(k)];
}

}  // namespace

Vec5 scaled_residual(const RaceScales& scales, const RaceLoadCase& task, const Vec5& load) {
  Vec5 r = Vec5::Zero();
  for (Eigen::Index k = 0; k < 5; ++k) {
    if (!is_given(task, k)) {
      r(k) = (task.load(k) - load(k)) / lever_of(scales, k);
    }
  }
  return r;
}

Mat5 scaled_stiffness(const RaceScales& scales, const RaceLoadCase& task, const Mat5& stiffness,
                      double k_ref) {
  Mat5 K = Mat5::Zero();
  for (Eigen::Index i = 0; i < 5; ++i) {
    for (Eigen::Index j = 0; j < 5; ++j) {
      if (is_given(task, i) || is_given(task, j)) {
        K(i, j) = i == j ? k_ref : 0.0;
      } else {
        K(i, j) = stiffness(i, j) / (lever_of(scales, i) * lever_of(scales, j));
      }
    }
  }
  return K;
}

RaceStep newton_step(const Mat5& K, const Vec5& r, double k_ref, double force, double longest,
                     bool downhill) {
  RaceStep step;
  const Eigen::PartialPivLU<Mat5> lu(K);
  if (!downhill && lu.matrixLU().diagonal().cwiseAbs().minCoeff() > 1e-7 * k_ref) {
    step.direction = lu.solve(r);
    return step;
  }
  const SymmetricEigen<5> eigen = symmetric_eigen<5>(0.5 * (K + K.transpose()));
  Vec5 unresisted = Vec5::Zero();
  for (Eigen::Index k = 0; k < 5; ++k) {
    const double stiffness = std::abs(eigen.values(k));
    const Vec5 mode = eigen.vectors.col(k);
    const double load = mode.dot(r);
    if (stiffness > 1e-9 * k_ref) {
      step.direction += mode * (load / stiffness);
    } else if (std::abs(load) > 1e-9 * force) {
      unresisted += mode * load;
    } else {
      Eigen::Index largest = 0;
      mode.cwiseAbs().maxCoeff(&largest);
      step.held.push_back(static_cast<int>(largest));
    }
  }
  if (unresisted.squaredNorm() > 0.0) {
    step.direction += unresisted * (longest / unresisted.norm());
  }
  return step;
}

Vec5 moved(const RaceScales& scales, const Vec5& q, const Vec5& direction, double t) {
  Vec5 next = q;
  for (Eigen::Index k = 0; k < 5; ++k) {
    next(k) += t * direction(k) / lever_of(scales, k);
  }
  return next;
}

double largest_displacement(const RaceScales& scales, const Vec5& q) {
  double largest = 0.0;
  for (Eigen::Index k = 0; k < 5; ++k) {
    largest = std::max(largest, std::abs(q(k)) * lever_of(scales, k));
  }
  return largest;
}

bool is_out_of_reach(const RaceScales& scales, const Vec5& q) {
  return !(largest_displacement(scales, q) < scales.reach);
}

bool starts_out_of_reach(const RaceScales& scales, const RaceLoadCase& task, const Vec5& q) {
  return is_out_of_reach(scales, q - given_displacements(task, q));
}

double force_scale(const RaceScales& scales, const RaceLoadCase& task, double largest_contact) {
  double scale = 0.0;
  for (Eigen::Index k = 0; k < 5; ++k) {
    if (!is_given(task, k)) {
      scale = std::max(scale, std::abs(task.load(k)) / lever_of(scales, k));
    }
  }
  return scale > 0.0 ? scale : std::max(largest_contact, scales.idle_load);
}

Vec5 given_displacements(const RaceLoadCase& task, const Vec5& displacement) {
  Vec5 q = displacement;
  for (Eigen::Index k = 0; k < 5; ++k) {
    if (!is_given(task, k)) {
      q(k) = 0.0;
    }
  }
  return q;
}

UnstableMode unstable_mode(const RaceScales& scales, const RaceLoadCase& task,
                           const Mat5& stiffness, double k_ref) {
  const Mat5 K = scaled_stiffness(scales, task, stiffness, k_ref);
  const SymmetricEigen<5> eigen = symmetric_eigen<5>(0.5 * (K + K.transpose()));
  UnstableMode mode;
  if (eigen.values(0) < -1e-6 * k_ref) {
    mode.stiffness = eigen.values(0);
    mode.direction = eigen.vectors.col(0);
    Eigen::Index largest = 0;
    mode.direction.cwiseAbs().maxCoeff(&largest);
    mode.lever = lever_of(scales, largest);
  }
  return mode;
}

Finding instability_note(const UnstableMode& mode,
                         const std::vector<std::array<double, 5>>& stable_ones) {
  Eigen::Index largest = 0;
  mode.direction.cwiseAbs().maxCoeff(&largest);
  const double stiffness = mode.stiffness * mode.lever * mode.lever;
  const char* const unit = largest < 3 ? "N/m" : "N.m/rad";
  const auto finding = [&](std::string text) {
    return make_finding("statics.unstable", std::move(text))
        .of("inner race")
        .measure("stiffness", stiffness, unit)
        .at_least(0.0);
  };
  std::string text = fmt::format(
      "the equilibrium is not stable: the stiffness of the inner race, mainly {}, is negative "
      "({:.3g} {}), so a disturbance grows. If the shaft prevents this displacement, prescribe "
      "it. ",
      kDirection[static_cast<std::size_t>(largest)], stiffness, unit);
  if (stable_ones.empty()) {
    return finding(text + "No stable equilibrium was found nearby");
  }
  text += stable_ones.size() == 1 ? "A stable equilibrium nearby:" : "Stable equilibria nearby:";
  for (std::size_t k = 0; k < stable_ones.size(); ++k) {
    const auto& q = stable_ones[k];
    text +=
        fmt::format("{} x, y, z = {:.4g} m, {:.4g} m, {:.4g} m, about y, z = {:.4g}, {:.4g} rad",
                    k == 0 ? "" : ";", q[0], q[1], q[2], q[3], q[4]);
  }
  return finding(std::move(text));
}

}  // namespace adore::statics
