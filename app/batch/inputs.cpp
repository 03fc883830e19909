#include "app/batch/inputs.h"

#include <fnmatch.h>
#include <glob.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <string_view>
#include <unordered_map>

#include "app/batch/archive.h"
#include "app/batch/rows.h"
#include "app/skin_arguments.h"
#include "geometry/error.h"
#include "geometry/files/atomic_file.h"
#include "geometry/files/text_lines.h"
#include "skin/molecule_files.h"

namespace morskin::app {
namespace {

using std::filesystem::path;

/// Whether a file that a folder or an archive holds is taken. Those that begin with a dot are
/// others' notes, such as the ._1abc.pdb that macOS puts beside 1abc.pdb into an archive.
bool is_taken(const path& file, const std::string& only) {
  const std::string name = file.filename().string();
  return !name.starts_with('.') && skin::molecule_format_of(file) &&
         (only.empty() || ::fnmatch(only.c_str(), name.c_str(), 0) == 0);
}

std::vector<BatchInput> listed(const std::string& list) {
  const geometry::FileBytes bytes = geometry::read_file(list);
  std::vector<BatchInput> inputs;
  if (bytes.view().find('\0') != std::string_view::npos) {
    throw geometry::UnreadableInput(list + ": is no list of names, one a line; name a molecule " +
                                    "by its usual ending, a folder or a tar archive");
  }
  geometry::TextLines lines(bytes.view(), list);
  while (lines.advance()) {
    const std::string name(geometry::trimmed(lines.line()));
    if (!name.empty() && name[0] != '#') inputs.push_back({name, name});
  }
  return inputs;
}

std::vector<BatchInput> in_folder(const path& folder, const std::string& only) {
  std::vector<BatchInput> inputs;
  path at = folder;  // which an error of the iterator does not tell
  try {
    using Iterator = std::filesystem::recursive_directory_iterator;
    for (Iterator i(folder), end; i != end; ++i) {
      at = i->path();
      const bool is_hidden = i->path().filename().string().starts_with('.');
      std::error_code ignored;  // of a link in a ring
      if (i->is_directory(ignored) && is_hidden) i.disable_recursion_pending();
      // A link that leads nowhere gets a row, or its molecule would pass for made.
      const bool leads_nowhere = !i->exists(ignored);
      if (!(i->is_regular_file(ignored) || leads_nowhere) || !is_taken(i->path(), only)) continue;
      inputs.push_back({i->path().lexically_relative(folder).string(), i->path()});
    }
  } catch (const std::filesystem::filesystem_error& error) {
    throw geometry::UnreadableInput(at.string() + ": " + error.code().message() +
                                    "; leave it out or make it readable");
  }
  std::ranges::sort(inputs, {}, &BatchInput::name);
  return inputs;
}

std::vector<BatchInput> in_archive(const path& file, const std::string& only) {
  std::vector<BatchInput> inputs;
  Archive archive(file);
  while (const auto name = archive.next()) {
    if (!is_taken(*name, only)) continue;
    if (archive.is_link()) {
      throw geometry::UnreadableInput(
          file.string() + ": " + *name + " is a link, which a batch " +
          "cannot follow there; unpack the archive and name the folder");
    }
    inputs.push_back({*name, file, true});
  }
  return inputs;
}

/// Whether ::glob ends at such an error. A link that leads nowhere holds nothing.
int ends_search(const char*, int error) { return error != ENOENT && error != ELOOP ? 1 : 0; }

/// @throws UnreadableInput  there are none: a slip more often than a wish; or some cannot be seen
std::vector<BatchInput> fitting(const std::string& pattern) {
  // Relative to the last folder before the first wildcard.
  const std::size_t slash = pattern.substr(0, pattern.find_first_of("*?[")).rfind('/');
  const path base = slash == std::string::npos ? "" : pattern.substr(0, slash + 1);
  glob_t found{};
  const auto free = [](glob_t* result) { ::globfree(result); };
  const std::unique_ptr<glob_t, decltype(free)> owner(&found, free);
  std::vector<BatchInput> inputs;
  const int outcome = ::glob(pattern.c_str(), 0, ends_search, &found);
  if (outcome == GLOB_ABORTED) {
    throw geometry::UnreadableInput(pattern + ": a folder that may fit cannot be read; make it " +
                                    "readable or take another pattern");
  }
  const bool is_found = outcome == 0;
  for (std::size_t i = 0; is_found && i < found.gl_pathc; ++i) {
    const path file = found.gl_pathv[i];
    std::error_code ignored;  // of a link in a ring
    const bool leads_nowhere = !std::filesystem::exists(file, ignored);
    if (!leads_nowhere && !std::filesystem::is_regular_file(file, ignored)) continue;
    inputs.push_back({(base.empty() ? file : file.lexically_relative(base)).string(), file});
  }
  if (inputs.empty()) {
    throw geometry::UnreadableInput("no file fits the pattern " + pattern +
                                    "; mend it or leave it out");
  }
  std::ranges::sort(inputs, {}, &BatchInput::name);
  return inputs;
}

std::vector<BatchInput> meant_by(const std::string& word, const std::string& only) {
  std::error_code ignored;
  if (word == "-") return listed(word);
  if (std::filesystem::is_directory(word, ignored)) return in_folder(word, only);
  if (names_an_archive(word)) return in_archive(word, only);
  const bool exists = std::filesystem::exists(word, ignored);
  if (!exists && word.find_first_of("*?[") != std::string::npos) return fitting(word);
  if (skin::molecule_format_of(word)) return {{word, word}};
  return listed(word);
}

/// Whether the word names what `--only` chooses from.
bool holds_molecules(const std::string& word) {
  std::error_code ignored;
  return word != "-" && (std::filesystem::is_directory(word, ignored) || names_an_archive(word));
}

std::string place_of(const BatchInput& input) {
  return (input.is_in_archive ? input.name + " in " : "") + input.file.string();
}

/// @throws UsageError  for one file under two names, and for one name twice in one archive
void check_given_once(const BatchInput& a, const BatchInput& b) {
  std::error_code ignored;
  if (a.is_in_archive && b.is_in_archive && place_of(a) == place_of(b)) {
    throw UsageError(place_of(a) + " is there twice; leave one out, of the archive or of LIST");
  }
  if (a.is_in_archive || b.is_in_archive) return;
  if (!std::filesystem::equivalent(a.file, b.file, ignored)) return;
  throw UsageError(place_of(a) + " and " + place_of(b) + " are the same file; leave one out");
}

void check_name(const BatchInput& input) {
  if (!fits_in_row(input.name)) {
    throw UsageError(input.name + ": the name is no UTF-8; rename the file");
  }
  const std::string name = input.file_name();
  if (name.empty() || name == "." || name == "..") throw UsageError(input.name + " names no file");
}

}  // namespace

std::vector<BatchInput> batch_inputs(const std::vector<std::string>& words,
                                     const std::string& only) {
  std::vector<BatchInput> inputs;
  std::unordered_map<std::string, BatchInput> by_file_name;
  for (const std::string& word : words) {
    for (BatchInput& input : meant_by(word, only)) {
      check_name(input);
      const auto [place, is_new] = by_file_name.try_emplace(input.file_name(), input);
      const BatchInput& other = place->second;
      if (is_new) {
        inputs.push_back(std::move(input));
      } else if (input.is_in_archive || other.is_in_archive || input.file != other.file) {
        check_given_once(other, input);
        throw UsageError("what is made of " + place_of(other) + " and of " + place_of(input) +
                         " would have the same name; rename one, or take them in two runs, to " +
                         "two folders");
      }
    }
  }
  if (!only.empty() && std::ranges::none_of(words, holds_molecules)) {
    throw UsageError("--only is of folders and archives, and none is given; leave it out");
  }
  if (inputs.empty()) {
    throw geometry::UnreadableInput("no molecules in " + words.front() +
                                    (words.size() > 1 ? " and the others" : "") +
                                    (only.empty() ? "" : " that fit --only " + only) +
                                    "; name some, a folder, an archive or a file of names");
  }
  return inputs;
}

}  // namespace morskin::app
