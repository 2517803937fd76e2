// Ctrl-C. The child is held at a named pipe until the signal has been sent, so that nothing depends on time.

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "tests/cli/child.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using namespace provis::test;

TEST_CASE("an interrupt ends the program with 130 and leaves no file") {
  const int signal = GENERATE(SIGINT, SIGTERM);
  const TempFolder directory;
  const std::string scene = write_small_scene(directory.path() / "s.ply"),
                    pipe = (directory.path() / "views").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  Child child({"point", scene, "--views", pipe + ":v", "--out", (directory.path() / "r.json").string()});
  // Opening waits for the child to open the other end; by then it catches signals.
  const int writer = open(pipe.c_str(), O_WRONLY);
  REQUIRE(writer >= 0);
  kill(child.pid(), signal);
  const std::string views = R"([{"name": "v", "eye": [0, 0, 0], "dir": [0, 0, -1]}])";
  CHECK(write(writer, views.data(), views.size()) == static_cast<ssize_t>(views.size()));
  close(writer);
  const Outcome outcome = child.wait();
  CHECK(outcome.status == 130);
  CHECK_THAT(outcome.err, Catch::Contains("interrupted"));
  CHECK(std::distance(std::filesystem::directory_iterator(directory.path()), {}) == 2);
}
