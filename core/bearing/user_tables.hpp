#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

/// Imperfections and inertia that a routine of the user gives (ADRX8), one value for each element
/// or pocket. SI.
namespace adore::bearing {

struct UserTables {
  bool elements = false, pockets = false, inertia = false;  ///< which the deck asks for
  // Deviations of elements; of balls the first alone [m].
  std::vector<double> diameter, crown_radius, length, central_length, land_offset;
  // Deviations of pockets: diametral clearances, wall, axial [m]; azimuth; tilt x, y, z each [rad].
  std::vector<double> pocket_clearance_1, pocket_clearance_2, pocket_thickness, pocket_axial,
      pocket_angular, pocket_tilt;
  // Of every element, as bearing::Inertia.
  double mass = 0.0;
  Eigen::Vector3d moments = Eigen::Vector3d::Zero(), geometric_centre = Eigen::Vector3d::Zero(),
                  frame = Eigen::Vector3d::Zero();

  explicit UserTables(std::size_t n = 0) {
    for (auto* one :
         {&diameter, &crown_radius, &length, &central_length, &land_offset, &pocket_clearance_1,
          &pocket_clearance_2, &pocket_thickness, &pocket_axial, &pocket_angular})
      one->assign(n, 0.0);
    pocket_tilt.assign(3 * n, 0.0);
  }
};

/// Places of a surface and what a routine of the user (ADRX5, ADRX6) adds there.
struct UserSurface {
  int race = -1, element = -1;           ///< body; the other is -1
  std::vector<double> axial, azimuth;    ///< [m, rad]
  std::vector<double> radius;            ///< larger radius [m]
  std::vector<double> curvature_factor;  ///< added to the groove factor [-]

  void place(double x, double psi) {
    axial.push_back(x);
    azimuth.push_back(psi);
    radius.push_back(0.0);
    curvature_factor.push_back(0.0);
  }
};

}  // namespace adore::bearing
