#pragma once
// Options that stand together in --help.

#include <CLI/CLI.hpp>
#include <string>

namespace provis {

/// Adds options whose values stay text until the command runs.
class OptionGroup {
 public:
  OptionGroup(CLI::App& command, std::string name) : command_(command), name_(std::move(name)) {}

  CLI::Option* operator()(const char* option, std::string& value, const char* type, const char* help) const {
    return command_.add_option(option, value, help)->type_name(type)->group(name_);
  }

 private:
  CLI::App& command_;
  std::string name_;
};

}  // namespace provis
