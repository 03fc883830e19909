#pragma once

#include <string_view>

namespace morskin::app {

/// The viewer: an HTML page whose marks @ABOUT@ and @DATA@ stand, in this order, where a page's own
/// data go. `viewer/dist/viewer.html`, made by `make viewer-asset`.
std::string_view viewer_asset();

}  // namespace morskin::app
