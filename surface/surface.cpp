#include "surface/surface.h"

namespace morskin::surface {

Surface::~Surface() = default;

}  // namespace morskin::surface
