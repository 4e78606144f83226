/// Replays recorded pins on a design with mutants behind a selector: which of them differ, and
/// when.
///
///   player VECTORS MUTANTS  prints "NUMBER BEAT" for a mutant that differs, "NUMBER -" for others,
///                          and "reference DIFFERENT OF" for the outputs against the recorded ones
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "Vplayer_top.h"

namespace {

using Words = std::vector<std::uint32_t>;

struct Line {
  char kind;                    ///< N, R or B(eat)
  Words inputs, outputs, care;  ///< care: bits of the outputs that mean something
};

Words words_of(const std::string& hex, unsigned bits) {
  Words words((bits + 31) / 32, 0);
  for (std::size_t digit = 0; digit < hex.size(); ++digit) {
    const char text[2] = {hex[hex.size() - 1 - digit], 0};
    const std::uint32_t value = std::strtoul(text, nullptr, 16);
    if (digit / 8 < words.size()) words[digit / 8] |= value << (4 * (digit % 8));
  }
  return words;
}

std::vector<Line> read_lines(const char* path) {
  std::vector<Line> lines;
  std::ifstream in(path);
  std::string kind, inputs, outputs, care;
  while (in >> kind >> inputs >> outputs >> care) {
    lines.push_back({kind[0], words_of(inputs, PINS_IN), words_of(outputs, PINS_OUT),
                     words_of(care, PINS_OUT)});
  }
  return lines;
}

bool alike(const Words& a, const Words& b, const Words& care) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (((a[i] ^ b[i]) & care[i]) != 0) return false;
  }
  return true;
}

/// Calls `beat` with the outputs of every beat until it says no.
template <typename Beat>
void replay(const std::vector<Line>& lines, unsigned mutant, Beat beat) {
  auto dut = std::make_unique<Vplayer_top>();
  Words outputs((PINS_OUT + 31) / 32);
  std::size_t number = 0;
  for (const Line& line : lines) {
    if (line.kind == 'N') {
      dut->final();
      dut = std::make_unique<Vplayer_top>();
      dut->mutsel = mutant;
    }
    if (line.kind != 'B') {
      dut->run_i = 1;
      dut->eval();
      dut->run_i = 0;
      dut->eval();
      dut->run_i = 1;
      continue;
    }
    std::memcpy(&dut->pins_i[0], line.inputs.data(), 4 * line.inputs.size());
    dut->eval();
    std::memcpy(outputs.data(), &dut->pins_o[0], 4 * outputs.size());
    if (!beat(number++, line, outputs)) break;
    dut->clk_i = 1;
    dut->eval();
    dut->clk_i = 0;
    dut->eval();
  }
  dut->final();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::vector<Line> lines = read_lines(argv[1]);
  const unsigned mutants = std::strtoul(argv[2], nullptr, 10);
  std::vector<Words> reference;
  std::size_t different = 0;
  replay(lines, 0, [&](std::size_t, const Line& line, const Words& outputs) {
    different += !alike(outputs, line.outputs, line.care);
    reference.push_back(outputs);
    return true;
  });
  std::printf("reference %zu %zu\n", different, reference.size());
  for (unsigned mutant = 1; mutant <= mutants; ++mutant) {
    long killed = -1;
    replay(lines, mutant, [&](std::size_t beat, const Line& line, const Words& outputs) {
      if (alike(outputs, reference[beat], line.care)) return true;
      killed = static_cast<long>(beat);
      return false;
    });
    if (killed < 0)
      std::printf("%u -\n", mutant);
    else
      std::printf("%u %ld\n", mutant, killed);
    std::fflush(stdout);
  }
}
