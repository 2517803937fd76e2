// Prints a scene and a view as the text that tests/support/envelope_child reads, for CGAL's lower_envelope_3.

#include <fstream>
#include <stdexcept>

#include "tests/support/case.hpp"
#include "tools/bench/child.hpp"

int main(int argc, char** argv) {
  provis::bench::Child child("bench_case");
  std::string out;
  child.options().add_option("--out", out, "The file")->required();
  return child.run(argc, argv, [&](const provis::bench::Child& c) {
    provis::test::Case text;
    text.arrays = c.scene().arrays();
    text.view = c.view();
    std::ofstream file(out);
    write_text(file, text);
    if (!file.flush()) throw std::runtime_error(out + " cannot be written");
    return nlohmann::json::object();
  });
}
