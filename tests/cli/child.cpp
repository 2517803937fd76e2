#include "tests/cli/child.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace provis::test {

namespace {

int nameless_file() {
  std::string name = (std::filesystem::temp_directory_path() / "provis-child-XXXXXX").string();
  const int file = mkstemp(name.data());
  if (file < 0) throw std::runtime_error("no temporary file for a child's output");
  unlink(name.c_str());
  return file;
}

std::string take(int file) {
  std::string text;
  char buffer[4096];
  lseek(file, 0, SEEK_SET);
  for (ssize_t count; (count = read(file, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(count));
  }
  close(file);
  return text;
}

/// Nine vertices and these faces.
std::string small_scene(int count, const std::string& faces) {
  return "ply\nformat ascii 1.0\nelement vertex 9\n"
         "property double x\nproperty double y\nproperty double z\n"
         "element face " +
         std::to_string(count) +
         "\nproperty list uchar int vertex_indices\nend_header\n"
         "-2 -1 -2\n0 -1 -2\n-1 1 -2\n"
         "-1.5 -1 -3\n-0.5 -1 -3\n-1 0 -3\n"
         "0.5 -1 -2\n1.5 -1 -2\n1 1 -2\n" +
         faces;
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments, const std::string& shell)
    : out_(nameless_file()), err_(nameless_file()) {
  std::vector<std::string> words = {PROVIS_BINARY};
  if (!shell.empty()) words = {"/bin/sh", "-c", shell + " && exec \"$0\" \"$@\"", PROVIS_BINARY};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("fork failed");
  if (pid_ > 0) return;
  dup2(out_, STDOUT_FILENO);
  dup2(err_, STDERR_FILENO);
  execv(argv[0], argv.data());
  _exit(127);
}

Outcome Child::wait() {
  int status = 0;
  waitpid(pid_, &status, 0);
  Outcome outcome;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = take(out_);
  outcome.err = take(err_);
  return outcome;
}

Outcome provis_run(const std::vector<std::string>& arguments, const std::string& shell) {
  return Child(arguments, shell).wait();
}

std::string write_small_scene(const std::filesystem::path& file) {
  std::ofstream(file) << small_scene(4, "3 0 1 2\n3 3 4 5\n3 6 7 8\n3 0 0 1\n");
  return file.string();
}

std::string write_broken_scene(const std::filesystem::path& file) {
  std::ofstream(file) << small_scene(6, "3 0 1 2\n3 3 4 5\n3 0 1 9\n0\n3 6 7 8\n3 0 0 1\n");
  return file.string();
}

std::string write_particles(const std::filesystem::path& file) {
  std::ofstream(file) << "ply\nformat ascii 1.0\nelement sphere 3\n"
                         "property double x\nproperty double y\nproperty double z\nproperty double radius\n"
                         "property double vx\nproperty double vy\nproperty double vz\nend_header\n"
                         "0 0 -5 1 0 0 0\n1 2 3 0.5 1 0 -1\n4 4 4 0 0 0 0\n";
  return file.string();
}

}  // namespace provis::test
