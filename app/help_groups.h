#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace morskin::app {

/// Lets the help of all commands, of those added afterwards too, state the defaults of options.
void show_defaults(CLI::App& app);

/// Sorts the options of `mesh` by task, for its help. Those of the laboratory, which the paper's
/// experiments need and others hardly ever, are in --help-all only; complaints of a hidden option
/// would lack its name. Without them each option has one line, so that all fit a screen.
void group_options(CLI::App& mesh, bool shows_laboratory);

}  // namespace morskin::app
