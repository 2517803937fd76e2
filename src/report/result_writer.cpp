// The writer of "provis.visible-set": a stream of short pieces, so that memory does not grow with the
// text. The order of the members is fixed; two runs differ in "stats" only.

#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "provis/error.hpp"
#include "provis/result_file.hpp"
#include "src/report/cell_query.hpp"
#include "src/report/json_text.hpp"
#include "src/report/names.hpp"
#include "src/report/query_json.hpp"
#include "src/report/result_keys.hpp"
#include "src/scene/atomic_file.hpp"

namespace provis {

namespace {

using Json = nlohmann::ordered_json;

// JSON has no word for infinity: writing one would make a file that cannot be read back.
double finite(double value) {
  if (!std::isfinite(value)) throw Error(Error::Code::internal, "result file", "a number is not finite");
  return value;
}

Json json(const Vec3d& v) { return {finite(v.x), finite(v.y), finite(v.z)}; }

Json json(const Window& w) { return {finite(w.x0), finite(w.x1), finite(w.y0), finite(w.y1)}; }

Json json(const Frame& frame) {
  return {{"right", json(frame.right)},
          {"up", json(frame.up)},
          {"forward", json(frame.forward)},
          {"window", json(frame.window)}};
}

Json json(const Dyadic& number) { return Json::array({number.mantissa, number.exponent}); }

Json json(const Vec3<Dyadic>& v) { return Json::array({json(v.x), json(v.y), json(v.z)}); }

Json json(const Witness& witness) {
  return {
      {"id", witness.primitive}, {"origin", json(witness.origin)}, {"direction", json(witness.direction)}};
}

Json json(const Seen& seen) {
  return {{"id", seen.primitive}, {"pixels", seen.pixels}, {"length", finite(seen.length)}};
}

Json json(const SubdivisionCell& cell) {
  Json corners = Json::array();
  for (const Vec3d& corner : cell.corners) corners.push_back({finite(corner.x), finite(corner.y)});
  return {{"frame", cell.frame},
          {"corners", std::move(corners)},
          {"area", cell.area},
          {"area_rounded", finite(cell.area_rounded)},
          {"visible", cell.visible}};
}

}  // namespace

Json scene_json(const ResultHeader& header) {
  Json scene = {{"file", header.scene_file},
                {"hash", header.scene_hash},
                {"triangles", header.triangles},
                {"spheres", header.spheres}};
  if (!header.left_out.empty()) scene["left_out"] = left_out_json(header.left_out);
  return scene;
}

namespace {

Json json(const std::vector<Frame>& frames) {
  Json list = Json::array();
  for (const Frame& frame : frames) list.push_back(json(frame));
  return list;
}

Json point_json(const PointView& view) {
  if (view.frames.empty()) throw Error(Error::Code::internal, "result file", "a view without frames");
  Json query = {{"kind", "point"}, {"projection", name(view.projection)}, {"eye", json(view.eye)}};
  if (view.projection == Projection::omni) {
    query["frames"] = json(view.frames);
  } else {
    query.update(json(view.frames.front()));
  }
  return query;
}

Json cell_json(const ViewCell& cell) {
  Json query = {{"kind", "cell"}, {"lower", json(cell.lower)}, {"upper", json(cell.upper)}};
  if (cell.window) query["directions"] = json(*cell.window);
  return query;
}

Json segment_json(const SegmentQuery& segments) {
  Json paths = Json::array();
  for (const SegmentQuery::Path& p : segments.paths)
    paths.push_back({{"from", json(p.from)}, {"to", json(p.to)}});
  return {{"kind", "segment"},
          {"segments", std::move(paths)},
          {"frames", json(segments.frames)},
          {"pixels", {segments.pixels.width, segments.pixels.height}}};
}

Json counts_json(CellCounts counts) {
  Json all = Json::object();
  for (const CellCount& c : counts_of(counts)) all[std::string(c.name)] = *c.value;
  all["list_average"] = finite(counts.offset.list_average());
  return all;
}

Json seconds_json(CellCounts counts) {
  Json all = Json::object();
  for (const CellSeconds& s : seconds_of(counts)) all[std::string(s.name)] = finite(*s.value);
  return all;
}

}  // namespace

Json query_json(const ResultHeader& header) {
  Json query = header.segments ? segment_json(*header.segments)
               : header.cell   ? cell_json(*header.cell)
                               : point_json(header.view);
  for (const auto& [option, value] : header.options) {
    if (is_view_key(option)) throw Error(Error::Code::internal, "result file", "option named " + option);
    query[option] = value;
  }
  return query;
}

namespace {

Json json(const SignCounts& counts, bool checked) {
  Json table = Json::object();
  for (int p = 0; p < predicate_count; ++p) {
    Json& row = table[std::string(name(static_cast<Predicate>(p)))];
    for (int t = 0; t < tier_count; ++t) {
      row[std::string(name(static_cast<Tier>(t)))] =
          counts.at(static_cast<Predicate>(p), static_cast<Tier>(t));
    }
    if (checked) row["wrong"] = counts.wrong_of(static_cast<Predicate>(p));
  }
  return table;
}

Json json(const SamplingStats& stats) {
  return {{"pixels", stats.pixels}, {"locations", stats.locations}, {"most", stats.most}};
}

Json json(const IterationStats& stats) {
  return {{"aggressive", stats.aggressive},
          {"undecided", stats.undecided},
          {"visible", stats.visible},
          {"visible_after_first", stats.visible_after_first},
          {"undecided_after_first", stats.undecided_after_first},
          {"iterations", stats.iterations},
          {"subtracted", stats.subtracted},
          {"area", finite(stats.area)},
          {"area_missed", finite(stats.area_missed)}};
}

Json json(const QueryStats& stats) {
  Json all = {{"seconds", finite(stats.seconds)},
              {"cpu_seconds", finite(stats.cpu_seconds)},
              {"threads", stats.threads},
              {"nodes", stats.nodes},
              {"leaves", stats.leaves},
              {"samples", stats.samples},
              {"subtractions", stats.subtractions},
              {"signs", json(stats.signs, stats.checked)}};
  if (stats.sampling.pixels > 0) all["sampling"] = json(stats.sampling);
  if (stats.iteration.area > 0) all["iteration"] = json(stats.iteration);
  if (stats.peak_bytes > 0) all["peak_bytes"] = stats.peak_bytes;
  return all;
}

void write_member(std::ostream& out, const char* key, const Json& value) {
  out << ",\n\"" << key << "\": " << json_text(value);
}

// Twenty to a line: short enough to look at, and a million ids make no million lines.
void write_id_array(std::ostream& out, const char* key, const std::vector<PrimitiveId>& ids) {
  constexpr std::size_t per_line = 20;
  out << ",\n\"" << key << "\": [";
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (i > 0) out << (i % per_line == 0 ? ",\n" : ",");
    out << ids[i];
  }
  out << "]";
}

template <class Item>
void write_items(std::ostream& out, const char* key, const std::vector<Item>& items) {
  if (items.empty()) return;
  out << ",\n\"" << key << "\": [\n";
  for (std::size_t i = 0; i < items.size(); ++i) out << (i > 0 ? ",\n" : "") << json(items[i]).dump();
  out << "]";
}

}  // namespace

void write_result(const ResultFile& result, std::ostream& out) {
  const ResultHeader& header = result.header;
  const VisibleSet& set = result.set;
  const std::vector<PrimitiveId> visible = set.with(Status::visible);
  const std::vector<PrimitiveId> undecided = set.with(Status::undecided);

  out << "{\"format\": \"" << result_format << "\",\n\"version\": " << result_version;
  write_member(out, "program", {{"name", "provis"}, {"version", PROVIS_VERSION}});
  write_member(out, "scene", scene_json(header));
  write_member(out, "query", query_json(header));
  write_member(out, "answers", set.answers);
  write_member(out, "guarantee", name(set.guarantee));
  write_member(out, "counts",
               {{"visible", visible.size()},
                {"hidden", set.status.size() - visible.size() - undecided.size()},
                {"undecided", undecided.size()}});
  write_member(out, "eye_on_primitive", set.eye_on_primitive);
  write_id_array(out, "visible", visible);
  write_id_array(out, "undecided", undecided);
  if (header.segments || header.cell) write_id_array(out, "boundary", result.boundary);
  write_items(out, "seen", result.seen);
  if (result.counts) {
    write_id_array(out, "unwitnessed", result.counts->unwitnessed);
    write_member(out, "stages", counts_json(*result.counts));
  }
  write_items(out, "witnesses", set.witnesses);
  write_items(out, "subdivision", set.subdivision);
  Json stats = json(set.stats);
  if (result.counts) stats["stages"] = seconds_json(*result.counts);
  write_member(out, "stats", stats);
  out << "}\n";
}

void write_result(const ResultFile& result, const std::filesystem::path& file) {
  AtomicFile target(file);
  write_result(result, target.stream());
  target.commit();
}

void write_ids(const VisibleSet& set, std::ostream& out) {
  for (std::size_t id = 0; id < set.status.size(); ++id) {
    if (set.status[id] == Status::visible) out << id << '\n';
  }
}

void write_ids(const VisibleSet& set, const std::filesystem::path& file) {
  AtomicFile target(file);
  write_ids(set, target.stream());
  target.commit();
}

}  // namespace provis
