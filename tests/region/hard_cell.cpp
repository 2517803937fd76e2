#include "tests/region/hard_cell.hpp"

#include "tests/support/hard_json.hpp"

namespace provis::test {

namespace {

using namespace hard_json;

ViewCell view_cell(const Json& query) {
  check_members(query, {"kind", "lower", "upper", "directions"});
  if (query.at("kind") != "cell") throw std::runtime_error("the query's kind is not 'cell'");
  ViewCell cell{vec3(query.at("lower")), vec3(query.at("upper")), {}};
  if (query.contains("directions")) cell.window = checked_frame(query.at("directions"));
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
  return hard_json::load(folder, hard_cell);
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
