#include "file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <goishi/error.hpp>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace goishi::cli {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail() {
  throw std::system_error(errno, std::generic_category());
}

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {
    if (value_ < 0) {
      fail();
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (0 <= value_) {
      ::close(value_);
    }
  }

  [[nodiscard]] int get() const { return value_; }

  /// Closing is the last chance of a file system to say that it is full.
  void close() {
    if (::close(std::exchange(value_, -1)) != 0) {
      fail();
    }
  }

 private:
  int value_;
};

void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (0 <= written) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      fail();
    }
  }
}

/// What a new file gets: the old file's permissions, else those that the user's umask leaves.
mode_t permissions_for(const fs::path& target) {
  struct stat old {};
  if (::stat(target.c_str(), &old) == 0) {
    return old.st_mode & 0777U;
  }
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666U & ~mask;
}

void replace(const fs::path& target, std::string_view text) {
  if (::access(target.c_str(), W_OK) != 0 && errno != ENOENT) {
    fail();
  }
  std::string temporary = (target.parent_path() / ".goishi-XXXXXX").string();
  Descriptor file(::mkstemp(temporary.data()));
  try {
    write_all(file.get(), text);
    if (::fchmod(file.get(), permissions_for(target)) != 0 || ::fsync(file.get()) != 0) {
      fail();
    }
    file.close();
    fs::rename(temporary, target);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
}

/// Devices and pipes, and whatever /dev/stdout stands for.
bool is_stream(const std::string& file) {
  const fs::file_status status = fs::status(file);
  return file.starts_with("/dev/") || (fs::exists(status) && !fs::is_regular_file(status));
}

void write_directly(const std::string& target, std::string_view text) {
  Descriptor file(::open(target.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  write_all(file.get(), text);
  file.close();
}

}  // namespace

void write_standard_output(std::string_view text) {
  try {
    write_all(STDOUT_FILENO, text);
  } catch (const std::system_error& error) {
    throw std::runtime_error("standard output: cannot be written: " + error.code().message());
  }
}

void write_file(const std::string& argument, const std::string& file, std::string_view text) {
  try {
    if (is_stream(file)) {
      write_directly(file, text);
    } else {
      replace(fs::is_symlink(file) ? fs::canonical(file) : fs::path(file), text);
    }
  } catch (const std::system_error& error) {
    throw InvalidArgument(argument, file, "cannot be written: " + error.code().message());
  }
}

std::string read_file(const std::string& argument, const std::string& file, std::size_t most) {
  try {
    const Descriptor source(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
    std::string text;
    std::array<char, 1 << 16> block;
    while (text.size() < most) {
      const ssize_t count = ::read(source.get(), block.data(), std::min(block.size(), most - text.size()));
      if (count == 0) {
        break;
      }
      if (0 < count) {
        text.append(block.data(), static_cast<std::size_t>(count));
      } else if (errno != EINTR) {
        fail();
      }
    }
    return text;
  } catch (const std::system_error& error) {
    throw InvalidArgument(argument, file, "cannot be read: " + error.code().message());
  }
}

}  // namespace goishi::cli
