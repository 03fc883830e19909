#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace morskin::geometry {

/// Walks the lines of a text file and knows where it is, so that every complaint can name the line.
/// A byte order mark is skipped; lines end in \n, \r\n or \r.
class TextLines {
 public:
  /// @param text    must outlive this object.
  /// @param source  the file's name, for messages.
  TextLines(std::string_view text, std::string source);

  /// Moves to the next line, or says that there is none.
  bool advance();

  std::string_view line() const { return line_; }  ///< without its end
  std::size_t number() const { return number_; }   ///< of line(), from 1
  std::string_view rest() const { return rest_; }  ///< what follows line()
  const std::string& source() const { return source_; }

  /// "source:line", for a message of one's own.
  std::string place() const;
  /// @throws UnreadableInput  "source:line: " + what
  [[noreturn]] void fail(std::string_view what) const;

 private:
  std::string_view rest_;
  std::string_view line_;
  std::string source_;
  std::size_t number_ = 0;
};

/// Takes the next field, ended by white space or by the end, off the front of `rest`; empty if
/// there is none.
std::string_view take_field(std::string_view& rest);

/// `text` with A to Z made small, whatever the locale.
std::string lower_case(std::string text);

/// `text` without white space at either end.
std::string_view trimmed(std::string_view text);

/// The number that all of `field` spells, whatever the locale; may be NaN or infinite if it is
/// spelled so. Nothing if it is not a number or does not fit a double.
std::optional<double> parse_double(std::string_view field);

/// The integer that all of `field` spells.
std::optional<std::int64_t> parse_integer(std::string_view field);

/// Appends the shortest decimal text that reads back as the same double.
void append_number(std::string& text, double value);
void append_number(std::string& text, std::uint64_t value);

/// `field` between quotation marks, fit for a message: at most 40 characters, control characters as
/// question marks.
std::string quoted(std::string_view field);

}  // namespace morskin::geometry
