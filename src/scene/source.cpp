#include "provis/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "provis/error.hpp"

namespace provis {
namespace {

[[noreturn]] void fail_usage(const std::string& place, const std::string& what) {
  throw Error(Error::Code::usage, place, what);
}

std::string id_range(const Scene& scene) {
  const std::size_t count = scene.primitive_count();
  return count == 0 ? "the scene has no primitives" : fmt::format("ids go from 0 to {}", count - 1);
}

}  // namespace

std::optional<PrimitiveSource> source_of(const Scene& scene, PrimitiveId id) {
  if (id >= scene.primitive_count()) fail_usage(fmt::format("id {}", id), id_range(scene));
  if (scene.sources().empty()) return std::nullopt;
  const auto after = std::ranges::upper_bound(scene.sources(), id, {}, &SourceRange::first);
  const SourceRange& run = *(after - 1);
  const std::uint32_t rank = id - run.first;
  return PrimitiveSource{run.node,
                         run.mesh,
                         run.primitive,
                         run.instance,
                         run.element + rank / run.per_element,
                         rank % run.per_element,
                         run.per_element};
}

std::vector<IdRange> ids_of_nodes(const Scene& scene, const std::vector<int>& nodes) {
  std::vector<IdRange> ranges;
  for (const SourceRange& run : scene.sources()) {
    if (run.count == 0 || std::ranges::find(nodes, run.node) == nodes.end()) continue;
    const PrimitiveId last = run.first + (run.count - 1);
    if (!ranges.empty() && ranges.back().last + 1 == run.first)
      ranges.back().last = last;
    else
      ranges.push_back({run.first, last});
  }
  return ranges;
}

std::vector<int> nodes_called(const Scene& scene, const std::string& index_or_name) {
  const auto names = scene.node_names();
  if (names.empty()) fail_usage("node " + index_or_name, "the file has no nodes");
  std::size_t index = 0;
  const char* end = index_or_name.data() + index_or_name.size();
  const auto [stop, error] = std::from_chars(index_or_name.data(), end, index);
  if (!index_or_name.empty() && stop == end) {
    if (error == std::errc() && index < names.size()) return {static_cast<int>(index)};
    fail_usage("node " + index_or_name, fmt::format("nodes go from 0 to {}", names.size() - 1));
  }
  std::vector<int> nodes;
  for (std::size_t n = 0; n < names.size(); ++n)
    if (names[n] == index_or_name) nodes.push_back(static_cast<int>(n));
  if (nodes.empty()) fail_usage(fmt::format("node \"{}\"", index_or_name), "no node has that name");
  return nodes;
}

}  // namespace provis
