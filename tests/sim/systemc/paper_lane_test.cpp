/// The lane's timing rules one by one, each from both sides; and another memory than ours behind it.
#include <gtest/gtest.h>
#include <tlm_utils/simple_target_socket.h>

#include <vector>

#include "sim/systemc/paper/shadow_lane.h"

namespace kagesen::tlm_model::paper {
namespace {

/// Answers after a time of its own, in no rhythm of the clock; tells neither when it took a request
/// nor of direct access.
class OtherMemory : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<OtherMemory> socket;
  std::vector<sc_dt::uint64> addresses;
  double latency = 19.5;  ///< cycles

  explicit OtherMemory(const sc_core::sc_module_name& name) : sc_module(name), socket("socket") {
    socket.register_b_transport(this, &OtherMemory::transport);
  }

 private:
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    addresses.push_back(payload.get_address());
    delay += sc_core::sc_time(latency, sc_core::SC_NS);
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }
};

class PaperLane : public testing::Test {
 protected:
  static constexpr std::uint32_t kSlots = 8;

  PaperLane() : lane_("lane"), texels_("texels"), slb_("slb") {
    lane_.texel_port().socket.bind(texels_.socket);
    lane_.slb_port().socket.bind(slb_.socket);
    cycles_.resize(64);
    ShadowLane::Pass pass{};
    pass.slots = kSlots;
    pass.texel_bytes = 22;
    pass.slb_bytes = 32;
    pass.pitch_log2 = 4;
    pass.cycles = cycles_.data();
    pass.stride = 1;
    lane_.begin_pass(pass);
  }
  void take(bool reads_texel, std::vector<std::uint32_t> records = {}) {
    unit::FragmentTrail& trail = lane_.open();
    trail.reads_texel = reads_texel;
    trail.x = 9;
    trail.y = 2;
    trail.records = std::move(records);
    lane_.take();
  }

  ShadowLane lane_;
  OtherMemory texels_, slb_;
  std::vector<FragmentCycles> cycles_;
};

TEST_F(PaperLane, KnownVerdictLeavesInTheThirdCycle) {
  take(false);
  lane_.drain();
  EXPECT_EQ(cycles_[0], (FragmentCycles{0, 3}));
  EXPECT_TRUE(texels_.addresses.empty());
}

TEST_F(PaperLane, TexelDecides) {
  take(true);
  lane_.drain();
  // Placed in 1, read in 2, answered in 22 (19.5 is seen in 20), decided in 23.
  EXPECT_EQ(cycles_[0], (FragmentCycles{0, 25}));
  EXPECT_EQ(texels_.addresses, (std::vector<sc_dt::uint64>{(2 * 16 + 2) * 22}));
}

TEST_F(PaperLane, EachRecordTakesLatencyAndFive) {
  take(true, {7, 100, 7});
  lane_.drain();
  // Decided on in 23, read in 25, answered in 45; each further record 25 later; decided 3 after.
  EXPECT_EQ(cycles_[0], (FragmentCycles{0, 45 + 2 * 25 + 3 + 2}));
  EXPECT_EQ(slb_.addresses, (std::vector<sc_dt::uint64>{7 * 32, 100 * 32, 7 * 32}));
}

TEST_F(PaperLane, SlotIsTakenAgainInTheCycleInWhichItIsFree) {
  for (std::uint32_t i = 0; i <= kSlots; ++i) take(true);
  lane_.drain();
  for (std::uint32_t i = 0; i < kSlots; ++i) EXPECT_EQ(cycles_[i].accepted, i);
  // The first verdict is fetched in 24: its slot is full then, and free in 25.
  EXPECT_EQ(cycles_[kSlots].accepted, 25u);
  lane_.end_pass(26, 52);
  const CauseMeter& causes = lane_.causes();
  EXPECT_EQ(causes.of(LaneCause::kFragment), kSlots + 1);
  EXPECT_EQ(causes.of(LaneCause::kTexel), 23 - kSlots);  // 8 to 22
  EXPECT_EQ(causes.of(LaneCause::kDecision), 1u);        // 23
  EXPECT_EQ(causes.of(LaneCause::kVerdict), 1u);         // 24
}

TEST_F(PaperLane, ReadsThatGoOnGoFirst) {
  slb_.latency = 0.5;
  // Fragment i asks for its first record in 25 + i; fragment 0 for its second one in 25 + 1 + 5.
  take(true, {10, 20});
  for (std::uint32_t i = 1; i < kSlots; ++i) take(true, {10 + i});
  lane_.drain();
  std::vector<sc_dt::uint64> records;
  for (const sc_dt::uint64 address : slb_.addresses) records.push_back(address / 32);
  EXPECT_EQ(records, (std::vector<sc_dt::uint64>{10, 11, 12, 13, 14, 15, 20, 16, 17}));
}

}  // namespace
}  // namespace kagesen::tlm_model::paper
