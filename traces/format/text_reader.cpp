#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "traces/format/checks.h"
#include "traces/format/error.h"
#include "traces/format/text_form.h"
#include "traces/format/text_string.h"
#include "traces/format/trace_file.h"

namespace kagesen {
namespace {

constexpr std::size_t kMaxLineBytes = 512u << 10;  ///< the longest string, wholly escaped, fits
constexpr std::size_t kBatch = 8192;               ///< records handed to the sink at a time
constexpr std::size_t kMaxInferredObjects = 4096;

class TextReader {
 public:
  TextReader(std::istream& in, const std::string& name, TraceSink& sink)
      : in_(in), name_(name), sink_(sink), buffer_(std::make_unique<char[]>(kMaxLineBytes)) {}

  void read() {
    while (next_line()) {
      if (!rest_.empty()) statement();
    }
    if (in_.bad()) refuse("reading failed", "copy the file again");
    if (versioned_ && !ended_) {
      refuse("the text stops without its end line", "copy the file again or add `end`");
    }
    if (!begun_) start();
    flush();
    sink_.end();
  }

 private:
  bool next_line() {
    in_.getline(buffer_.get(), kMaxLineBytes);
    auto length = static_cast<std::size_t>(in_.gcount());
    if (length == 0 && !in_.good()) return false;
    ++line_;
    if (in_.fail() && !in_.eof()) {
      refuse(fmt::format("the line is longer than {} bytes", kMaxLineBytes - 2), "shorten it");
    }
    if (!in_.eof()) --length;  // the newline is counted, but not kept
    rest_ = strip_comment({buffer_.get(), length});
    return true;
  }

  void statement() {
    const std::string_view key = take_word(rest_);
    if (ended_) refuse("a line after `end`", "remove it");
    if (key == "caster") return caster();
    if (key == "fragment") return fragment();
    if (key == "end") {
      ended_ = true;
      return no_more();
    }
    if (begun_ || inferred_) {
      refuse(fmt::format("`{}` after the first record", escape_text(key.substr(0, 40))),
             "move it up or correct the word");
    }
    if (key == "object") return object();
    if (key == "warning") return warning();
    if (!seen_.insert(std::string(key)).second) refuse("given twice", "remove one");
    field(key);
    check(scalar_fault(header_));
  }

  void field(std::string_view key) {
    if (key == "kagesen-trace") {
      if (seen_.size() > 1 || !header_.objects.empty() || !header_.warnings.empty()) {
        refuse("the version is not the first line", "move it up");
      }
      versioned_ = true;
      if (number<unsigned>() != kTextVersion) {
        refuse("an unknown version of the text form", "use the kagesen that wrote it");
      }
    } else if (key == "map") {
      header_.map_width = number<std::uint32_t>();
      header_.map_height = number<std::uint32_t>();
    } else if (key == "fraction_bits") {
      header_.fraction_bits = number<std::uint32_t>();
    } else if (key == "scale") {
      header_.scale_x = number<double>();
      header_.scale_y = number<double>();
    } else if (key == "image") {
      header_.image_width = number<std::uint32_t>();
      header_.image_height = number<std::uint32_t>();
    } else if (key == "mode") {
      header_.mode = static_cast<FragmentMode>(choice(kModeNames, "visible, early-z or all"));
    } else if (key == "source") {
      header_.source = text();
    } else if (key == "source_sha256") {
      header_.source_sha256 = text();
    } else if (key == "light") {
      header_.light = text();
    } else if (key == "seed") {
      header_.seed = number<std::uint64_t>();
    } else {
      refuse(fmt::format("unknown word `{}`", escape_text(key.substr(0, 40))),
             "see docs/trace-format.md for the words there are");
    }
    no_more();
  }

  void object() {
    static constexpr std::string_view kClosedNames[] = {"open", "closed"};
    static constexpr std::string_view kCasterNames[] = {"receiver", "caster"};
    const auto index = number<std::uint32_t>();
    if (index != header_.objects.size()) {
      refuse(fmt::format("object {} where {} comes next", index, header_.objects.size()),
             "number the objects 0, 1, 2, ...");
    }
    if (index == kMaxObjects) refuse("too many objects", "merge some");
    ObjectInfo info;
    info.closed = choice(kClosedNames, "closed or open") != 0;
    info.caster = choice(kCasterNames, "caster or receiver") != 0;
    info.triangles = number<std::uint32_t>();
    info.name = text();
    header_.objects.push_back(std::move(info));
  }

  void warning() {
    if (header_.warnings.size() == kMaxWarnings) refuse("too many warnings", "remove some");
    header_.warnings.push_back(text());
  }

  void caster() {
    if (in_fragments_) refuse("a caster after the first fragment", "move it up");
    Caster record;
    for (LightPoint& point : record.vertex) point = light_point();
    record.object = number<std::uint32_t>();
    record.polygon = number<std::uint32_t>();
    no_more();
    prepare(record.object);
    check(caster_fault(record, header_));
    casters_.push_back(record);
    if (!inferred_ && casters_.size() == kBatch) flush();
  }

  void fragment() {
    Fragment record;
    record.pixel_x = number<std::uint16_t>();
    record.pixel_y = number<std::uint16_t>();
    record.position = light_point();
    record.object = number<std::uint32_t>();
    record.shade = number<std::uint8_t>();
    record.flags = number<std::uint8_t>();
    no_more();
    prepare(record.object);
    check(fragment_fault(record, header_));
    in_fragments_ = true;
    fragments_.push_back(record);
    if (!inferred_ && fragments_.size() == kBatch) flush();
  }

  LightPoint light_point() {
    LightPoint point;
    point.x = number<std::int32_t>();
    point.y = number<std::int32_t>();
    point.z = number<std::uint32_t>();
    return point;
  }

  /// Before the first record: begins the trace, or, where no object is listed, starts to infer
  /// them; the records then wait until the last one has told how many there are.
  void prepare(std::uint32_t object) {
    if (!begun_ && !inferred_) {
      inferred_ = header_.objects.empty();
      if (!inferred_) start();
    }
    if (!inferred_ || object < header_.objects.size()) return;
    if (object >= kMaxInferredObjects) {
      refuse(fmt::format("object {} without any `object` line", object),
             "list the objects before the records");
    }
    while (header_.objects.size() <= object) {
      header_.objects.push_back({fmt::format("object{}", header_.objects.size()), 0, false, true});
    }
  }

  void start() {
    check(header_fault(header_));
    sink_.begin(header_);
    begun_ = true;
  }

  void flush() {
    if (!casters_.empty()) sink_.casters(casters_.data(), casters_.size());
    if (!fragments_.empty()) sink_.fragments(fragments_.data(), fragments_.size());
    casters_.clear();
    fragments_.clear();
  }

  template <typename Number>
  Number number() {
    const std::string_view word = take_word(rest_);
    if (word.empty()) refuse("a number is missing", "see docs/trace-format.md for the line's form");
    Number value{};
    const char* last = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), last, value);
    if (stop == last && error == std::errc()) return value;
    const std::string shown = escape_text(word.substr(0, 40));
    if (error == std::errc::result_out_of_range) {
      refuse(fmt::format("`{}` is out of range", shown), "correct the number");
    }
    refuse(fmt::format("`{}` is not the number expected here", shown), "correct it");
  }

  template <std::size_t kCount>
  std::size_t choice(const std::string_view (&names)[kCount], const char* expected) {
    const std::string_view word = take_word(rest_);
    const auto* found = std::find(names, names + kCount, word);
    if (found == names + kCount) {
      refuse(fmt::format("`{}` stands where {} belongs", escape_text(word.substr(0, 40)), expected),
             "correct the word");
    }
    return static_cast<std::size_t>(found - names);
  }

  /// The rest of the line, unescaped.
  std::string text() {
    std::string value;
    if (!unescape_text(rest_, value)) {
      refuse("a backslash that begins no escape", "write \\\\ for a backslash");
    }
    rest_ = {};
    text_bytes_ += value.size();
    if (text_bytes_ > kMaxHeaderBytes)
      refuse("the header is too long", "shorten names or warnings");
    return value;
  }

  void no_more() {
    if (!rest_.empty()) refuse("more words than the line takes", "remove them");
  }

  void check(const std::string& fault) {
    if (!fault.empty()) refuse(fault, "correct the line");
  }

  [[noreturn]] void refuse(const std::string& what, const std::string& mend) {
    throw UserError(fmt::format("{} line {}", name_, line_), what, mend);
  }

  std::istream& in_;
  const std::string& name_;
  TraceSink& sink_;
  std::unique_ptr<char[]> buffer_;
  std::string_view rest_;  ///< of the line, still to be read
  std::uint64_t line_ = 0;
  std::size_t text_bytes_ = 0;  ///< of the header's strings
  TraceHeader header_;
  std::set<std::string> seen_;
  std::vector<Caster> casters_;
  std::vector<Fragment> fragments_;
  bool versioned_ = false, begun_ = false, inferred_ = false, in_fragments_ = false;
  bool ended_ = false;
};

}  // namespace

void read_trace_text(std::istream& in, const std::string& name, TraceSink& sink) {
  TextReader(in, name, sink).read();
}

}  // namespace kagesen
