#include "file_bytes.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <new>
#include <system_error>
#include <utility>

#include "../base/error.hpp"
#include "../base/machine.hpp"

namespace velum {
namespace {

constexpr std::size_t largest_transfer = std::size_t{1} << 30;

std::string reason(int error_number) {
  return std::generic_category().message(error_number);
}

[[noreturn]] void fail_to_write(const std::string& name, int error_number) {
  throw Error(ErrorKind::write, "cannot be written: " + reason(error_number), name,
              "choose another path, or make room and give permission there");
}

[[noreturn]] void fail_to_read(const std::string& name, int error_number) {
  throw Error(ErrorKind::read, "cannot be read: " + reason(error_number), name,
              "check the path and its permissions");
}

/// An open file, closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  /// 0 or the error number: some systems tell only now that the disk is full.
  int close() {
    const int number = std::exchange(number_, -1);
    return number >= 0 && ::close(number) != 0 ? errno : 0;
  }

 private:
  int number_;
};

/// 0 or the error number.
int write_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), std::min(bytes.size(), largest_transfer));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return 0;
}

/// A new file under a name of its own; removed again unless it is moved into place.
class TemporaryFile {
 public:
  /// @param name how messages call the file that shall appear
  TemporaryFile(const std::filesystem::path& folder, std::string name)
      : name_(std::move(name)), file_(create(folder)) {}
  ~TemporaryFile() {
    if (!path_.empty()) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::span<const std::byte> bytes, const mode_t* permissions) {
    int failure = write_all(file_.number(), bytes);
    if (failure == 0 && permissions != nullptr && ::fchmod(file_.number(), *permissions) != 0)
      failure = errno;
    const int close_failure = file_.close();
    if (failure == 0) failure = close_failure;
    if (failure != 0) fail_to_write(name_, failure);
  }

  void move_to(const std::filesystem::path& target) {
    if (::rename(path_.c_str(), target.c_str()) != 0) fail_to_write(name_, errno);
    path_.clear();
  }

 private:
  int create(const std::filesystem::path& folder) {
    constexpr int attempts = 10000;
    for (int i = 0; i < attempts; ++i) {
      path_ = folder / (".velum-" + std::to_string(::getpid()) + "-" + std::to_string(i) + ".partial");
      const int number = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (number >= 0) return number;
      if (errno != EEXIST) break;
    }
    const int failure = errno;
    path_.clear();
    fail_to_write(name_, failure);
  }

  std::string name_;
  std::filesystem::path path_;
  Descriptor file_;  // after path_: create() sets it
};

void write_in_place(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!file.is_open()) fail_to_write(path.string(), errno);
  int failure = write_all(file.number(), bytes);
  const int close_failure = file.close();
  if (failure == 0) failure = close_failure;
  if (failure != 0) fail_to_write(path.string(), failure);
}

void write_whole(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail_to_write(path.string(), EISDIR);
  if (exists && !S_ISREG(status.st_mode)) return write_in_place(path, bytes);
  // A rename needs no permission on the file it replaces; a person who took it away means it.
  if (exists && ::access(path.c_str(), W_OK) != 0) fail_to_write(path.string(), errno);
  std::error_code no_link;
  const std::filesystem::path target = exists ? std::filesystem::canonical(path, no_link) : path;
  if (no_link) fail_to_write(path.string(), no_link.value());

  const std::filesystem::path folder = target.parent_path();
  TemporaryFile temporary(folder.empty() ? "." : folder, path.string());
  const mode_t permissions = status.st_mode & 07777;
  temporary.write(bytes, exists ? &permissions : nullptr);
  temporary.move_to(target);
}

[[noreturn]] void fail_as_too_large(const std::string& name, std::uint64_t most) {
  throw Error(ErrorKind::limit,
              "has more than " + std::to_string(most) + " bytes, the most that are read (half of the " +
                  "machine's memory, unless the caller set it)",
              name, "choose a smaller file, or check that the program that writes into the pipe ends");
}

/// @param most  > 0
std::vector<std::byte> read_all(int descriptor, const std::string& name, std::uint64_t most) {
  std::vector<std::byte> bytes;
  struct stat status {};
  if (::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode)) {
    if (static_cast<std::uint64_t>(status.st_size) > most) fail_as_too_large(name, most);
    bytes.resize(static_cast<std::size_t>(status.st_size) + 1);  // one more: the end is seen without growing
  }
  std::size_t filled = 0;
  while (true) {
    if (filled > most) fail_as_too_large(name, most);
    if (filled == bytes.size()) {
      bytes.resize(static_cast<std::size_t>(
          std::min<std::uint64_t>(std::max<std::uint64_t>(65536, 2 * filled), most + 1)));
    }
    const std::size_t room = std::min(bytes.size() - filled, largest_transfer);
    const ssize_t count = ::read(descriptor, bytes.data() + filled, room);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_to_read(name, errno);
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace

void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  if (path != "-") {
    if (path.empty()) fail_to_write("\"\"", ENOENT);
    return write_whole(path, bytes);
  }
  const int failure = write_all(STDOUT_FILENO, bytes);
  if (failure != 0) fail_to_write("standard output", failure);
}

std::vector<std::byte> read_file(const std::filesystem::path& path, std::uint64_t most) {
  const std::string name = input_name(path);
  if (most == 0) most = physical_memory() / 2;
  if (most == 0) most = std::numeric_limits<std::uint64_t>::max() - 1;  // the system does not tell
  try {
    if (path == "-") return read_all(STDIN_FILENO, name, most);
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) fail_to_read(name, errno);
    return read_all(file.number(), name, most);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::limit, "does not fit into memory", name, "choose a smaller file");
  }
}

std::string input_name(const std::filesystem::path& path) {
  return path == "-" ? "standard input" : path.string();
}

}  // namespace velum
