#include "src/report/summary.hpp"

#include <fmt/format.h>

#include <iterator>

#include "src/report/names.hpp"

namespace provis {

std::string options_text(const std::map<std::string, std::string>& options) {
  std::string line;
  for (const auto& [option, value] : options) {
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", option, value);
  }
  return line;
}

std::array<std::uint64_t, tier_count> by_tier(const SignCounts& signs) {
  std::array<std::uint64_t, tier_count> sums{};
  for (const auto& row : signs.decided) {
    for (std::size_t t = 0; t < row.size(); ++t) sums[t] += row[t];
  }
  return sums;
}

namespace {

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string text(const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

std::string signs_text(const SignCounts& signs) {
  const auto sums = by_tier(signs);
  std::uint64_t total = 0;
  for (std::uint64_t sum : sums) total += sum;
  std::string line = fmt::format("{}", total);
  for (std::size_t t = 0; t < sums.size(); ++t) {
    line += fmt::format("{} {} {:.4g} %", t == 0 ? ":" : ",", name(static_cast<Tier>(t)),
                        percent(sums[t], total));
  }
  return line;
}

std::string wrong_text(const SignCounts& signs) {
  std::uint64_t total = 0;
  for (std::uint64_t count : signs.wrong) total += count;
  std::string line = fmt::format("{} of these signs", total);
  const char* separator = ": ";
  for (int p = 0; p < predicate_count; ++p) {
    const auto predicate = static_cast<Predicate>(p);
    if (signs.wrong_of(predicate) == 0) continue;
    line += fmt::format("{}{} {}", separator, name(predicate), signs.wrong_of(predicate));
    separator = ", ";
  }
  return line;
}

}  // namespace

std::string sampling_text(const QueryStats& stats) {
  std::string text;
  auto out = std::back_inserter(text);
  if (const SamplingStats& s = stats.sampling; s.pixels > 0) {
    fmt::format_to(out, "sampling   {:.4g} locations per pixel, at most {}\n",
                   static_cast<double>(s.locations) / static_cast<double>(s.pixels), s.most);
  }
  if (const IterationStats& s = stats.iteration; s.area > 0) {
    fmt::format_to(out, "aggressive {:.4g} % of the set, {:.6g} % of the image\n",
                   percent(s.aggressive, s.visible), 100 * (1 - s.area_missed / s.area));
    fmt::format_to(out, "first      {:.4g} % of the set visible, {:.4g} % of the rest decided\n",
                   percent(s.visible_after_first, s.visible),
                   percent(s.undecided - s.undecided_after_first, s.undecided));
    fmt::format_to(out, "iterations {}, {} decided by subtraction\n", s.iterations, s.subtracted);
  }
  return text;
}

std::string query_text(const PointView& view) {
  if (view.projection == Projection::omni) return fmt::format("omni from {}", text(view.eye));
  const Frame& frame = view.frames.front();
  const Window& w = frame.window;
  return fmt::format("{} from {} along {}, window {:.6g},{:.6g},{:.6g},{:.6g}", name(view.projection),
                     text(view.eye), text(frame.forward), w.x0, w.x1, w.y0, w.y1);
}

std::string query_text(const SegmentQuery& segments) {
  const std::size_t n = segments.frames.size(), paths = segments.paths.size();
  return fmt::format("segment from {} to {}{}, {} frame{} of {}x{} pixels", text(segments.paths.front().from),
                     text(segments.paths.front().to),
                     paths == 1 ? "" : fmt::format(" and {} more", paths - 1), n, n == 1 ? "" : "s",
                     segments.pixels.width, segments.pixels.height);
}

std::string query_text(const ViewCell& cell) {
  std::string line = fmt::format("cell from {} to {}", text(cell.lower), text(cell.upper));
  if (cell.window) line += fmt::format(", along {}", text(cell.window->forward));
  return line;
}

std::string query_text(const ResultHeader& header) {
  if (header.segments) return query_text(*header.segments);
  return header.cell ? query_text(*header.cell) : query_text(header.view);
}

namespace {

std::string cell_text(const CellCounts& counts, Guarantee guarantee) {
  const BoundStats& b = counts.bounds;
  const OffsetStats& o = counts.offset;
  if (guarantee == Guarantee::sampled)
    return fmt::format("sampled    {} viewpoints; nothing is proven\n", b.viewpoints_used);
  const DetailStats& d = counts.detail;
  const std::string detail =
      d.objects == 0
          ? ""
          : fmt::format("objects    {} of {} hidden; the cell reaches into {}, occluders of {} dropped\n",
                        d.objects - d.candidates, d.objects, d.whole, d.dropped);
  return fmt::format(
             "proven by  {} from {} viewpoints, then {} along {} paths, then {} at {} samples, {} by rays; "
             "{} meet the "
             "cell, {} "
             "without a witness\n"
             "offsets    {} lists, {} entries, {:.4g} on average, at most {}; {} refinements\n",
             b.viewpoints, b.viewpoints_used, b.paths, b.paths_used, b.samples, b.samples_used, b.rays,
             b.touching, counts.unwitnessed.size(), o.lists, o.list_entries, o.list_average(), o.list_most,
             o.refined) +
         detail;
}

}  // namespace

std::string summary(const ResultFile& result) {
  const ResultHeader& header = result.header;
  const VisibleSet& set = result.set;
  const QueryStats& stats = set.stats;
  const std::size_t visible = set.with(Status::visible).size();
  const std::size_t undecided = set.with(Status::undecided).size();
  const std::size_t total = set.status.size();
  std::string text;
  auto out = std::back_inserter(text);
  fmt::format_to(out, "scene      {} ({} triangles, {} spheres)\n", header.scene_file, header.triangles,
                 header.spheres);
  if (!header.left_out.empty()) {
    fmt::format_to(out, "left out   {} invalid primitives\n", header.left_out.size());
  }
  fmt::format_to(out, "hash       {}\n", header.scene_hash);
  fmt::format_to(out, "query      {}\n", query_text(header));
  fmt::format_to(out, "options    {}\n", options_text(header.options));
  fmt::format_to(out, "visible    {} ({:.4g} %)\n", visible, percent(visible, total));
  if (header.segments || !result.boundary.empty())
    fmt::format_to(out, "boundary   {} of them\n", result.boundary.size());
  fmt::format_to(out, "hidden     {}\n", total - visible - undecided);
  fmt::format_to(out, "undecided  {}\n", undecided);
  if (result.counts) text += cell_text(*result.counts, set.guarantee);
  fmt::format_to(out, "guarantee  {}, answers {}{}\n", name(set.guarantee), set.answers,
                 set.eye_on_primitive ? ", eye-on-primitive" : "");
  fmt::format_to(out, "time       {:.3f} s on {} thread{} ({:.3f} s of CPU)\n", stats.seconds, stats.threads,
                 stats.threads == 1 ? "" : "s", stats.cpu_seconds);
  text += sampling_text(stats);
  fmt::format_to(out, "signs      {}\n", signs_text(stats.signs));
  if (stats.checked) fmt::format_to(out, "wrong      {}\n", wrong_text(stats.signs));
  if (!set.witnesses.empty()) fmt::format_to(out, "witnesses  {}\n", set.witnesses.size());
  if (!set.subdivision.empty()) fmt::format_to(out, "cells      {}\n", set.subdivision.size());
  return text;
}

std::string memory_text(const QueryStats& stats) {
  if (stats.peak_bytes == 0) return "";
  return fmt::format("memory     {:.1f} MiB at the peak, beyond the scene\n",
                     static_cast<double>(stats.peak_bytes) / (1 << 20));
}

std::string sign_table(const SignCounts& signs) {
  std::string text = fmt::format("{:<14}", "predicate");
  auto out = std::back_inserter(text);
  for (int t = 0; t < tier_count; ++t) fmt::format_to(out, "{:>14}", name(static_cast<Tier>(t)));
  for (int p = 0; p < predicate_count; ++p) {
    fmt::format_to(out, "\n{:<14}", name(static_cast<Predicate>(p)));
    for (int t = 0; t < tier_count; ++t) {
      fmt::format_to(out, "{:>14}", signs.at(static_cast<Predicate>(p), static_cast<Tier>(t)));
    }
  }
  fmt::format_to(out, "\n{:<14}", "all");
  for (std::uint64_t sum : by_tier(signs)) fmt::format_to(out, "{:>14}", sum);
  return text + "\n";
}

}  // namespace provis
