// Output that appears whole or not at all.
#include "src/scene/atomic_file.hpp"

#include <catch2/catch.hpp>

#include "tests/scene/files.hpp"

namespace provis {
namespace {

std::size_t entries(const std::filesystem::path& folder) {
  const std::filesystem::directory_iterator begin(folder), end;
  return static_cast<std::size_t>(std::distance(begin, end));
}

TEST_CASE("a file appears with commit and not before") {
  const TempFolder folder;
  const auto file = folder.path() / "out.txt";
  {
    AtomicFile out(file);
    out.stream() << "content " << 42 << '\n';
    CHECK_FALSE(std::filesystem::exists(file));
    out.commit();
    CHECK(read_text(file) == "content 42\n");
  }
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("without commit the old file stays and nothing is left beside it") {
  const TempFolder folder;
  const auto file = folder.write("out.txt", "old");
  {
    AtomicFile out(file);
    out.stream() << std::string(1 << 20, 'x');
  }
  CHECK(read_text(file) == "old");
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("commit replaces the old file, large content included") {
  const TempFolder folder;
  const auto file = folder.write("out.txt", "old");
  const std::string content(3'000'001, 'y');
  AtomicFile out(file);
  out.stream().write(content.data(), static_cast<std::streamsize>(content.size()));
  out.commit();
  CHECK(read_text(file) == content);
}

TEST_CASE("two writers of one name do not meet") {
  const TempFolder folder;
  const auto file = folder.path() / "out.txt";
  AtomicFile first(file), second(file);
  first.stream() << "first";
  second.stream() << "second";
  first.commit();
  CHECK(read_text(file) == "first");
  second.commit();
  CHECK(read_text(file) == "second");
}

TEST_CASE("of a symbolic link the target is replaced") {
  const TempFolder folder;
  const auto target = folder.write("target.txt", "old");
  std::filesystem::create_symlink(target, folder.path() / "link.txt");
  AtomicFile out(folder.path() / "link.txt");
  out.stream() << "new";
  out.commit();
  CHECK(std::filesystem::is_symlink(folder.path() / "link.txt"));
  CHECK(read_text(target) == "new");
}

TEST_CASE("a device is written in place, and a full one is reported") {
  {
    AtomicFile null("/dev/null");
    null.stream() << "gone";
    null.commit();
  }
  CHECK(std::filesystem::is_character_file("/dev/null"));
  const Failure failure = failure_of([] {
    AtomicFile full("/dev/full");
    full.stream() << "too much";
    full.commit();
  });
  CHECK_FAILURE(failure, 4, "/dev/full");
  CHECK_THAT(failure.message, Catch::Contains("No space left on device"));
  CHECK(std::filesystem::is_character_file("/dev/full"));
}

TEST_CASE("an error in the middle of the content is reported by commit") {
  const Failure failure = failure_of([] {
    AtomicFile full("/dev/full");
    for (int i = 0; i < 100; ++i) full.stream() << std::string(10'000, 'z');
    CHECK(full.stream().bad());
    full.commit();
  });
  CHECK_THAT(failure.message, Catch::Contains("No space left on device"));
}

TEST_CASE("a name that cannot be written is an error at once") {
  const TempFolder folder;
  CHECK_FAILURE(failure_of([&] { AtomicFile out(folder.path()); }), 4, folder.path().string());
  const auto file = folder.path() / "no" / "out.txt";
  CHECK_FAILURE(failure_of([&] { AtomicFile out(file); }), 4, file.string());
}

}  // namespace
}  // namespace provis
