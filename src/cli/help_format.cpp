#include "src/cli/help_format.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

namespace provis {

namespace {

constexpr std::size_t left_column = 32, page_width = 100;

// Breaks the text between words, so that no line is longer than the right column.
std::string wrapped(const std::string& text) {
  std::istringstream words(text);
  std::string line, result;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > page_width - left_column) {
      result += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return result + line;
}

class HelpFormat : public CLI::Formatter {
 public:
  HelpFormat() {
    column_width(left_column);
    label("SUBCOMMAND", "COMMAND");
    label("Positionals", "Arguments");
  }

  // The parser's library leaves two blank lines between groups.
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    std::string help = CLI::Formatter::make_help(app, name, mode);
    for (std::size_t at = 0; (at = help.find("\n\n\n", at)) != std::string::npos;) help.erase(at, 1);
    return help;
  }

  std::string make_option_opts(const CLI::Option* option) const override {
    std::string type = option->get_type_size() == 0 ? "" : option->get_type_name();
    // Where only certain words are taken, they follow a colon and an empty type.
    if (type.rfind(':', 0) == 0) type.erase(0, 1);
    return (type.empty() ? "" : " " + type) + (option->get_required() ? " (required)" : "");
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    return wrapped(option->get_description());
  }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_format() { return std::make_shared<HelpFormat>(); }

}  // namespace provis
