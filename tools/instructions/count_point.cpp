// A query for valgrind to count the instructions of; run says how.
//
// valgrind does sums and products rounded to nearest whatever the program asks for. The library notices and
// refuses to answer, rightly. Here nobody takes the answer: only the way to it is counted, and it hardly
// depends on the last bit of an interval. So this program, and no other, brings its own check of the
// environment, which finds no fault; the linker takes it in place of the library's.

#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "predicates/environment.hpp"
#include "provis/point.hpp"
#include "provis/scene.hpp"

namespace provis {

void check_environment() {}

bool rounds_up() { return true; }

namespace {

PointOptions options_named(const std::string& name) {
  PointOptions options;
  if (name == "exact-doubles") options.arithmetic = Arithmetic::doubles;
  if (name == "aggressive") options.method = Method::aggressive;
  if (name == "paper") options.engine = PointEngine::paper;
  return options;
}

int run(const std::string& file, const std::string& name) {
  LookAt camera;
  camera.eye = {-5.5, 1.7, 7.5};
  camera.direction = {0.65, 0.03, -1};
  Context context;
  context.threads = 1;
  const VisibleSet set = visible_from_point(load_scene(file), look_at(camera), options_named(name), context);
  std::cout << set.with(Status::visible).size() << " visible\n";
  return 0;
}

}  // namespace

}  // namespace provis

int main(int argc, char** argv) try {
  if (argc != 3) throw std::runtime_error("wanted: a scene and exact, exact-doubles, aggressive or paper");
  return provis::run(argv[1], argv[2]);
} catch (const std::exception& error) {
  std::cerr << "count_point: " << error.what() << "\n";
  return 1;
}
