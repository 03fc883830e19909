#pragma once

#include <doctest/doctest.h>

#include <optional>
#include <string>

#include "morskin/morskin.h"

namespace morskin::support {

/// What a call throws.
template <class Call>
std::optional<Error::Kind> kind_of(Call call) {
  try {
    call();
  } catch (const Error& error) {
    CHECK(std::string(error.what()) != "");
    return error.kind();
  }
  return std::nullopt;
}

}  // namespace morskin::support
