// cell with a level of detail: the answer, what is recorded, and what is said of files that are none.

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "provis/result_file.hpp"
#include "tests/cli/child.hpp"
#include "tests/lod/solids.hpp"
#include "tests/report/schema.hpp"
#include "tests/scene/files.hpp"
#include "tests/scene/gltf_builder.hpp"

using namespace provis;
using namespace provis::test;

namespace {

/// Twelve triangles each.
SceneArrays boxes(const std::vector<SolidBox>& all) {
  SceneArrays scene;
  for (const SolidBox& box : all) add(scene, box_solid(box), 0);
  return scene;
}

const SolidBox wall{{-8, -8, -5}, {8, 8, -4}}, urn{{-1, -1, -9}, {1, 1, -7}};

/// Each box as a node of this name.
std::string gltf(const std::vector<std::pair<std::string, SolidBox>>& nodes) {
  GltfBuilder builder;
  for (const auto& [name, box] : nodes) {
    const SceneArrays scene = boxes({box});
    std::vector<float> positions;
    for (const Vec3d& p : scene.vertices)
      for (const double x : {p.x, p.y, p.z}) positions.push_back(static_cast<float>(x));
    std::vector<std::uint16_t> indices;
    for (const Triangle& t : scene.triangles)
      for (const std::uint32_t k : t) indices.push_back(static_cast<std::uint16_t>(k));
    const int mesh = builder.mesh(builder.positions(positions), {{"indices", builder.indices(indices)}});
    builder.root({{"name", name}, {"mesh", mesh}});
  }
  return builder.glb();
}

/// A wall and an urn behind it; the urn's shell is larger, and the wall's occluder smaller.
struct DetailRun {
  TempFolder directory;
  std::string full = write("full.ply", {wall, urn}),
              inner = write("inner.ply", {{{-8, -8, -4.75}, {8, 8, -4.25}}}),
              outer = write("outer.ply", {wall, {{-1.5, -1.5, -10}, {1.5, 1.5, -6}}}),
              map = write_map(
                  R"([{"name": "wall", "full": [[0, 11]], "occluders": [[0, 11]], "shell": [[0, 11]]},
                                  {"name": "urn", "full": [[12, 23]], "shell": [[12, 23]]}])");

  std::string path(const std::string& name) const { return (directory.path() / name).string(); }
  std::string write(const std::string& name, const std::vector<SolidBox>& all) const {
    export_ply(Scene(boxes(all)), path(name));
    return path(name);
  }
  std::string write_map(const std::string& objects) const {
    return directory
        .write("map.json", R"({"format": "provis.objects", "version": 1, "objects": )" + objects + "}")
        .string();
  }
  Outcome run(const Words& more = {}) const {
    return provis_run(Words{"cell", full, "--center", "0,0,0", "--edge", "0.5", "--occluders", inner,
                            "--shell", outer, "--objects", map} +
                      more);
  }
  /// Standard error of a run that must fail with status 2.
  std::string complaint(const std::string& objects) const {
    write_map(objects);
    const Outcome outcome = run();
    CHECK(outcome.status == 2);
    return outcome.err;
  }
};

}  // namespace

TEST_CASE("cell: with a level of detail the urn behind the wall is hidden, and the files are recorded") {
  for (const char* method : {"bounds", "cos"}) {
    const DetailRun query;
    const Outcome outcome = query.run({"--method", method, "--out", query.path("r.json")});
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const ResultFile result = read_result(query.path("r.json"));
    for (PrimitiveId id = 12; id < 24; ++id) CHECK(result.set.status[id] == Status::hidden);
    CHECK(result.set.with(Status::hidden).size() < 24);
    const auto& options = result.header.options;
    CHECK(options.at("occluders") == query.inner);
    CHECK(options.at("occluders-hash") == load_scene(query.inner).hash());
    CHECK(options.at("shell") == query.outer);
    CHECK(options.at("shell-hash") == load_scene(query.outer).hash());
    CHECK(options.at("objects") == query.map);
    CHECK(options.at("objects-hash").size() == 64);
    REQUIRE(result.counts);
    const DetailStats& counts = result.counts->detail;
    CHECK(counts.objects == 2);
    CHECK(counts.candidates == 1);
    CHECK(counts.whole == 0);
    CHECK(counts.dropped == 0);
    CHECK(counts.triangles > 12);
    CHECK(counts.seconds_verification > 0);
    const Json schema =
        Json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/src/report/visible-set.schema.json"));
    CHECK(schema_violations(schema, Json::parse(read_text(query.path("r.json")))).empty());
    const Outcome told = query.run({"--method", method, "--stats"});
    CHECK_THAT(told.out, Catch::Contains("objects    1 of 2 hidden") &&
                             Catch::Contains("detail_candidates") && Catch::Contains("verification"));
  }
}

TEST_CASE("cell: the bundled level of detail is one, and hides nothing that is proven visible") {
  const TempFolder directory;
  const std::string bundled = PROVIS_SOURCE_DIR "/data/detail/",
                    file = (directory.path() / "r.json").string();
  const auto result = [&](const Words& more) {
    const Outcome outcome = provis_run(
        Words{"cell", bundled + "street.ply", "--center", "0,1.7,0", "--edge", "0.3", "--out", file} + more);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return read_result(file);
  };
  const ResultFile hidden =
      result({"--method", "cos", "--cos-size", "16x16", "--occluders", bundled + "inner.ply", "--shell",
              bundled + "outer.ply", "--objects", bundled + "objects.json"});
  CHECK(hidden.counts->detail.objects == 80);
  CHECK(hidden.counts->detail.candidates < 40);
  const ResultFile seen = result({"--method", "lower", "--viewpoints", "2"});
  CHECK(seen.set.with(Status::visible).size() > 100);
  for (const PrimitiveId id : seen.set.with(Status::visible)) CHECK(hidden.set.status[id] != Status::hidden);
}

TEST_CASE("cell: objects may be named by the nodes of glTF files") {
  DetailRun q;
  q.full = q.directory.write("full.glb", gltf({{"urn", urn}, {"wall", wall}})).string();
  q.outer = q.directory.write("outer.glb", gltf({{"box", wall}, {"box", urn}})).string();
  q.write_map(R"([{"name": "both", "full": ["wall", "0"], "occluders": [[0, 11]], "shell": ["box"]}])");
  const Outcome outcome = q.run({"--out", q.path("r.json")});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(read_result(q.path("r.json")).counts->detail.candidates == 1);
  const auto objects = [](const std::string& shell) {
    return R"([{"name": "both", "full": ["wall", "urn"], "shell": [")" + shell + "\"]}]";
  };
  CHECK_THAT(q.complaint(objects("lid")), Catch::Contains(q.map + ": objects[0].shell[0]: in " + q.outer) &&
                                              Catch::Contains("no node has that name"));
  CHECK_THAT(q.complaint(objects("0")), Catch::Contains(q.inner + ": id 0 belongs to no object"));
}

TEST_CASE("cell: the hash of the map is that of the file's bytes") {
  const DetailRun query;
  std::ofstream(query.map, std::ios::app) << "\n";
  REQUIRE(query.run({"--out", query.path("a.json")}).status == 0);
  const std::string before = read_result(query.path("a.json")).header.options.at("objects-hash");
  std::ofstream(query.map, std::ios::app) << " ";
  REQUIRE(query.run({"--out", query.path("a.json")}).status == 0);
  CHECK(read_result(query.path("a.json")).header.options.at("objects-hash") != before);
}

TEST_CASE("cell: what is no level of detail is refused, naming file, object and id") {
  const DetailRun q;
  const std::string good_wall =
      R"({"name": "wall", "full": [[0, 11]], "occluders": [[0, 11]], "shell": [[0, 11]]})";
  const auto with = [&](const std::string& second) { return "[" + good_wall + ", " + second + "]"; };
  CHECK_THAT(q.complaint("[" + good_wall + "]"), Catch::Contains(q.outer + ": id 12 belongs to no object"));
  CHECK_THAT(q.complaint(with(R"({"name": "urn", "full": [[11, 23]], "shell": [[12, 23]]})")),
             Catch::Contains(q.full + ": object \"urn\": id 11 belongs to object \"wall\" too"));
  CHECK_THAT(q.complaint(with(R"({"name": "urn", "full": [[12, 24]], "shell": [[12, 23]]})")),
             Catch::Contains(q.full + ": object \"urn\": ids 12-24 in a scene of 24 primitives"));
  CHECK_THAT(q.complaint(with(R"({"name": "urn", "full": [[12, 23]]})")),
             Catch::Contains(q.outer + ": object \"urn\": has no shell"));
  CHECK_THAT(q.complaint(with(R"({"name": "urn", "full": [[12, 23]], "shell": ["lid"]})")),
             Catch::Contains(q.map + ": objects[1].shell[0]: in " + q.outer) && Catch::Contains("no nodes"));
  CHECK_THAT(q.complaint(with(R"({"name": "urn", "full": [[12, 23]], "shel": []})")),
             Catch::Contains(q.map + ": objects[1]: has a member \"shel\""));
  CHECK_THAT(q.complaint(with(R"({"name": "urn", "full": [12], "shell": [[12, 23]]})")),
             Catch::Contains(q.map + ": objects[1].full[0]: is not an array"));
  CHECK_THAT(q.complaint(with(R"({"full": [[12, 23]], "shell": [[12, 23]]})")),
             Catch::Contains("has no member \"name\""));
  CHECK_THAT(q.complaint(R"([{"name": "urn", "full": [[12, 23]], "occluders": [[0, 11]], "shell": [[12, 23]]},
                      {"name": "wall", "full": [[0, 11]], "shell": [[0, 11]]}])"),
             Catch::Contains(q.inner + ": object \"urn\": occluder 0 is outside"));
  CHECK_THAT(q.complaint(R"([{"name": "wall", "full": [[0, 11]], "occluders": [[0, 11]], "shell": [[12, 23]]},
                             {"name": "urn", "full": [[12, 23]], "shell": [[0, 11]]}])"),
             Catch::Contains(q.full + ": object \"wall\": id 0 is outside of the shell of " + q.outer));
  CHECK_THAT(q.complaint("[], \"more\": 1"), Catch::Contains("belongs to no object"));
}

TEST_CASE("cell: the options of a level of detail belong together, and to methods with an upper set") {
  const DetailRun q;
  const Words query{"cell", q.full, "--center", "0,0,0", "--edge", "0.5"};
  const Outcome lone = provis_run(query + Words{"--shell", q.outer});
  CHECK(lone.status == 1);
  CHECK_THAT(lone.err, Catch::Contains("--occluders, --shell and --objects belong together"));
  CHECK(q.run({"--method", "lower"}).status == 1);
  CHECK(q.run({"--method", "cos-exact"}).status == 1);
  CHECK(provis_run(query + Words{"--occluders", q.inner, "--shell", q.outer, "--objects", q.path("none")})
            .status == 2);
}
