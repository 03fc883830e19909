#pragma once

#include <string_view>

namespace morskin::app {

/// The viewer: an HTML page with the marks @ABOUT@ and @DATA@, in this order, for a page's own
/// data. `viewer/dist/viewer.html`, made by `make viewer-asset`.
std::string_view viewer_asset();

}  // namespace morskin::app
