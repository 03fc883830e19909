#pragma once

/// Base64 (RFC 4648, section 4).

#include <optional>
#include <string>
#include <string_view>

namespace morskin::geometry {

void append_base64(std::string& text, std::string_view bytes);

/// The bytes that a text stands for, without what follows padding; nothing if it has other signs.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace morskin::geometry
