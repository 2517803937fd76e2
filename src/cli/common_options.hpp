#pragma once
// Options that mean the same in several commands.

#include <string>

#include "src/cli/option_group.hpp"

namespace provis {

/// --arithmetic and --check.
void add_arithmetic(const OptionGroup& add, std::string& arithmetic, bool& check);
void add_threads(const OptionGroup& add, std::string& threads);

void add_out(const OptionGroup& add, std::string& out);
void add_ids(const OptionGroup& add, std::string& ids);
void add_witness(const OptionGroup& add, bool& witness);
void add_effects(const OptionGroup& add, bool& effects);

}  // namespace provis
