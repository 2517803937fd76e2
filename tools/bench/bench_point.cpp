// Measures visible_from_point.

#include "provis/point.hpp"

#include "provis/error.hpp"
#include "src/report/names.hpp"
#include "tools/bench/child.hpp"

namespace provis::bench {

namespace {

nlohmann::json tiers(const SignCounts& signs) {
  nlohmann::json counts;
  for (int t = 0; t < tier_count; ++t) {
    const Tier tier = static_cast<Tier>(t);
    std::uint64_t sum = 0;
    for (int p = 0; p < predicate_count; ++p) sum += signs.at(static_cast<Predicate>(p), tier);
    counts[std::string(name(tier))] = sum;
  }
  return counts;
}

const std::map<std::string, Method> methods = {
    {"exact", Method::exact}, {"aggressive", Method::aggressive}, {"sampled", Method::sampled}};
const std::map<std::string, PointEngine> engines = {{"fast", PointEngine::fast},
                                                    {"paper", PointEngine::paper}};

int run(int argc, char** argv) {
  Child child("bench_point");
  PointOptions options;
  options.pixels = {width, height};
  std::string arithmetic = "chain", reference_out;
  child.options().add_option("--method", options.method)->transform(CLI::CheckedTransformer(methods));
  child.options().add_option("--engine", options.engine)->transform(CLI::CheckedTransformer(engines));
  child.options()
      .add_option("--arithmetic", arithmetic)
      ->check(CLI::IsMember({"chain", "doubles", "mpfr", "exact"}));
  child.options().add_option("--write-reference", reference_out, "Write the ids that are visible");
  return child.run(argc, argv, [&](const Child& c) {
    options.arithmetic = arithmetic_named(arithmetic).value();
    VisibleSet set;
    nlohmann::json result = c.measured([&] {
      set = {};
      set = visible_from_point(c.scene(), c.view(), options, c.context());
    });
    const std::vector<PrimitiveId> ids = set.with(Status::visible);
    result.update(c.found(ids));
    result["tiers"] = tiers(set.stats.signs);
    result["guarantee"] = name(set.guarantee);
    if (!reference_out.empty()) write_reference(ids, reference_out);
    return result;
  });
}

}  // namespace

}  // namespace provis::bench

int main(int argc, char** argv) { return provis::bench::run(argc, argv); }
