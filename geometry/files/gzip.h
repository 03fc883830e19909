#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace morskin::geometry {

/// Whether the bytes begin as gzip's do.
bool is_gzip(std::string_view bytes);

/// Beyond `bomb_bytes` a file that unpacks to more than `bomb_ratio` times its size is taken for a
/// bomb. Tables of atoms unpack to 3 to 5 times their size, a lattice written out to 30; DEFLATE
/// reaches 1032. Below it the ratio does not matter: a few hundred bytes of nothing are harmless.
constexpr std::size_t bomb_ratio = 100;
constexpr std::size_t bomb_bytes = std::size_t{1} << 26;

/// What gzip packed; several packed parts one after the other are joined.
///
/// @param source      the file's name, for messages.
/// @param max_bytes  how much the result may hold.
/// @throws UnreadableInput  if the bytes are damaged or cut short, or hold more than `max_bytes`,
///                          or are a bomb
std::string unpack_gzip(std::string_view bytes, const std::string& source, std::size_t max_bytes);

}  // namespace morskin::geometry
