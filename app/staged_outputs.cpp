#include "app/staged_outputs.h"

#include <string>
#include <utility>

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

}  // namespace morskin::app
