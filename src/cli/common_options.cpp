#include "src/cli/common_options.hpp"

namespace provis {

void add_arithmetic(const OptionGroup& add, std::string& arithmetic, bool& check) {
  add("--arithmetic", arithmetic, {"chain", "doubles", "mpfr", "exact"},
      "How each comparison is computed: 'chain' is certain and fast, 'mpfr' and 'exact' are certain and "
      "slow, 'doubles' is sometimes wrong and for comparison only [chain]");
  add("--check", check,
      "With --arithmetic doubles: decide each comparison exactly too, and count those that were "
      "wrong; the answer is that of the doubles");
}

void add_threads(const OptionGroup& add, std::string& threads) {
  add("--threads", threads, "N", "Threads, 0 to 4096; 0 takes every core; never changes the answer [0]");
}

void add_out(const OptionGroup& add, std::string& out) {
  add("--out", out, "FILE", "Write the result as JSON, which 'provis draw' reads; '-' is standard output");
}

void add_ids(const OptionGroup& add, std::string& ids) {
  add("--ids", ids, "FILE", "Write one visible id per line, ascending; '-' is standard output");
}

void add_witness(const OptionGroup& add, bool& witness) {
  add("--witness", witness,
      "Add to the result a verified proof for each visible primitive: a ray that sees it");
}

void add_effects(const OptionGroup& add, bool& effects) {
  add("--effects", effects,
      "Print which effects of the scene the query simulates (culling, see-through surfaces, ...), "
      "and why");
}

}  // namespace provis
