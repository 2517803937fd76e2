#include "src/cli/detail_options.hpp"

#include "provis/error.hpp"
#include "src/cli/object_map.hpp"
#include "src/cli/option_group.hpp"
#include "src/cli/run.hpp"
#include "src/scene/file_bytes.hpp"
#include "src/scene/scene_hash.hpp"

namespace provis {

namespace {

std::unique_ptr<const Scene> load_as(const SceneOptions& source, const std::string& file, Run& run) {
  SceneOptions other = source;
  other.file = file;
  auto scene = std::make_unique<const Scene>(other.load(run));
  warn_of_left_out(*scene, file);
  return scene;
}

std::string hash_of(const std::string& file) {
  try {
    return bytes_hash(read_file(file));
  } catch (const Error& error) {
    throw Error(error.code(), file, error.what());
  }
}

}  // namespace

void DetailOptions::add_to(CLI::App& command) {
  const OptionGroup add(command, group);
  add("--occluders", occluders, "FILE",
      "A scene of simple meshes inside of the full ones, to hide with in their place; loaded with the "
      "options "
      "of the full scene, and verified exactly. With --shell and --objects");
  add("--shell", shell, "FILE",
      "A scene of simple closed meshes around the full ones: what is behind the occluders with all of its "
      "shell is hidden");
  add("--objects", objects, "FILE",
      "Which primitives of the three scenes are one object: JSON {\"format\": \"provis.objects\", "
      "\"version\": "
      "1, \"objects\": [{\"name\": \"urn\", \"full\": [\"urn\"], \"occluders\": [[0, 11]], \"shell\": [[12, "
      "23]]}, ...]}, of node names and ranges of ids, both ends included");
}

void DetailOptions::validate(const std::string& method) const {
  if (occluders.empty() && shell.empty() && objects.empty()) return;
  for (const auto& [option, value] :
       {std::pair("--occluders", occluders), {"--shell", shell}, {"--objects", objects}})
    if (value.empty())
      throw Error(Error::Code::usage, option, "--occluders, --shell and --objects belong together");
  if (method != "bounds" && method != "cos")
    throw Error(Error::Code::usage, "--shell", "has a meaning only with --method bounds or cos");
}

std::optional<LoadedDetail> DetailOptions::load(const SceneOptions& source, const Scene& full,
                                                Run& run) const {
  if (shell.empty()) return std::nullopt;
  auto inner = load_as(source, occluders, run), outer = load_as(source, shell, run);
  const DetailScene three[] = {{&full, source.file}, {inner.get(), occluders}, {outer.get(), shell}};
  run.stage("reading " + objects);
  const std::string hash = hash_of(objects);
  const std::vector<DetailObject> map = read_object_map(objects, three[0], three[1], three[2]);
  run.stage("verifying the level of detail");
  LevelOfDetail detail(three[0], three[1], three[2], map, run.context);
  return LoadedDetail{std::move(inner), std::move(outer), hash, std::move(detail)};
}

void DetailOptions::state(const LoadedDetail& loaded, std::map<std::string, std::string>& options) const {
  options["occluders"] = occluders;
  options["occluders-hash"] = loaded.occluders->hash();
  options["shell"] = shell;
  options["shell-hash"] = loaded.shell->hash();
  options["objects"] = objects;
  options["objects-hash"] = loaded.objects_hash;
}

}  // namespace provis
