#include "model/golden.h"

namespace kagesen {
namespace {

/// Becomes the configured profile's engine when a frame begins.
class GoldenEngine : public Engine {
 public:
  std::string name() const override { return "golden"; }
  void begin(const UnitConfig& config, const FrameSetup& setup) override {
    if (!engine_ || profile_ != config.profile) {
      profile_ = config.profile;
      engine_ =
          profile_ == Profile::kPaper ? make_golden_paper_engine() : make_golden_winding_engine();
    }
    engine_->begin(config, setup);
  }
  void announce(const Fragment* fragments, std::size_t count) override {
    engine_->announce(fragments, count);
  }
  void draw(const Caster* casters, std::size_t count) override { engine_->draw(casters, count); }
  void decide(const Fragment* fragments, std::size_t count, Verdict* verdicts) override {
    engine_->decide(fragments, count, verdicts);
  }
  MapContents contents() const override { return engine_->contents(); }
  UnitCounters counters() const override { return engine_->counters(); }

 private:
  Profile profile_ = Profile::kPaper;
  std::unique_ptr<Engine> engine_;
};

}  // namespace

std::unique_ptr<Engine> make_golden_engine() { return std::make_unique<GoldenEngine>(); }

}  // namespace kagesen
