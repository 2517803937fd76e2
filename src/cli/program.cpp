#include "src/cli/program.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <utility>
#include <vector>

#include "provis/error.hpp"
#include "src/cli/help_format.hpp"

namespace provis {

namespace {

// A valid task that needs more memory than there is ends like any other that is out of reach.
constexpr int out_of_memory_status = exit_status(Error::Code::unsupported);

constexpr const char* description =
    "provis computes which primitives of a 3D scene are visible, and proves it.\n"
    "Coordinates are taken as exact; no sign that decides anything is rounded.";

constexpr const char* closing =
    "A first look at a scene, from 1.8 units above its origin:\n"
    "  provis info house.glb\n"
    "  provis point house.glb --eye 0,1.8,0 --dir 1,0,0 --out house.json\n"
    "  provis draw house.glb house.json --view-image view.png --above above.png\n\n"
    "Each command explains its options: provis point --help\n"
    "Lengths are scene units. Results go to standard output or to --out, talk to standard error.\n"
    "Exit status: 0 done; 1 wrong usage; 2 input unreadable or invalid; 3 valid but unsupported, or\n"
    "more than the memory holds; 4 output not written; 5 asked guarantee not reached; 70 internal\n"
    "error; 130 interrupted.";

class Program {
 public:
  Program() : app_(description, "provis") {
    app_.require_subcommand(1);
    app_.set_help_flag("-h,--help", "Print this help and exit");
    app_.set_version_flag("--version", std::string("provis ") + PROVIS_VERSION, "Print the version and exit");
    app_.formatter(help_format());
    app_.footer(closing);
    for (const auto add : {add_info, add_export, add_point, add_segment, add_cell, add_draw, add_accuracy}) {
      Action action = add(app_);
      CLI::App* command = app_.get_subcommands({}).back();
      command->group("Commands");
      actions_.emplace_back(command, std::move(action));
    }
  }

  // Returns false if help or the version was all that was wanted.
  bool parse(int argc, const char* const* argv) {
    require_known_command(argc, argv);
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) {
        app_.exit(error);
        return false;
      }
      throw Error(Error::Code::usage, "", error.what() + hint());
    }
    refuse_empty_values();
    return true;
  }

  void act(Run& run) const {
    for (const auto& [command, action] : actions_) {
      if (command->parsed()) action(run);
    }
  }

 private:
  // The parser would say "a subcommand is required" to anything mistaken in this place.
  void require_known_command(int argc, const char* const* argv) const {
    if (argc < 2) throw Error(Error::Code::usage, "", "no command given" + hint());
    const std::string word = argv[1];
    for (const char* option : {"-h", "--help", "--version"}) {
      if (word == option) return;
    }
    for (const auto& [command, action] : actions_) {
      if (command->get_name() == word) return;
    }
    throw Error(Error::Code::usage, word, "neither a command nor an option" + hint());
  }

  // An empty text stands for an option that was not given.
  void refuse_empty_values() const {
    for (const auto& [command, action] : actions_) {
      if (!command->parsed()) continue;
      for (const CLI::Option* option : command->get_options()) {
        for (const std::string& value : option->results()) {
          if (value.empty())
            throw Error(Error::Code::usage, option->get_name(), "has an empty value" + hint());
        }
      }
    }
  }

  std::string hint() const {
    for (const auto& [command, action] : actions_) {
      if (command->parsed()) return "; see provis " + command->get_name() + " --help";
    }
    return "; see provis --help";
  }

  CLI::App app_;
  std::vector<std::pair<CLI::App*, Action>> actions_;
};

int complain(const std::string& what, int status) {
  std::cerr << "provis: error: " << what << std::endl;
  return status;
}

}  // namespace

int run_program(int argc, const char* const* argv, Run& run) {
  try {
    Program program;
    if (program.parse(argc, argv)) program.act(run);
    return 0;
  } catch (const Error& error) {
    return complain(error.what(), exit_status(error.code()));
  } catch (const std::bad_alloc&) {
    return complain("out of memory while " + run.doing, out_of_memory_status);
  } catch (const std::exception& error) {
    return complain("internal error while " + run.doing + ": " + error.what(),
                    exit_status(Error::Code::internal));
  }
}

}  // namespace provis
