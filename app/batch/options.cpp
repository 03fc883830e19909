#include "app/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "app/features_options.h"
#include "app/presets.h"
#include "app/shared_options.h"
#include "app/typed_values.h"
#include "geometry/files/mesh_files.h"
#include "geometry/files/text_lines.h"

namespace morskin::app {
namespace {

/// "I/N".
Shard parsed_shard(std::string_view text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto number = parse_digits(text.substr(0, slash));
  const auto count = parse_digits(text.substr(std::min(slash + 1, text.size())));
  if (!number || !count || *number < 1 || *number > *count) {
    throw UsageError("--shard takes I/N, with I from 1 to N, as in 3/16");
  }
  return {static_cast<std::size_t>(*number), static_cast<std::size_t>(*count)};
}

/// Checked here, since mesh and features would name a file of the batch and not the option.
void check_endings(const std::vector<std::string>& endings, bool are_of_features) {
  for (const std::string& ending : endings) {
    const bool is_more = ending.find_first_of("./") != std::string::npos;
    if (is_more || !geometry::mesh_format_of("molecule." + ending)) {
      throw UsageError("--format takes endings of meshes, as in ply,vtu; not " +
                       geometry::quoted(ending));
    }
    const std::string known = geometry::lower_case(ending);
    if (are_of_features && known != "npz" && known != "ply") {
      throw UsageError("--format takes npz and ply with --features; not " +
                       geometry::quoted(ending));
    }
    if (std::ranges::count(endings, ending) > 1) {
      throw UsageError("--format has " + ending + " twice");
    }
  }
}

/// An option as it was typed, in one word for each of its values. An empty one would be lost:
/// behind "=" the next word is taken for the value.
std::vector<std::string> as_typed(const CLI::Option& option) {
  if (option.get_expected_max() == 0) return {option.get_name()};  // a flag
  const bool is_long = !option.get_lnames().empty();
  std::vector<std::string> words;
  for (const std::string& value : option.results()) {
    if (value.empty()) throw UsageError(option.get_name() + " is empty; leave it out or fill it");
    words.push_back(option.get_name() + (is_long ? "=" : "") + value);
  }
  return words;
}

}  // namespace

void add_batch(CLI::App& app, TypedBatch& batch, Typed& typed) {
  BatchArguments& arguments = batch.arguments;
  CLI::App& command = *app.add_subcommand("batch", "Mesh many molecules, one worker per core");
  command
      .add_option("LIST", arguments.sources,
                  "A file of names, one a line; - for names on standard input; a folder\n"
                  "or tar archive of molecules; a pattern; molecules. Or several of these")
      ->required();
  command
      .add_option("-o,--output", arguments.folder,
                  "The folder for the files and rows.jsonl, which has a row for each molecule.\n"
                  "What has a row there is not made again")
      ->required();
  command
      .add_option("--format", arguments.endings,
                  "Endings of the files to make, as mesh has them: ply,vtu,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->default_str("ply; npz with --features; that of --for");
  command.add_option("--only", arguments.only,
                     "Of folders and archives only what fits this pattern: '*.cif.gz'");
  command.add_flag("--features", arguments.features, "Run features in place of mesh");
  command.add_option("--shard", batch.shard,
                     "I/N: every N-th molecule, beginning with the I-th; rows go to\n"
                     "rows-I-of-N.jsonl. I from 1 to N");
  arguments.workers = std::max(1U, std::thread::hardware_concurrency());
  command.add_option("--workers", arguments.workers, "Processes at a time (all cores)")
      ->check(CLI::Range(1U, 1024U));
  add_meshing_options(command, batch.mesh, typed);
  add_preset_option(command, typed);
  command.add_option("--timeout", batch.timeout, "Seconds for a molecule; then its row says limit");
  command.add_option("--max-memory", batch.max_memory,
                     "Bytes for a molecule, 2G is 2 GiB; then its row says limit\n"
                     "(default: what the machine has, divided by the workers)");
  command.add_flag("--json", arguments.json, "Print the summary as JSON");
  command.add_flag("-q,--quiet", arguments.quiet,
                   "Print nothing but errors, and the summary if --json asks for it");
  add_progress_option(command, typed);
  command.footer(
      "Exit code 0: every molecule has its row. A row's status is ok, refused, uncertified,\n"
      "unreadable, limit or failed. The same command, run again, resumes where it stopped.");
}

BatchArguments batch_arguments(const CLI::App& command, const TypedBatch& typed) {
  BatchArguments batch = typed.arguments;
  if (typed.shard) batch.shard = parsed_shard(*typed.shard);
  if (batch.folder.empty()) throw UsageError("an output's name is empty");
  const CLI::Option* purpose = command.get_option("--for");
  if (command.count("--format") == 0) {
    if (batch.features) batch.endings = {"npz"};
    if (purpose->count() > 0) batch.endings = {preset_ending(purpose->as<std::string>()).substr(1)};
  }
  const auto require_mesh = [&](const std::string& name) {
    if (batch.features && command.count(name) > 0) {
      throw UsageError(name + " is of mesh; features sets what it writes");
    }
  };
  require_mesh("--for");
  for (const char* name : features_lack) require_mesh(name);
  check_endings(batch.endings, batch.features);
  constexpr std::array<std::string_view, 11> own{"--help", "LIST",       "--output",  "--format",
                                                 "--only", "--features", "--shard",   "--workers",
                                                 "--json", "--quiet",    "--progress"};
  constexpr std::array<std::string_view, 2> limits{"--timeout", "--max-memory"};
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || std::ranges::find(own, name) != own.end()) continue;
    const bool is_limit = std::ranges::find(limits, name) != limits.end();
    std::vector<std::string>& target = is_limit ? batch.limit_options : batch.options;
    for (std::string& word : as_typed(*option)) target.push_back(std::move(word));
  }
  return batch;
}

}  // namespace morskin::app
