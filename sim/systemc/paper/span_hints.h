#pragma once
/// Buckets that spans will walk: of texels with lines in a word that was fetched for a span.
/// Twin: rtl/paper/span_hints.sv, whose tables and registers these are.
#include <array>
#include <vector>

#include "sim/systemc/paper/slb_step.h"

namespace kagesen::tlm_model::paper {

class SpanHints {
 public:
  struct Inputs {
    bool visit = false;  ///< enters the queue
    std::uint32_t visit_word = 0;
    RecordAddress visit_bucket = 0;
    unsigned visit_mask = 0;  ///< of a span that hides; else 0
    bool read = false;        ///< a word is asked for
    std::uint32_t read_word = 0;
    unsigned read_line = 0;
    bool response = false;  ///< it comes; which of its texels hold lines
    unsigned response_line = 0, edges = 0;
    bool hint_ready = false;
  };

  void reset(unsigned texel_lines, RecordAddress bucket_mask) {
    *this = SpanHints{};
    fetched_.assign(texel_lines, {});
    bucket_mask_ = bucket_mask;
  }
  bool valid() const { return todo_ != 0; }
  RecordAddress address() const {
    const unsigned texel = todo_ & 1 ? 0 : todo_ & 2 ? 1 : todo_ & 4 ? 2 : 3;
    return (bucket_ + texel) & bucket_mask_;
  }

  /// The clock's edge. @return did anything change?
  bool step(const Inputs& in) {
    const unsigned before = todo_;
    const bool moved = read_ || came_ || in.visit || in.read || in.response;
    const unsigned fresh = came_ && !unknown_ ? came_span_.mask & edges_ : 0;
    if (fresh != 0) {
      todo_ = fresh;
      bucket_ = came_span_.bucket;
    } else if (in.hint_ready) {
      todo_ &= todo_ - 1;
    }
    unknown_ = read_ && in.response_line == read_line_;
    came_ = in.response;
    edges_ = in.edges;
    if (in.response) came_span_ = fetched_[in.response_line];
    if (read_) {
      fetched_[read_line_] = read_span_;
      if (read_span_.word != read_word_) fetched_[read_line_].mask = 0;
    }
    read_ = in.read;
    if (in.read) {
      read_span_ = queued_[in.read_word % kQueued];
      read_word_ = in.read_word;
      read_line_ = in.read_line;
    }
    if (in.visit) queued_[in.visit_word % kQueued] = {in.visit_word, in.visit_bucket, in.visit_mask};
    return moved || todo_ != before;
  }

 private:
  struct Span {
    std::uint32_t word = ~0u;
    RecordAddress bucket = 0;
    unsigned mask = 0;
  };
  static constexpr std::size_t kQueued = 64;

  RecordAddress bucket_mask_ = 0;
  std::array<Span, kQueued> queued_;  // of visits, by word
  std::vector<Span> fetched_;         // by line
  Span read_span_, came_span_;
  bool read_ = false, came_ = false;
  bool unknown_ = false;  // it came before the table had it
  std::uint32_t read_word_ = 0;
  unsigned read_line_ = 0, edges_ = 0, todo_ = 0;
  RecordAddress bucket_ = 0;
};

}  // namespace kagesen::tlm_model::paper
