#pragma once
// The views that come with the shared scenes.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "provis/view.hpp"

namespace provis::test {

struct NamedView {
  std::string name;
  PointView view;
};

/// The views of one scene (file name with ending) in views.json beside it, in the file's order.
std::vector<NamedView> named_views(const std::filesystem::path& scene_file);

}  // namespace provis::test
