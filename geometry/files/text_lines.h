#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.h"

namespace morskin::geometry {

/// What a carriage return without a line feed is: the end of a line, as on old Macs, or refused,
/// where programs that read the same file disagree about it.
enum class LoneReturn { EndsLine, IsRefused };

/// The lines of a text file, one by one, with their numbers for messages. Skips a byte order mark;
/// lines end in \n, \r\n or \r.
class TextLines {
 public:
  /// @param text    must outlive this object.
  /// @param source  the file's name, for messages.
  /// @param before  lines of the file that come before the text
  TextLines(std::string_view text, std::string source,
            LoneReturn lone_return = LoneReturn::EndsLine, std::size_t before = 0);

  /// Moves to the next line. @return false if there is none
  /// @throws UnreadableInput  for a lone return that is refused
  bool advance();

  std::string_view line() const { return line_; }  ///< without its end
  std::size_t number() const { return number_; }   ///< of line(), from 1
  std::string_view rest() const { return rest_; }  ///< after line()
  const std::string& source() const { return source_; }

  /// "source:line", for messages.
  std::string location() const;
  /// @throws UnreadableInput  "source:line: " + what
  [[noreturn]] void fail(std::string_view what) const;

 private:
  std::string_view rest_;
  std::string_view line_;
  std::string source_;
  LoneReturn lone_return_;
  std::size_t number_;
};

/// Removes and returns the next field, up to white space, from the front of `rest`; empty if there
/// is none.
std::string_view take_field(std::string_view& rest);

/// All fields of a line.
std::vector<std::string_view> fields_of(std::string_view line);

/// `text` with A to Z in lower case, in any locale.
std::string lower_case(std::string text);

/// `text` without white space at either end.
std::string_view trimmed(std::string_view text);

/// The number in all of `field`, in any locale, NaN and infinities included. Nothing if it is no
/// number or out of a double's range.
std::optional<double> parse_double(std::string_view field);

/// The integer in all of `field`.
std::optional<std::int64_t> parse_integer(std::string_view field);

/// Appends the shortest decimal text that reads back as the same double.
void append_number(std::string& text, double value);
void append_number(std::string& text, std::uint64_t value);

/// With so many digits and no idle zeros, for people: as %.3g of C, with a point in any locale.
std::string in_digits(double value, int digits);

/// "(x, y, z)", each in six digits.
std::string in_words(const Point& position);

/// `field` between quotation marks, for messages: at most 40 characters, control characters as
/// question marks.
std::string quoted(std::string_view field);

}  // namespace morskin::geometry
