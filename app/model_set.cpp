#include "app/model_set.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "app/skin_arguments.h"
#include "app/typed_values.h"
#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "skin/selection.h"

namespace morskin::app {
namespace {

/// @param typed  what it is a part of, for the message
std::int64_t required_number(std::string_view text, std::string_view typed) {
  const std::optional<std::int64_t> value = parse_digits(text);
  if (!value) {
    throw UsageError("--model-number takes whole numbers from 0, as in 3 or 1,3-5, or all; not " +
                     geometry::quoted(typed));
  }
  return *value;
}

}  // namespace

std::optional<ModelSet> ModelSet::parsed(const std::string& text) {
  ModelSet set;
  if (text == "all") return set;
  if (text.find_first_of(",-") == std::string::npos) return std::nullopt;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t comma = std::min(text.find(',', first), text.size());
    const std::string_view item = std::string_view(text).substr(first, comma - first);
    const std::size_t hyphen = std::min(item.find('-'), item.size());
    Range range{required_number(item.substr(0, hyphen), item), 0};
    range.last =
        hyphen == item.size() ? range.first : required_number(item.substr(hyphen + 1), item);
    if (range.last < range.first) {
      throw UsageError("--model-number: " + std::string(item) + " ends before it begins");
    }
    set.ranges_.push_back(range);
    first = comma + 1;
  }
  return set;
}

std::vector<std::int64_t> ModelSet::chosen_from(const std::vector<std::int64_t>& present,
                                                const std::string& source) const {
  if (ranges_.empty()) return present;
  const std::set<std::int64_t> known(present.begin(), present.end());
  std::set<std::int64_t> taken;
  std::vector<std::int64_t> chosen;
  for (const Range& range : ranges_) {
    // The first that is missing ends it, so it takes no longer than the file has models.
    for (std::int64_t model = range.first;; ++model) {
      if (!known.contains(model)) {
        throw geometry::RefusedInput(source + ": has no model " + std::to_string(model) +
                                     "; choose from " + skin::listed_models(present));
      }
      if (taken.insert(model).second) chosen.push_back(model);
      if (model == range.last) break;
    }
  }
  return chosen;
}

std::int64_t parsed_model_number(const std::string& text) { return required_number(text, text); }

}  // namespace morskin::app
