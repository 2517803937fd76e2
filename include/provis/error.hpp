#pragma once
// What can go wrong, and the exit status it becomes.

#include <stdexcept>
#include <string>
#include <string_view>

namespace provis {

/// A failure with a code and a place; every function of the library throws this type and no other
/// (std::bad_alloc excepted).
class Error : public std::runtime_error {
 public:
  enum class Code {
    usage,          ///< an option or argument that makes no sense
    invalid_input,  ///< a file that cannot be read or is not what it says it is
    unsupported,    ///< valid, but outside what the program can do
    output,         ///< a result that could not be written
    guarantee,      ///< the asked guarantee was not reached
    rejected,       ///< a certificate that does not hold
    threshold,      ///< a score below what was asked
    internal,       ///< a broken invariant of certified code: never a wrong answer instead
    cancelled,      ///< interrupted by the caller
  };

  /// place: file, accessor, node, byte offset or option; may be empty
  Error(Code code, std::string place, const std::string& what)
      : std::runtime_error(place.empty() ? what : place + ": " + what),
        code_(code),
        place_(std::move(place)) {}

  Code code() const { return code_; }
  const std::string& place() const { return place_; }

 private:
  Code code_;
  std::string place_;
};

/// The exit status of the command line tool for a failure (0 is success).
constexpr int exit_status(Error::Code code) {
  switch (code) {
    case Error::Code::usage:
      return 1;
    case Error::Code::invalid_input:
      return 2;
    case Error::Code::unsupported:
      return 3;
    case Error::Code::output:
      return 4;
    case Error::Code::guarantee:
      return 5;
    case Error::Code::rejected:
      return 6;
    case Error::Code::threshold:
      return 7;
    case Error::Code::internal:
      return 70;
    case Error::Code::cancelled:
      return 130;
  }
  return 70;
}

}  // namespace provis
