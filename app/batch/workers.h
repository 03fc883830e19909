#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/arguments.h"
#include "app/batch/archive.h"
#include "app/batch/children.h"
#include "app/batch/inputs.h"
#include "geometry/stopwatch.h"

namespace morskin::app {

/// The words of the command line of one molecule's worker.
/// @param folder  for what it makes
std::vector<std::string> worker_words(const BatchArguments& arguments,
                                      const std::filesystem::path& input,
                                      const std::filesystem::path& folder);

/// The options that decided what is made, in one line, for rows; a table of radii with its digest.
std::string options_text(const BatchArguments& arguments);

/// A folder that is empty at the start, whatever was left there, and gone at the end.
class WorkFolder {
 public:
  /// @throws geometry::UnwritableOutput
  explicit WorkFolder(std::filesystem::path path);
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  ~WorkFolder();

  /// A new folder in it, of a name that no earlier one had.
  std::filesystem::path new_folder() const;

 private:
  std::filesystem::path path_;
};

/// Runs `mesh`, or `features`, on molecules, each in a process of its own. All that is unfinished
/// lies in the work folder; from there whole files are moved to the batch's folder.
class Workers {
 public:
  /// @param options      for the rows
  /// @param work_folder  in the batch's folder, for this object alone
  /// @throws geometry::UnwritableOutput
  Workers(const BatchArguments& arguments, std::string options, std::filesystem::path work_folder)
      : arguments_(arguments), options_(std::move(options)), work_folder_(std::move(work_folder)) {}

  bool are_idle() const { return jobs_.empty(); }
  bool have_room() const { return jobs_.size() < arguments_.workers; }

  /// @pre have_room(), and inputs of one archive come in its order
  /// @throws geometry::UnreadableInput  the archive ends early
  void start(const BatchInput& input);

  /// Waits for a molecule to be done, and moves what was made of it to the batch's folder, in the
  /// place of what an earlier run may have left there without a row.
  /// @return its row; nothing if a signal asks for the end
  /// @pre !are_idle()
  /// @throws geometry::UnwritableOutput  also where a worker could not write
  std::optional<nlohmann::ordered_json> next_row();

  int stop_signal() const { return children_.stop_signal(); }

 private:
  struct Job {
    BatchInput input;
    std::filesystem::path folder, file;  ///< of its own; the molecule
    geometry::Stopwatch time;
    int attempts = 1;
  };

  void run(Job job);
  std::filesystem::path file_of(const BatchInput& input, const std::filesystem::path& folder);
  nlohmann::ordered_json row_of(const Job& job, const EndedChild& ended) const;
  /// @param is_killed  what the worker made does not count
  std::vector<std::string> move_outputs(const Job& job, bool is_killed) const;

  const BatchArguments& arguments_;
  const std::string options_;
  WorkFolder work_folder_;
  std::optional<std::pair<std::filesystem::path, Archive>> archive_;  ///< the one that is read
  std::map<pid_t, Job> jobs_;
  Children children_;  // goes first: none works any more when the folder is removed
};

}  // namespace morskin::app
