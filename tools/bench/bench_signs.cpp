// Nanoseconds per sign by arithmetic and kind of question (Google Benchmark). A program of its own: run it by
// hand.

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "predicates/signs.hpp"
#include "src/point/guard.hpp"
#include "tests/support/random.hpp"

namespace provis::bench {

namespace {

constexpr std::size_t count = 1024;

/// Triangles ahead of an eye at the origin, and lines and rays made of them.
class Material {
 public:
  explicit Material(bool flat) : geometry_(make_geometry({}, Frame{}, false)) {
    test::Random random(1);
    for (std::array<Vec3d, 3>& t : triangles_)
      for (Vec3d& p : t) {
        p = 0x1p-17 * random.lattice(1 << 16);
        p.z = flat ? -1 - 0.25 * p.x : p.z - 2;  // flat: all in one plane, so that every depth line is zero
      }
  }

  const ViewGeometry& geometry() const { return geometry_; }

  Line edge(std::size_t t, std::size_t k) const {
    Line line;
    line.first.p[0] = &triangles_[t % count][k];
    line.first.p[1] = &triangles_[t % count][(k + 1) % 3];
    return line;
  }

  Line depth(std::size_t t, std::size_t u) const {
    Line line;
    line.kind = LineKind::depth;
    for (std::size_t k = 0; k < 3; ++k) {
      line.first.p[k] = &triangles_[t % count][k];
      line.second.p[k] = &triangles_[u % count][k];
    }
    return line;
  }

 private:
  ViewGeometry geometry_;
  std::array<std::array<Vec3d, 3>, count> triangles_;
};

/// Asks on which side of one line the crossing of two others lies, over and over.
template <Arithmetic A>
void ask(benchmark::State& state, bool depth, bool flat) {
  const RoundingGuard<A> guard;
  const Material material(flat);
  SignCounts counts;
  Signs<A> signs(material.geometry(), counts);
  std::vector<Line> edges, lines;
  std::vector<Direction> crossings(count);
  for (std::size_t t = 0; t < count; ++t) {
    edges.push_back(material.edge(t, 0));
    lines.push_back(depth ? material.depth(t, t + 2) : material.edge(t + 2, 1));
  }
  for (std::vector<Line>* made : {&edges, &lines})
    for (Line& line : *made) line.approx = signs.shadow(line);
  for (std::size_t t = 0; t < count; ++t) {
    crossings[t].kind = DirectionKind::crossing;
    crossings[t].lines[0] = &edges[t];
    crossings[t].lines[1] = &edges[(t + 1) % count];
    crossings[t].approx = signs.shadow(crossings[t]);
  }
  std::size_t t = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(signs.side(lines[t], crossings[t]));
    t = (t + 1) % count;
  }
}

template <Arithmetic A>
void add_all(const std::string& arithmetic) {
  const auto add = [&](const std::string& what, bool depth, bool flat) {
    benchmark::RegisterBenchmark((arithmetic + "/" + what).c_str(),
                                 [=](benchmark::State& state) { ask<A>(state, depth, flat); });
  };
  add("edge at crossing", false, false);
  add("depth at crossing", true, false);
  add("depth at crossing, always zero", true, true);
}

}  // namespace

}  // namespace provis::bench

int main(int argc, char** argv) {
  using provis::Arithmetic;
  provis::bench::add_all<Arithmetic::doubles>("doubles");
  provis::bench::add_all<Arithmetic::chain>("chain");
  provis::bench::add_all<Arithmetic::mpfr>("mpfr");
  provis::bench::add_all<Arithmetic::exact>("exact");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
