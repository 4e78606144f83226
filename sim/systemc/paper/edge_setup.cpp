#include "sim/systemc/paper/edge_setup.h"

#include <algorithm>
#include <cstdlib>

#include "sim/systemc/common/divider.h"

namespace kagesen::tlm_model::paper {
namespace {

constexpr unsigned kCoordBits = 28, kMaxFraction = 26;

unit::Int128 floor_div(unit::Int128 a, std::int64_t b) { return a / b - (a % b < 0); }

}  // namespace

void EdgeSetup::begin_pass(const UnitConfig& config, unsigned texel_bits) {
  const auto depth_bits = static_cast<unsigned>(config.depth_bits);
  texel_bits_ = texel_bits;
  farthest_ = config.hidden_removal == HiddenRemoval::kFarthest;
  step_bits_ = (depth_bits + kCoordBits + 2 + texel_bits) / 2 * 2;
  start_bits_ = (depth_bits + kCoordBits + kMaxFraction + 3) / 2 * 2;
  // The divider of the minor coordinate, and those of depth along both axes.
  const Cycle minor = kRamps + 1 + (kMaxFraction + 2) / 2;
  const Cycle depth = kRamps + 4 + 1 + (depth_bits + 1) / 2;
  edge_cycles_ = std::max({kProgram, minor, depth});
  begins_ = plane_free_ = 0;
}

Cycle EdgeSetup::begin(const unit::TriangleTrail& triangle, Cycle offered) {
  triangle_ = &triangle;
  return begins_ = offered + kGradients;
}

Cycle EdgeSetup::edge_ready(unsigned edge) {
  const Cycle begins = std::max(begins_, plane_free_);
  Cycle divide = begins + kStart;
  if (edge == 0) divide = std::max(divide, divide_steps(begins + kSteps));
  const Cycle plane =
      divide +
      division_cycles(floor_div(triangle_->start[edge], triangle_->twice_area), start_bits_);
  return std::max(begins + edge_cycles_, plane);
}

/// The cycle in which the divider is free after them.
Cycle EdgeSetup::divide_steps(Cycle at) const {
  const unit::TriangleTrail& t = *triangle_;
  const auto divide = [&](unit::Int128 numerator) {
    at += division_cycles(floor_div(numerator, t.twice_area), step_bits_) + kBetweenDivisions;
  };
  if (farthest_) {
    at += kFarthest;
    const unit::Int128 steepness = unit::Int128{std::abs(t.gradient_x)} + std::abs(t.gradient_y);
    divide(steepness << (texel_bits_ - 1));
  }
  divide(unit::Int128{t.gradient_x} * (std::int64_t{1} << texel_bits_));
  divide(unit::Int128{t.gradient_y} * (std::int64_t{1} << texel_bits_));
  return at;
}

void EdgeSetup::take(Cycle at, Cycle fresh) {
  begins_ = at + 1;
  plane_free_ = fresh + kPlane;
}

}  // namespace kagesen::tlm_model::paper
