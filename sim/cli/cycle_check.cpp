#include "sim/cli/cycle_check.h"

#include <fmt/format.h>

#include <algorithm>

namespace kagesen {
namespace {

constexpr std::size_t kAround = 3;  // fragments shown before and after the first difference

std::string text_of(const FragmentCycles& c) { return fmt::format("{} to {}", c.accepted, c.retired); }

std::string text_of(std::uint64_t cycle) { return std::to_string(cycle); }

/// What differs first, what came before it and after; a line each. @param what  "fragment"
template <typename Times>
void add_timelines(const char* what, const std::vector<Times>& rtl, const std::vector<Times>& model,
                   std::size_t at, std::vector<std::string>& lines) {
  lines.push_back(fmt::format("  {:<12}{:<24}{}", what, "systemc", "rtl"));
  const std::size_t last = std::min(rtl.size(), at + kAround + 1);
  for (std::size_t i = at > kAround ? at - kAround : 0; i < last; ++i) {
    lines.push_back(fmt::format("{} {:<12}{:<24}{}", i == at ? '>' : ' ', i, text_of(model[i]),
                                text_of(rtl[i])));
  }
}

std::vector<std::string> side_by_side(const Frame& frame, const std::vector<FragmentCycles>& rtl,
                                      const std::vector<FragmentCycles>& model, std::size_t at) {
  const Fragment& f = frame.trace.all_fragments[at];
  const auto texel = [&](std::int32_t place, std::int64_t side) {
    return (place >> frame.setup.fraction_bits) + static_cast<std::int32_t>(side / 2);
  };
  std::vector<std::string> lines = {
      fmt::format("fragment {} of object {}, texel ({}, {}): cycles of pass 2 from taken to answered",
                  at, f.object, texel(f.position.x, frame.config.map_width),
                  texel(f.position.y, frame.config.map_height))};
  add_timelines("fragment", rtl, model, at, lines);
  return lines;
}

std::vector<std::string> first_triangle(const Frame& frame, const std::vector<std::uint64_t>& rtl,
                                        const std::vector<std::uint64_t>& model, std::size_t at) {
  std::vector<std::string> lines = {
      fmt::format("triangle {} of object {}: cycle of pass 1 in which it was taken", at,
                  frame.trace.all_casters[at].object)};
  add_timelines("triangle", rtl, model, at, lines);
  return lines;
}

template <typename Named>
Named named(const std::vector<Named>& all, const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& n) { return n.name == name; });
  return found == all.end() ? Named{} : *found;
}

/// "pass 2, texel: systemc 12, rtl 13" for each figure that differs.
void compare_pass(const char* name, const PassCycles& model, const PassCycles& rtl,
                  std::vector<std::string>& lines) {
  const auto compare = [&](const std::string& what, std::uint64_t a, std::uint64_t b) {
    if (a != b) lines.push_back(fmt::format("{}, {}: systemc {}, rtl {}", name, what, a, b));
  };
  compare("cycles", model.total, rtl.total);
  compare("items", model.items, rtl.items);
  for (const auto& [cause, cycles] : rtl.causes) compare(cause, model.of(cause), cycles);
  if (model.traffic) {
    compare("texel reads", model.traffic->texel_reads, rtl.traffic->texel_reads);
    compare("texel bytes", model.traffic->texel_bytes, rtl.traffic->texel_bytes);
    compare("slb reads", model.traffic->slb_reads, rtl.traffic->slb_reads);
    compare("slb bytes", model.traffic->slb_bytes, rtl.traffic->slb_bytes);
  }
  // What the model does not meter is absent there.
  for (const CacheCounts& mine : model.caches) {
    const CacheCounts other = named(rtl.caches, mine.name);
    compare(mine.name + " look-ups", mine.lookups, other.lookups);
    compare(mine.name + " misses", mine.misses, other.misses);
  }
  for (const QueueCycles& mine : model.queues) {
    const QueueCycles other = named(rtl.queues, mine.name);
    const std::size_t most = std::max(mine.cycles.size(), other.cycles.size());
    const auto at = [](const QueueCycles& q, std::size_t n) {
      return n < q.cycles.size() ? q.cycles[n] : 0;
    };
    for (std::size_t n = 0; n < most; ++n) {
      compare(fmt::format("cycles with {} words in {}", n, mine.name), at(mine, n), at(other, n));
    }
  }
}

}  // namespace

CycleCheck check_cycles(const Frame& frame, const Expected& expected, const RtlEngine& rtl,
                        SystemcEngine& model) {
  CycleCheck check;
  const std::vector<Verdict> verdicts = run_frame(frame, model);
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    check.verdict_differences += verdicts[i] != expected.verdicts[i];
  }
  const std::vector<std::uint64_t>&drawn = model.triangle_cycles(), &taken = rtl.triangle_cycles();
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i] == taken[i]) continue;
    if (check.cycle_differences++ == 0) check.first = first_triangle(frame, taken, drawn, i);
  }
  const std::vector<FragmentCycles>&a = model.fragment_cycles(), &b = rtl.fragment_cycles();
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (check.cycle_differences++ > 0) continue;
    check.first_fragment = i;
    check.first = side_by_side(frame, b, a, i);
  }
  const CycleReport ours = *model.cycles(), theirs = *rtl.cycles();
  std::vector<std::string> figures;
  const auto compare = [&](const char* name, const auto& mine, const auto& other) {
    if (!mine || !other) return;  // not modelled
    if (*mine != *other) figures.push_back(fmt::format("{}: systemc {}, rtl {}", name, *mine, *other));
  };
  compare("wipe", ours.clear, theirs.clear);
  compare("announce", ours.announce, theirs.announce);
  compare("settle", ours.settle, theirs.settle);
  if (ours.pass1) compare_pass("pass 1", *ours.pass1, *theirs.pass1, figures);
  if (ours.pass2) compare_pass("pass 2", *ours.pass2, *theirs.pass2, figures);
  check.cycle_differences += figures.size();
  check.first.insert(check.first.end(), figures.begin(), figures.end());
  return check;
}

}  // namespace kagesen
