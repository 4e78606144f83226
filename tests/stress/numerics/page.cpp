#include "tests/stress/numerics/page.h"

#include <fmt/format.h>

#include "traces/format/words.h"

namespace kagesen::stress {
namespace {

std::string decimal(const Exact& value) {
  if (denominator(value) == 1) return numerator(value).str();
  return fmt::format("{:.10g}", value.convert_to<double>());
}

std::string inputs_text(const Measured& m) {
  std::string text;
  for (std::size_t i = 0; i < m.worst.inputs.size(); ++i) {
    text += fmt::format("{}{} {}", i ? ", " : "", m.quantity.inputs[i], m.worst.inputs[i]);
  }
  return text;
}

std::string table(const std::vector<Measured>& measured, const std::string& profile) {
  std::string text =
      "| quantity | format | what is bounded | bound | worst seen | samples "
      "|\n|---|---|---|---|---|---|\n";
  std::string inputs = "\nThe inputs of the worst values:\n\n";
  for (const Measured& m : measured) {
    const Quantity& q = m.quantity;
    if (q.profile != profile) continue;
    const std::string value = decimal(m.worst.value);
    const bool plain = q.strict || q.bound == decimal(q.limit);
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} |\n", q.name, q.format, q.meaning,
                    plain ? q.bound : q.bound + " = " + decimal(q.limit),
                    m.worst.exceeded == 0 ? value : "**" + value + "**", grouped(m.worst.samples));
    inputs += fmt::format("- {}: {}\n", q.name, inputs_text(m));
  }
  return text + inputs;
}

}  // namespace

std::string numerics_page(const std::vector<Measured>& measured, const std::string& command) {
  std::string text =
      "# Numbers of the unit: bounds and worst cases\n\nWritten by `" + command + "`.\n";
  text += R"(
Every quantity is measured by driving the unit's own blocks with random input, and with
small changes of the worst input so far, against exact rational arithmetic. Widths are the
defaults; units are 2^-f texel, f fraction bits of the trace (16 where none is given).
Bits are those that the blocks' formulas take on extreme input. A value beyond its bound
would stand in bold, and the command would fail.
)";
  for (const char* profile : {"paper", "winding"}) {
    text += fmt::format("\n## The {} profile\n\n", profile);
    text += table(measured, profile);
  }
  text += R"(
*walk*: texels stepped along the edge before the measurement, for the paper profile per
mille of its walk. *w1*, *w2*: weights, in 1/1024, of the facet's second and third vertex
at the place where its threshold is read. *run*: texels that the ramp was advanced before
the texel. G and B: see [unit.md](unit.md).
)";
  return text;
}

}  // namespace kagesen::stress
