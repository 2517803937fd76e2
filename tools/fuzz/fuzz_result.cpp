// Any bytes as a result file: it is read, or ends in an Error; and what was read writes and reads again.

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

#include "provis/error.hpp"
#include "provis/result_file.hpp"

namespace {

/// A file that exists in memory only.
class MemoryFile {
 public:
  MemoryFile(const void* data, std::size_t size) : descriptor_(memfd_create("result", 0)) {
    if (descriptor_ < 0 || write(descriptor_, data, size) != static_cast<ssize_t>(size)) std::abort();
  }
  ~MemoryFile() { close(descriptor_); }
  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

std::string written(const provis::ResultFile& result) {
  std::ostringstream text;
  write_result(result, text);
  return text.str();
}

void read_and_write(const std::uint8_t* data, std::size_t size) {
  const provis::ResultFile result = provis::read_result(MemoryFile(data, size).path());
  const std::string once = written(result);
  const std::string twice = written(provis::read_result(MemoryFile(once.data(), once.size()).path()));
  if (once != twice) {
    std::cerr << "written\n" << once << "and read and written again\n" << twice;
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    read_and_write(data, size);
  } catch (const provis::Error& error) {
    const bool of_the_file = error.code() == provis::Error::Code::invalid_input ||
                             error.code() == provis::Error::Code::unsupported;
    if (!of_the_file) {
      std::cerr << error.what() << '\n';
      std::abort();
    }
  }
  return 0;
}
