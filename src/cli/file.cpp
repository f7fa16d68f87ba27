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

/// A file under a temporary name in its folder, until it is put in place, or gone.
class Staged {
 public:
  Staged(fs::path target, std::string_view text) : target_(std::move(target)) {
    if (::access(target_.c_str(), W_OK) != 0 && errno != ENOENT) {
      fail();
    }
    std::string name = (target_.parent_path() / ".goishi-XXXXXX").string();
    Descriptor file(::mkstemp(name.data()));
    temporary_ = std::move(name);
    try {
      write_all(file.get(), text);
      if (::fchmod(file.get(), permissions_for(target_)) != 0 || ::fsync(file.get()) != 0) {
        fail();
      }
      file.close();
    } catch (...) {
      remove();
      throw;
    }
  }
  Staged(const Staged&) = delete;
  Staged& operator=(const Staged&) = delete;
  ~Staged() { remove(); }

  void put_in_place() {
    fs::rename(temporary_, target_);
    temporary_.clear();
  }

 private:
  void remove() {
    if (!temporary_.empty()) {
      ::unlink(temporary_.c_str());
    }
  }

  fs::path target_;
  std::string temporary_;
};

/// What a name leads to.
fs::path target_of(const std::string& file) {
  return fs::is_symlink(file) ? fs::canonical(file) : fs::path(file);
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

std::string extension_of(const std::string& file) {
  std::string extension = fs::path(file).extension().string();
  extension.erase(0, 1);
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return extension;
}

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
      Staged(target_of(file), text).put_in_place();
    }
  } catch (const std::system_error& error) {
    throw InvalidArgument(argument, file, "cannot be written: " + error.code().message());
  }
}

void write_pair(const std::string& argument, const FileText& beside, const FileText& file) {
  for (const FileText* one : {&file, &beside}) {
    if (is_stream(one->name)) {
      throw InvalidArgument(argument, file.name,
                            one == &file ? "must be a file that can be replaced"
                                         : "needs " + beside.name + " too, which is no file that can be replaced");
    }
  }
  bool is_beside = true;  // what is being written
  try {
    Staged first(target_of(beside.name), beside.text);
    is_beside = false;
    Staged second(target_of(file.name), file.text);
    is_beside = true;
    first.put_in_place();
    is_beside = false;
    second.put_in_place();
  } catch (const std::system_error& error) {
    throw InvalidArgument(
        argument, file.name,
        (is_beside ? "needs " + beside.name + " too, which cannot be written: " : std::string("cannot be written: ")) +
            error.code().message());
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
