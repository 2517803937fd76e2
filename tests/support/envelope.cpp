#include "tests/support/envelope.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace provis::test {

namespace {

using Clock = std::chrono::steady_clock;

/// A running child whose standard input and output are one socket. Ends with the object.
class Child {
 public:
  explicit Child(const char* program);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// A child that dies early is noticed when its answer is read, so a failed write is no error here.
  void write(const std::string& text);

  /// Everything the child writes until it ends its output; nothing if that takes longer than allowed.
  std::optional<std::string> read_until(Clock::time_point deadline);

 private:
  int socket_ = -1;
  pid_t pid_ = -1;
};

Child::Child(const char* program) {
  if (access(program, X_OK) != 0) {
    throw std::runtime_error(std::string(program) + " is missing: build the target envelope_child");
  }
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::runtime_error("no socket pair");
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("fork failed");
  if (pid_ == 0) {
    dup2(ends[1], STDIN_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    close(STDERR_FILENO);  // CGAL reports each failed assertion there; the exit status says enough
    execl(program, program, static_cast<char*>(nullptr));
    _exit(127);
  }
  close(ends[1]);
  socket_ = ends[0];
}

Child::~Child() {
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
  close(socket_);
}

void Child::write(const std::string& text) {
  std::size_t sent = 0;
  while (sent < text.size()) {
    const ssize_t n = send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (n <= 0) break;
    sent += static_cast<std::size_t>(n);
  }
  shutdown(socket_, SHUT_WR);
}

std::optional<std::string> Child::read_until(Clock::time_point deadline) {
  std::string text;
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd ready{socket_, POLLIN, 0};
    if (left <= 0 || poll(&ready, 1, static_cast<int>(left)) <= 0) return {};
    char buffer[4096];
    const ssize_t n = recv(socket_, buffer, sizeof buffer, 0);
    if (n <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

EnvelopeOpinion parse(const std::string& text) {
  std::istringstream words(text);
  std::string word;
  words >> word;
  EnvelopeOpinion opinion;
  if (word == "refused") {
    std::getline(words >> std::ws, opinion.reason);
    return opinion;
  }
  opinion.outcome = EnvelopeOpinion::answered;
  for (PrimitiveId id = 0; words >> id;) opinion.visible.push_back(id);
  words.clear();
  // The closing word tells a complete answer from one cut short by a crash.
  if (words >> word && word == "end") return opinion;
  return {EnvelopeOpinion::crashed, {}, "the child failed before its answer was complete"};
}

}  // namespace

EnvelopeOpinion ask_envelope(const Case& c, int limit_seconds) {
  const Clock::time_point deadline = Clock::now() + std::chrono::seconds(limit_seconds);
  std::ostringstream text;
  write_text(text, c);
  Child child(PROVIS_ENVELOPE_CHILD);
  child.write(text.str());
  const std::optional<std::string> answer = child.read_until(deadline);
  if (!answer) return {EnvelopeOpinion::crashed, {}, "out of time"};
  return parse(*answer);
}

}  // namespace provis::test
