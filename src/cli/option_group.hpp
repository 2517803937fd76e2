#pragma once
// Options that stand together in --help.

#include <initializer_list>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace provis {

/// Adds options whose values stay text until the command runs. Nothing that includes this needs CLI11.
class OptionGroup {
 public:
  OptionGroup(CLI::App& command, std::string name) : command_(command), name_(std::move(name)) {}

  /// type: how a value is written, for example "x,y,z".
  CLI::Option* operator()(const char* option, std::string& value, const char* type, const char* help) const;

  /// A value that is one of these words.
  void operator()(const char* option, std::string& value, std::initializer_list<const char*> words,
                  const char* help) const;

  /// Given or not.
  void operator()(const char* option, bool& given, const char* help) const;

 private:
  CLI::App& command_;
  std::string name_;
};

/// The option cannot stand beside any of the others.
void exclude(CLI::Option* option, std::initializer_list<const char*> others);

}  // namespace provis
