#pragma once
// Results on disk: JSON of format "provis.visible-set", version 1 (schema in src/report/README.md).

#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "provis/cell.hpp"
#include "provis/scene.hpp"
#include "provis/segment.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

/// A query along segments: all of them through the same frames.
struct SegmentQuery {
  struct Path {
    Vec3d from, to;
  };
  std::vector<Path> paths;  ///< one or more; the answer is the union
  std::vector<Frame> frames;
  PixelGrid pixels;

  /// Path k as the engine is asked about it.
  SegmentView view(std::size_t k) const { return {paths[k].from, paths[k].to, frames, pixels}; }
  /// The first viewpoint, and the frames that it looks through: six that make a sphere, or the first.
  PointView first_view() const;
};

/// Everything a result file says besides the set itself.
struct ResultHeader {
  std::string scene_file;
  std::string scene_hash;
  std::size_t triangles = 0, spheres = 0;
  std::vector<LeftOut> left_out;               ///< of the file, because it was invalid
  PointView view;                              ///< of other queries: a viewpoint to draw from
  std::optional<SegmentQuery> segments;        ///< of such a query only: view is first_view()
  std::optional<ViewCell> cell;                ///< of such a query only: view is center_view()
  std::map<std::string, std::string> options;  ///< every option that can change the set, as given
};

/// The view from the middle of the cell, rounded.
PointView center_view(const ViewCell& cell);

/// How the answer for a cell was found.
struct CellCounts {
  std::vector<PrimitiveId> unwitnessed;  ///< as in CellSet
  BoundStats bounds;
  OffsetStats offset;
  DetailStats detail;
};

struct ResultFile {
  ResultHeader header;
  VisibleSet set;
  std::vector<PrimitiveId> boundary;  ///< as in SegmentSet
  std::vector<Seen> seen;             ///< likewise
  std::optional<CellCounts> counts;   ///< of a query from a cell
};

/// Writes the result; float64 numbers read back bit for bit.
///
/// Throws:     Error::output; no partial file is left behind
void write_result(const ResultFile& result, const std::filesystem::path& file);

/// The same text to a stream; whether it arrived is the stream's state.
void write_result(const ResultFile& result, std::ostream& out);

/// Throws:     Error::invalid_input naming the place, Error::unsupported for another version
ResultFile read_result(const std::filesystem::path& file);

/// One visible id per line, ascending.
///
/// Throws:     Error::output; no partial file is left behind
void write_ids(const VisibleSet& set, const std::filesystem::path& file);

/// The same text to a stream; whether it arrived is the stream's state.
void write_ids(const VisibleSet& set, std::ostream& out);

}  // namespace provis
