#include "app/staged_outputs.h"

#include <string>
#include <system_error>

#include "app/output_names.h"
#include "geometry/error.h"

namespace morskin::app {

StagedOutputs::StagedOutputs(const std::vector<std::filesystem::path>& names) {
  files_.reserve(names.size());
  interruption_.guard([&] {
    std::vector<std::string> temporary_names;
    for (const std::filesystem::path& name : names) {
      if (geometry::is_written_directly(name)) {
        direct_.push_back(name);
      } else {
        temporary_names.push_back(files_.emplace_back(name).temporary_name());
      }
    }
    return temporary_names;
  });
}

void check_unverified_name(const geometry::PendingFile& file) {
  const std::filesystem::path name = file.final_name(unverified);
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored)) {
    throw geometry::UnwritableOutput(name.string() + ": is a folder, in the place of what is not " +
                                     "certified; remove it or choose another name");
  }
}

void write_to_all(StagedOutputs& outputs, std::string_view bytes) {
  for (geometry::PendingFile& file : outputs.files()) {
    file.write(bytes);
    file.commit();
  }
  for (const std::filesystem::path& path : outputs.direct()) {
    geometry::write_file_atomically(path, bytes);
  }
}

}  // namespace morskin::app
