#pragma once
/// The table behind the run time against error curve: a row a configuration, kept as CSV.
#include <cstdint>
#include <string>
#include <vector>

namespace kagesen {

/// One configuration on one frame. Up to `image` it says which; the rest was measured.
struct CurveRow {
  std::string scene, profile, semantics;
  std::uint64_t fraction_bits = 0, slope_bits = 0;
  std::uint64_t map = 0;    ///< its side, texels
  std::uint64_t scale = 0;  ///< of the virtual projection space
  std::string image;        ///< WxH, pixels

  std::uint64_t judged = 0, wrong = 0, band = 0, band_wrong = 0;
  double band_rate = 0;
  double displacement_mean = 0;  ///< texels
  std::uint64_t beyond_bound = 0, overflow_texels = 0;
  std::uint64_t map_bytes = 0, slb_bytes = 0, total_bytes = 0;
  double pass1_s = 0, pass2_s = 0;              ///< wall time, best of several
  double fragments_per_s = 0;                   ///< of pass 2
  std::uint64_t plain_same_side_wrong = 0;      ///< of a plain map of that side
  double plain_pass1_s = 0, plain_pass2_s = 0;  ///< to draw it and to look it up, in the same run
  double lookup_ratio = 0;                      ///< pass2_s in units of plain_pass2_s
  double total_ratio = 0;                       ///< both passes in units of both of the plain map

  /// The same configuration on the same frame.
  bool same_setting(const CurveRow& other) const;
};

/// Calls visit(name, field) for every column, in the order of the file.
template <class Row, class Visit>
void visit_columns(Row& row, Visit visit) {
  visit("scene", row.scene);
  visit("profile", row.profile);
  visit("semantics", row.semantics);
  visit("fraction_bits", row.fraction_bits);
  visit("slope_bits", row.slope_bits);
  visit("map", row.map);
  visit("scale", row.scale);
  visit("image", row.image);
  visit("judged", row.judged);
  visit("wrong", row.wrong);
  visit("band", row.band);
  visit("band_wrong", row.band_wrong);
  visit("band_rate", row.band_rate);
  visit("displacement_mean", row.displacement_mean);
  visit("beyond_bound", row.beyond_bound);
  visit("overflow_texels", row.overflow_texels);
  visit("map_bytes", row.map_bytes);
  visit("slb_bytes", row.slb_bytes);
  visit("total_bytes", row.total_bytes);
  visit("pass1_s", row.pass1_s);
  visit("pass2_s", row.pass2_s);
  visit("fragments_per_s", row.fragments_per_s);
  visit("plain_same_side_wrong", row.plain_same_side_wrong);
  visit("plain_pass1_s", row.plain_pass1_s);
  visit("plain_pass2_s", row.plain_pass2_s);
  visit("lookup_ratio", row.lookup_ratio);
  visit("total_ratio", row.total_ratio);
}

/// The whole file: the names of the columns, then a line a row.
std::string curve_csv(const std::vector<CurveRow>& rows);
/// Reads such a file; none where there is no file. Throws UserError naming the file and the line of
/// anything else.
std::vector<CurveRow> read_curve_csv(const std::string& path);

}  // namespace kagesen
