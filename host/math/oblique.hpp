// Oblique projections: parallel projectors that meet the picture's plane at an angle. What lies `d` behind the plane is
// drawn moved by d * (x, y), so the plane itself keeps its true shape.
//
// The shear factors (l cos a, l sin a) are what is stored and computed with, not the angle beta between the projectors
// and the plane: l = cot(beta) turns an error of beta into one 1 / sin^2(beta) times as large. Below 1 degree an angle
// rounded to fp32 would move what lies 1 behind the plane by more than 1e-5, so smaller angles are refused.
#pragma once

#include <glm/glm.hpp>

namespace morphcl {

struct ObliqueShear {
  double x = 0, y = 0;
};

constexpr double smallest_beta_degrees = 1;
constexpr double largest_oblique_factor = 57.289961630759425;  // cot(1 degree)
constexpr double cavalier_factor = 1, cabinet_factor = 0.5;

// Edges that lead straight away from the viewer are drawn at `direction_degrees`, counter-clockwise from the picture's
// x axis, and `factor` times as long as they are: 1 in cavalier, 1/2 in cabinet, 0 in orthographic projections.
// Error(usage) when the factor is not in [0, largest_oblique_factor] or the direction is not finite.
ObliqueShear oblique_shear(double direction_degrees, double factor);

// cot(beta): 1 at 45 degrees, 1/2 at atan(2) = 63.43 degrees. Error(usage) when beta is not in [1, 90] degrees.
double oblique_factor(double beta_degrees);

// From the projectors' direction (a, b, c) in eye space, of any length: (a / c, b / c). Error(usage) when it is not
// finite or runs closer than smallest_beta_degrees to the picture's plane.
ObliqueShear oblique_shear_along(const glm::dvec3& direction);

}  // namespace morphcl
