#pragma once

#include "skin/mixed_complex.h"
#include "surface/surface.h"

namespace morskin::skin {

/// Points drawn evenly from the quadrics of the kept cells, by the measure rho^-2, without those
/// that lie outside of their cells.
surface::Samples skin_samples(const surface::Surface& skin, const MixedComplex& complex);

}  // namespace morskin::skin
