#pragma once
/// A run made by hand: two objects on a 4 x 2 image, one fragment a pixel but the first; the last
/// is wrong.
#include <cstdint>

#include "sim/report/run_result.h"

namespace kagesen {

struct Tiny {
  Trace trace;
  RunResult result;
  Tiny() {
    trace.header.source = "tiny";
    trace.header.light = "directional";
    trace.header.image_width = 4;
    trace.header.image_height = 2;
    trace.header.objects = {{"ground", 2, false, false}, {"box", 12, true, true}};
    for (std::uint16_t i = 1; i < 8; ++i) {
      Fragment f;
      f.pixel_x = i % 4;
      f.pixel_y = i / 4;
      f.object = i / 4;
      f.flags = Fragment::kVisible;
      trace.all_fragments.push_back(f);
      result.verdicts.push_back(i > 3 ? Verdict::kDark : Verdict::kLit);
    }
    result.engine = "golden";
    result.contents.width = result.contents.height = 2;
    result.contents.depth = {5, 9, 0xffffff, 0xffffff};
    result.contents.object = {1, 1, kNoObject, kNoObject};
    result.contents.overflowed = {0, 0, 0, 0};
    result.contents.entries = {{1, 0, 1, 9, false, std::vector<LineRecord>(2)}};
  }
  void judge() {
    Judgement judgement;
    judgement.exact_paper = judgement.exact_physical = {0, 0, 0, 1, 1, 1, 0};
    judgement.cause_paper.assign(7, Cause::kNone);
    judgement.cause_physical = judgement.cause_paper;
    judgement.cause_paper[6] = Cause::kQuantisation;
    judgement.paper.judged = 7;
    judgement.paper.wrong = judgement.paper.false_dark = 1;
    judgement.paper.causes[1] = 1;
    result.judgement = judgement;
  }
};

}  // namespace kagesen
