#include "tests/point/hard_case.hpp"

#include <stdexcept>

#include "tests/support/hard_json.hpp"

namespace provis::test {

namespace {

using namespace hard_json;

PointView view(const Json& query) {
  check_members(query, {"kind", "projection", "eye", "right", "up", "forward", "window"});
  if (query.at("kind") != "point") throw std::runtime_error("the query's kind is not 'point'");
  const std::string projection = query.at("projection");
  const Vec3d eye = vec3(query.at("eye"));
  if (projection == "omni") return omni(eye);
  if (projection != "pinhole" && projection != "parallel") {
    throw std::runtime_error("'" + projection + "' is no projection");
  }
  return {eye, projection == "pinhole" ? Projection::pinhole : Projection::parallel, {frame(query)}};
}

HardCase hard_case(const std::string& name, const Json& file) {
  check_members(file, {"why", "because", "vertices", "triangles", "flags", "query", "visible",
                       "eye_on_primitive", "doubles", "without_mpfr"});
  HardCase c;
  c.why = file.at("why");
  c.because = file.at("because");
  c.input = {name, 0, scene(file), view(file.at("query"))};
  const std::size_t count = c.input.arrays.triangles.size();
  c.visible = ids(file.at("visible"), count);
  c.eye_on_primitive = file.at("eye_on_primitive").get<bool>();
  if (file.contains("doubles")) c.doubles = ids(file["doubles"], count);
  c.without_mpfr = file.value("without_mpfr", "");
  return c;
}

}  // namespace

std::vector<HardCase> load_hard_cases(const std::filesystem::path& folder) {
  return hard_json::load(folder, hard_case);
}

std::string hard_table(const std::vector<HardCase>& cases) {
  std::string table =
      "| case | why it is hard | triangles | visible | doubles only |\n"
      "| --- | --- | ---: | --- | --- |\n";
  for (const HardCase& c : cases) {
    const std::string flag = c.eye_on_primitive ? " (eye on primitive)" : "";
    table += "| [" + c.input.name + "](" + c.input.name + ".json) | " + c.why + " | " +
             std::to_string(c.input.arrays.triangles.size()) + " | " + ids_text(c.visible) + flag + " | " +
             (c.doubles ? "**" + ids_text(*c.doubles) + "**" : "") + " |\n";
  }
  return table;
}

}  // namespace provis::test
