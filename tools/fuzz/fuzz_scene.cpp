// Any bytes as a scene file: they load, or end in an Error of the statuses that a file can cause.

#include <cstdlib>
#include <iostream>

#include "provis/error.hpp"
#include "provis/scene.hpp"
#include "src/scene/scene_source.hpp"

namespace provis {
namespace {

/// Different files try different options; the same file always the same ones.
LoadOptions options_for(ByteSpan file) {
  std::uint32_t hash = 2166136261u;
  for (const std::uint8_t byte : file) hash = (hash ^ byte) * 16777619u;
  LoadOptions options;
  if ((hash >> 8) % 2 == 0) options.time = 0.25 * static_cast<double>((hash >> 9) % 8);
  if ((hash >> 12) % 2 == 0) options.radius = 0.5;
  options.skip_invalid = (hash >> 13) % 2 == 0;
  return options;
}

bool may_end_so(const Error& error) {
  return error.code() == Error::Code::invalid_input || error.code() == Error::Code::unsupported ||
         error.code() == Error::Code::usage;
}

}  // namespace
}  // namespace provis

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace provis;
  const ByteSpan file(data, size);
  try {
    summarize(Scene(load_source(file, "/nonexistent", options_for(file)).arrays));
  } catch (const Error& error) {
    if (may_end_so(error)) return 0;
    std::cerr << error.what() << '\n';
    std::abort();
  }
  return 0;
}
