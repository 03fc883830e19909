#include "app/batch/workers.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "app/exit_codes.h"
#include "app/output_names.h"
#include "app/report_lines.h"
#include "app/sha256.h"
#include "geometry/error.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/text_lines.h"
#include "skin/molecule_files.h"
#include "skin/radius_table.h"

namespace morskin::app {
namespace {

using nlohmann::ordered_json;
using std::filesystem::path;

constexpr const char* report_name = "report.json";
constexpr const char* errors_name = "errors.txt";

/// Of a molecule whose worker somebody else ends: another program, or the system for lack of
/// memory.
constexpr int max_attempts = 3;

/// Signals that say a program is at fault; the others come from outside.
bool is_fault(int signal) {
  constexpr std::array faults = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP};
  return std::ranges::find(faults, signal) != faults.end();
}

/// The system's, of processor time; a second attempt would reach it as well.
bool is_limit(int signal) { return signal == SIGXCPU; }

/// Why a molecule has no mesh whose worker a signal ended.
std::string reason_of(int signal) {
  if (is_limit(signal)) {
    return "reached the processor time that the system grants a program; raise it, see ulimit -t";
  }
  const std::string end = "ended by signal " + std::to_string(signal);
  if (is_fault(signal)) return end + "; please report it with the input";
  return end + ", " + std::to_string(max_attempts) + " times; is there memory for so many workers?";
}

std::string_view status_of(int exit_code) {
  switch (static_cast<ExitCode>(exit_code)) {
    case ExitCode::Success:
      return "ok";
    case ExitCode::UnreadableInput:
      return "unreadable";
    case ExitCode::RefusedInput:
      return "refused";
    case ExitCode::NotCertified:
      return "uncertified";
    case ExitCode::LimitReached:
      return "limit";
    default:
      return "failed";
  }
}

/// The names in the batch's folder of what is made of a molecule that is certified.
std::vector<path> output_names(const BatchArguments& arguments, const std::string& file_name) {
  std::vector<path> names;
  for (const std::string& ending : arguments.endings) names.emplace_back(file_name + "." + ending);
  add_msms_partners(names);
  return names;
}

/// What a worker said last, behind the program's name and with the molecule's name in the row in
/// the place of its file's.
std::string last_words(const path& errors, const path& file, const std::string& name) {
  std::ifstream stream(errors);
  std::string text = "\n";
  text.append(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  // To the end and not to that of the line, for a name may hold several lines.
  constexpr std::string_view program = "\nmorskin: ";
  const std::size_t begin = text.rfind(program);
  std::string last(geometry::trimmed(
      begin == std::string::npos ? text : std::string_view(text).substr(begin + program.size())));
  const std::size_t at = last.find(file.string());
  if (at != std::string::npos) last.replace(at, file.string().size(), name);
  return last;
}

/// What a row tells of a report of `mesh`.
void add_figures(ordered_json& row, const ordered_json& report) {
  const auto add = [&](const char* key, const char* place) {
    row[key] = report.value(ordered_json::json_pointer(place), ordered_json());
  };
  add("input_sha256", "/provenance/input-sha256");
  add("atoms", "/atoms_used");
  add("vertices", "/vertices");
  add("triangles", "/triangles");
  add("area", "/area");
  add("vertices_per_square_angstrom", "/quality/vertices_per_square_angstrom");
  add("min_angle_deg", "/min_angle_deg");
  add("components", "/components");
  add("genus", "/genus");
  add("peak_memory_bytes", "/peak_memory_bytes");
}

/// A moved file is in its new place after any end of this process; this is for ends of the machine.
void force_to_disk(const path& file) {
  const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (opened < 0) return;
  ::fsync(opened);
  ::close(opened);
}

}  // namespace

std::vector<std::string> worker_words(const BatchArguments& arguments, const path& input,
                                      const path& folder) {
  std::vector<std::string> words{arguments.features ? "features" : "mesh", input.string(),
                                 "--threads=1", "-q"};
  for (const std::string& ending : arguments.endings) {
    words.push_back("--output=" + (folder / (input.filename().string() + "." + ending)).string());
  }
  words.push_back("--report=" + (folder / report_name).string());
  words.insert(words.end(), arguments.options.begin(), arguments.options.end());
  words.insert(words.end(), arguments.limit_options.begin(), arguments.limit_options.end());
  return words;
}

std::string options_text(const BatchArguments& arguments) {
  std::string text;
  const auto add = [&](std::string_view option, std::string_view value = {}) {
    if (!text.empty()) text += ' ';
    text.append(option).append(value);
  };
  if (arguments.features) add("--features");
  for (const std::string& ending : arguments.endings) add("--format=", ending);
  for (const std::string& option : arguments.options) {
    constexpr std::string_view radii = "--radii=";
    if (!option.starts_with(radii) || skin::parse_radius_table(option.substr(radii.size()))) {
      add(option);
      continue;
    }
    // What a table of radii says counts, not its name.
    const geometry::FileBytes table = geometry::read_file(option.substr(radii.size()));
    add("--radii=sha256:", sha256_of(table.view()));
  }
  return text;
}

WorkFolder::WorkFolder(path path) : path_(std::move(path)) {
  std::error_code failed;
  std::filesystem::remove_all(path_, failed);
  if (!failed) std::filesystem::create_directory(path_, failed);
  if (failed) geometry::fail_to_write(path_, failed.value());
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

path WorkFolder::new_folder() const {
  // A worker of a run that was killed a moment ago may still know the folders of that run.
  std::string name = (path_ / "XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) geometry::fail_to_write(name, errno);
  return name;
}

path Workers::file_of(const BatchInput& input, const path& folder) {
  // A name that begins with a dash would be an option.
  if (!input.is_in_archive) return input.file.is_relative() ? "." / input.file : input.file;
  if (!archive_ || archive_->first != input.file) {
    archive_.emplace(input.file, Archive(input.file));
  }
  while (const auto name = archive_->second.next()) {
    if (*name != input.name) continue;
    const path file = folder / "in" / input.file_name();
    std::error_code failed;
    std::filesystem::create_directory(file.parent_path(), failed);
    if (failed) geometry::fail_to_write(file, failed.value());
    archive_->second.extract(file, skin::ReadOptions().max_bytes);
    return file;
  }
  throw geometry::UnreadableInput(input.file.string() + ": " + input.name + " is gone from it; " +
                                  "leave archives alone while a batch reads them");
}

void Workers::start(const BatchInput& input) {
  Job job{input, work_folder_.new_folder(), {}, {}};
  job.file = file_of(input, job.folder);
  run(std::move(job));
}

void Workers::run(Job job) {
  const pid_t child =
      children_.start(worker_words(arguments_, job.file, job.folder), job.folder / errors_name);
  jobs_.emplace(child, std::move(job));
}

std::optional<ordered_json> Workers::next_row() {
  while (true) {
    const std::optional<EndedChild> ended = children_.next_ended();
    if (!ended) return std::nullopt;
    Job job = std::move(jobs_.extract(ended->id).mapped());
    const bool comes_from_outside =
        ended->signal != 0 && !is_fault(ended->signal) && !is_limit(ended->signal);
    if (comes_from_outside && job.attempts < max_attempts) {
      ++job.attempts;
      run(std::move(job));
      continue;
    }
    if (ended->exit_code == Children::not_started) {
      throw geometry::UnwritableOutput(
          arguments_.folder.string() +
          ": no worker could be started; is the folder there, with space, and /proc?");
    }
    if (ended->exit_code == static_cast<int>(ExitCode::UnwritableOutput)) {
      const std::string words = last_words(job.folder / errors_name, job.file, job.input.name);
      throw geometry::UnwritableOutput(
          words.empty() ? job.folder.string() + ": is gone; leave the folder alone while a batch " +
                              "writes there"
                        : words);
    }
    ordered_json row = row_of(job, *ended);
    std::error_code ignored;
    std::filesystem::remove_all(job.folder, ignored);
    return row;
  }
}

ordered_json Workers::row_of(const Job& job, const EndedChild& ended) const {
  const bool is_killed = ended.signal != 0;
  const std::string_view status = is_limit(ended.signal) ? "limit"
                                  : is_killed            ? "failed"
                                                         : status_of(ended.exit_code);
  ordered_json row = {{"input", job.input.name}, {"status", status}};
  ordered_json report;
  if (std::ifstream stream(job.folder / report_name); stream && !is_killed) {
    report = ordered_json::parse(stream);
  }
  if (is_killed) {
    row["reason"] = reason_of(ended.signal);
  } else if (status != "ok") {
    row["reason"] = last_words(job.folder / errors_name, job.file, job.input.name);
    if (report.contains("reason")) row["reason"] = report["reason"];
  }
  row["outputs"] = move_outputs(job, is_killed);
  if (!report.empty()) add_figures(row, report);
  row["seconds"] = rounded(job.time.seconds());
  row["cpu_seconds"] = rounded(ended.cpu_seconds);
  row["options"] = options_;
  return row;
}

std::vector<std::string> Workers::move_outputs(const Job& job, bool is_killed) const {
  std::vector<std::string> moved;
  for (const path& name : output_names(arguments_, job.file.filename().string())) {
    for (const path& made : {name, path(name.string().append(unverified))}) {
      const path target = arguments_.folder / made;
      std::error_code failed;
      if (is_killed || !std::filesystem::exists(job.folder / made)) {
        std::filesystem::remove(target, failed);
        continue;
      }
      force_to_disk(job.folder / made);
      std::filesystem::rename(job.folder / made, target, failed);
      if (failed) geometry::fail_to_write(target, failed.value());
      moved.push_back(made.string());
    }
  }
  return moved;
}

}  // namespace morskin::app
