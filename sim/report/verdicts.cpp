#include "sim/report/verdicts.h"

#include <fmt/format.h>

#include <iterator>
#include <string>

namespace kagesen {

void write_verdicts(const Trace& trace, const RunResult& result, std::ostream& out) {
  out << "index px py verdict exact_paper exact_physical cause_paper cause_physical\n";
  constexpr std::size_t kBlock = 1u << 16;
  std::string text;
  for (std::size_t i = 0; i < trace.all_fragments.size(); ++i) {
    const Fragment& f = trace.all_fragments[i];
    const auto verdict = static_cast<int>(result.verdicts[i]);
    auto at = std::back_inserter(text);
    if (result.judgement) {
      const Judgement& judgement = *result.judgement;
      fmt::format_to(at, "{} {} {} {} {} {} {} {}\n", i, f.pixel_x, f.pixel_y, verdict,
                     judgement.exact_paper[i], judgement.exact_physical[i],
                     cause_name(judgement.cause_paper[i]), cause_name(judgement.cause_physical[i]));
    } else {
      fmt::format_to(at, "{} {} {} {} - - - -\n", i, f.pixel_x, f.pixel_y, verdict);
    }
    if (text.size() < kBlock) continue;
    out << text;
    text.clear();
    if (!out) return;
  }
  out << text;
}

}  // namespace kagesen
