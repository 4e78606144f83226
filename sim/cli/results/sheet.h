#pragma once
/// A contact sheet: the same window of the frame at every scale, as the paper's Fig 8 shows it.
#include <cstdint>
#include <string>
#include <vector>

#include "model/engine.h"
#include "sim/report/canvas.h"
#include "traces/format/records.h"

namespace kagesen {

class Sheet {
 public:
  enum Row { k8Bits, k4Bits, kPlain };
  explicit Sheet(std::vector<unsigned> scales);
  /// The window with the longest shadow edge in it.
  void choose_window(const Trace& trace, const std::vector<std::uint8_t>& exact);
  bool empty() const { return !chosen_; }
  void add(const Trace& trace, const std::vector<Verdict>& verdicts, unsigned scale, Row row);
  const Canvas& picture() const { return picture_; }

 private:
  std::vector<unsigned> scales_;
  Canvas picture_;
  bool chosen_ = false;
  int x_ = 0, y_ = 0;
};

}  // namespace kagesen
