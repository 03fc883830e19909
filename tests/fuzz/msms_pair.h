#pragma once

#include <string_view>

namespace morskin::fuzz {

/// The two files of an MSMS mesh in one input: what comes before its first zero byte, and what
/// comes behind it. Seeds stay texts that anyone can read, and both files can grow.
struct MsmsPair {
  std::string_view vertices, faces;
};

inline MsmsPair msms_pair(std::string_view bytes) {
  const std::string_view vertices = bytes.substr(0, bytes.find('\0'));
  bytes.remove_prefix(vertices.size());
  return {vertices, bytes.substr(bytes.empty() ? 0 : 1)};
}

}  // namespace morskin::fuzz
