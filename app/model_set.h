#pragma once

/// Several of a file's models, as --model-number names them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace morskin::app {

/// "all", or numbers and ranges with commas between, "1,3-5".
class ModelSet {
 public:
  /// The set in the words above; nothing for the number of one model, "3".
  /// @throws UsageError  for what is neither
  static std::optional<ModelSet> parsed(const std::string& text);

  /// Each once, in the order of the words.
  /// @param present  the numbers of the file's models
  /// @throws geometry::RefusedInput  the file lacks one that is named
  std::vector<std::int64_t> chosen_from(const std::vector<std::int64_t>& present,
                                        const std::string& source) const;

 private:
  struct Range {
    std::int64_t first, last;
  };
  std::vector<Range> ranges_;  // none: all
};

/// The number of a model.
/// @throws UsageError
std::int64_t parsed_model_number(const std::string& text);

}  // namespace morskin::app
