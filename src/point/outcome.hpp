#pragma once
// What a part of the window contributes to the answer. Parts are added up in a fixed order, so that the sum
// does not depend on which thread looked where.

#include <iterator>
#include <vector>

#include "provis/visible_set.hpp"
#include "src/point/witness_point.hpp"

namespace provis {

struct Outcome {
  std::vector<PrimitiveId> found;
  std::vector<WitnessPoint> witnesses;  ///< one for each of `found`, where asked for; else none
  std::vector<SubdivisionCell> cells;
  QueryStats stats;

  void add(Outcome&& other) {
    found.insert(found.end(), other.found.begin(), other.found.end());
    witnesses.insert(witnesses.end(), std::make_move_iterator(other.witnesses.begin()),
                     std::make_move_iterator(other.witnesses.end()));
    cells.insert(cells.end(), std::make_move_iterator(other.cells.begin()),
                 std::make_move_iterator(other.cells.end()));
    stats.signs += other.stats.signs;
    stats.nodes += other.stats.nodes;
    stats.leaves += other.stats.leaves;
    stats.samples += other.stats.samples;
    stats.subtractions += other.stats.subtractions;
    stats.sampling += other.stats.sampling;
    stats.iteration += other.stats.iteration;
  }
};

}  // namespace provis
