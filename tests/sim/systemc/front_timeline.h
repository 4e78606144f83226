#pragma once
/// What a front did, cycle by cycle, and a store that stalls it: for its model and for Verilog.
#include <gtest/gtest.h>

#include <vector>

#include "sim/systemc/common/front_causes.h"
#include "sim/systemc/common/visit_register.h"

namespace kagesen::tlm_model {

/// Cycles count from the first one.
struct FrontTimeline {
  struct Taken {
    Cycle at;
    int kind;
    std::int32_t x, y;
    bool operator==(const Taken& o) const {
      return at == o.at && kind == o.kind && x == o.x && y == o.y;
    }
  };
  std::vector<Cycle> beats;  ///< when each was taken
  std::vector<Taken> visits;
  std::uint64_t setup = 0, none = 0, walk = 0;  ///< cycles in which no visit was offered
  Cycle idle = 0;                               ///< the first cycle after all was done
};
inline std::ostream& operator<<(std::ostream& out, const FrontTimeline::Taken& t) {
  return out << "kind " << t.kind << " (" << t.x << ", " << t.y << ") in cycle " << t.at;
}

/// Takes a visit in each cycle in which it does not stall.
template <typename Visit>
class StallingStore : public VisitTaker<Visit> {
 public:
  StallingStore(const Stalls& stalls, FrontCauses& causes, FrontTimeline& line)
      : stalls_(stalls), causes_(causes), line_(line) {}

  Cycle take(const Visit& visit, Cycle offered) override {
    count(offered);
    const Cycle at = stalls_.next(offered);
    line_.visits.push_back({at, visit.kind, visit.x, visit.y});
    free_ = at + 1;
    return at;
  }
  bool ready(Cycle at) override { return !stalls_.at(at); }
  /// Cycles without a visit, up to this one.
  void count(Cycle to) {
    const FrontCauses::Cycles cycles = causes_.of(free_, to);
    line_.setup += cycles.setup;
    line_.none += cycles.none;
    line_.walk += cycles.walk;
  }

 private:
  Stalls stalls_;
  FrontCauses& causes_;
  FrontTimeline& line_;
  Cycle free_ = 0;
};

inline void expect_same(const FrontTimeline& model, const FrontTimeline& verilog) {
  for (std::size_t i = 0; i < verilog.visits.size(); ++i) {
    ASSERT_LT(i, model.visits.size());
    ASSERT_EQ(model.visits[i], verilog.visits[i]) << "visit " << i;
  }
  ASSERT_EQ(model.visits.size(), verilog.visits.size());
  ASSERT_EQ(model.beats, verilog.beats);
  EXPECT_EQ(model.idle, verilog.idle);
  EXPECT_EQ(model.setup, verilog.setup);
  EXPECT_EQ(model.none, verilog.none);
  EXPECT_EQ(model.walk, verilog.walk);
}

}  // namespace kagesen::tlm_model
