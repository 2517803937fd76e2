#include "src/cli/draw_epi.hpp"

#include <fmt/format.h>

#include "provis/error.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/option_group.hpp"
#include "src/report/names.hpp"

namespace provis {

namespace {

constexpr std::uint64_t most = 1 << 30;

std::uint64_t index(const char* option, const std::string& text) {
  return text.empty() ? 0 : parse_whole(option, text, 0, most);
}

void require_below(const char* option, std::uint64_t value, std::uint64_t count) {
  if (value >= count)
    throw Error(Error::Code::usage, option, fmt::format("the result has 0 to {}, got {}", count - 1, value));
}

/// The policy that a result was found by.
Arithmetic arithmetic_of(const ResultFile& result) {
  const auto stated = result.header.options.find("arithmetic");
  if (stated == result.header.options.end()) return Arithmetic::chain;
  return arithmetic_named(stated->second).value_or(Arithmetic::chain);
}

}  // namespace

PixelRow EpiOptions::place() const {
  return {static_cast<int>(index("--face", face)), static_cast<int>(index("--row", row))};
}

std::size_t EpiOptions::path() const { return index("--segment", segment); }

void EpiOptions::validate() const {
  if (file.empty()) {
    for (const auto& [option, text] : {std::pair("--row", row), {"--face", face}, {"--segment", segment}})
      if (!text.empty()) throw Error(Error::Code::usage, option, "is for --epi, which is not given");
    return;
  }
  if (row.empty()) throw Error(Error::Code::usage, "--epi", "shows one row of pixels: give --row, too");
  place();
  path();
}

void EpiOptions::check_against(const ResultFile& result, const std::string& result_file) const {
  if (!result.header.segments)
    throw Error(Error::Code::invalid_input, result_file, "--epi needs a result of 'provis segment'");
  if (result.header.options.contains("method"))
    throw Error(Error::Code::invalid_input, result_file,
                "single viewpoints saw this: it says nothing of the time between them");
  require_below("--segment", path(), result.header.segments->paths.size());
  require_below("--face", static_cast<std::uint64_t>(place().frame), result.header.segments->frames.size());
  require_below("--row", static_cast<std::uint64_t>(place().row),
                static_cast<std::uint64_t>(result.header.segments->pixels.height));
}

Image EpiOptions::picture(const Scene& scene, const ResultFile& result, const std::string& result_file,
                          const std::array<int, 2>& size, const Context& context) const {
  std::vector<PixelSights> pixels;
  SegmentOptions options;
  options.arithmetic = arithmetic_of(result);
  options.only = place();
  options.on_pixel = [&](const PixelSights& p) { pixels.push_back(p); };
  const SegmentSet seen = visible_from_segment(scene, result.header.segments->view(path()), options, context);
  for (const Seen& s : seen.seen)
    if (result.set.status[s.primitive] != Status::visible)
      throw Error(Error::Code::invalid_input, result_file,
                  fmt::format("does not hold primitive {}, which is seen in row {}", s.primitive, row));
  return draw_over_time(pixels, size[0], size[1]);
}

void EpiOptions::add_to(CLI::App& command) {
  const char* group = "A result along segments";
  const OptionGroup add(command, group);
  add("--epi", file, "FILE",
      "PNG to write: an epipolar-plane image, what one row of pixels sees over time. Columns are those of "
      "the "
      "row, time runs downwards; a colour per visible primitive, their mean where several are seen at once, "
      "grey for nothing");
  add("--row", row, "Y", "The row of pixels, 0 on top");
  add("--face", face, "F",
      "Through which frame: +x, -x, +y, -y, +z, -z of a cube are 0 to 5, those of the next of --runs 6 to 11 "
      "[0]");
  add("--segment", segment, "K", "Along which segment: the sides of --rect are 0 to 3 [0]");
}

}  // namespace provis
