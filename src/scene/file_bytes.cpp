#include "src/scene/file_bytes.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "src/scene/failure.hpp"

namespace provis {

Bytes read_file(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) fail_invalid("", "no such file");
  if (!std::filesystem::is_regular_file(status)) fail_invalid("", "not a regular file");
  const auto size = std::filesystem::file_size(file, error);
  if (error) fail_invalid("", error.message());
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail_invalid("", std::generic_category().message(errno != 0 ? errno : EIO));
  Bytes bytes(size);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(stream.gcount()) != size)
    fail_invalid("", "the file shrank while it was read");
  return bytes;
}

}  // namespace provis
