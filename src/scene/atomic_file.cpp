#include "src/scene/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <streambuf>
#include <system_error>
#include <utility>

#include "provis/error.hpp"

namespace provis {

/// A stream buffer over a file descriptor that remembers why a write failed; std::filebuf does not.
class AtomicFile::Buffer : public std::streambuf {
 public:
  explicit Buffer(int descriptor) : descriptor_(descriptor) {
    setp(block_.data(), block_.data() + block_.size());
  }
  ~Buffer() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  int error() const { return error_; }

  /// Some file systems report a full disk only here.
  void close() {
    sync();
    if (::close(std::exchange(descriptor_, -1)) != 0 && error_ == 0) error_ = errno;
  }

 protected:
  int sync() override {
    const char* data = pbase();
    while (error_ == 0 && data < pptr()) {
      const ssize_t written = ::write(descriptor_, data, static_cast<std::size_t>(pptr() - data));
      if (written >= 0)
        data += written;
      else if (errno != EINTR)
        error_ = errno;
    }
    setp(block_.data(), block_.data() + block_.size());
    return error_ == 0 ? 0 : -1;
  }

  int_type overflow(int_type c) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }

 private:
  std::array<char, 1 << 16> block_;
  int descriptor_;
  int error_ = 0;
};

AtomicFile::AtomicFile(const std::filesystem::path& path) : name_(path.string()) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) fail(EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) fail(errno);
    buffer_ = std::make_unique<Buffer>(descriptor);
  } else {
    const auto real = std::filesystem::exists(status) ? std::filesystem::canonical(path, ignored) : path;
    create_aside(real.empty() ? path : real);
  }
  stream_ = std::make_unique<std::ostream>(buffer_.get());
}

void AtomicFile::create_aside(const std::filesystem::path& target) {
  static std::atomic<unsigned> counter{0};
  int descriptor = -1;
  std::filesystem::path aside;
  do {
    aside = target;
    aside += ".part-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    descriptor = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor < 0 && errno == EEXIST);
  if (descriptor < 0) fail(errno);
  target_ = target;
  aside_ = aside;
  buffer_ = std::make_unique<Buffer>(descriptor);
}

AtomicFile::~AtomicFile() {
  if (!aside_.empty()) ::unlink(aside_.c_str());
}

std::ostream& AtomicFile::stream() { return *stream_; }

void AtomicFile::commit() {
  buffer_->close();
  if (buffer_->error() != 0) fail(buffer_->error());
  if (!stream_->good()) fail(EIO);
  if (aside_.empty()) return;
  if (std::rename(aside_.c_str(), target_.c_str()) != 0) fail(errno);
  aside_.clear();
}

void AtomicFile::fail(int error) const {
  throw Error(Error::Code::output, name_, "cannot be written: " + std::generic_category().message(error));
}

}  // namespace provis
