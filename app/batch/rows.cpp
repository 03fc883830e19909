#include "app/batch/rows.h"

#include <fcntl.h>
#include <fnmatch.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "geometry/error.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/text_lines.h"

namespace morskin::app {
namespace {

using nlohmann::ordered_json;

void add_row(std::map<std::string, BatchRow>& rows, const geometry::TextLines& lines) {
  try {
    const ordered_json json = ordered_json::parse(lines.line());
    BatchRow row{json.at("status"), json.at("options"), {}};
    for (std::size_t i = 0; i < measures.size(); ++i) {
      const auto found = json.find(measures[i]);
      const bool is_there = found != json.end() && found->is_number();
      row.values[i] = is_there ? found->get<double>() : std::numeric_limits<double>::quiet_NaN();
    }
    rows.emplace(json.at("input"), std::move(row));
  } catch (const nlohmann::json::exception&) {
    lines.fail("is no row of a batch; remove this line");
  }
}

std::vector<std::filesystem::path> row_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    std::error_code ignored;
    if (!entry.is_regular_file(ignored)) continue;  // a pipe would be waited for
    if (name == rows_name({}) || ::fnmatch("rows-*-of-*.jsonl", name.c_str(), 0) == 0) {
      files.push_back(entry.path());
    }
  }
  return files;
}

/// Another run writes the file.
struct IsLocked : geometry::UnwritableOutput {
  using UnwritableOutput::UnwritableOutput;
};

std::string_view whole_lines(std::string_view text) { return text.substr(0, text.rfind('\n') + 1); }

}  // namespace

bool fits_in_row(const std::string& text) {
  try {
    static_cast<void>(ordered_json(text).dump());  // only for what it throws
    return true;
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

std::string rows_name(const Shard& shard) {
  if (shard.count == 1) return "rows.jsonl";
  return "rows-" + std::to_string(shard.number) + "-of-" + std::to_string(shard.count) + ".jsonl";
}

std::map<std::string, BatchRow> read_rows(const std::filesystem::path& folder) {
  std::map<std::string, BatchRow> rows;
  for (const std::filesystem::path& file : row_files(folder)) {
    const geometry::FileBytes bytes = geometry::read_file(file);
    geometry::TextLines lines(whole_lines(bytes.view()), file.string());
    while (lines.advance()) add_row(rows, lines);
  }
  return rows;
}

void cut_torn_lines(const std::filesystem::path& folder) {
  for (const std::filesystem::path& file : row_files(folder)) {
    const geometry::FileBytes bytes = geometry::read_file(file);
    if (whole_lines(bytes.view()).size() == bytes.view().size()) continue;
    try {
      RowFile{file};
    } catch (const IsLocked&) {  // by another run, which is writing that line
    }
  }
}

RowFile::RowFile(std::filesystem::path path)
    : path_(std::move(path)),
      file_(::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (file_ < 0) geometry::fail_to_write(path_, errno);
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    ::close(file_);
    if (error != EWOULDBLOCK) geometry::fail_to_write(path_, error);
    throw IsLocked(path_.string() + ": another run writes it; wait for its end, or take shards");
  }
  struct stat found {};
  if (::fstat(file_, &found) != 0 || !S_ISREG(found.st_mode)) {
    ::close(file_);
    throw geometry::UnwritableOutput(path_.string() + ": is no regular file; remove it");
  }
  cut_torn_line();
}

RowFile::~RowFile() { ::close(file_); }

void RowFile::cut_torn_line() {
  const geometry::FileBytes bytes = geometry::read_file(path_);
  const std::size_t whole = whole_lines(bytes.view()).size();
  if (whole == bytes.view().size()) return;
  if (::ftruncate(file_, static_cast<off_t>(whole)) != 0) geometry::fail_to_write(path_, errno);
}

void RowFile::append(const ordered_json& row) {
  const std::string line = row.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
  struct stat before {};
  if (::fstat(file_, &before) != 0) geometry::fail_to_write(path_, errno);
  int error = geometry::write_all(file_, line);
  if (error == 0) {
    if (::fsync(file_) == 0) return;
    error = errno;
  }
  static_cast<void>(::ftruncate(file_, before.st_size));
  geometry::fail_to_write(path_, error);
}

}  // namespace morskin::app
