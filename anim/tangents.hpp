// Tangents for cubic keys that have none of their own.
//
// Where a key's neighbours are equally far away, the tangent is the slope between them (Catmull and Rom). Elsewhere it
// is that of the parabola through the three keys (Bessel), limited as Fritsch and Carlson (1980) do: 0 where the values
// turn round, else at most three times the smaller of the two slopes. So a pair of keys that nearly coincide does not
// throw the curve out of their neighbourhood, as its steep slope would, and rising values give a rising curve. At the
// ends the tangent is the slope to the only neighbour.
#pragma once

#include <span>
#include <vector>

namespace morphcl {

// One tangent a key, in value per unit of time. `times` increase; as many values as times, at least 2.
std::vector<double> default_tangents(std::span<const double> times, std::span<const double> values);

// The limited form at every key, evenly spaced or not: between two keys the curve never leaves the interval of their
// values, if the values of all keys rise or all fall.
std::vector<double> monotone_tangents(std::span<const double> times, std::span<const double> values);

}  // namespace morphcl
