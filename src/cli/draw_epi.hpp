#pragma once
// The picture of `provis draw` for results along segments: a row of pixels over time.

#include <array>
#include <string>

#include "provis/context.hpp"
#include "provis/draw.hpp"
#include "provis/result_file.hpp"

namespace CLI {
class App;
}

namespace provis {

struct EpiOptions {
  std::string file, row, face, segment;

  void add_to(CLI::App& command);

  /// Throws Error::usage where options do without what they need.
  void validate() const;

  /// Throws:     Error::invalid_input where the result says nothing of a row over time, Error::usage where it
  ///             has no such row
  void check_against(const ResultFile& result, const std::string& result_file) const;

  /// Resolves the row again, as the result was found.
  ///
  /// Requires:   validate, check_against
  /// Throws:     Error::invalid_input where a pixel sees what the result does not hold
  Image picture(const Scene& scene, const ResultFile& result, const std::string& result_file,
                const std::array<int, 2>& size, const Context& context) const;

 private:
  PixelRow place() const;
  std::size_t path() const;
};

}  // namespace provis
