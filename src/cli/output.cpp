#include "src/cli/output.hpp"

#include <iostream>

#include "provis/error.hpp"
#include "src/scene/atomic_file.hpp"

namespace provis {

Output::Output(const std::string& name) {
  if (name != "-") file_ = std::make_unique<AtomicFile>(name);
}

Output::~Output() = default;
Output::Output(Output&&) noexcept = default;

std::ostream& Output::stream() { return file_ ? file_->stream() : std::cout; }

void Output::commit() {
  if (file_) {
    file_->commit();
  } else if (!std::cout.flush()) {
    throw Error(Error::Code::output, "standard output", "cannot be written");
  }
}

void print(const std::string& text) {
  Output out("-");
  out.stream() << text;
  out.commit();
}

void say(const std::string& text, bool result_on_stdout) {
  if (result_on_stdout)
    std::cerr << text;
  else
    print(text);
}

}  // namespace provis
