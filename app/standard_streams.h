#pragma once

/// Standard output and error: what a file of unknown origin can make them say.

#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace morskin::app {

/// Replaces control characters by question marks, since names of files and atoms are the user's
/// at best: an escape sequence in one would command the terminal. Keeps line ends and UTF-8.
class ControlFilter {
 public:
  char operator()(char c);

 private:
  unsigned char lead_ = 0;  ///< of a character of UTF-8 that is not complete
  int missing_ = 0;         ///< bytes of it
};

std::string printable(std::string_view text);

/// While this exists a stream passes through a ControlFilter.
class PrintableStream : private std::streambuf {
 public:
  explicit PrintableStream(std::ostream& stream) : stream_(stream), target_(stream.rdbuf(this)) {}
  PrintableStream(const PrintableStream&) = delete;
  PrintableStream& operator=(const PrintableStream&) = delete;
  ~PrintableStream() override { stream_.rdbuf(target_); }

 private:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;
  int sync() override { return target_->pubsync(); }

  std::ostream& stream_;
  std::streambuf* target_;
  ControlFilter filter_;
};

/// Fills the places of standard streams that the caller has closed, so that no output file gets one
/// of their numbers and what is printed. Reading and writing them still fails.
void fill_closed_streams();

}  // namespace morskin::app
