#include <signal.h>

#include <cmath>
#include <iostream>
#include <span>
#include <system_error>

#include "app/batch/inputs.h"
#include "app/batch/rows.h"
#include "app/batch/summary.h"
#include "app/batch/workers.h"
#include "app/commands.h"
#include "app/limits.h"
#include "app/options.h"
#include "app/progress.h"
#include "app/report_lines.h"
#include "geometry/error.h"
#include "geometry/stopwatch.h"
#include "skin/radius_table.h"

namespace morskin::app {
namespace {

/// Whether the workers will understand their options; prints a complaint if not.
/// @throws UsageError
/// @throws geometry::UnreadableInput, geometry::RefusedInput  of a table of radii
bool are_options_sound(const BatchArguments& arguments) {
  const std::vector<std::string> words = worker_words(arguments, "molecule.pdb", ".");
  std::vector<const char*> pointers{"morskin"};
  for (const std::string& word : words) pointers.push_back(word.c_str());
  const Arguments parsed =
      parse_arguments(static_cast<int>(pointers.size()), pointers.data(), "batch");
  const auto* const features = std::get_if<FeaturesArguments>(&parsed);
  const auto* const mesh =
      features != nullptr ? &features->mesh : std::get_if<MeshArguments>(&parsed);
  if (mesh != nullptr && mesh->molecule.radii) {
    const std::string& radii = *mesh->molecule.radii;
    if (is_read_once(radii)) {
      throw UsageError(
          "workers can read neither standard input nor a pipe: give --radii a file or a list");
    }
    // Only for what it throws: else each row would call its molecule unreadable.
    static_cast<void>(skin::radius_table(radii));
  }
  return !std::holds_alternative<Finished>(parsed);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (failed || !std::filesystem::is_directory(folder)) {
    throw geometry::UnwritableOutput(folder.string() + ": cannot be made a folder: " +
                                     (failed ? failed.message() : "it is a file") +
                                     "; choose another name");
  }
}

/// A row of another molecule of the same file name, or with other options, would be taken for one
/// of this run.
void check_rows(const std::map<std::string, BatchRow>& rows, const BatchArguments& arguments,
                const std::string& options, std::span<const BatchInput> inputs) {
  for (const auto& [name, row] : rows) {
    if (row.options == options) continue;
    throw UsageError(arguments.folder.string() + " has rows made with \"" + row.options +
                     "\", not \"" + options + "\"; choose another folder");
  }
  std::map<std::string, const std::string*> by_file_name;
  for (const auto& [name, row] : rows) {
    by_file_name.emplace(std::filesystem::path(name).filename().string(), &name);
  }
  for (const BatchInput& input : inputs) {
    const auto found = by_file_name.find(input.file_name());
    if (found == by_file_name.end() || *found->second == input.name) continue;
    throw UsageError(arguments.folder.string() + " has a row of " + *found->second +
                     ", and what is made of " + input.name + " would have the same name; choose " +
                     "another folder");
  }
}

/// A name too long for its output would end the batch whenever its turn came.
void check_lengths(const BatchArguments& arguments, std::span<const BatchInput> inputs) {
  constexpr std::size_t longest_name = 255, of_unfinished = 20;  // .part1234567-12, .unverified
  std::size_t longest_ending = 0;
  for (const std::string& ending : arguments.endings) {
    longest_ending = std::max(longest_ending, ending.size());
  }
  for (const BatchInput& input : inputs) {
    if (input.file_name().size() + 1 + longest_ending + of_unfinished <= longest_name) continue;
    throw UsageError(input.name + ": with another ending the name is too long; rename the file");
  }
}

std::vector<BatchInput> shard_of(std::vector<BatchInput> inputs, const Shard& shard) {
  std::vector<BatchInput> part;
  for (std::size_t i = shard.number - 1; i < inputs.size(); i += shard.count) {
    part.push_back(std::move(inputs[i]));
  }
  return part;
}

std::string time_text(double seconds) {
  if (seconds < 100) return std::to_string(std::lround(seconds)) + " s";
  if (seconds < 6000) return std::to_string(std::lround(seconds / 60)) + " min";
  return std::to_string(std::lround(seconds / 3600)) + " h";
}

/// "1,234 of 4,000, 20 min left"
std::string progress_text(std::size_t done, std::size_t all, const BatchSummary& so_far) {
  const double each = so_far.seconds / static_cast<double>(so_far.made);
  return grouped(done) + " of " + grouped(all) + ", " +
         time_text(each * static_cast<double>(all - done)) + " left";
}

/// Makes what has no row yet.
/// @return the signal that asks for the end, or 0
int work(const BatchArguments& arguments, const std::string& options,
         std::span<const BatchInput> inputs, const std::map<std::string, BatchRow>& rows,
         RowFile& file, BatchSummary& done) {
  const std::string stem = std::filesystem::path(rows_name(arguments.shard)).stem().string();
  Workers workers(arguments, options, arguments.folder / ("." + stem));
  ProgressLine line(arguments.quiet ? ShowProgress::Never : arguments.progress);
  const geometry::Stopwatch time;
  const std::size_t made_before = static_cast<std::size_t>(std::ranges::count_if(
      inputs, [&](const BatchInput& input) { return rows.contains(input.name); }));
  std::size_t next = 0;
  while (true) {
    while (next < inputs.size() && workers.have_room()) {
      const BatchInput& input = inputs[next++];
      if (!rows.contains(input.name)) workers.start(input);
    }
    if (workers.are_idle()) return 0;
    const auto row = workers.next_row();
    if (!row) return workers.stop_signal();
    file.append(*row);
    ++done.made;
    done.seconds = time.seconds();
    line.show(progress_text(made_before + done.made, inputs.size(), done), -1);
  }
}

}  // namespace

ExitCode batch_command(const BatchArguments& given) {
  BatchArguments arguments = given;
  const bool has_memory_limit =
      std::ranges::any_of(arguments.limit_options,
                          [](const std::string& word) { return word.starts_with("--max-memory"); });
  if (!has_memory_limit) {
    arguments.limit_options.push_back("--max-memory=" +
                                      std::to_string(machine_bytes() / arguments.workers));
  }
  if (!are_options_sound(arguments)) return ExitCode::Usage;
  const std::vector<BatchInput> all = batch_inputs(arguments.sources, arguments.only);
  check_lengths(arguments, all);
  const std::vector<BatchInput> inputs = shard_of(all, arguments.shard);
  const std::string options = options_text(arguments);
  if (!fits_in_row(options)) {
    throw UsageError("an option is no UTF-8, for which rows have no place: " + options);
  }
  make_folder(arguments.folder);
  // Once before there is a file of rows, so that a refusal leaves none, and once when it is locked.
  check_rows(read_rows(arguments.folder), arguments, options, all);
  RowFile file(arguments.folder / rows_name(arguments.shard));
  cut_torn_lines(arguments.folder);
  const std::map<std::string, BatchRow> rows = read_rows(arguments.folder);
  check_rows(rows, arguments, options, all);
  BatchSummary done;
  if (const int signal = work(arguments, options, inputs, rows, file, done); signal != 0) {
    std::cerr << "morskin: " << arguments.folder.string() << ": ended by a signal with "
              << counted(done.made, "row", "rows") << " more; run it again to resume\n";
    ::raise(signal);
  }
  BatchSummary summary = summarized(inputs, read_rows(arguments.folder));
  summary.made = done.made;
  summary.seconds = done.seconds;
  if (arguments.json) {
    std::cout << json_text(summary);
  } else if (!arguments.quiet) {
    std::cout << people_text(summary);
  }
  return ExitCode::Success;
}

}  // namespace morskin::app
