#include "src/cli/limited_child.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <thread>

#include "provis/error.hpp"

namespace provis {

namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const char* what) { throw Error(Error::Code::internal, what, std::strerror(errno)); }

/// A file without a name, for what the child says on standard error.
class Talk {
 public:
  Talk() {
    std::string name = (std::filesystem::temp_directory_path() / "provis-talk-XXXXXX").string();
    file_ = mkostemp(name.data(), O_CLOEXEC);
    if (file_ < 0) fail("temporary file");
    unlink(name.c_str());
  }
  ~Talk() { close(file_); }
  Talk(const Talk&) = delete;
  Talk& operator=(const Talk&) = delete;

  int file() const { return file_; }

  /// Its last few KiB.
  std::string end() const {
    std::array<char, 4096> buffer{};
    const off_t size = lseek(file_, 0, SEEK_END);
    const off_t begin = std::max<off_t>(0, size - static_cast<off_t>(buffer.size()));
    const ssize_t count = pread(file_, buffer.data(), buffer.size(), begin);
    return {buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(0, count))};
  }

 private:
  int file_;
};

/// Becomes the program. Between fork and exec only what a signal handler may do is allowed.
[[noreturn]] void become(char* const* argv, const Limits& limits, pid_t parent, int talk) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);  // it ended before it could take us along
  if (limits.bytes > 0) {
    const rlimit limit{limits.bytes, limits.bytes};
    setrlimit(RLIMIT_DATA, &limit);
  }
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
  dup2(talk, STDERR_FILENO);
  execv("/proc/self/exe", argv);
  _exit(127);
}

/// Ends the child if it is still there when the object goes.
class Process {
 public:
  explicit Process(pid_t pid) : pid_(pid) {}
  ~Process() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    while (waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Whether it has ended, and how.
  bool ended(int& status) {
    const pid_t got = waitpid(pid_, &status, WNOHANG);
    if (got < 0 && errno != EINTR) fail("waiting for a child");
    if (got <= 0) return false;
    pid_ = -1;
    return true;
  }

 private:
  pid_t pid_;
};

/// Which words tell of a lack of memory: ours, GMP's and MPFR's, and the standard library's.
bool tells_of_memory(const std::string& talk) {
  const auto holds = [&](const char* words) { return talk.find(words) != std::string::npos; };
  return holds("out of memory") || holds("annot allocate memory") || holds("bad_alloc") ||
         holds("MPFR: Can't allocate memory");
}

std::string last_line(std::string talk) {
  while (!talk.empty() && talk.back() == '\n') talk.pop_back();
  std::string line = talk.substr(talk.rfind('\n') + 1);
  const std::string prefix = "provis: error: ";
  return line.rfind(prefix, 0) == 0 ? line.substr(prefix.size()) : line;
}

}  // namespace

ChildEnd run_limited_child(const std::vector<std::string>& arguments, const Limits& limits,
                           const std::atomic<bool>* cancel) {
  std::vector<std::string> words = {"provis"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const Talk talk;
  const pid_t parent = getpid();
  const Clock::time_point start = Clock::now();
  const pid_t pid = fork();
  if (pid < 0) fail("starting a child");
  if (pid == 0) become(argv.data(), limits, parent, talk.file());

  Process process(pid);
  int status = 0;
  for (auto pause = std::chrono::milliseconds(1); !process.ended(status);
       pause = std::min(2 * pause, std::chrono::milliseconds(20))) {
    if (cancel != nullptr && cancel->load()) throw Error(Error::Code::cancelled, "", "interrupted");
    if (std::chrono::duration<double>(Clock::now() - start).count() > limits.seconds) {
      ChildEnd late;
      late.timed_out = true;
      return late;
    }
    std::this_thread::sleep_for(pause);
  }
  ChildEnd end;
  if (WIFEXITED(status)) end.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  const std::string said = talk.end();
  end.out_of_memory = (end.status != 0 || end.signal != 0) && tells_of_memory(said);
  end.complaint = last_line(said);
  return end;
}

}  // namespace provis
