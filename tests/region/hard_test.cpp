// The engine on the catalogue of hard cells, along all axes and in all mirrors.

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include "provis/witness.hpp"
#include "tests/region/hard_cell.hpp"

namespace provis::test {
namespace {

using Ids = std::vector<PrimitiveId>;

const std::filesystem::path folder = PROVIS_SOURCE_DIR "/data/hard/cell";

const std::vector<HardCell>& catalogue() {
  static const std::vector<HardCell> cases = load_hard_cells(folder);
  return cases;
}

/// New coordinate k is old coordinate axes[k], negated where the sign is -1.
struct Turn {
  std::array<int, 3> axes{0, 1, 2};
  std::array<int, 3> signs{1, 1, 1};

  Vec3d operator()(const Vec3d& p) const {
    const double c[3] = {p.x, p.y, p.z};
    const auto at = [&](std::size_t k) { return signs[k] * c[axes[k]]; };
    return {at(0), at(1), at(2)};
  }
  bool mirrors() const {
    const Vec3d x = (*this)({1, 0, 0}), y = (*this)({0, 1, 0}), z = (*this)({0, 0, 1});
    return dot(cross(x, y), z) < 0;
  }
};

HardCell turned(HardCell c, const Turn& turn) {
  for (Vec3d& v : c.arrays.vertices) v = turn(v);
  if (turn.mirrors())
    for (Triangle& t : c.arrays.triangles) std::swap(t[1], t[2]);
  const Vec3d a = turn(c.cell.lower), b = turn(c.cell.upper);
  c.cell.lower = {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
  c.cell.upper = {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
  if (c.cell.window)
    for (Vec3d* v : {&c.cell.window->right, &c.cell.window->up, &c.cell.window->forward}) *v = turn(*v);
  return c;
}

std::vector<Turn> all_turns() {
  std::vector<Turn> turns;
  std::array<int, 3> axes{0, 1, 2};
  do
    for (int s = 0; s < 8; ++s) turns.push_back({axes, {s & 1 ? -1 : 1, s & 2 ? -1 : 1, s & 4 ? -1 : 1}});
  while (std::next_permutation(axes.begin(), axes.end()));
  return turns;
}

/// Effort: refinements, viewpoints, and directions of samples.
CellSet ask(const HardCell& c, CellMethod method, PixelGrid pixels = {8, 8}, int effort = 8) {
  CellOptions options;
  options.refinements = effort;
  options.viewpoints = effort;
  options.directions = effort / 2;
  options.method = method;
  options.pixels = pixels;
  Context context;
  context.threads = 1;
  return visible_from_cell(Scene(c.arrays), c.cell, options, context);
}

Ids without(const Ids& all, const Ids& taken) {
  Ids left;
  std::set_difference(all.begin(), all.end(), taken.begin(), taken.end(), std::back_inserter(left));
  return left;
}

}  // namespace

TEST_CASE("bounds give the expected answer of every hard cell, and witnesses that hold") {
  for (const HardCell& c : catalogue()) {
    INFO(c.name << ": " << c.because);
    const CellSet set = ask(c, CellMethod::bounds);
    CHECK(set.set.with(Status::undecided) == c.undecided);
    CHECK(set.set.with(Status::visible) == without(c.visible, c.undecided));
    CHECK(set.unwitnessed.empty());
    CHECK(verify_witnesses(Scene(c.arrays), c.cell, set) == set.set.witnesses.size());
  }
}

TEST_CASE("nothing that is visible is hidden along any axes and in any mirror, nor the other way round") {
  // 48 for each case, of which every run takes eight.
  const std::vector<Turn> turns = all_turns();
  std::size_t next = 0;
  for (const HardCell& original : catalogue())
    for (std::size_t k = 0; k < 8; ++k, next += 6) {
      const Turn& turn = turns[(next + next / turns.size()) % turns.size()];
      const HardCell c = turned(original, turn);
      INFO(c.name << ": " << c.because << "\naxes " << turn.axes[0] << turn.axes[1] << turn.axes[2]
                  << " signs " << turn.signs[0] << turn.signs[1] << turn.signs[2]);
      const Ids hidden = ask(c, CellMethod::cos, {2, 1}, 1).set.with(Status::hidden);
      CHECK(without(c.visible, hidden) == c.visible);
      CHECK(without(ask(c, CellMethod::lower, {1, 1}, 0).set.with(Status::visible), c.visible).empty());
    }
}

TEST_CASE("samples of hard cells show what they should, and prove no more than they can") {
  int asked = 0;
  for (const HardCell& c : catalogue()) {
    if (!c.samples) continue;
    ++asked;
    INFO(c.name << ": " << c.because);
    const CellSet set = ask(c, CellMethod::cos_exact, c.samples->pixels);
    CHECK(set.set.with(Status::visible) == c.samples->visible);
    CHECK(set.boundary == c.samples->boundary);
  }
  CHECK(asked >= 2);
}

TEST_CASE("the table of hard cells says what the files say") {
  std::ifstream in(folder / "README.md");
  std::ostringstream readme;
  readme << in.rdbuf();
  const std::string all = readme.str(), end = "\n\n" + hard_table(catalogue());
  INFO("data/hard/cell/README.md has to end with" << end);
  CHECK((all.size() > end.size() && all.compare(all.size() - end.size(), end.size(), end) == 0));
}

}  // namespace provis::test
