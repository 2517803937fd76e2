#pragma once
// Results on disk: JSON of format "provis.visible-set", version 1 (schema in src/report/README.md).

#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

/// Everything a result file says besides the set itself.
struct ResultHeader {
  std::string scene_file;
  std::string scene_hash;
  std::size_t triangles = 0, spheres = 0;
  std::vector<LeftOut> left_out;  ///< of the file, because it was invalid
  PointView view;
  std::map<std::string, std::string> options;  ///< every option that can change the set, as given
};

struct ResultFile {
  ResultHeader header;
  VisibleSet set;
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
