#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
class Error;
}  // namespace CLI

namespace morskin::app {

/// What is wrong with the words that CLI11 does not take. It would name those left over in the
/// reverse order, and of a value that it cannot convert not say why.
std::string complaint(const CLI::App& app, const CLI::Error& error);

}  // namespace morskin::app
