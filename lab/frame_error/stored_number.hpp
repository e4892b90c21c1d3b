// The number formats of image files: the value nearest to an exact one, and the spacing there.
#pragma once

namespace morphcl::accuracy {

// Distance between neighbouring binary16 (binary32) numbers at `value`; that of the denormals below the normal range.
double half_spacing(double value);
double float_spacing(double value);

// To nearest, ties to even; infinite from 65520 on.
double nearest_half(double value);
double nearest_float(double value);

}  // namespace morphcl::accuracy
