#pragma once
// The body of a PLY file, value by value, with the place of whatever goes wrong.

#include <string>
#include <string_view>
#include <vector>

#include "src/scene/ply_format.hpp"

namespace provis {

/// One row of an element. Every PLY number is a float64 without rounding.
struct PlyRow {
  std::vector<double> scalars;  ///< by property; 0 in place of a list
  std::vector<double> list;     ///< the list that was asked for
};

/// Reads rows in the file's order. ASCII numbers are rounded once to the type that the header declares;
/// a row may run over several lines, but the next one begins on a line of its own.
class PlyBody {
 public:
  PlyBody(ByteSpan file, const PlyHeader& header);

  /// Refuses counts that the rest of the file cannot hold, before anybody takes memory for them.
  ///
  /// Throws:     Error::invalid_input naming byte or line
  void check_count(const PlyElement& element) const;

  /// wanted_list: the property whose items are kept; any position past the end keeps none.
  void read_row(const PlyElement& element, std::size_t wanted_list, PlyRow& row);

  /// Refuses anything but white space and zero bytes behind the last row: it would be a sign that the
  /// rows were cut in the wrong places.
  void check_end() const;

  /// "byte 812" or "line 14" of the row read last.
  std::string row_place() const;

 private:
  [[noreturn]] void fail(std::size_t position, const std::string& what) const;
  std::string place(std::size_t position) const;
  std::size_t rest() const { return file_.size() - position_; }

  double value(PlyType type);
  double binary_value(PlyType type);
  double ascii_value(PlyType type);
  std::string_view next_word();
  void end_ascii_row();

  ByteSpan file_;
  PlyEncoding encoding_;
  std::size_t body_offset_, body_line_;
  std::size_t position_, row_position_;
  mutable std::size_t counted_to_, counted_line_;  ///< the last place that was asked for, and its line
};

}  // namespace provis
