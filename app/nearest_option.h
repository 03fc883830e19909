#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace morskin::app {

/// The option of the command being used, "--density" for "--densty" or "-C" for "-c", that a word
/// which is none was probably meant to be; nothing if none is near. Of several as near, the first.
/// Failing that one that others call so, "--biological-assembly" for "--biounit", or whose name has
/// all its words, or all of whose words it has. Underscores count as hyphens.
std::optional<std::string> nearest_option(const CLI::App& app, std::string_view typed);

}  // namespace morskin::app
