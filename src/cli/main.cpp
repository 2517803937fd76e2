#include "src/cli/program.hpp"
#include "src/cli/signals.hpp"

int main(int argc, char** argv) {
  provis::Run run;
  run.context.cancel = &provis::catch_interrupts();
  return provis::run_program(argc, argv, run);
}
