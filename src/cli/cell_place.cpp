#include "src/cli/cell_place.hpp"

#include "provis/error.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/option_group.hpp"

namespace provis {

Vec3d CellPlace::middle() const { return parse_vec3("--center", center); }

/// One length for a cube, three for a box.
ViewCell CellPlace::cell() const {
  for (const auto& [option, text] : {std::pair("--center", center), {"--edge", edge}})
    if (text.empty()) throw Error(Error::Code::usage, option, "a cell needs --center and --edge");
  ViewCell cell;
  if (edge.find(',') != std::string::npos) {
    cell = cell_around(middle(), parse_vec3("--edge", edge));
  } else {
    const double a = parse_number("--edge", edge);
    cell = cell_around(middle(), {a, a, a});
  }
  check(cell);
  return cell;
}

void CellPlace::add_to(CLI::App& command) {
  const OptionGroup add(command, group);
  add("--center", center, "X,Y,Z", "Its middle, in scene units");
  add("--edge", edge, "A[,B,C]", "The length of its edges, or one for each axis; 0 makes it flat");
}

}  // namespace provis
