// Writes a generated scene of about a given number of triangles as PLY; README.md describes them.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <map>

#include "src/scene/atomic_file.hpp"
#include "tools/scenes/generators.hpp"

namespace provis::scenes {

namespace {

struct Kind {
  void (*generate)(Mesh&, std::uint64_t);
  double unit;
};

const std::map<std::string, Kind> kinds = {{"city", {city, city_unit}},
                                           {"grass", {grass, grass_unit}},
                                           {"dense_grass", {dense_grass, grass_unit}},
                                           {"forest", {forest, forest_unit}},
                                           {"closed_mesh", {closed_mesh, closed_mesh_unit}},
                                           {"soup", {soup, soup_unit}}};

int run(int argc, char** argv) {
  CLI::App app("Writes a generated scene as PLY: the same file on every machine.", "make_scene");
  std::string kind, out;
  std::uint64_t triangles = 1'000'000;
  bool rotate = false;
  std::vector<std::string> names;
  for (const auto& [name, entry] : kinds) names.push_back(name);
  app.add_option("kind", kind, "Which scene")->required()->check(CLI::IsMember(names));
  app.add_option("out", out, "The file")->required();
  app.add_option("--triangles", triangles, "About how many [1000000]")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1'000'000'000}));
  app.add_flag("--rotate", rotate, "Turn everything by 0.1 rad about y, rounded to float64");
  CLI11_PARSE(app, argc, argv);

  const Kind& entry = kinds.at(kind);
  const std::string comment =
      fmt::format("make_scene {} --triangles {}{}", kind, triangles, rotate ? " --rotate" : "");
  AtomicFile file(out);
  write_ply(file.stream(), [&](Mesh& mesh) { entry.generate(mesh, triangles); },
            {entry.unit, rotate, comment});
  file.commit();
  return 0;
}

}  // namespace

}  // namespace provis::scenes

int main(int argc, char** argv) try {
  return provis::scenes::run(argc, argv);
} catch (const std::exception& e) {
  std::cerr << "make_scene: error: " << e.what() << "\n";
  return 1;
}
