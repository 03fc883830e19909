#include "geometry/files/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "geometry/error.h"
#include "geometry/task_trace.h"

namespace morskin::geometry {
namespace {

std::string reason(int error) { return std::generic_category().message(error); }

// What is wrong with a name that has a NUL; empty if it has none. The system would read the name up
// to there, which is that of another file.
std::string fault_of_nul(const std::filesystem::path& path) {
  std::string name = path.string();
  if (name.find('\0') == std::string::npos) return {};
  std::ranges::replace(name, '\0', '?');
  return name + ": no file has a NUL in its name, shown as ? here; take it out";
}

[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& what) {
  throw UnreadableInput(path.string() + ": " + what);
}

// An open file descriptor, closed at the end of its scope unless it is only borrowed.
class Descriptor {
 public:
  explicit Descriptor(int number, bool is_owned = true) : number_(number), is_owned_(is_owned) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

  // 0 or the error of the close, which is where some file systems report a full disk.
  int close() {
    if (!is_owned_ || number_ < 0) return 0;
    return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno;
  }

 private:
  int number_;
  bool is_owned_;
};

// Reads into the buffer until it is full or the file ends; how many bytes came.
std::size_t read_up_to(const Descriptor& file, char* buffer, std::size_t size,
                       const std::filesystem::path& path) {
  const Traced traced(TaskTrace::Kind::Stage, "read");
  std::size_t have = 0;
  while (have < size) {
    const ssize_t count = ::read(file.number(), buffer + have, size - have);
    if (count == 0) break;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_to_read(path, "reading failed: " + reason(errno) + "; try again");
    have += static_cast<std::size_t>(count);
  }
  return have;
}

void write_directly(const std::filesystem::path& path, Descriptor& file, std::string_view bytes) {
  if (!file.is_open()) fail_to_write(path, errno);
  const int write_error = write_all(file.number(), bytes);
  const int close_error = file.close();
  if (write_error != 0) fail_to_write(path, write_error);
  if (close_error != 0) fail_to_write(path, close_error);
}

// Creates a file that did not exist, beside `target`, with the permissions of any new file.
std::string create_beside(const std::filesystem::path& target, int& number) {
  const std::string stem = target.string() + ".part" + std::to_string(::getpid()) + "-";
  for (int attempt = 0;; ++attempt) {
    std::string name = stem + std::to_string(attempt);
    number = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (number >= 0 || errno != EEXIST) return name;
  }
}

}  // namespace

void fail_to_open(const std::filesystem::path& path, int error) {
  const char* cure = "; check the name";
  if (error == EACCES) cure = "; ask for the right to read it";
  if (error == EMFILE || error == ENFILE) cure = "; allow more open files (ulimit -n)";
  fail_to_read(path, "cannot be opened: " + reason(error) + cure);
}

FileBytes read_file(const std::filesystem::path& path, std::size_t max_bytes) {
  if (path.empty()) throw UnreadableInput("the name of a file to read is empty; give one");
  if (const std::string fault = fault_of_nul(path); !fault.empty()) throw UnreadableInput(fault);
  const bool is_standard_input = path == "-";
  Descriptor file(is_standard_input ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC),
                  !is_standard_input);
  if (!file.is_open()) fail_to_open(path, errno);
  struct stat status {};
  if (::fstat(file.number(), &status) != 0) fail_to_read(path, reason(errno) + "; try again");
  if (S_ISDIR(status.st_mode)) fail_to_read(path, "is a folder; name a file in it");
  const auto refuse_length = [&] {
    fail_to_read(path,
                 "holds more than " + std::to_string(max_bytes) + " bytes; name another file");
  };
  const bool has_length = S_ISREG(status.st_mode) && !is_standard_input;
  if (has_length && static_cast<std::uintmax_t>(status.st_size) > max_bytes) refuse_length();

  // One byte more than the size, so that a file that does not grow is read in one piece.
  std::size_t capacity = 1 << 16;
  if (S_ISREG(status.st_mode)) capacity = static_cast<std::size_t>(status.st_size) + 1;
  capacity = std::min(capacity, max_bytes + 1);
  auto bytes = std::make_unique_for_overwrite<char[]>(capacity);
  std::size_t size = read_up_to(file, bytes.get(), capacity, path);
  while (size == capacity && size <= max_bytes) {
    capacity = std::min(2 * capacity, max_bytes + 1);
    auto larger = std::make_unique_for_overwrite<char[]>(capacity);
    std::memcpy(larger.get(), bytes.get(), size);
    bytes = std::move(larger);
    size += read_up_to(file, bytes.get() + size, capacity - size, path);
  }
  if (size > max_bytes) refuse_length();
  return {std::move(bytes), size};
}

int write_all(int file, std::string_view bytes) {
  const Traced traced(TaskTrace::Kind::Stage, "write");
  while (!bytes.empty()) {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    if (count == 0) return EIO;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

void fail_to_write(const std::filesystem::path& path, int error) {
  std::string advice = "choose another folder";
  if (error == ENOSPC || error == EDQUOT) advice = "free some space or choose another folder";
  if (error == ENOENT || error == ENOTDIR) advice = "create the folder first";
  if (error == EACCES || error == EPERM || error == EROFS) {
    advice = "choose a folder that you may write to";
  }
  if (error == EISDIR) advice = "name a file, not a folder";
  if (error == ENAMETOOLONG) advice = "choose a shorter one";
  if (error == EFBIG) advice = "choose another folder or allow larger files (ulimit -f)";
  if (error == EMFILE || error == ENFILE) advice = "allow more open files (ulimit -n)";
  if (error == EPIPE || error == EBADF) advice = "whoever was to read it is gone";
  throw UnwritableOutput(path.string() + ": cannot write: " + reason(error) + "; " + advice);
}

bool is_written_directly(const std::filesystem::path& path) {
  if (path == "-" || path == "/dev/stdout" || path == "/dev/stderr") return true;
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

std::filesystem::path link_target(std::filesystem::path path, std::error_code& error) {
  error.clear();
  std::error_code ignored;
  constexpr int max_links = 40;  // as many as the system follows
  // One by one, for the last may lead to a file that does not exist yet.
  for (int k = 0; std::filesystem::is_symlink(path, ignored); ++k) {
    if (k == max_links) {
      error = std::make_error_code(std::errc::too_many_symbolic_link_levels);
      break;
    }
    const std::filesystem::path next = std::filesystem::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / next;  // which an absolute path replaces
  }
  return path;
}

PendingFile::PendingFile(std::filesystem::path path) : path_(std::move(path)) {
  if (const std::string fault = fault_of_nul(path_); !fault.empty()) throw UnwritableOutput(fault);
  struct stat status {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail_to_write(path_, EISDIR);
  if (exists && ::access(path_.c_str(), W_OK) != 0) fail_to_write(path_, errno);
  std::error_code error;
  target_ = link_target(path_, error);
  if (error) fail_to_write(path_, error.value());
  std::string name = create_beside(target_, number_);
  if (number_ < 0) fail_to_write(path_, errno);
  if (exists && ::fchmod(number_, status.st_mode & 07777) != 0) {
    const int failure = errno;
    ::close(number_);
    ::unlink(name.c_str());
    fail_to_write(path_, failure);
  }
  temporary_ = std::move(name);
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      number_(std::exchange(other.number_, -1)) {}

PendingFile::~PendingFile() {
  if (number_ >= 0) ::close(number_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void PendingFile::write(std::string_view bytes) {
  if (number_ < 0) number_ = ::open(temporary_.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
  Descriptor file(std::exchange(number_, -1));
  write_directly(path_, file, bytes);
}

void PendingFile::read_again(std::string& bytes) const {
  const Descriptor file(::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) fail_to_read(path_, "cannot be read again: " + reason(errno));
  char beyond = 0;
  const bool is_as_long = read_up_to(file, bytes.data(), bytes.size(), path_) == bytes.size() &&
                          read_up_to(file, &beyond, 1, path_) == 0;
  if (!is_as_long) fail_to_read(path_, "has lost or gained bytes since it was written; try again");
}

std::filesystem::path PendingFile::commit(std::string_view suffix) {
  const std::string name = target_.string() + std::string(suffix);
  if (::rename(temporary_.c_str(), name.c_str()) != 0) fail_to_write(name, errno);
  temporary_.clear();
  return final_name(suffix);
}

std::filesystem::path PendingFile::final_name(std::string_view suffix) const {
  return suffix.empty() ? path_ : std::filesystem::path(target_.string() + std::string(suffix));
}

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  if (const std::string fault = fault_of_nul(path); !fault.empty()) throw UnwritableOutput(fault);
  if (!is_written_directly(path)) {
    PendingFile file(path);
    file.write(bytes);
    file.commit();
  } else if (path == "-" || path == "/dev/stdout" || path == "/dev/stderr") {
    Descriptor file(path == "/dev/stderr" ? STDERR_FILENO : STDOUT_FILENO, false);
    write_directly(path, file, bytes);
  } else {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    write_directly(path, file, bytes);
  }
}

}  // namespace morskin::geometry
