#pragma once

/// Which molecules a batch is of.

#include <filesystem>
#include <string>
#include <vector>

namespace morskin::app {

/// One molecule of a batch.
struct BatchInput {
  std::string name;            ///< in its row, and where it ends the names of what is made
  std::filesystem::path file;  ///< to be read, or the archive that holds it under `name`
  bool is_in_archive = false;

  /// `1a8o.pdb`: what is made of it is called `1a8o.pdb.ply`.
  std::string file_name() const { return std::filesystem::path(name).filename().string(); }
};

/// The molecules that words of the command line stand for, in an order that depends on nothing but
/// them and what they name. A word is, whatever fits first:
///  - "-": names on standard input, one a line;
///  - a folder: all molecules in it and below, by their endings, sorted; hidden folders left out;
///  - a tar archive: all molecules in it, by their endings, in its order;
///  - a pattern with *, ? or [...]: the files that it fits, sorted;
///  - a molecule, by its ending;
///  - a file of names, one a line, relative to the current folder.
/// Blank lines, lines that begin with #, and names that were there before are left out. Names are
/// relative to the folder, to the archive, or to the part of the pattern that has no wildcards;
/// those that are listed stay as they are written.
///
/// @param only  a pattern for the names, without their folders, of what folders and archives hold;
///              empty for all
/// @throws UsageError                 two molecules whose files have the same name in two folders,
///                                    and a name that is no UTF-8, for which rows have no place
/// @throws geometry::UnreadableInput  a list, folder or archive that cannot be read; no molecules
std::vector<BatchInput> batch_inputs(const std::vector<std::string>& words,
                                     const std::string& only);

}  // namespace morskin::app
