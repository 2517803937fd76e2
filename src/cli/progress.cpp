#include "src/cli/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace provis {

std::string progress_text(const Progress& progress, double seconds) {
  const double share = progress.total > 0 ? std::clamp(progress.done / progress.total, 0.0, 1.0) : 1;
  std::string text = fmt::format("{:.1f} %", 100 * share);
  if (share > 0 && seconds > 0) {
    const double rate = share / seconds;
    text += fmt::format(", {:.1f} %/s, {:.0f} s left", 100 * rate, (1 - share) / rate);
  }
  return text;
}

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  if (shown_ > 0) fmt::print(stderr, "\r{:{}}\r", "", shown_);
}

void ProgressLine::show(const Progress& progress) {
  constexpr std::chrono::milliseconds interval(200);
  const Clock::time_point now = Clock::now();
  if (!terminal_ || now < next_) return;
  next_ = now + interval;
  const std::string text = progress_text(progress, std::chrono::duration<double>(now - start_).count());
  shown_ = std::max(shown_, text.size());
  fmt::print(stderr, "\r{:<{}}", text, shown_);
  std::fflush(stderr);
}

}  // namespace provis
