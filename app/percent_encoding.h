#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace morskin::app {

/// `text` with every byte but letters, digits, `-`, `.`, `_`, `~` and those of `kept` as % and two
/// hexadecimal digits (RFC 3986), so that it fits on a line of any file.
std::string percent_encoded(std::string_view text, std::string_view kept = {});

/// The text behind that; nothing if a % is not followed by two hexadecimal digits.
std::optional<std::string> percent_decoded(std::string_view text);

}  // namespace morskin::app
