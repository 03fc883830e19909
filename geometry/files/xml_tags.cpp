#include "geometry/files/xml_tags.h"

#include <algorithm>
#include <vector>

#include "geometry/files/text_lines.h"

namespace morskin::geometry::mesh_formats {
namespace {

/// The attributes name="value" of a tag's inside.
std::map<std::string_view, std::string_view> attributes_of(std::string_view inside) {
  std::map<std::string_view, std::string_view> result;
  while (true) {
    const std::size_t equals = inside.find('=');
    const std::size_t open = inside.find_first_of("\"'", equals);
    if (equals == inside.npos || open == inside.npos) return result;
    const std::size_t close = inside.find(inside[open], open + 1);
    if (close == inside.npos) return result;
    std::string_view name = inside.substr(0, equals);
    result.emplace(take_field(name), inside.substr(open + 1, close - open - 1));
    inside.remove_prefix(close + 1);
  }
}

/// The > of the tag that begins here, which its quotes may hold too; npos if it is cut short.
std::size_t end_of_tag(std::string_view bytes, std::size_t at) {
  for (at = bytes.find_first_of(">\"'", at); at != bytes.npos && bytes[at] != '>';) {
    const std::size_t close = bytes.find(bytes[at], at + 1);
    at = close == bytes.npos ? close : bytes.find_first_of(">\"'", close + 1);
  }
  return at;
}

/// The tags that are open.
class Nesting {
 public:
  void take(std::string_view name, bool is_empty) {
    if (!complaint_.empty() || is_empty || name.starts_with('?')) return;
    if (!name.starts_with('/')) return open_.push_back(name);
    if (!open_.empty() && open_.back() == name.substr(1)) return open_.pop_back();
    complaint_ = "closes " + quoted(name.substr(1)) + ", which is not what is to be closed there";
  }
  std::string complaint() const {
    if (!complaint_.empty() || open_.empty()) return complaint_;
    return "ends before " + quoted(open_.back()) + " is closed";
  }

 private:
  std::vector<std::string_view> open_;
  std::string complaint_;
};

}  // namespace

std::string for_each_tag(std::string_view bytes, const std::function<void(const XmlTag&)>& take) {
  constexpr std::string_view comment = "<!--";
  Nesting nesting;
  std::size_t at = bytes.find('<');
  while (at < bytes.size()) {
    if (bytes.substr(at).starts_with(comment)) {
      at = bytes.find('<', bytes.find("-->", at + comment.size()));
      continue;
    }
    const std::size_t end = end_of_tag(bytes, at);
    if (end == bytes.npos) break;
    const std::size_t next = std::min(bytes.find('<', end), bytes.size());
    std::string_view inside = bytes.substr(at + 1, end - at - 1);
    const bool is_empty = inside.ends_with('/');
    const std::string_view name = take_field(inside);
    nesting.take(name, is_empty);
    take({name, attributes_of(inside), bytes.substr(end + 1, next - end - 1)});
    at = next;
  }
  return nesting.complaint();
}

}  // namespace morskin::geometry::mesh_formats
