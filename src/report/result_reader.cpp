// The reader of "provis.visible-set". Nothing is taken on trust: ids are in range and ascending, and
// the counts agree with them.

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "provis/error.hpp"
#include "provis/result_file.hpp"
#include "src/report/cell_query.hpp"
#include "src/report/json_node.hpp"
#include "src/report/names.hpp"
#include "src/report/result_keys.hpp"

namespace provis {

namespace {

// Each takes a byte of memory, and a short file can claim any number of hidden ones. The arrays of a scene
// of so many take 20 GB.
constexpr std::size_t most_primitives = std::size_t{1} << 29;

Frame frame(const JsonNode& node) {
  return {node.member("right").vec3(), node.member("up").vec3(), node.member("forward").vec3(),
          node.member("window").window()};
}

bool is_decimal_integer(const std::string& text) {
  const std::size_t first = !text.empty() && text[0] == '-' ? 1 : 0;
  return first < text.size() && text.find_first_not_of("0123456789", first) == std::string::npos;
}

Dyadic dyadic(const JsonNode& node) {
  const std::vector<JsonNode> n = node.items(2);
  if (!is_decimal_integer(n[0].text())) n[0].fail("is not a decimal integer");
  return {n[0].text(), static_cast<long>(n[1].integer())};
}

Vec3<Dyadic> dyadic3(const JsonNode& node) {
  const std::vector<JsonNode> n = node.items(3);
  return {dyadic(n[0]), dyadic(n[1]), dyadic(n[2])};
}

PrimitiveId id_below(const JsonNode& node, std::size_t count) {
  const std::uint64_t id = node.natural();
  if (id >= count) node.fail(fmt::format("is id {} in a scene of {} primitives", id, count));
  return static_cast<PrimitiveId>(id);
}

// Reads the raw array: a node with a place for each of a million ids would cost more than the parsing.
std::vector<PrimitiveId> ascending_ids(const JsonNode& node, std::size_t count) {
  if (!node.raw().is_array()) node.fail("is not an array");
  std::vector<PrimitiveId> ids;
  ids.reserve(node.raw().size());
  for (const nlohmann::json& item : node.raw()) {
    const bool good = item.is_number_unsigned() && item.get<std::uint64_t>() < count &&
                      (ids.empty() || ids.back() < item.get<std::uint64_t>());
    if (!good) {
      node.fail(fmt::format("entry {} ({}) is no id below {} above the one before it", ids.size(),
                            item.dump(), count));
    }
    ids.push_back(item.get<PrimitiveId>());
  }
  return ids;
}

/// Runs what checks a view; a complaint names the query.
template <class View>
void require_good(const View& view, const JsonNode& query) {
  try {
    check(view);
  } catch (const Error& error) {
    query.fail(error.what());
  }
}

int pixels(const JsonNode& node) {
  const std::uint64_t n = node.natural();
  if (n > 1 << 20) node.fail("is too large");
  return static_cast<int>(n);
}

SegmentQuery segments(const JsonNode& query) {
  SegmentQuery result;
  for (const JsonNode& item : query.member("frames").items()) result.frames.push_back(frame(item));
  const std::vector<JsonNode> size = query.member("pixels").items(2);
  result.pixels = {pixels(size[0]), pixels(size[1])};
  for (const JsonNode& item : query.member("segments").items()) {
    result.paths.push_back({item.member("from").vec3(), item.member("to").vec3()});
    require_good(result.view(result.paths.size() - 1), query);
  }
  if (result.paths.empty()) query.member("segments").fail("is empty");
  return result;
}

ViewCell view_cell(const JsonNode& query) {
  ViewCell result{query.member("lower").vec3(), query.member("upper").vec3(), {}};
  if (query.has("directions")) result.window = frame(query.member("directions"));
  require_good(result, query);
  return result;
}

CellCounts counts(const JsonNode& root, std::size_t primitives) {
  CellCounts result;
  result.unwitnessed = ascending_ids(root.member("unwitnessed"), primitives);
  const JsonNode node = root.member("stages");
  // A counter that did not exist when the file was written counted nothing.
  for (const CellCount& c : counts_of(result))
    if (node.has(c.name)) *c.value = node.member(c.name).natural();
  const JsonNode stats = root.member("stats");
  if (!stats.has("stages")) return result;
  for (const CellSeconds& s : seconds_of(result))
    if (stats.member("stages").has(s.name)) *s.value = stats.member("stages").member(s.name).number();
  return result;
}

PointView view(const JsonNode& query) {
  const auto projection = projection_named(query.member("projection").text());
  if (!projection) query.member("projection").fail("is no projection of this version");
  PointView view{query.member("eye").vec3(), *projection, {}};
  if (*projection == Projection::omni) {
    for (const JsonNode& item : query.member("frames").items()) view.frames.push_back(frame(item));
    if (view.frames.empty()) query.member("frames").fail("is empty");
  } else {
    view.frames.push_back(frame(query));
  }
  require_good(view, query);
  return view;
}

std::vector<LeftOut> left_out(const JsonNode& node) {
  std::vector<LeftOut> result;
  for (const JsonNode& item : node.items()) {
    result.push_back({item.member("place").text(), item.member("reason").text()});
  }
  return result;
}

ResultHeader header(const JsonNode& root) {
  const JsonNode scene = root.member("scene");
  ResultHeader header;
  header.scene_file = scene.member("file").text();
  header.scene_hash = scene.member("hash").text();
  header.triangles = scene.member("triangles").natural();
  header.spheres = scene.member("spheres").natural();
  const std::size_t most = std::numeric_limits<PrimitiveId>::max();
  if (header.triangles > most || header.spheres > most - header.triangles)
    scene.fail("holds too many primitives");
  if (scene.has("left_out")) header.left_out = left_out(scene.member("left_out"));
  const JsonNode query = root.member("query");
  const std::string& kind = query.member("kind").text();
  if (kind == "segment") {
    header.segments = segments(query);
    header.view = header.segments->first_view();
  } else if (kind == "cell") {
    header.cell = view_cell(query);
    header.view = center_view(*header.cell);
  } else if (kind == "point") {
    header.view = view(query);
  } else {
    query.member("kind").fail("is none of \"point\", \"segment\" and \"cell\"");
  }
  for (const auto& [key, value] : query.raw().items()) {
    if (!is_view_key(key)) header.options[key] = query.member(key).text();
  }
  return header;
}

std::vector<Witness> witnesses(const JsonNode& node, std::size_t count) {
  std::vector<Witness> result;
  for (const JsonNode& item : node.items()) {
    result.push_back({id_below(item.member("id"), count), dyadic3(item.member("origin")),
                      dyadic3(item.member("direction"))});
  }
  return result;
}

SubdivisionCell cell(const JsonNode& node, const ResultHeader& header) {
  SubdivisionCell cell;
  const std::uint64_t frame_index = node.member("frame").natural();
  if (frame_index >= header.view.frames.size()) node.member("frame").fail("is no frame of the query");
  cell.frame = static_cast<int>(frame_index);
  for (const JsonNode& corner : node.member("corners").items()) {
    const std::vector<JsonNode> n = corner.items(2);
    cell.corners.push_back({n[0].number(), n[1].number(), 0});
  }
  cell.area = node.member("area").text();
  cell.area_rounded = node.member("area_rounded").number();
  cell.visible = ascending_ids(node.member("visible"), header.triangles + header.spheres);
  return cell;
}

/// One for each visible primitive, in id order.
std::vector<Seen> seen(const JsonNode& node, const VisibleSet& set) {
  const std::vector<PrimitiveId> visible = set.with(Status::visible);
  const std::vector<JsonNode> items = node.items(visible.size());
  std::vector<Seen> result;
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (items[k].member("id").natural() != visible[k])
      items[k].member("id").fail(fmt::format("is not {}, the next visible id", visible[k]));
    result.push_back({visible[k], items[k].member("pixels").natural(), items[k].member("length").number()});
  }
  return result;
}

SamplingStats sampling(const JsonNode& node) {
  return {node.member("pixels").natural(), node.member("locations").natural(), node.member("most").natural()};
}

IterationStats iteration(const JsonNode& node) {
  IterationStats stats;
  stats.aggressive = node.member("aggressive").natural();
  stats.undecided = node.member("undecided").natural();
  stats.visible = node.member("visible").natural();
  stats.visible_after_first = node.member("visible_after_first").natural();
  stats.undecided_after_first = node.member("undecided_after_first").natural();
  stats.iterations = node.member("iterations").natural();
  stats.subtracted = node.member("subtracted").natural();
  stats.area = node.member("area").number();
  stats.area_missed = node.member("area_missed").number();
  return stats;
}

QueryStats stats(const JsonNode& node) {
  QueryStats stats;
  stats.seconds = node.member("seconds").number();
  stats.cpu_seconds = node.member("cpu_seconds").number();
  stats.threads = static_cast<int>(std::min<std::uint64_t>(node.member("threads").natural(), 1 << 30));
  stats.nodes = node.member("nodes").natural();
  stats.leaves = node.member("leaves").natural();
  stats.samples = node.member("samples").natural();
  stats.subtractions = node.member("subtractions").natural();
  if (node.has("peak_bytes")) stats.peak_bytes = node.member("peak_bytes").natural();
  for (int p = 0; p < predicate_count; ++p) {
    // A predicate that did not exist when the file was written decided nothing.
    if (!node.member("signs").has(name(static_cast<Predicate>(p)))) continue;
    const JsonNode row = node.member("signs").member(name(static_cast<Predicate>(p)));
    for (int t = 0; t < tier_count; ++t) {
      stats.signs.at(static_cast<Predicate>(p), static_cast<Tier>(t)) =
          row.member(name(static_cast<Tier>(t))).natural();
    }
    if (!row.has("wrong")) continue;
    stats.signs.wrong_of(static_cast<Predicate>(p)) = row.member("wrong").natural();
    stats.checked = true;
  }
  if (node.has("sampling")) stats.sampling = sampling(node.member("sampling"));
  if (node.has("iteration")) stats.iteration = iteration(node.member("iteration"));
  return stats;
}

void mark(const std::vector<PrimitiveId>& ids, Status status, const JsonNode& place,
          std::vector<Status>& all) {
  for (PrimitiveId id : ids) {
    if (all[id] != Status::hidden) place.fail(fmt::format("repeats id {} of another list", id));
    all[id] = status;
  }
}

void check_counts(const JsonNode& counts, std::size_t visible, std::size_t undecided, std::size_t total) {
  const auto agree = [&](const char* key, std::size_t listed) {
    if (counts.member(key).natural() != listed)
      counts.member(key).fail(fmt::format("is not {} as listed", listed));
  };
  agree("visible", visible);
  agree("undecided", undecided);
  agree("hidden", total - visible - undecided);
}

VisibleSet visible_set(const JsonNode& root, const ResultHeader& header) {
  const std::size_t count = header.triangles + header.spheres;
  VisibleSet set;
  set.status.assign(count, Status::hidden);
  const std::vector<PrimitiveId> visible = ascending_ids(root.member("visible"), count);
  const std::vector<PrimitiveId> undecided = ascending_ids(root.member("undecided"), count);
  mark(visible, Status::visible, root.member("visible"), set.status);
  mark(undecided, Status::undecided, root.member("undecided"), set.status);
  check_counts(root.member("counts"), visible.size(), undecided.size(), count);

  const auto guarantee = guarantee_named(root.member("guarantee").text());
  if (!guarantee) root.member("guarantee").fail("is no guarantee of this version");
  set.guarantee = *guarantee;
  set.answers = root.member("answers").text();
  set.eye_on_primitive = root.member("eye_on_primitive").boolean();
  if (root.has("witnesses")) set.witnesses = witnesses(root.member("witnesses"), count);
  if (root.has("subdivision")) {
    for (const JsonNode& item : root.member("subdivision").items()) {
      set.subdivision.push_back(cell(item, header));
    }
  }
  set.stats = stats(root.member("stats"));
  return set;
}

}  // namespace

ResultFile read_result(const std::filesystem::path& file) {
  const nlohmann::json json = parse_json_file(file.string());
  const JsonNode root(json, file.string());
  if (root.member("format").text() != result_format) {
    root.member("format").fail(fmt::format("is not \"{}\"", result_format));
  }
  const std::uint64_t version = root.member("version").natural();
  if (version != result_version) {
    throw Error(
        Error::Code::unsupported, file.string(),
        fmt::format("version {} of the format; this program reads version {}", version, result_version));
  }
  ResultFile result;
  result.header = header(root);
  const std::size_t primitives = result.header.triangles + result.header.spheres;
  if (primitives > most_primitives) {
    throw Error(Error::Code::unsupported, file.string(),
                fmt::format("a scene of {} primitives; this program reads results of up to {}", primitives,
                            most_primitives));
  }
  result.set = visible_set(root, result.header);
  if (result.header.cell) result.counts = counts(root, primitives);
  if (!result.header.segments && !root.has("boundary")) return result;
  result.boundary = ascending_ids(root.member("boundary"), primitives);
  for (const PrimitiveId id : result.boundary)
    if (result.set.status[id] != Status::visible)
      root.member("boundary").fail(fmt::format("holds id {}, which is not visible", id));
  if (root.has("seen")) result.seen = seen(root.member("seen"), result.set);
  return result;
}

}  // namespace provis
