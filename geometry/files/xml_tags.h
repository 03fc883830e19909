#pragma once

// As much of XML as VTU files need.

#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace morskin::geometry::mesh_formats {

/// A tag and the text up to the next one.
struct XmlTag {
  std::string_view name;  ///< "/Points" where it closes
  std::map<std::string_view, std::string_view> attributes;
  std::string_view text;
};

/// Calls take(tag) with each whole tag in turn. Comments are passed over, whatever tags they hold.
/// @return why other readers of XML refuse the bytes, if it is that tags are not closed in turn, as
///         in a file that was cut short; "" if they are
std::string for_each_tag(std::string_view bytes, const std::function<void(const XmlTag&)>& take);

}  // namespace morskin::geometry::mesh_formats
