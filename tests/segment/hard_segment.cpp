#include "tests/segment/hard_segment.hpp"

#include "tests/support/hard_json.hpp"

namespace provis::test {

namespace {

using namespace hard_json;

/// Fills in what the query says.
void read_query(const Json& query, SegmentCase& c) {
  check_members(query, {"kind", "from", "to", "size", "frames"});
  if (query.at("kind") != "segment") throw std::runtime_error("the query's kind is not 'segment'");
  c.start.view.eye = vec3(query.at("from"));
  c.to = vec3(query.at("to"));
  for (const Json& f : query.at("frames")) c.start.view.frames.push_back(checked_frame(f));
  const Json& size = items(query.at("size"), 2);
  c.pixels = {size[0].get<int>(), size[1].get<int>()};
}

ExactSight sight(const Json& s, std::size_t count) {
  items(s, 3);
  ExactSight found{Rational(s[0].get<std::string>()), Rational(s[1].get<std::string>()), ids(s[2], count)};
  found.from.canonicalize();
  found.to.canonicalize();
  return found;
}

ExactSights sights(const Json& pixel, std::size_t count) {
  check_members(pixel, {"frame", "column", "row", "sights"});
  ExactSights found{
      pixel.at("frame").get<int>(), pixel.at("column").get<int>(), pixel.at("row").get<int>(), {}};
  for (const Json& s : pixel.at("sights")) found.sights.push_back(sight(s, count));
  return found;
}

HardSegment hard_segment(const std::string& name, const Json& file) {
  check_members(
      file, {"why", "because", "vertices", "triangles", "flags", "query", "visible", "boundary", "sights"});
  HardSegment c;
  c.why = file.at("why");
  c.because = file.at("because");
  c.input.start.name = name;
  c.input.start.arrays = scene(file);
  read_query(file.at("query"), c.input);
  const std::size_t count = c.input.start.arrays.triangles.size();
  c.answer = {ids(file.at("visible"), count), ids(file.at("boundary"), count), {}};
  for (const Json& pixel : file.at("sights")) c.answer.pixels.push_back(sights(pixel, count));
  return c;
}

}  // namespace

std::vector<HardSegment> load_hard_segments(const std::filesystem::path& folder) {
  return hard_json::load(folder, hard_segment);
}

std::string hard_table(const std::vector<HardSegment>& cases) {
  std::string table =
      "| case | why it is hard | triangles | visible | of these, boundary |\n"
      "| --- | --- | ---: | --- | --- |\n";
  for (const HardSegment& c : cases) {
    const std::string& name = c.input.start.name;
    table += "| [" + name + "](" + name + ".json) | " + c.why + " | " +
             std::to_string(c.input.start.arrays.triangles.size()) + " | " + ids_text(c.answer.visible) +
             " | " + (c.answer.boundary.empty() ? "" : ids_text(c.answer.boundary)) + " |\n";
  }
  return table;
}

}  // namespace provis::test
