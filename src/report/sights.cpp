#include "src/report/sights.hpp"

#include <ostream>

namespace provis {

void write_sights(const PixelSights& pixel, std::size_t segment, std::ostream& out) {
  out << "{\"segment\":" << segment << ",\"frame\":" << pixel.frame << ",\"column\":" << pixel.column
      << ",\"row\":" << pixel.row << ",\"sights\":[";
  const char* separator = "";
  for (const Sight& s : pixel.sights) {
    out << separator << "[\"" << s.from << "\",\"" << s.to << "\",[";
    for (std::size_t k = 0; k < s.visible.size(); ++k) out << (k > 0 ? "," : "") << s.visible[k];
    out << "]]";
    separator = ",";
  }
  out << "]}\n";
}

}  // namespace provis
