#pragma once

#include <string>

#include "app/pictures/image.h"

namespace morskin::pictures {

/// The picture as the bytes of a PNG file, 8 bits a channel, no alpha. The same picture gives the
/// same bytes with the same libpng and zlib.
std::string png(const Image& image);

}  // namespace morskin::pictures
