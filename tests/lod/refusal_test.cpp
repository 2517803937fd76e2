// What is no level of detail is refused, by name.

#include <catch2/catch.hpp>
#include <cmath>

#include "predicates/formulas.hpp"
#include "provis/cell.hpp"
#include "provis/error.hpp"
#include "tests/lod/detail_case.hpp"
#include "tests/scene/files.hpp"
#include "tests/support/cells.hpp"

namespace provis::test {
namespace {

const SolidBox unit{{0, 0, 0}, {1, 1, 1}};

DetailSoup box_object(std::uint8_t flags = single_sided) {
  return {box_solid(unit), box_solid(unit), box_solid(unit), flags};
}

DetailCase one(const DetailSoup& object) {
  DetailCase c;
  add(c, "urn", object);
  return c;
}

/// What is said of it; empty where it is accepted.
std::string complaint(const DetailCase& c) {
  const Scene full(c.full.arrays), occluders(c.occluders), shell(c.shell);
  const Failure f = failure_of([&] {
    LevelOfDetail({&full, "full.ply"}, {&occluders, "inner.ply"}, {&shell, "outer.ply"}, c.objects,
                  one_thread());
  });
  if (f.status != 0) CHECK(f.status == exit_status(Error::Code::invalid_input));
  return f.message;
}

/// Moves all vertices at a place by one unit in the last place of one coordinate.
void nudge(SceneArrays& scene, const Vec3d& where, int axis, double towards) {
  for (Vec3d& p : scene.vertices)
    if (p == where) component(p, axis) = std::nextafter(component(p, axis), towards);
}

}  // namespace

TEST_CASE("a surface that is its own shell and its own occluder is accepted, whichever way its sides are") {
  CHECK(complaint(one(box_object())).empty());
  CHECK(complaint(one(box_object(0))).empty());
  DetailSoup turned = box_object(0);
  turned.full = reversed(turned.full);
  CHECK(complaint(one(turned)).empty());
}

TEST_CASE("a shell with a hole is refused") {
  DetailSoup s = box_object();
  s.shell.pop_back();
  const std::string what = complaint(one(s));
  CHECK_THAT(what, Catch::StartsWith("outer.ply: object \"urn\": its shell is no closed oriented surface"));
  s = box_object();
  std::swap(s.shell[3][0], s.shell[3][1]);
  CHECK_THAT(complaint(one(s)), Catch::Contains("its shell is no closed oriented surface"));
}

TEST_CASE("a full vertex that sticks out of its shell by one ulp is refused, and one that sticks in is not") {
  for (const double towards : {2.0, -2.0}) {
    DetailSoup s = box_object();
    s.occluders.clear();
    DetailCase c = one(s);
    nudge(c.full.arrays, {1, 1, 1}, 2, towards);
    if (towards > 1)
      CHECK_THAT(complaint(c),
                 Catch::Matches("full.ply: object \"urn\": id [0-9]+ is outside of the shell of "
                                "outer.ply near 0\\.9.*,0\\.9.*,1|full.ply: object \"urn\": id "
                                "[0-9]+ is outside of the shell of outer.ply near .*"));
    else
      CHECK(complaint(c).empty());
  }
}

TEST_CASE("an occluder that sticks out by one ulp is refused, and one that sticks in is not") {
  for (const std::uint8_t flags : {0, int(single_sided)})
    for (const double towards : {2.0, -2.0}) {
      DetailCase c = one(box_object(flags));
      nudge(c.occluders, {1, 1, 1}, 0, towards);
      if (towards > 1)
        CHECK_THAT(complaint(c),
                   Catch::StartsWith("inner.ply: object \"urn\": occluder ") &&
                       Catch::Contains("outside of what the opaque triangles of full.ply enclose"));
      else
        CHECK(complaint(c).empty());
    }
}

TEST_CASE("what occluders are inscribed to is closed, opaque and looks outwards") {
  DetailSoup open = box_object();
  open.full.pop_back();
  CHECK_THAT(
      complaint(one(open)),
      Catch::StartsWith("full.ply: object \"urn\": has occluders, but its opaque triangles are no closed"));
  DetailSoup glass = box_object(see_through);
  CHECK_THAT(complaint(one(glass)), Catch::Contains("occluder 0 is outside of what"));
  DetailSoup inwards = box_object();
  inwards.full = reversed(inwards.full);
  CHECK_THAT(complaint(one(inwards)), Catch::Contains("so their fronts must look outwards"));
  DetailSoup in_cavity = box_object();
  in_cavity.full =
      joined(box_solid({{-4, -4, -4}, {4, 4, 4}}), reversed(box_solid({{-1, -1, -1}, {2, 2, 2}})));
  in_cavity.shell = box_solid({{-4, -4, -4}, {4, 4, 4}});
  CHECK_THAT(complaint(one(in_cavity)), Catch::Contains("outside of what"));
  // A part of a face in which a larger occluder lies is missing: the rest covers most of it.
  DetailSoup dented = box_object();
  dented.full = joined(box_solid(unit), box_solid({{1, 0, 0}, {2, 1, 0.5}}));
  dented.occluders = {Corners{Vec3d{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}};
  dented.shell = box_solid({{0, 0, 0}, {2, 1, 1}});
  CHECK(complaint(one(dented)).empty());
  dented.occluders = {Corners{Vec3d{0, 0, 1}, {2, 0, 1}, {0, 1, 1}}};
  CHECK_THAT(complaint(one(dented)), Catch::Contains("occluder 0 is outside of what"));
}

TEST_CASE("vertices inside edges leave a surface closed") {
  Random random(5);
  DetailSoup s = box_object();
  s.full = box_solid(unit, 3, random);
  s.shell = box_solid(unit, 2, random);
  CHECK(complaint(one(s)).empty());
}

TEST_CASE("each primitive of shell and occluders belongs to one object") {
  DetailCase c = one(box_object());
  add(c, "vase", box_object());
  DetailCase twice = c;
  twice.objects[1].shell = {{11, 23}};
  CHECK(complaint(twice) == "outer.ply: object \"vase\": id 11 belongs to object \"urn\" too");
  DetailCase again = c;
  again.objects[1].full.push_back({14, 14});
  CHECK(complaint(again) == "full.ply: object \"vase\": id 14 is listed twice");
  DetailCase nobody = c;
  nobody.objects[0].shell = {{0, 10}};
  CHECK(complaint(nobody) == "outer.ply: id 11 belongs to no object");
  nobody = c;
  nobody.objects.pop_back();
  CHECK(complaint(nobody) == "inner.ply: id 12 belongs to no object");
  DetailCase beyond = c;
  beyond.objects[1].occluders = {{12, 24}};
  CHECK(complaint(beyond) == "inner.ply: object \"vase\": ids 12-24 in a scene of 24 primitives");
  DetailCase backwards = c;
  backwards.objects[1].occluders = {{23, 12}};
  CHECK(complaint(backwards) == "inner.ply: object \"vase\": ids 23-12 in a scene of 24 primitives");
  DetailCase bare = c;
  bare.objects[1].shell.clear();
  CHECK(complaint(bare) == "outer.ply: object \"vase\": has no shell");
  DetailCase empty = c;
  empty.objects[1].full.clear();
  CHECK(complaint(empty) == "full.ply: object \"vase\": has no primitives in the full scene");
}

TEST_CASE("a level of detail serves its own scene, where there is an upper set") {
  const DetailCase c = one(box_object());
  const Scene full(c.full.arrays), occluders(c.occluders), shell(c.shell);
  const LevelOfDetail detail({&full, ""}, {&occluders, ""}, {&shell, ""}, c.objects, one_thread());
  const ViewCell cell{{3, 3, 3}, {4, 4, 4}, {}};
  CellOptions o;
  o.detail = &detail;
  CHECK(failure_of([&] { visible_from_cell(Scene(), cell, o); }).status == 1);
  o.method = CellMethod::lower;
  CHECK(failure_of([&] { visible_from_cell(full, cell, o); }).status == 1);
  o.method = CellMethod::cos_exact;
  CHECK(failure_of([&] { visible_from_cell(full, cell, o); }).status == 1);
}

TEST_CASE("scenes with spheres have no level of detail") {
  const DetailCase c = one(box_object());
  SceneArrays with_sphere = c.shell;
  with_sphere.spheres = {{{0, 0, 0}, 1}};
  with_sphere.sphere_flags = {0};
  const Scene full(c.full.arrays), occluders(c.occluders), shell(with_sphere);
  CHECK(failure_of([&] {
          LevelOfDetail({&full, "f"}, {&occluders, "i"}, {&shell, "o"}, c.objects, one_thread());
        }).status == exit_status(Error::Code::unsupported));
}

}  // namespace provis::test
