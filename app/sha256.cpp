#include "app/sha256.h"

#include <array>
#include <cstdint>

namespace morskin::app {

std::string Sha256::digest() {
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> bytes;
  nettle_sha256_digest(&state_, bytes.size(), bytes.data());
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) text += {digits[byte >> 4U], digits[byte & 15U]};
  return text;
}

std::string sha256_of(std::string_view bytes) {
  Sha256 hash;
  hash.update(std::as_bytes(std::span(bytes)));
  return hash.digest();
}

}  // namespace morskin::app
