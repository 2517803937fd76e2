#include "tests/region/hard_cell.hpp"

#include <algorithm>
#include <fstream>

#include "tests/support/hard_json.hpp"

namespace provis::test {

namespace {

using namespace hard_json;

Frame frame(const Json& f) {
  check_members(f, {"right", "up", "forward", "window"});
  const Json& w = items(f.at("window"), 4);
  return {vec3(f.at("right")),
          vec3(f.at("up")),
          vec3(f.at("forward")),
          {number(w[0]), number(w[1]), number(w[2]), number(w[3])}};
}

ViewCell view_cell(const Json& query) {
  check_members(query, {"kind", "lower", "upper", "directions"});
  if (query.at("kind") != "cell") throw std::runtime_error("the query's kind is not 'cell'");
  ViewCell cell{vec3(query.at("lower")), vec3(query.at("upper")), {}};
  if (query.contains("directions")) cell.window = frame(query.at("directions"));
  return cell;
}

HardCell::Samples samples(const Json& s, std::size_t count) {
  check_members(s, {"size", "visible", "boundary"});
  const Json& size = items(s.at("size"), 2);
  return {
      {size[0].get<int>(), size[1].get<int>()}, ids(s.at("visible"), count), ids(s.at("boundary"), count)};
}

HardCell hard_cell(const std::string& name, const Json& file) {
  check_members(
      file, {"why", "because", "vertices", "triangles", "flags", "query", "visible", "undecided", "samples"});
  HardCell c;
  c.name = name;
  c.why = file.at("why");
  c.because = file.at("because");
  c.arrays = scene(file);
  c.cell = view_cell(file.at("query"));
  const std::size_t count = c.arrays.triangles.size();
  c.visible = ids(file.at("visible"), count);
  c.undecided = ids(file.value("undecided", Json::array()), count);
  if (file.contains("samples")) c.samples = samples(file.at("samples"), count);
  return c;
}

}  // namespace

std::vector<HardCell> load_hard_cells(const std::filesystem::path& folder) {
  std::vector<HardCell> cases;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    try {
      std::ifstream in(entry.path());
      cases.push_back(hard_cell(entry.path().stem().string(), Json::parse(in)));
    } catch (const std::exception& e) {
      throw std::runtime_error(entry.path().string() + ": " + e.what());
    }
  }
  std::sort(cases.begin(), cases.end(), [](const HardCell& a, const HardCell& b) { return a.name < b.name; });
  return cases;
}

std::string hard_table(const std::vector<HardCell>& cases) {
  std::string table =
      "| case | why it is hard | triangles | visible | left undecided |\n"
      "| --- | --- | ---: | --- | --- |\n";
  for (const HardCell& c : cases)
    table += "| [" + c.name + "](" + c.name + ".json) | " + c.why + " | " +
             std::to_string(c.arrays.triangles.size()) + " | " + ids_text(c.visible) + " | " +
             (c.undecided.empty() ? "" : ids_text(c.undecided)) + " |\n";
  return table;
}

}  // namespace provis::test
