#pragma once
/// Sets a triangle's plane up, and works out the products that edge_setup asks for.
/// Twin: rtl/winding/plane_setup.sv with plane_program, plane_factors, plane_sums, gradient_encoder.
///
/// A program of sums, a digit of a product a cycle; three sums go to one divider, and two of its
/// quotients on to the encoder. An edge's product of two digits goes between two sums.
#include <systemc>

#include "model/unit/winding/triangle_trail.h"
#include "sim/systemc/winding/edge_setup.h"

namespace kagesen::tlm_model::winding {

class PlaneSetup : public sc_core::sc_module {
 public:
  explicit PlaneSetup(const sc_core::sc_module_name& name) : sc_module(name) {}

  void begin_pass(const UnitConfig& config, unsigned texel_bits);

  // What is taken in cycle `at` keeps the setup busy:
  /// Another triangle's plane, of a triangle to come. Returns the first cycle in which it is idle again.
  static Cycle plane(Cycle at) { return at + kPlaneCycles; }
  /// A triangle without area; as above.
  static Cycle flat(Cycle at) { return at + kArea + 1; }
  /// Returns the cycle in which the triangle is ready. Its first edge is set up beside it.
  Cycle triangle(const unit::winding::TriangleTrail& triangle, Cycle at, EdgeSetup& first_edge);

  /// All products of an edge, while a triangle is ready.
  void serve(EdgeSetup& edge) { serve(edge, kNever); }

 private:
  using Figures = unit::winding::FacetPlane::Figures;
  static constexpr Cycle kProgram = 4;       // from a triangle's cycle to the first sum's
  static constexpr Cycle kSum = 4;           // from a sum's last digit to the sum
  static constexpr Cycle kArea = 11;         // from a triangle's cycle to its area
  static constexpr Cycle kFirstEdge = 2;     // from there to the first edge's
  static constexpr Cycle kPlaneCycles = 25;
  static constexpr Cycle kEdgeDigits = 2;
  // Digits of sums.
  static constexpr Cycle kShortSum = 4, kStartSum = 8, kSquareSum = 18, kNarrowSum = 2;

  void serve(EdgeSetup& edge, Cycle until);
  void sum(Cycle digits);
  Cycle divide(std::int64_t quotient);
  void step(std::int64_t quotient);
  void narrow(const Figures& plane);
  Cycle encoding_cycles(std::int64_t gradient) const;

  unsigned quotient_bits_ = 0, code_bits_ = 0;
  std::int64_t small_area_ = 0;  // twice an area that is not below is never that of a narrow triangle
  EdgeSetup* edge_ = nullptr;
  Cycle next_ = 0;        // digit
  Cycle in_flight_ = 0;   // sums, until before this cycle
  Cycle divider_ = 0;     // free from this cycle on
  Cycle encoder_ = 0;     // as well
  Cycle encoded_ = 0;     // both codes are there
};

}  // namespace kagesen::tlm_model::winding
