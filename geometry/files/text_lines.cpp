#include "geometry/files/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "geometry/error.h"

namespace morskin::geometry {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
constexpr std::string_view white_space = " \t\r\n\v\f";

constexpr bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

// std::from_chars takes no leading plus sign, though files do.
std::string_view without_plus(std::string_view field) {
  if (field.size() > 1 && field[0] == '+' && field[1] != '-' && field[1] != '+') {
    field.remove_prefix(1);
  }
  return field;
}

template <class Number>
std::optional<Number> parse(std::string_view field) {
  field = without_plus(field);
  Number value{};
  const char* end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

template <class Number>
void append(std::string& text, Number value) {
  std::array<char, 32> digits;
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  text.append(digits.data(), end);
}

}  // namespace

TextLines::TextLines(std::string_view text, std::string source, LoneReturn lone_return,
                     std::size_t before)
    : rest_(text), source_(std::move(source)), lone_return_(lone_return), number_(before) {
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

bool TextLines::advance() {
  if (rest_.empty()) return false;
  std::size_t end = 0;
  while (end < rest_.size() && rest_[end] != '\n' && rest_[end] != '\r') ++end;
  line_ = rest_.substr(0, end);
  ++number_;
  if (end == rest_.size()) {
    rest_ = {};
    return true;
  }
  const bool two_characters = rest_.substr(end, 2) == "\r\n";
  if (lone_return_ == LoneReturn::IsRefused && rest_[end] == '\r' && !two_characters) {
    fail(
        "a carriage return without a line feed ends a line for some programs only; write the mesh "
        "again");
  }
  rest_.remove_prefix(end + (two_characters ? 2 : 1));
  return true;
}

std::string TextLines::location() const { return source_ + ":" + std::to_string(number_); }

void TextLines::fail(std::string_view what) const {
  throw UnreadableInput(location() + ": " + std::string(what));
}

std::string_view take_field(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && is_blank(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_blank(rest[end])) ++end;
  const std::string_view field = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return field;
}

std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (auto field = take_field(line); !field.empty(); field = take_field(line)) {
    fields.push_back(field);
  }
  return fields;
}

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  return text;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(white_space);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(white_space) - begin + 1);
}

std::optional<double> parse_double(std::string_view field) { return parse<double>(field); }

std::optional<std::int64_t> parse_integer(std::string_view field) {
  return parse<std::int64_t>(field);
}

void append_number(std::string& text, double value) { append(text, value); }
void append_number(std::string& text, std::uint64_t value) { append(text, value); }

std::string in_digits(double value, int digits) {
  std::array<char, 64> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value,
                                          std::chars_format::general, digits);
  return {text.data(), end};
}

std::string in_words(const Point& position) {
  std::string text;
  for (const double x : position) text += (text.empty() ? "(" : ", ") + in_digits(x, 6);
  return text + ")";
}

std::string quoted(std::string_view field) {
  constexpr std::size_t longest = 40;
  std::string result = "\"";
  for (const char c : field.substr(0, longest)) {
    const bool is_printable = c >= 0x20 && c < 0x7f;
    result += is_printable ? c : '?';
  }
  result += field.size() > longest ? "...\"" : "\"";
  return result;
}

}  // namespace morskin::geometry
