#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "verify/report/escape.hpp"
#include "verify/report/report.hpp"

namespace goishi::verify {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw std::runtime_error(
      fmt::format("cannot write {}: {}", printable(path.string()), std::generic_category().message(error)));
}

/// 0, or the number of the error. Closes the file.
int write_and_close(int file, std::string_view content, bool sync) {
  int error = 0;
  while (!content.empty() && error == 0) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written >= 0) {
      content.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (error == 0 && sync && ::fsync(file) != 0) {
    error = errno;
  }
  if (::close(file) != 0 && error == 0) {
    error = errno;
  }
  return error;
}

/// A pipe or a device cannot be replaced, only written to.
void write_through(const std::filesystem::path& path, const std::string& content) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  const int error = file < 0 ? errno : write_and_close(file, content, false);
  if (error != 0) {
    fail(path, error);
  }
}

}  // namespace

void write_file(const std::filesystem::path& path, const std::string& content) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) {
    fail(path, EISDIR);
  }
  if (std::filesystem::is_other(status)) {
    write_through(path, content);
    return;
  }
  // A link stays a link: what it points to is replaced.
  std::filesystem::path target = std::filesystem::canonical(path, ignored);
  if (ignored) {
    target = path;  // there is nothing yet
  }

  static std::atomic<unsigned> number = 0;
  std::filesystem::path temporary = target;
  temporary.replace_filename(fmt::format(".goishi-{}-{}.tmp", ::getpid(), number++));
  const int file = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) {
    fail(path, errno);
  }
  int error = write_and_close(file, content, true);
  if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) {
    error = errno;
  }
  if (error != 0) {
    ::unlink(temporary.c_str());
    fail(path, error);
  }
}

}  // namespace goishi::verify
