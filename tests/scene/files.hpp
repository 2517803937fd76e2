#pragma once
// Temporary files, and failures taken apart into code and place.

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "provis/error.hpp"
#include "provis/scene.hpp"

namespace provis {

/// A folder of its own that ends with the object.
class TempFolder {
 public:
  TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "provis-test-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~TempFolder() { std::filesystem::remove_all(path_); }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

inline std::string read_text(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// What a call failed with: the exit status, the place without the file's name, and the sentence.
struct Failure {
  int status = 0;
  std::string place, message;
};

template <class Call>
Failure failure_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return {exit_status(error.code()), error.place(), error.what()};
  }
  return {};
}

/// Of loading a file with this content.
inline Failure load_failure(const std::string& name, const std::string& content,
                            const LoadOptions& options = {}) {
  const TempFolder folder;
  const auto file = folder.write(name, content);
  Failure failure = failure_of([&] { load_scene(file, options); });
  const std::string prefix = file.string() + ": ";
  if (failure.place.rfind(prefix, 0) == 0) failure.place.erase(0, prefix.size());
  return failure;
}

inline Scene load_content(const std::string& name, const std::string& content,
                          const LoadOptions& options = {}) {
  const TempFolder folder;
  return load_scene(folder.write(name, content), options);
}

/// The bytes of numbers, little-endian.
template <class T>
std::string bytes_of(std::initializer_list<T> values) {
  std::string bytes;
  for (const T& value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
  return bytes;
}

}  // namespace provis

#define CHECK_FAILURE(failure, expected_status, expected_place) \
  do {                                                          \
    const auto failed = (failure);                              \
    CAPTURE(failed.message);                                    \
    CHECK(failed.status == (expected_status));                  \
    CHECK(failed.place == (expected_place));                    \
  } while (false)
