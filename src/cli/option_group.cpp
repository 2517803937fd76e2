#include "src/cli/option_group.hpp"

#include <CLI/CLI.hpp>

namespace provis {

CLI::Option* OptionGroup::operator()(const char* option, std::string& value, const char* type,
                                     const char* help) const {
  return command_.add_option(option, value, help)->type_name(type)->group(name_);
}

void OptionGroup::operator()(const char* option, std::string& value, std::initializer_list<const char*> words,
                             const char* help) const {
  (*this)(option, value, "", help)
      ->check(CLI::IsMember(std::vector<std::string>(words.begin(), words.end())));
}

void OptionGroup::operator()(const char* option, bool& given, const char* help) const {
  command_.add_flag(option, given, help)->group(name_);
}

void exclude(CLI::Option* option, std::initializer_list<const char*> others) {
  for (const char* other : others) option->excludes(other);
}

}  // namespace provis
