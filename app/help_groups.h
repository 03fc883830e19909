#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace morskin::app {

/// Sorts the options of `mesh` by task, for its help. Those of the laboratory, which the paper's
/// experiments need and others hardly ever, are in --help-all only; complaints of a hidden option
/// would lack its name.
void group_options(CLI::App& mesh, bool shows_laboratory);

}  // namespace morskin::app
