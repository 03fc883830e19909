#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace morskin::geometry {

/// Whether the bytes begin as gzip's do.
bool is_gzip(std::string_view bytes);

/// What gzip packed; several packed parts one after the other are joined.
///
/// @param source      the file's name, for messages.
/// @param most_bytes  how much the result may hold.
/// @throws UnreadableInput  if the bytes are damaged or cut short, or hold more than `most_bytes`
std::string unpack_gzip(std::string_view bytes, const std::string& source, std::size_t most_bytes);

}  // namespace morskin::geometry
