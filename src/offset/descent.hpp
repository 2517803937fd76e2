#pragma once
// One raster of a face, halved until what it may show is decided.

#include <array>
#include <span>
#include <vector>

#include "provis/cell.hpp"
#include "src/offset/resolver.hpp"

namespace provis::offset {

/// One face with everything that its rasters share.
struct Outlook {
  Face face;
  Facets facets;
  Mesh mesh;
  OffsetStats stats;

  Outlook(const Scene& scene, const Seams& seams, const Face& f)
      : face(f), facets(facets_of(scene, seams, face)), mesh(facets.all, seams) {
    stats.facing_unknown = facets.facing_unknown;
  }
};

/// Halves one raster down to its pixels, and what is left undecided there some times more.
class Descent {
 public:
  Descent(const Outlook& outlook, const Raster& raster, std::vector<char> wanted, int refinements,
          const Context& context)
      : outlook_(outlook),
        raster_(raster),
        shafts_(raster.frame),
        resolver_(outlook.facets.all, outlook.mesh, shafts_),
        wanted_(std::move(wanted)),
        reached_(wanted_.size(), 0),
        refinements_(refinements),
        context_(context) {}

  void run();

  const std::vector<char>& reached() const { return reached_; }
  const OffsetStats& stats() const { return stats_; }

 private:
  /// Pixels of the raster, from the first up to the last.
  struct Block {
    int column0, column1, row0, row1;

    bool is_pixel() const { return column1 - column0 == 1 && row1 - row0 == 1; }
  };

  /// Which of a beam's half spaces the list at hand does not lie in yet.
  struct Cuts {
    std::size_t first = 0, count = Shafts::count;
    std::span<const HalfSpace> of(const Beam& b) const { return std::span(b.spaces).subspan(first, count); }
  };
  struct Half {
    Beam beam;
    Cuts cuts;
  };
  /// What widens a beam: the edges of the face, and the ranges of directions.
  enum Edge : std::size_t { face_i, face_j, columns, rows };

  void halve(const Block& block, const Face& face, std::vector<Entry> list, Cuts cuts, int refinements);
  void shorten(const Beam& beam, std::vector<Entry> list, int left, int refinements);
  void look_at_pixel(const Beam& beam, std::vector<Entry> list, int refinements);
  void refine(const Beam& beam, std::vector<Entry> list, int refinements);

  Window window(const Block& b) const;
  std::array<double, 4> widths(const Beam& beam, double depth) const;
  Edge widest_edge(const Beam& beam, double depth) const;
  double spread(const Beam& beam, const std::vector<Entry>& list) const;
  std::array<Half, 2> halves(const Beam& beam, double depth) const;

  std::vector<Entry> part(std::span<const HalfSpace> cuts, const std::vector<Entry>& list);
  bool cut(Entry& entry, std::span<const HalfSpace> spaces) const;
  void measure(Entry& entry, const Polygon& polygon) const;
  void forget_known(std::vector<Entry>& list) const;
  static double least_depth(const std::vector<Entry>& list);
  static double middle_depth(const std::vector<Entry>& list) { return list[list.size() / 2].near; }

  void drop_covered(const Beam& beam, std::vector<Entry>& list);
  std::uint64_t resolve(const Beam& beam, std::vector<Entry>& list, bool by_sides);
  void keep(Entry& entry);
  void count(Failure f);
  const Facet& facet(const Entry& e) const { return outlook_.facets.all[e.facet]; }

  static constexpr std::ptrdiff_t few_wanted = 4;
  static constexpr std::size_t largest_list = 8192;  ///< that is resolved before it has come down to pixels
  static constexpr double most_spread = 8;           ///< of a beam that is
  static constexpr std::size_t long_list = 2048;     ///< is shared among parts of its pixel
  static constexpr std::size_t short_list = 128;  ///< is not shared among parts of the face; sides are tried

  const Outlook& outlook_;
  const Raster& raster_;
  Shafts shafts_;
  Resolver resolver_;
  std::vector<char> wanted_, reached_;
  int refinements_;
  OffsetStats stats_;
  const Context& context_;
};

}  // namespace provis::offset
