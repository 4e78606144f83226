#include "testbench/mutation/care.h"

#include <fstream>
#include <map>

#include "traces/format/error.h"

namespace kagesen {
namespace {

bool ends_with(const std::string& word, const std::string& end) {
  return word.size() >= end.size() && word.compare(word.size() - end.size(), end.size(), end) == 0;
}

/// The name of the valid that data `name` belongs to, or "": that of the longest common prefix.
std::string valid_of(const std::string& name, const Recording& recording,
                     const Qualifiers& qualifiers) {
  for (const auto& [data, valid] : qualifiers) {
    if (data == name) return valid;
  }
  std::string found;
  if (ends_with(name, "valid_o") || ends_with(name, "ready_o")) return found;
  for (const Recording::Pin& pin : recording.outputs) {
    if (!ends_with(pin.name, "valid_o")) continue;
    const std::string prefix = pin.name.substr(0, pin.name.size() - 7);
    if (name.compare(0, prefix.size(), prefix) == 0 && pin.name.size() > found.size())
      found = pin.name;
  }
  return found;
}

bool bit_of(const std::string& hex, unsigned bit) {
  const std::size_t digit = bit / 4;
  if (digit >= hex.size()) return false;
  const char c = hex[hex.size() - 1 - digit];
  const unsigned value = c <= '9' ? c - '0' : c - 'a' + 10;
  return value >> (bit % 4) & 1;
}

std::string care_of(const std::string& outputs, const std::vector<CareField>& fields) {
  std::string care(outputs.size(), '0');
  for (const CareField& field : fields) {
    unsigned valid = 0;
    for (unsigned bit = field.valid_width; bit-- > 0;) {
      valid = 2 * valid + bit_of(outputs, field.valid_low + bit);
    }
    if (field.valid_width > 0 && valid != field.valid_value) continue;
    for (unsigned bit = field.low; bit < field.low + field.width; ++bit) {
      char& c = care[care.size() - 1 - bit / 4];
      const unsigned value = (c <= '9' ? c - '0' : c - 'a' + 10) | 1u << (bit % 4);
      c = "0123456789abcdef"[value];
    }
  }
  return care;
}

}  // namespace

std::vector<CareField> care_fields(const Recording& recording, const Qualifiers& qualifiers) {
  std::map<std::string, unsigned> lows, widths;
  unsigned low = total_width(recording.outputs);
  for (const Recording::Pin& pin : recording.outputs) {
    lows[pin.name] = low -= pin.width;
    widths[pin.name] = pin.width;
  }
  std::vector<CareField> fields;
  for (const Recording::Pin& pin : recording.outputs) {
    CareField field{lows[pin.name], pin.width};
    std::string valid = valid_of(pin.name, recording, qualifiers);
    if (const std::size_t equals = valid.find('='); equals != std::string::npos) {
      field.valid_value = static_cast<unsigned>(std::stoul(valid.substr(equals + 1)));
      valid.resize(equals);
    }
    // A single bit without a stream of its own is control: idle, empty.
    const bool control = pin.width == 1 && valid == "valid_o";
    if (!valid.empty() && !control) {
      field.valid_low = lows.at(valid);
      field.valid_width = widths.at(valid);
    }
    fields.push_back(field);
  }
  return fields;
}

void write_vectors(const Recording& recording, const Qualifiers& qualifiers, std::size_t most,
                   const std::filesystem::path& file) {
  const std::vector<CareField> fields = care_fields(recording, qualifiers);
  std::ifstream in(recording.pins);
  std::ofstream out(file);
  std::size_t beats = 0;
  bool reset = true;  // has it been? In its first beat Verilator's model has not
  for (std::string line; beats < most && std::getline(in, line);) {
    if (line == "N" || line == "R") {
      out << line << " 0 0 0\n";
      reset = line == "R" || !recording.clocked;
    } else if (const std::size_t gap = line.find(' '); gap != std::string::npos) {
      out << "B " << line << ' ' << (reset ? care_of(line.substr(gap + 1), fields) : "0") << '\n';
      reset = true;
      ++beats;
    }
  }
  if (!out.flush()) throw UserError(file.string(), "cannot be written", "make room");
}

}  // namespace kagesen
