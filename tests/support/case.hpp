#pragma once
// One test case: a scene, a view, and the text form in which a failing case is printed and replayed.

#include <cstdint>
#include <iosfwd>
#include <string>

#include "provis/scene.hpp"
#include "provis/view.hpp"

namespace provis::test {

/// A query to be answered by the engine and by the oracles.
struct Case {
  std::string name;        ///< the families and knobs that went into it
  std::uint64_t seed = 0;  ///< what generate() was given; 0 for cases made by hand
  SceneArrays arrays;      ///< triangles only
  PointView view;
};

/// Everything needed to replay a case: a headline with name and seed, then its text form.
std::string describe(const Case& c);

/// The text form: words and hexadecimal float64 numbers, so that it reads back bit for bit.
void write_text(std::ostream& out, const Case& c);

/// Reads the text form; throws std::runtime_error naming the word that does not fit.
Case read_text(std::istream& in);

}  // namespace provis::test
