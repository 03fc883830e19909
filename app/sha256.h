#pragma once

#include <nettle/sha2.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace morskin::app {

/// SHA-256 (FIPS 180-4) of bytes that come in parts.
class Sha256 {
 public:
  Sha256() { nettle_sha256_init(&state_); }
  void update(std::span<const std::byte> bytes) {
    nettle_sha256_update(&state_, bytes.size(),
                         reinterpret_cast<const std::uint8_t*>(bytes.data()));
  }
  /// 64 hexadecimal digits in lower case. @pre called once
  std::string digest();

 private:
  sha256_ctx state_;
};

/// The digest of some bytes.
std::string sha256_of(std::string_view bytes);

}  // namespace morskin::app
