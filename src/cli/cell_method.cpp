#include "src/cli/cell_method.hpp"

#include "provis/error.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/common_options.hpp"
#include "src/cli/option_group.hpp"

namespace provis {

namespace {

constexpr std::uint64_t most_threads = 4096, most_viewpoints = 65536, most_directions = 256,
                        most_path_pixels = 1024, most_refinements = 32, most_per_axis = 100,
                        most_rays = 1'000'000;

int whole(const char* option, const std::string& text, std::uint64_t least, std::uint64_t most) {
  return static_cast<int>(parse_whole(option, text, least, most));
}

}  // namespace

void CellMethodOptions::validate() const {
  (void)options(1);
  (void)raster();
  (void)grid_number();
  for (const auto& [option, text] : {std::pair("--grid", grid), {"--size", size}})
    if (!sampled() && !text.empty())
      throw Error(Error::Code::usage, option, "goes with --method sampled only");
}

int CellMethodOptions::thread_count() const { return whole("--threads", threads, 0, most_threads); }

/// Each pixel of cos-exact is a query of its own.
std::string CellMethodOptions::cos_size_or_usual() const {
  if (!cos_size.empty()) return cos_size;
  return method == "cos-exact" ? "32x32" : "200x100";
}

std::array<int, 2> CellMethodOptions::raster() const {
  if (!sampled()) return parse_size("--cos-size", cos_size_or_usual());
  return size.empty() ? std::array{800, 800} : parse_size("--size", size);
}

int CellMethodOptions::grid_number() const {
  return grid.empty() ? 6 : whole("--grid", grid, 1, most_per_axis);
}

CellOptions CellMethodOptions::options(std::uint64_t seed) const {
  CellOptions o;
  o.method = method == "lower"       ? CellMethod::lower
             : method == "cos"       ? CellMethod::cos
             : method == "cos-exact" ? CellMethod::cos_exact
                                     : CellMethod::bounds;
  const auto [width, height] = parse_size("--cos-size", cos_size_or_usual());
  o.pixels = {width, height};
  o.refinements = whole("--refinements", refinements, 0, most_refinements);
  o.viewpoints = whole("--viewpoints", viewpoints, 0, most_viewpoints);
  o.path_pixels = whole("--path-pixels", path_pixels, 0, most_path_pixels);
  o.directions = whole("--directions", directions, 0, most_directions);
  o.rays = whole("--rays", rays, 0, most_rays);
  o.seed = seed;
  return o;
}

void CellMethodOptions::record(std::map<std::string, std::string>& recorded, std::uint64_t seed) const {
  recorded["method"] = method;
  if (sampled()) {
    const auto [width, height] = raster();
    recorded["size"] = std::to_string(width) + "x" + std::to_string(height);
    recorded["grid"] = std::to_string(grid_number());
    return;
  }
  recorded["cos-size"] = cos_size_or_usual();
  recorded["refinements"] = refinements;
  recorded["viewpoints"] = viewpoints;
  recorded["path-pixels"] = path_pixels;
  recorded["sample-directions"] = directions;
  recorded["rays"] = rays;
  recorded["viewpoint-seed"] = std::to_string(seed);
}

CellSet CellMethodOptions::answer(const Scene& scene, const ViewCell& cell, std::uint64_t seed,
                                  const LevelOfDetail* detail, const Context& context) const {
  if (!sampled()) {
    CellOptions exact = options(seed);
    exact.detail = detail;
    return visible_from_cell(scene, cell, exact, context);
  }
  const auto [width, height] = raster();
  return sampled_from_cell(scene, cell, grid_number(), {width, height}, context);
}

void CellMethodOptions::add_to(CLI::App& command) {
  const OptionGroup add(command, "How to compute");
  add("--method", method, {"bounds", "lower", "cos", "cos-exact", "sampled"},
      "'bounds', what is proven visible and what is not proven hidden; 'lower', only what is proven "
      "visible; 'cos', what the camera offset space does not prove hidden; 'cos-exact', what its samples "
      "show, one direction in the centre of each pixel, exactly; 'sampled', what is seen from a grid of "
      "viewpoints, in plain float64, for comparison only [bounds]");
  add("--cos-size", cos_size, "WxH",
      "Pixels of each raster of the camera offset space, five around each face, one with --dir; at most "
      "1024 each way: more hides more, and shows more with 'cos-exact' [200x100; 32x32 with "
      "'cos-exact']");
  add("--refinements", refinements, "N",
      "How often the rays of a pixel are halved where a triangle stays undecided, 0 to 32 [8]");
  add("--viewpoints", viewpoints, "N",
      "Exact sets from so many viewpoints, besides corners and middle, 0 to 65536 [32]");
  add("--path-pixels", path_pixels, "N",
      "Look continuously along the cell's edges and diagonals, at N^2 pixels of each frame, for 'bounds' and "
      "'lower', 0 to 1024 [16]");
  add("--directions", directions, "N",
      "Exact samples of the camera offset space for 'bounds' and 'lower', N^2 for each face of the cell, "
      "0 to 256 [4]");
  add("--rays", rays, "N",
      "For 'bounds': random rays aimed at each primitive that is undecided after all else, 0 to 1000000 "
      "[64]");
  add("--grid", grid, "N", "With --method sampled: N viewpoints along each axis, N^3 in all, 1 to 100 [6]");
  add("--size", size, "WxH",
      "With --method sampled: pixels of each of six frames, or of the one with --dir [800x800]");
  add_threads(add, threads);
}

}  // namespace provis
