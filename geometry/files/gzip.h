#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace morskin::geometry {

/// Whether the bytes begin with gzip's magic number.
bool is_gzip(std::string_view bytes);

/// A file that unpacks to more than `bomb_bytes` and `bomb_ratio` times its size is refused as a
/// bomb. Tables of atoms unpack to 3 to 5 times their size, the text of a lattice to 30; DEFLATE
/// reaches 1032.
constexpr std::size_t bomb_ratio = 100;
constexpr std::size_t bomb_bytes = std::size_t{1} << 26;

/// The unpacked bytes of one gzip member or several in a row.
///
/// @param source     the file's name, for messages
/// @param max_bytes  limit of the result
/// @throws UnreadableInput  if the bytes are damaged, cut short, beyond the limit or a bomb
std::string unpack_gzip(std::string_view bytes, const std::string& source, std::size_t max_bytes);

}  // namespace morskin::geometry
