// provis info: what a scene holds, what its queries will have to simulate, and where its primitives are from.

#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <limits>

#include "provis/error.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/option_group.hpp"
#include "src/cli/output.hpp"
#include "src/cli/run.hpp"
#include "src/cli/scene_options.hpp"
#include "src/report/scene_report.hpp"
#include "src/report/source_report.hpp"

namespace provis {

namespace {

struct InfoCommand {
  SceneOptions source;
  std::string id, node;
  bool json = false;

  void add_to(CLI::App& command);
  void run(Run& run) const;

 private:
  void print_scene(const Scene& scene, const LoadCost& cost, Run& run) const;
  void print_source(const Scene& scene) const;
  void print_ids(const Scene& scene) const;
  PrimitiveId id_number() const;
};

/// The largest part of the memory that the program has held at any time.
std::size_t peak_resident_bytes() {
  constexpr std::size_t unit = 1024;  // Linux counts in KiB
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * unit;
}

PrimitiveId InfoCommand::id_number() const {
  return static_cast<PrimitiveId>(
      parse_whole("--source", id, 0, std::numeric_limits<PrimitiveId>::max() - 1));
}

void InfoCommand::run(Run& run) const {
  source.validate();
  if (!id.empty()) id_number();
  if (!id.empty() && !node.empty()) {
    throw Error(Error::Code::usage, "--ids-of", "--source asks something else: give one of the two");
  }
  const auto begin = std::chrono::steady_clock::now();
  const Scene scene = source.load(run);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const LoadCost cost{seconds.count(), peak_resident_bytes()};
  if (!id.empty()) return print_source(scene);
  if (!node.empty()) return print_ids(scene);
  print_scene(scene, cost, run);
}

void InfoCommand::print_scene(const Scene& scene, const LoadCost& cost, Run& run) const {
  SceneInfo info;
  info.file = source.file;
  info.options = source.recorded();
  info.cost = cost;
  run.stage("counting what " + source.file + " holds");
  info.counts = summarize(scene, run.context);
  info.topology = topology(scene, run.context);
  info.effects = plan_effects(scene, Projection::pinhole);
  if (!json) return print(scene_text(scene, info));
  Output out("-");
  write_scene_json(scene, info, out.stream());
  out.commit();
}

void InfoCommand::print_source(const Scene& scene) const {
  print(json ? source_json(source.file, scene, id_number()) : source_text(source.file, scene, id_number()));
}

void InfoCommand::print_ids(const Scene& scene) const {
  const std::vector<int> nodes = nodes_called(scene, node);
  if (nodes.size() > 1) {
    std::cerr << fmt::format("provis: note: {} nodes are called \"{}\": {}\n", nodes.size(), node,
                             fmt::join(nodes, ", "));
  }
  if (ids_of_nodes(scene, nodes).empty()) {
    std::cerr << fmt::format("provis: note: node {} holds no primitives of its own\n",
                             fmt::join(nodes, ", "));
  }
  print(json ? node_ids_json(source.file, scene, nodes) : node_ids_text(ids_of_nodes(scene, nodes)));
}

void InfoCommand::add_to(CLI::App& command) {
  source.add_to(command);
  const OptionGroup ask(command, "What to tell");
  ask("--source", id, "ID",
      "Tell only where primitive ID came from: node, mesh, primitive and element of a glTF file, row "
      "of a PLY file; and its corners, or its centre and radius");
  ask("--ids-of", node, "NODE",
      "Tell only the ids of a glTF node, by its number in the file or its exact name, one "
      "'first-last' to a line, without those of nodes below it; of several nodes of one name, the "
      "ids of all");
  ask("--json", json, "JSON instead of text");
  command.footer(
      "An open edge belongs to one triangle only; a duplicate has the three corners of an earlier triangle.\n"
      "Positions are compared exactly, and triangles of zero area are passed over.\n\n"
      "Examples:\n"
      "  provis info house.glb\n"
      "  provis info house.glb --source 17\n"
      "  provis info house.glb --ids-of door");
}

}  // namespace

Action add_info(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("info", "Print what a scene holds: counts, extent, holes, materials, hash");
  const auto options = std::make_shared<InfoCommand>();
  options->add_to(*command);
  return [options](Run& run) { options->run(run); };
}

}  // namespace provis
